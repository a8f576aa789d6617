"""The numbers of a scene as a mapping, as in Mitsuba."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, MutableMapping

import numpy as np
from numpy.typing import ArrayLike

from . import _capwalk
from ._results import Array
from .errors import ArgumentError


class SceneParameters(MutableMapping[str, Array]):
    """Arrays of a scene by their names. What is set counts when :meth:`update` is called, all
    at once. Iteration gives each array under its first name; other names that it has
    (``ball.vertex_positions`` for ``ball.positions``) are understood."""

    def __init__(self, scene: _capwalk.Scene) -> None:
        self._scene = scene
        self._listed = scene.arrays()
        self._changed: dict[str, Array] = {}
        self._first = {name: alias or name for name, _, _, _, alias, _ in self._listed}

    def __getitem__(self, name: str) -> Array:
        first = self._first.get(name, name)
        if first not in self._changed:
            # Changed in place, too: ``params["ball.positions"][0] += 1``.
            self._changed[first] = self._scene.values(first)
        return self._changed[first]

    def __setitem__(self, name: str, value: ArrayLike) -> None:
        shape = self._scene.values(name).shape
        numbers = np.asarray(value, dtype=np.float64)
        if numbers.size == np.prod(shape) and numbers.ndim <= 1:
            # A number for an array of one, and a flat array as Mitsuba has them.
            numbers = numbers.reshape(shape)
        if numbers.shape != shape:
            raise ArgumentError(f"{name} has the shape {shape}; found {numbers.shape}")
        self._changed[self._first.get(name, name)] = np.array(numbers)

    def __delitem__(self, name: str) -> None:
        raise TypeError(f"{name} cannot be removed: the scene needs all of its parameters")

    def __iter__(self) -> Iterator[str]:
        return (name for name, _, _, _, alias, _ in self._listed if alias is None)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __contains__(self, name: object) -> bool:
        return name in self._first

    def update(self, *others: Mapping[str, ArrayLike], **more: ArrayLike) -> None:  # type: ignore[override]
        """Changes the scene to what was set, all of it or, if the scene could not be rendered
        so, nothing; then what was set is forgotten. Moved vertices refit the trees, other
        colours touch none. Mappings are set before."""
        for other in (*others, more):
            for name, value in other.items():
                self[name] = value
        changed, self._changed = self._changed, {}
        self._scene.update({
            name: value
            for name, value in changed.items()
            if not np.array_equal(value, self._scene.values(name))
        })

    def __repr__(self) -> str:
        """A table: ``D`` stands where edges move, so that the derivative has a boundary part."""
        rows = [
            (name, str(tuple(shape)), "D" if moves else "", unit, description)
            for name, shape, unit, description, alias, moves in self._listed
            if alias is None
        ]
        rows.insert(0, ("name", "shape", "", "unit", "what it is"))
        widths = [max(len(row[i]) for row in rows) for i in range(4)]
        lines = ("  ".join([*(c.ljust(w) for c, w in zip(row, widths)), row[4]]) for row in rows)
        return "\n".join(line.rstrip() for line in lines)


def traverse(scene: _capwalk.Scene) -> SceneParameters:
    """The arrays of a scene that can be read, set and differentiated with respect to.

    >>> import capwalk as cw
    >>> scene = cw.load_file("leaf")
    >>> params = cw.traverse(scene)
    >>> params["leaf.positions"] += [0.1, 0.0, 0.0]
    >>> params.update()
    """
    return SceneParameters(scene)


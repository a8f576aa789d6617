"""The numbers of a scene as a mapping, as in Mitsuba."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, MutableMapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from . import _capwalk
from ._numbers import Array, numbers
from .errors import ArgumentError, BusyError


_PLACES = {
    "to_world": ("positions", "normals", "translate", "rotate"),
    "translate": ("positions", "position"),
}
"""Kinds of arrays, and others that place the same thing."""


def check_apart(names: Iterable[str]) -> None:
    """Raises an error if two arrays, given by their first names, set the position of the same
    object: the result would depend on their order."""
    chosen = set(names)
    for name in chosen:
        owner, _, kind = name.rpartition(".")
        for other in _PLACES.get(kind, ()):
            if f"{owner}.{other}" in chosen:
                raise ArgumentError(f"{name} and {owner}.{other} both place {owner}; give one")


@dataclass
class _Entry:
    """An array that was read or set."""

    value: Array
    """What the user has and may change in place."""
    read: Array
    """What the scene had."""
    revision: int
    """When the scene had it."""
    was_set: bool = False
    """True if it counts even if it is what the scene had."""

    @property
    def changed(self) -> bool:
        return self.was_set or not np.array_equal(self.value, self.read, equal_nan=True)


class SceneParameters(MutableMapping[str, Array]):
    """Arrays of a scene by their names. Arrays that are set, or changed in place, take effect
    together when :meth:`update` is called. Iteration gives each array under its first name; its
    other names (``ball.vertex_positions`` for ``ball.positions``) are accepted."""

    def __init__(self, scene: _capwalk.Scene) -> None:
        self._scene = scene
        self._listed = scene._arrays()
        self._first = {name: alias or name for name, _, _, _, alias, _ in self._listed}
        self._kept = [name for name, first in self._first.items() if name == first]
        self._entries: dict[str, _Entry] = {}

    def __getitem__(self, name: str) -> Array:
        first = self._first.get(name, name)
        entry = self._entries.get(first)
        revision = self._scene.revision
        if entry is None or (entry.revision != revision and not entry.changed):
            now = self._scene._values(first)
            entry = self._entries[first] = _Entry(now, now.copy(), revision)
        return entry.value

    def __setitem__(self, name: str, value: ArrayLike) -> None:
        entry = self._entry(name, value)
        self._entries[self._first[name]] = entry

    def __delitem__(self, name: str) -> None:
        raise TypeError(f"{name} cannot be removed: the scene needs all of its parameters")

    def __iter__(self) -> Iterator[str]:
        return iter(self._kept)

    def __len__(self) -> int:
        return len(self._kept)

    def __contains__(self, name: object) -> bool:
        return name in self._first

    __eq__ = object.__eq__
    __hash__ = object.__hash__

    def keep(self, pattern: str) -> None:
        """Leaves only the arrays whose names match a regular expression as a whole. The others
        can still be read and set by name."""
        self._kept = [name for name in self._kept if re.fullmatch(pattern, name)]

    def update(self, *others: Mapping[str, ArrayLike], **more: ArrayLike) -> None:  # type: ignore[override]
        """Applies all values that were set to the scene, or none if the scene could not be rendered
        with them; then they are forgotten. Moved vertices refit the trees, colours touch none. A
        mapping as argument is set first.

        :raises BusyError: another thread renders the scene; the values are kept, so that it can be
            tried again.
        """
        entries = dict(self._entries)
        for other in (*others, more):
            for name, value in dict(other).items():
                entry = self._entry(name, value)
                entries[self._first[name]] = entry
        self._entries = entries
        try:
            changes = {name: entry.value for name, entry in entries.items() if entry.changed}
            check_apart(changes)
            if changes:
                self._scene._update(changes)
        except BusyError:
            raise
        except Exception:
            self._entries = {}
            raise
        self._entries = {}

    def _entry(self, name: str, value: ArrayLike) -> _Entry:
        now = self._scene._values(name)
        array = numbers(name, value)
        if array.size == now.size and array.ndim <= 1:
            # A number for an array of one, and a flat array as Mitsuba has them.
            array = array.reshape(now.shape)
        if array.shape != now.shape:
            raise ArgumentError(f"{name} has the shape {now.shape}; found {array.shape}")
        return _Entry(array.copy(), now, self._scene.revision, was_set=True)

    def __repr__(self) -> str:
        """A table; ``D`` marks parameters that move edges, whose derivative has a boundary part."""
        rows = [
            (name, str(tuple(shape)), "D" if moves else "", unit, description)
            for name, shape, unit, description, _, moves in self._listed
            if name in self._kept
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

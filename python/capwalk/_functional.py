"""Images as functions of numbers, for frameworks in which nothing changes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import reduce
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np

from . import _capwalk, _functions
from ._method import Method
from ._numbers import Array
from ._options import (
    LARGEST_COUNT,
    LARGEST_SEED,
    Options,
    check_names,
    checked,
    integer,
    sensor_numbers,
)
from ._parameters import check_apart
from .errors import ArgumentError, ParameterError, Refused
from .options import FunctionOptions, MethodOptions, Unpack

Scene = _capwalk.Scene


@dataclass(frozen=True)
class _Listed:
    """An array of a scene."""

    shape: tuple[int, ...]
    unit: str
    first: str
    """The name under which it is listed first."""


@dataclass
class _Copy:
    """A copy of a scene, and what it is at."""

    scene: Scene
    was: Scene | None = None
    values: dict[str, Array] = field(default_factory=dict)

    def move(self, was: Scene, values: dict[str, Array]) -> None:
        """Goes over to what a scene would be with these values. A derivative that follows its
        image is there already."""
        is_current = self.was is was and self.values.keys() == values.keys()
        if not is_current or any((self.values[name] != values[name]).any() for name in values):
            self.was = None
            self.scene._restore(was, values)
            # Those who gave the values may change them.
            self.was, self.values = was, {name: value.copy() for name, value in values.items()}


@dataclass
class _Kept:
    """What is kept of a scene from call to call."""

    arrays: dict[str, _Listed]
    """By all of their names, which do not change."""
    revision: int
    was: Scene
    """The scene at this revision; nobody changes it."""
    spare: dict[str | None, list[_Copy]] = field(default_factory=dict)
    """Copies that nobody is using, by what they show. Sensors take turns with them."""
    methods: dict[tuple[Options, tuple[int, ...], tuple[str, ...]], Method | None] = field(
        default_factory=dict
    )
    """What was chosen, by how derivatives are asked for, the shape of the image and the names;
    ``None`` where the derivative was refused."""


_KEPT: WeakKeyDictionary[Scene, _Kept] = WeakKeyDictionary()


class Work:
    """The image of a scene as a function of some of its arrays, and its derivatives; or the images
    of several views of it.

    The scene counts as it was when this was made, and stays as it is. What is done is done on
    copies of it, which are kept and refitted. Every call has one for itself, so that none waits
    for another, be they in several threads, in forked processes or in callbacks.

    Values are in the order of the names, in the shapes that were given.
    """

    def __init__(
        self,
        scene: Scene,
        shapes: Mapping[str, tuple[int, ...]],
        **options: Unpack[FunctionOptions],
    ) -> None:
        check_names("render", FunctionOptions, options)
        given: dict[str, Any] = {**options}
        views = given.pop("views", None)
        if views is None:
            asked = [checked(scene, given)]
        elif "sensor" in given:
            raise ArgumentError("both sensor and views are given; keep one of them")
        else:
            numbers = sensor_numbers(scene, "views", views)
            asked = [checked(scene, {**given, "sensor": number}) for number in numbers]
        kept = _kept(scene)
        self._arrays = {name: _array(scene, kept.arrays, name) for name in shapes}
        for name, shape in shapes.items():
            _check_shape(name, self._arrays[name].shape, shape)
        _check_apart(self._arrays)
        self._views = [_View(kept, self._arrays, of_view, given) for of_view in asked]
        self._is_one = views is None
        self.seed = asked[0].seed
        """The scene's own."""
        shape = _common_shape(self._views)
        self.image_shape = shape if self._is_one else (len(self._views), *shape)

    @property
    def names(self) -> tuple[str, ...]:
        """The arrays, in the order of the values."""
        return tuple(self._arrays)

    def image(self, seed: int, values: Sequence[Array]) -> Array:
        """The image, (height, width, 3), or the images of the views, (views, height, width, 3)."""
        return self._stacked([view.image(own, values) for view, own in self._seeded(seed)])

    def push(
        self,
        seed: int,
        values: Sequence[Array],
        moving: Sequence[bool],
        velocities: Sequence[Array],
    ) -> Array:
        """The derivative of what :meth:`image` gives, in its shape, while some values move."""
        return self._stacked(
            [view.push(own, values, moving, velocities) for view, own in self._seeded(seed)]
        )

    def pull(
        self, seed: int, values: Sequence[Array], wanted: Sequence[bool], adjoint: Array
    ) -> list[Array]:
        """The gradients of ``(adjoint * image).sum()`` with respect to some values, each in the
        shape of its value. The transpose of :meth:`push`."""
        adjoints = [adjoint] if self._is_one else adjoint
        of_views = [
            view.pull(own, values, wanted, of_view)
            for (view, own), of_view in zip(self._seeded(seed), adjoints)
        ]
        # In the order of the views, on which the rounding depends. Sums of numbers are no arrays.
        return [np.asarray(reduce(np.add, of_value)) for of_value in zip(*of_views)]

    def _seeded(self, seed: int) -> Iterator[tuple[_View, int]]:
        """The views with their seeds; the first has this one."""
        for i, view in enumerate(self._views):
            yield view, _capwalk.view_seed(seed, i)

    def _stacked(self, images: list[Array]) -> Array:
        return images[0] if self._is_one else np.stack(images)


class _View:
    """The image of one sensor, and its derivatives."""

    def __init__(
        self,
        kept: _Kept,
        arrays: Mapping[str, _Listed],
        asked: Options,
        given: Mapping[str, Any],
    ) -> None:
        spp_grad = given.get("spp_grad")
        spp_grad = (
            asked.spp if spp_grad is None else integer("spp_grad", spp_grad, 1, LARGEST_COUNT)
        )
        given = {**given, "sensor": asked.sensor}
        given.pop("spp_grad", None)
        of_method = MethodOptions.__annotations__
        self._of_image = {
            **{name: value for name, value in given.items() if name not in of_method},
            "spp": asked.spp,
        }
        self._of_derivative = {**given, "spp": spp_grad}
        self._asked = replace(asked, spp=spp_grad, seed=0)
        self._arrays = arrays
        # The image does not depend on other sensors.
        names = [name for name, _, _, _ in kept.was._sensors()]
        self.sensor = names[asked.sensor]
        others = {name for name in names if name != self.sensor}
        self._seen = [array.first.rpartition(".")[0] not in others for array in arrays.values()]
        self._was, self._spare = kept.was, kept.spare.setdefault(asked.aov, [])
        self._methods = kept.methods
        _, (width, height), _, _ = self._was._sensors()[asked.sensor]
        self.image_shape = (height, width, 3)

    def image(self, seed: int, values: Sequence[Array]) -> Array:
        """The image, (height, width, 3)."""
        with self._at(values) as scene:
            return _functions.render(scene, seed=seed, **self._of_image).value

    def push(
        self,
        seed: int,
        values: Sequence[Array],
        moving: Sequence[bool],
        velocities: Sequence[Array],
    ) -> Array:
        """The derivative of the image, (height, width, 3), while some values move."""
        along = {
            name: _turned(array, value, velocity.reshape(array.shape))
            for (name, array, value, seen), velocity in zip(
                self._chosen(values, moving), velocities
            )
            if seen
        }
        # What stands still is no direction.
        along = {name: velocity for name, velocity in along.items() if velocity.any()}
        if not along:
            return np.zeros(self.image_shape)
        how = self._how(tuple(along))
        with self._at(values) as scene:
            return _functions.gradient(scene, along, seed=seed, **how).gradient

    def pull(
        self, seed: int, values: Sequence[Array], wanted: Sequence[bool], adjoint: Array
    ) -> list[Array]:
        """The gradients of ``(adjoint * image).sum()`` with respect to some values, each in the
        shape of its value. The transpose of :meth:`push`."""
        chosen = list(self._chosen(values, wanted))
        names = [name for name, _, _, seen in chosen if seen]
        gradients: Mapping[str, Array] = {}
        if names:
            how = self._how(tuple(names))
            with self._at(values) as scene:
                gradients = _functions.backward(scene, adjoint, names, seed=seed, **how)
        return [
            _turned(array, value, gradients[name], transposed=True).reshape(value.shape)
            if seen
            else np.zeros(value.shape)
            for name, array, value, seen in chosen
        ]

    def _how(self, names: tuple[str, ...]) -> dict[str, Any]:
        """How derivatives with respect to these arrays are estimated: by the method that a pilot
        chose for the scene itself and not for the values of the call that happens to be first.
        So a call is a function of its arguments, and only the first one needs a pilot."""
        if self._asked.chosen is not None:
            return self._of_derivative
        question = (self._asked, self.image_shape, names)
        if question not in self._methods:
            nothing = np.zeros(self.image_shape)
            try:
                with self._at(()) as scene:
                    chosen = _capwalk.choose(scene, (nothing, list(names)), self._asked)
            except Refused:
                # It may be allowed with other values, each call for itself.
                chosen = None
            self._methods[question] = None if chosen is None else Method(*chosen)
        method = self._methods[question]
        if method is None:
            return self._of_derivative
        # Steps and cutoff are the method's.
        own = {"steps": None, "max_angle": None, "antithetic": None}
        return {**self._of_derivative, **own, "method": method}

    def _chosen(
        self, values: Sequence[Array], chosen: Sequence[bool]
    ) -> Iterator[tuple[str, _Listed, Array, bool]]:
        arrays = zip(self._arrays.items(), values, self._seen, chosen)
        for (name, array), value, seen, is_chosen in arrays:
            if is_chosen:
                yield name, array, value, seen

    @contextmanager
    def _at(self, values: Sequence[Array]) -> Iterator[Scene]:
        """A copy of the scene with these values, until they are done with it."""
        shaped = {
            name: np.ascontiguousarray(value.reshape(array.shape))
            for (name, array), value in zip(self._arrays.items(), values)
        }
        try:
            copy = self._spare.pop()
        except IndexError:
            copy = _Copy(self._was.copy())
        # If that fails, the copy is not used again.
        copy.move(self._was, shaped)
        copy.scene._turn(self._asked.sensor, self._asked.aov)
        try:
            yield copy.scene
        finally:
            self._spare.append(copy)


def _common_shape(views: Sequence[_View]) -> tuple[int, int, int]:
    """The shape of all images."""
    if len({view.image_shape for view in views}) > 1:
        sizes = (f"{v.sensor} {v.image_shape[1]} x {v.image_shape[0]}" for v in views)
        raise ArgumentError(
            f"the images of the views have several sizes ({', '.join(sizes)}); expected one: resize "
            "the scene, or render views of each size by a call of their own"
        )
    return views[0].image_shape


def second_derivative(names: Sequence[str]) -> Refused:
    """The exception for a derivative of a derivative."""
    by = ", ".join(names)
    reason = f"derivatives of the image are not differentiated again, here with respect to {by}"
    instead = "Take differences of gradients with the same `seed_grad`"
    return Refused(f"{reason}. {instead}", reason, instead)


def seeds(own: int, seed: int | None, seed_grad: int | None) -> tuple[int, int]:
    """The seeds of an image and of its derivatives, by default the scene's own and one that
    never collides with nearby seeds."""
    seed = own if seed is None else integer("seed", seed, 0, LARGEST_SEED)
    if seed_grad is None:
        seed_grad = _capwalk.independent_seed(seed)
    seed_grad = integer("seed_grad", seed_grad, 0, LARGEST_SEED)
    check_seeds(seed, seed_grad)
    return seed, seed_grad


def check_seeds(seed: int, seed_grad: int) -> None:
    """An error if an image and its derivatives would have the same random numbers."""
    if seed == seed_grad:
        raise ArgumentError(
            f"seed and seed_grad are both {seed}; the gradient of a loss is a product of what the "
            "image and its derivative say, which is biased if they share their random numbers: "
            "leave seed_grad out, or take another one"
        )


def _kept(scene: Scene) -> _Kept:
    revision = scene.revision
    kept = _KEPT.get(scene)
    if kept is None:
        arrays = {
            name: _Listed(tuple(shape), unit, alias or name)
            for name, shape, unit, _, alias, _ in scene._arrays()
        }
        return _KEPT.setdefault(scene, _Kept(arrays, revision, scene.copy()))
    if kept.revision != revision:
        kept.was, kept.revision = scene.copy(), revision
    return kept


def _array(scene: Scene, arrays: Mapping[str, _Listed], name: str) -> _Listed:
    if name in arrays:
        return arrays[name]
    direction = re.match(r"(.+)\.(translate|rotate|scale)\b", name)
    if direction and f"{direction[1]}.to_world" in arrays:
        owner, motion = direction.groups()
        instead = [f"{owner}.{array}" for array in (motion, "to_world", "positions")]
        instead = [f'"{array}"' for array in instead if array in arrays]
        raise ParameterError(
            f'"{name}" is a direction and has no value; what moves {owner} are the arrays '
            f"{', '.join(instead[:-1])} and {instead[-1]}"
        )
    # Raises, with names that were perhaps meant.
    scene._values(name)
    raise ParameterError(f'"{name}" is no array of the scene')


def _check_shape(name: str, expected: tuple[int, ...], found: tuple[int, ...]) -> None:
    # A number for an array of one, and a flat array as Mitsuba has them.
    is_flat = len(found) <= 1 and np.prod(found) == np.prod(expected)
    if found != expected and not is_flat:
        raise ArgumentError(f"{name} has the shape {expected}; found {found}")


def _check_apart(arrays: Mapping[str, _Listed]) -> None:
    """An error if two arrays set the same numbers: only one of them would count."""
    names: dict[str, str] = {}
    for name, array in arrays.items():
        if array.first in names:
            raise ArgumentError(f"{names[array.first]} and {name} are the same array; give one")
        names[array.first] = name
    check_apart(names)


def _turned(array: _Listed, value: Array, vector: Array, *, transposed: bool = False) -> Array:
    """A velocity of a value as that of the scene's numbers, or, transposed, a gradient with
    respect to these as that with respect to the value."""
    turned = vector
    if array.unit == "length 1":
        # Normals are made unit: n/|n| moves by 1/|n| as much, where it can.
        turned = vector / np.linalg.norm(value.reshape(array.shape), axis=-1, keepdims=True)
    elif array.unit == "radians":
        # The sensor turns on from where it is.
        jacobian = _rotation_jacobian(value)
        turned = (jacobian.T if transposed else jacobian) @ vector
    return turned


def _rotation_jacobian(rotation: Array) -> Array:
    """How fast, in radians about world axes, that turns which is turned by a rotation vector
    r, per change of r. With K v = r × v and the angle a = |r|,
    I + (1 - cos a)/a² K + (a - sin a)/a³ K²; e.g. Solà et al. 2018, Eq. (145)."""
    x, y, z = rotation
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.linalg.norm(rotation)
    if angle**2 == 0:
        return np.eye(3)
    # sinc is sin(πx)/(πx). What cancels in 1 - sinc is multiplied by K².
    first = np.sinc(angle / (2 * np.pi)) ** 2 / 2
    second = (1 - np.sinc(angle / np.pi)) / angle**2
    jacobian: Array = np.eye(3) + first * cross + second * (cross @ cross)
    return jacobian

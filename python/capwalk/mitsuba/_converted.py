"""A scene of Mitsuba's as a dictionary in which numbers may change."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import drjit as dr
import numpy as np

from .._numbers import Array

Description = dict[str, Any]


@dataclass(frozen=True, eq=False)
class Number:
    """A number or an array that can change without anything else in its scene."""

    owner: Any
    """The object of Mitsuba's that has it."""
    key: str
    """What this calls it."""
    name: str
    """What capwalk calls it."""
    value: Array
    """As capwalk has it, but for numbers that stand for all of a colour."""
    halo: bool = False
    """True if Mitsuba has a column more at each side, which repeats the opposite one."""

    def ours(self, theirs: Any) -> Array:
        """An array of Mitsuba's, of values or of their velocities, in the shape of ours."""
        array = numbers(theirs)
        if self.halo:
            array = array.reshape(array.shape[0], -1, 3)[:, 1:-1]
        return array.reshape(self.value.shape)

    def theirs(self, gradient: Array) -> Array:
        """A gradient with respect to capwalk's array as one with respect to Mitsuba's."""
        # One number may stand for three channels.
        extra = gradient.ndim - self.value.ndim
        gradient = gradient.sum(axis=tuple(range(extra)))
        repeated = tuple(i for i, n in enumerate(self.value.shape) if n < gradient.shape[i])
        gradient = gradient.sum(axis=repeated, keepdims=True)
        # The halo is copied from the image whenever this changes.
        return np.pad(gradient, ((0, 0), (1, 1), (0, 0))) if self.halo else gradient


@dataclass
class Converted:
    """A scene as a dictionary for :func:`capwalk.load_dict`, with a :class:`Number` wherever one
    may change."""

    description: Description
    numbers: list[Number] = field(default_factory=list)
    objects: dict[Any, str] = field(default_factory=dict)
    """What was converted, and what it is called."""

    def plain(self) -> Description:
        """The dictionary with all numbers as they are."""
        return {key: _plain(value) for key, value in self.description.items()}

    def values(self) -> dict[str, Array]:
        """All numbers by capwalk's names."""
        return {number.name: number.value for number in self.numbers}

    def fingerprint(self) -> str:
        """The same for scenes that differ in their numbers only."""
        digest = hashlib.blake2b()
        for piece in _pieces(self.description):
            digest.update(piece)
            digest.update(b"\0")
        return digest.hexdigest()


def numbers(value: Any) -> Array:
    """A value of Mitsuba's as an array, without derivatives."""
    if hasattr(value, "inverse_transpose"):
        value = value.matrix
    array = np.asarray(value, dtype=np.float64)
    # Vectorized variants have one of each number.
    vectorized = array.ndim > 1 and array.shape[-1] == 1 and not dr.is_tensor_v(value)
    return array[..., 0] if vectorized else array


def _plain(value: Any) -> Any:
    if isinstance(value, Number):
        return value.value if value.value.ndim else float(value.value)
    if isinstance(value, dict):
        return {key: _plain(child) for key, child in value.items()}
    return value


def _pieces(value: Any) -> Iterator[bytes]:
    """What a description consists of, without numbers that may change."""
    if isinstance(value, dict):
        yield b"{"
        for key, child in value.items():
            # Every call has its own count, and Mitsuba's integrators change that of a sampler.
            if key != "sample_count":
                yield key.encode()
                yield from _pieces(child)
        yield b"}"
    elif isinstance(value, Number):
        yield f"{value.name} {value.value.shape}".encode()
    elif isinstance(value, np.ndarray):
        yield str(value.shape).encode()
        yield value.tobytes()
    else:
        yield repr(value).encode()

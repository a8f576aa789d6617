"""Numbers that are given as arrays of any framework, with errors that say what they are."""

from __future__ import annotations

from numpy.typing import ArrayLike

from ._numbers import Array, numbers
from .errors import ArgumentError


def array_of(what: str, value: ArrayLike) -> Array:
    """The numbers of an array of any framework."""
    # PyTorch's do not convert if they are part of a graph or elsewhere than in main memory.
    detach = getattr(value, "detach", None)
    return numbers(what, detach().cpu() if detach else value)


def number_of(what: str, value: ArrayLike) -> float:
    """The one number of an array."""
    array = array_of(what, value)
    if array.size != 1:
        raise ArgumentError(f"{what} has the shape {array.shape}; expected one number")
    return float(array.item())


def vectors_of(what: str, value: ArrayLike, count: int) -> Array:
    """Rows of three numbers, flat or not."""
    array = array_of(what, value)
    if array.size != 3 * count:
        raise ArgumentError(f"{what} has the shape {array.shape}; expected {count} x 3 numbers")
    return array.reshape(count, 3)


def pixels_of(what: str, image: ArrayLike) -> Array:
    """The colours of an image, (height, width, 3)."""
    pixels = array_of(what, image)
    if pixels.ndim != 3 or pixels.shape[2] != 3:
        raise ArgumentError(f"{what} has the shape {pixels.shape}; expected (height, width, 3)")
    return pixels

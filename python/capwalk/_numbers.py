"""Arrays of numbers, as the module takes them."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import ArgumentError

Array = NDArray[np.float64]


def numbers(what: str, value: ArrayLike) -> Array:
    """An array in double precision. Refuses what are no real numbers; ``what`` they are for."""
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ArgumentError(f"{what} is no array of numbers: {error}") from None
    if array.dtype.kind not in "biuf":
        raise ArgumentError(f"{what} is an array of {array.dtype}; expected real numbers")
    return np.require(array, np.float64, ["A", "C"])

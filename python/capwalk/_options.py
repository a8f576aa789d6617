"""What every kind of work is asked for with, checked."""

from __future__ import annotations

import operator
from collections.abc import Callable
from dataclasses import dataclass

from . import _capwalk
from .errors import ArgumentError


@dataclass(frozen=True)
class Options:
    """What `_capwalk` reads, attribute by attribute."""

    spp: int
    seed: int
    threads: int | None
    progress: Callable[[int, int], object] | None
    method: str = "auto"
    steps: int | None = None
    max_angle: float | None = None
    antithetic: bool | None = None


def options(
    scene: _capwalk.Scene,
    spp: int | None,
    seed: int | None,
    threads: int | None,
    progress: Callable[[int, int], object] | None,
    *,
    method: str = "auto",
    steps: int | None = None,
    max_angle: float | None = None,
    antithetic: bool | None = None,
) -> Options:
    """The options; what is ``None`` is as the scene's file says."""
    own_spp, own_seed = scene.sampling
    return Options(
        spp=own_spp if spp is None else integer("spp", spp, 1, 2**32 - 1),
        seed=own_seed if seed is None else integer("seed", seed, 0, 2**64 - 1),
        threads=None if threads is None else integer("threads", threads, 1, 2**16),
        progress=progress,
        method=method,
        steps=None if steps is None else integer("steps", steps, 1, 2**32 - 1),
        max_angle=max_angle,
        antithetic=antithetic,
    )


def integer(name: str, value: int, least: int, most: int) -> int:
    """An integer, also one of NumPy's, within its bounds."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is {value!r}; expected an integer") from None
    if not least <= number <= most:
        raise ArgumentError(f"{name} is {number}; expected {least} to {most}")
    return number

"""What every kind of work is asked for with, checked."""

from __future__ import annotations

import math
import operator
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from . import _capwalk
from ._method import Method
from .errors import ArgumentError, SceneWarning

LARGEST_SEED = 2**64 - 1
LARGEST_COUNT = 2**32 - 1
"""Of samples or steps, as the module has them."""


@dataclass(frozen=True)
class Options:
    """What `_capwalk` reads, attribute by attribute."""

    sensor: int
    aov: str | None
    spp: int
    seed: int
    threads: int | None
    progress: Callable[[int, int], object] | None
    method: str = "auto"
    steps: int | None = None
    max_angle: float | None = None
    antithetic: bool | None = None
    chosen: bytes | None = None
    """What a pilot has chosen, instead of the last four."""
    allow_missing: tuple[str, ...] = ()


def options(
    scene: _capwalk.Scene,
    sensor: int | str,
    spp: int | None,
    seed: int | None,
    *,
    independent: bool = False,
    aov: str | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    method: str | Method = "auto",
    steps: int | None = None,
    max_angle: float | None = None,
    antithetic: bool | None = None,
    allow_missing: Sequence[str] = (),
) -> Options:
    """The options; what is ``None`` is as the scene's file says. The seed is then
    ``independent`` of that of an image, if asked for."""
    if not isinstance(scene, _capwalk.Scene):
        raise TypeError(
            f"the scene is a {type(scene).__name__}; expected what load_file or load_string give"
        )
    if antithetic not in (None, True, False):
        raise TypeError(f"antithetic is {antithetic!r}; expected True or False")
    missing = (allow_missing,) if isinstance(allow_missing, str) else tuple(allow_missing)
    if not all(isinstance(name, str) for name in missing):
        raise TypeError(f'allow_missing is {allow_missing!r}; expected names: ("specular",)')
    chosen = None
    if isinstance(method, Method):
        if (steps, max_angle, antithetic) != (None, None, None):
            raise ArgumentError(
                "steps, max_angle and antithetic are part of a method that was chosen; give its "
                f'name with them: method="{method.name}"'
            )
        chosen = method.settings
        method = method.name
    if not isinstance(method, str):
        raise TypeError(f"method is {method!r}; expected a name, or the method of a result")
    sensors = scene._sensors()
    number = _sensor([name for name, _, _, _ in sensors], sensor)
    _, _, own_spp, own_seed = sensors[number]
    if independent:
        own_seed = LARGEST_SEED - own_seed
    asked = Options(
        sensor=number,
        aov=aov,
        spp=own_spp if spp is None else integer("spp", spp, 1, LARGEST_COUNT),
        seed=own_seed if seed is None else integer("seed", seed, 0, LARGEST_SEED),
        threads=None if threads is None else integer("threads", threads, 1, 1024),
        progress=progress,
        method=method,
        steps=None if steps is None else integer("steps", steps, 1, LARGEST_COUNT),
        max_angle=None if max_angle is None else real("max_angle", max_angle),
        antithetic=None if antithetic is None else bool(antithetic),
        chosen=chosen,
        allow_missing=missing,
    )
    # Here, not only when the first derivative is asked for.
    _capwalk.check_options(asked)
    if aov is None:
        # For the caller of what calls this.
        for warning in scene._light_warnings:
            warnings.warn(warning, SceneWarning, stacklevel=3)
    return asked


def sensor_number(scene: _capwalk.Scene, sensor: int | str) -> int:
    """The number of a sensor, from 0."""
    return _sensor([name for name, _, _, _ in scene._sensors()], sensor)


def integer(name: str, value: int, least: int, most: int) -> int:
    """An integer, also one of NumPy's, within its bounds."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is {value!r}; expected an integer") from None
    if not least <= number <= most:
        raise ArgumentError(f"{name} is {number}; expected {least} to {most}")
    return number


def real(name: str, value: float) -> float:
    """A number, also one of NumPy's."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {value!r}; expected a number") from None
    if not math.isfinite(number):
        raise ArgumentError(f"{name} is {number}; expected a finite number")
    return number


def _sensor(names: list[str], sensor: int | str) -> int:
    if isinstance(sensor, str):
        if sensor not in names:
            raise ArgumentError(f'there is no sensor "{sensor}"; there are {", ".join(names)}')
        return names.index(sensor)
    return integer("sensor", sensor, 0, len(names) - 1)

"""What every kind of work is asked for with, checked."""

from __future__ import annotations

import difflib
import math
import operator
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from . import _capwalk
from ._method import Method
from .errors import ArgumentError, SceneWarning
from .options import Sensor

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
    device: str = "cpu"
    method: str = "auto"
    steps: int | None = None
    max_angle: float | None = None
    antithetic: bool | None = None
    chosen: bytes | None = None
    """What a pilot has chosen, instead of the last four."""


def check_names(function: str, kind: type, given: Mapping[str, object]) -> None:
    """A `TypeError` for a keyword that is none of this kind's, as Python's own."""
    # Those of its bases, too.
    known = kind.__annotations__
    for name in given:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            hint = f". Did you mean '{near[0]}'?" if near else ""
            raise TypeError(f"{function}() got an unexpected keyword argument '{name}'{hint}")


def checked(
    scene: _capwalk.Scene,
    given: Mapping[str, Any],
    *,
    progress: Callable[[int, int], object] | None = None,
    threads: int | None = None,
    independent: bool = False,
) -> Options:
    """The options that keywords ask for; what is left out or ``None`` is as the scene's file says.
    The scene's own seed is made ``independent`` of that of an image, if asked for."""
    if not isinstance(scene, _capwalk.Scene):
        raise TypeError(
            f"the scene is a {type(scene).__name__}; expected what load_file or load_string give"
        )
    sensors = scene._sensors()
    number = _sensor([name for name, _, _, _ in sensors], given.get("sensor", 0))
    _, _, own_spp, own_seed = sensors[number]
    if independent:
        own_seed = _capwalk.independent_seed(own_seed)

    def count(name: str, least: int, most: int, otherwise: int | None = None) -> Any:
        value = given.get(name)
        return otherwise if value is None else integer(name, value, least, most)

    aov = given.get("aov")
    device = given.get("device", "cpu")
    if not isinstance(device, str):
        raise TypeError(f"device is {device!r}; expected a name")
    asked = Options(
        sensor=number,
        aov=aov,
        spp=count("spp", 1, LARGEST_COUNT, own_spp),
        seed=count("seed", 0, LARGEST_SEED, own_seed),
        threads=count("threads", 1, 1024, threads),
        progress=progress,
        device=device,
        **_method(given, count("steps", 1, LARGEST_COUNT)),
    )
    # Here, not only when the first derivative is asked for.
    _capwalk.check_options(asked)
    if aov is None:
        # For the caller of what calls this.
        for warning in scene._light_warnings:
            warnings.warn(warning, SceneWarning, stacklevel=3)
    return asked


def sensor_numbers(scene: _capwalk.Scene, name: str, sensors: Sequence[Sensor]) -> list[int]:
    """The numbers of several sensors, from 0; ``name`` is that of the argument."""
    if isinstance(sensors, str):
        raise TypeError(f"{name} is the string {sensors!r}; expected a list: [{sensors!r}]")
    if len(sensors) == 0:
        raise ArgumentError(f"{name} is empty; expected one sensor at least")
    return [_sensor([of for of, _, _, _ in scene._sensors()], sensor) for sensor in sensors]


def _method(given: Mapping[str, Any], steps: int | None) -> dict[str, Any]:
    """How derivatives are estimated, as fields of :class:`Options`."""
    method: str | Method = given.get("method", "auto")
    max_angle, antithetic = given.get("max_angle"), given.get("antithetic")
    if antithetic not in (None, True, False):
        raise TypeError(f"antithetic is {antithetic!r}; expected True or False")
    chosen = None
    if isinstance(method, Method):
        if (steps, max_angle, antithetic) != (None, None, None):
            raise ArgumentError(
                "steps, max_angle and antithetic are part of a method that was chosen; give its "
                f'name with them: method="{method.name}"'
            )
        chosen, method = method.settings, method.name
    if not isinstance(method, str):
        raise TypeError(f"method is {method!r}; expected a name, or the method of a result")
    return {
        "method": method,
        "steps": steps,
        "max_angle": None if max_angle is None else real("max_angle", max_angle),
        "antithetic": None if antithetic is None else bool(antithetic),
        "chosen": chosen,
    }


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

"""capwalk as an integrator of Mitsuba's."""

from __future__ import annotations

import re
from collections import OrderedDict
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from .. import _capwalk
from .._dictionary import load_dict
from .._functions import backward, gradient, render
from .._numbers import Array
from .._parameters import traverse
from ..errors import LoadError, ParameterError
from ._convert import Answers, convert, is_known
from ._converted import Converted, Description, Number, numbers
from ._tree import parts

# Scenes that are kept with their trees.
_MOST = 8

# Channels of a film from linear RGB, by what it calls its format.
_CHANNELS = {
    "rgb": np.eye(3),
    "y": np.array([[0.212671, 0.715160, 0.072169]]),
    "xyz": np.array(
        [
            [0.412453, 0.357580, 0.180423],
            [0.212671, 0.715160, 0.072169],
            [0.019334, 0.119193, 0.950227],
        ]
    ),
}


@dataclass
class _Kept:
    """A scene of Mitsuba's as capwalk's."""

    scene: _capwalk.Scene
    fingerprint: str
    numbers: dict[str, Array]
    """As they were last set."""


@dataclass(frozen=True)
class _View:
    """A scene as it is now, seen by one sensor."""

    scene: _capwalk.Scene
    converted: Converted
    sensor: Any
    channels: Array
    """Channels of the film from linear RGB."""

    def sampling(self, seed: Any, spp: int) -> dict[str, Any]:
        """What is asked for in all kinds of work."""
        return {
            "sensor": self.converted.objects[self.sensor],
            "spp": int(spp or self.sensor.sampler().sample_count()),
            "seed": int(np.asarray(seed).item()),
        }

    def image(self, rgb: Array) -> Any:
        """An image as Mitsuba has it."""
        return mi.TensorXf((rgb @ self.channels.T).astype(_float()))

    def differentiated(self) -> Iterator[tuple[Number, Any]]:
        """Numbers that are attached to Dr.Jit's graph, with their variables there."""
        by_place: dict[tuple[Any, str], list[Number]] = {}
        for number in self.converted.numbers:
            by_place.setdefault((number.owner, number.key), []).append(number)
        for owner, path in self.converted.objects.items():
            if isinstance(owner, mi.Sensor) and owner != self.sensor:
                continue
            values = parts(owner).values
            for key, value in values.items():
                variable = value.matrix if hasattr(value, "inverse_transpose") else value
                if not dr.grad_enabled(variable):
                    continue
                attached = by_place.get((owner, key), [])
                yield from ((number, variable) for number in attached)
                # Flat faces have their normals from the vertices.
                follows = key == "vertex_normals" and dr.grad_enabled(values["vertex_positions"])
                if not attached and not follows:
                    raise ParameterError(
                        f"{path}.{key} has no derivative in capwalk; disable its gradient"
                    )


class Scenes:
    """Scenes that are kept from call to call."""

    def __init__(self) -> None:
        self._kept: OrderedDict[tuple[int, int], _Kept] = OrderedDict()
        self._answers: Answers = {}

    def view(self, scene: Any, sensor: Any, integrator: Description) -> _View:
        """The scene as it is now. It is built anew only if more than its numbers has changed."""
        own = scene.sensors()
        if isinstance(sensor, int):
            sensor = own[sensor]
        channels = _channels(sensor)
        sensors = [other for other in own if other == sensor or is_known(other)]
        if sensor not in own:
            sensors.append(sensor)
        converted = convert(scene, sensors, integrator, self._answers)
        fingerprint, values = converted.fingerprint(), converted.values()
        # A scene that is gone may have had the same place: what is found is compared as a whole.
        place = (id(scene), 0 if sensor in own else id(sensor))
        kept = self._kept.get(place)
        if kept is None or kept.fingerprint != fingerprint:
            kept = _Kept(load_dict(converted.plain()), fingerprint, values)
            self._kept[place] = kept
        self._kept.move_to_end(place)
        while len(self._kept) > _MOST:
            self._kept.popitem(last=False)
        params = traverse(kept.scene)
        params.update(
            {
                name: np.broadcast_to(value, params[name].shape)
                for name, value in values.items()
                if not np.array_equal(value, kept.numbers[name])
            }
        )
        kept.numbers = values
        return _View(kept.scene, converted, sensor, channels)


def integrator_class() -> Any:
    """The integrator for the current variant."""
    if not str(mi.variant()).endswith(("_rgb", "_rgb_double")):
        return None

    class CapwalkIntegrator(mi.SamplingIntegrator):  # type: ignore[misc, unused-ignore]
        """Images and derivatives by capwalk."""

        def __init__(self, props: Any) -> None:
            level = mi.log_level()
            # Mitsuba warns that its own loops are slow in scalar variants. None of them runs.
            mi.set_log_level(mi.LogLevel.Error)
            super().__init__(props)
            mi.set_log_level(level)
            kind = props.get("integrator", "path")
            if kind not in ("path", "direct"):
                raise LoadError(
                    f'capwalk: integrator is {kind!r}; expected "path" or "direct"',
                    None,
                    None,
                    None,
                )
            self._description: Description = {"type": kind}
            self._description["hide_emitters"] = props.get("hide_emitters", False)
            # Defaults of Mitsuba's differentiable integrators.
            depths = {"max_depth": props.get("max_depth", 6), "rr_depth": props.get("rr_depth", 5)}
            if kind == "path":
                self._description |= depths
            self._threads: dict[str, Any] = {"threads": props.get("threads", 0) or None}
            self._how: dict[str, Any] = {"method": props.get("method", "auto"), **self._threads}
            self._scenes = Scenes()

        def render(
            self,
            scene: Any,
            sensor: Any = 0,
            seed: Any = 0,
            spp: int = 0,
            develop: bool = True,
            evaluate: bool = True,
        ) -> Any:
            if not develop:
                raise ValueError("develop is False; expected True: Mitsuba's films are not used")
            view = self._scenes.view(scene, sensor, self._description)
            image = render(view.scene, **view.sampling(seed, spp), **self._threads)
            return view.image(image.value)

        def render_forward(
            self, scene: Any, params: Any, sensor: Any = 0, seed: Any = 0, spp: int = 0
        ) -> Any:
            view = self._scenes.view(scene, sensor, self._description)
            ours = traverse(view.scene)
            along: dict[str, Array] = {}
            for number, variable in view.differentiated():
                velocity = number.ours(dr.grad(variable))
                if velocity.any():
                    along[number.name] = np.broadcast_to(velocity, ours[number.name].shape)
            if not along:
                width, height = (int(n) for n in view.sensor.film().crop_size())
                return view.image(np.zeros((height, width, 3)))
            derivative = gradient(view.scene, along, **view.sampling(seed, spp), **self._how)
            return view.image(derivative.gradient)

        def render_backward(
            self,
            scene: Any,
            params: Any,
            grad_in: Any,
            sensor: Any = 0,
            seed: Any = 0,
            spp: int = 0,
        ) -> None:
            view = self._scenes.view(scene, sensor, self._description)
            wanted = list(view.differentiated())
            if not wanted:
                return
            adjoint = numbers(grad_in) @ view.channels
            names = list(dict.fromkeys(number.name for number, _ in wanted))
            sampling = view.sampling(seed, spp)
            gradients = backward(view.scene, adjoint, names, **sampling, **self._how)
            for number, variable in wanted:
                ours = number.theirs(gradients[number.name])
                dr.accum_grad(variable, _like(variable, ours.astype(_float())))
                dr.enqueue(dr.ADMode.Backward, variable)
            dr.traverse(dr.ADMode.Backward)

        def to_string(self) -> str:
            return f"CapwalkIntegrator[{self._description | self._how}]"

    return CapwalkIntegrator


def _channels(sensor: Any) -> Array:
    found = re.search(r"pixel_format = (\w+)", str(sensor.film()))
    if found is None or found[1] not in _CHANNELS:
        name = "unknown" if found is None else found[1]
        raise LoadError(
            f"{sensor.id()}.film: Mitsuba's pixel_format {name} cannot be converted; expected rgb, "
            "luminance or xyz, without an alpha channel",
            None,
            None,
            None,
        )
    return _CHANNELS[found[1]]


def _like(variable: Any, array: Array) -> Any:
    """An array in the type of a variable."""
    kind = type(variable)
    if dr.is_tensor_v(kind):
        return kind(array)
    if dr.is_matrix_v(kind):
        return kind(array.reshape(*array.shape, 1))
    if dr.depth_v(kind) > 1:
        return kind(array.reshape(-1, 1))
    return kind(array.ravel())


def _float() -> Any:
    return np.float64 if str(mi.variant()).endswith("_double") else np.float32

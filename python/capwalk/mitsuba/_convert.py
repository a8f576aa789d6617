"""Loaded scenes of Mitsuba's as dictionaries. What cannot be told exactly is refused by name."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from .._numbers import Array
from ..errors import LoadError
from . import _bitmap, _normals
from ._converted import Converted, Description, Number, numbers
from ._tree import Parts, parts, paths

Answer = tuple[Any, ...]
Answers = dict[tuple[Any, str], Answer]
"""What was found out about objects, by object and question; ``None`` for what was not."""


def convert(
    scene: Any,
    sensors: Sequence[Any],
    integrator: Description,
    answers: Answers | None = None,
) -> Converted:
    """A loaded scene, seen by some sensors.

    :param answers: from the last time. What is found out is added, what is about objects of
        other scenes is removed.
    :raises LoadError: capwalk cannot render an object of it; the message has its name.
    """
    answers = {} if answers is None else answers
    converted = _Converter(scene, sensors, integrator, answers).converted
    for about in [about for about in answers if about[0] not in converted.objects]:
        del answers[about]
    return converted


def is_known(sensor: Any) -> bool:
    """True if a sensor is of a kind that can be converted."""
    film = sensor.film()
    return (
        sensor.class_name() in _SENSORS
        and film.class_name() == "HDRFilm"
        and film.rfilter().class_name() in _FILTERS
    )


# Mitsuba's class, the plugin, and what only the text of an object says.
_BSDFS: dict[str, tuple[str, tuple[str, ...]]] = {
    "SmoothDiffuse": ("diffuse", ()),
    "SmoothConductor": ("conductor", ()),
    "RoughConductor": ("roughconductor", ("distribution",)),
    "SmoothDielectric": ("dielectric", ()),
    "ThinDielectric": ("thindielectric", ()),
    "RoughDielectric": ("roughdielectric", ("distribution",)),
    "SmoothPlastic": ("plastic", ("nonlinear",)),
    "RoughPlastic": ("roughplastic", ("distribution", "nonlinear")),
    "Principled": ("principled", ()),
    "Null": ("null", ()),
    "TwoSidedBRDF": ("twosided", ()),
    "MaskBSDF": ("mask", ()),
    "BlendBSDF": ("blendbsdf", ()),
    "NormalMap": ("normalmap", ()),
    "BumpMap": ("bumpmap", ()),
}

_SHAPES = {"Sphere": "sphere", "Rectangle": "rectangle", "Disk": "disk"}

_SENSORS = {
    "PerspectiveCamera": "perspective",
    "ThinLensCamera": "thinlens",
    "OrthographicCamera": "orthographic",
}

# The plugin, its parameter, and how many times the radius this is.
_FILTERS = {
    "BoxFilter": ("box", "", 0.0),
    "TentFilter": ("tent", "radius", 1.0),
    "GaussianFilter": ("gaussian", "stddev", 0.25),
}

# What a face's normal and those of its vertices may differ by, as cosines, if it is flat: the
# rounding of single precision.
_FLAT = 1e-5


class _Converter:
    def __init__(
        self, scene: Any, sensors: Sequence[Any], integrator: Description, answers: Answers
    ) -> None:
        self._answers = answers
        self._paths = paths(scene)
        self.converted = Converted({"type": "scene", "integrator": integrator})
        # Those that are written already, and can be referred to.
        self._textures: set[Any] = set()
        described = self.converted.description
        for i, sensor in enumerate(sensors):
            # Not all stand in the scene.
            self._paths.setdefault(sensor, f"sensor_{len(self._paths)}")
            described[f"sensor_{i}"] = self._sensor(sensor)
        for i, shape in enumerate(scene.shapes()):
            described[f"shape_{i}"] = self._shape(shape)
        for i, emitter in enumerate(scene.emitters()):
            # The others came with their shapes.
            if emitter.class_name() != "AreaLight":
                described[f"emitter_{i}"] = self._emitter(emitter)

    def _begin(self, owner: Any, plugin: str) -> tuple[str, Parts, Description]:
        path = self._paths[owner]
        self.converted.objects[owner] = path
        return path, parts(owner), {"type": plugin, "id": path}

    def _number(
        self, owner: Any, key: str, name: str, value: Any, shape: tuple[int, ...]
    ) -> Number:
        number = Number(owner, key, name, numbers(value).reshape(shape))
        self.converted.numbers.append(number)
        return number

    def _sensor(self, sensor: Any) -> Description:
        path, own, described = self._begin(sensor, self._plugin(sensor, "sensor", _SENSORS))
        self._no_medium(path, sensor.get_medium())
        described["to_world"] = self._matrix(sensor, path, own)
        for key in (
            "near_clip",
            "far_clip",
            "principal_point_offset_x",
            "principal_point_offset_y",
        ):
            if key in own.values:
                described[key] = float(numbers(own.values[key]).item())
        for key, ours in (("x_fov", "fov"), ("aperture_radius",) * 2, ("focus_distance",) * 2):
            if key in own.values:
                value = own.values[key]
                described[ours] = self._number(sensor, key, f"{path}.{key}", value, ())
        if "fov" in described:
            described["fov_axis"] = "x"
        described["film"] = self._film(f"{path}.film", sensor.film())
        sampler = sensor.sampler()
        # Those that divide a pixel into cells have the same mean.
        independent = sampler.class_name() == "IndependentSampler"
        described["sampler"] = {
            "type": "independent" if independent else "ldsampler",
            "sample_count": int(sampler.sample_count()),
        }
        return described

    def _film(self, path: str, film: Any) -> Description:
        if film.class_name() != "HDRFilm":
            raise _refused(path, film, "expected an hdrfilm")
        plugin, parameter, factor = self._plugin(film.rfilter(), "rfilter", _FILTERS, path)
        rfilter: Description = {"type": plugin}
        if parameter:
            rfilter[parameter] = factor * float(film.rfilter().radius())
        size, crop, offset = (
            [int(x) for x in numbers(corner).ravel()]
            for corner in (film.size(), film.crop_size(), film.crop_offset())
        )
        described: Description = {"type": "hdrfilm", "rfilter": rfilter}
        described["sample_border"] = bool(film.sample_border())
        for i, side in enumerate(("width", "height")):
            described[side] = size[i]
            described[f"crop_{side}"] = crop[i]
            described[f"crop_offset_{'xy'[i]}"] = offset[i]
        return described

    def _shape(self, shape: Any) -> Description:
        plugin = "mesh" if shape.is_mesh() else "shape"
        plugin = _SHAPES.get(shape.class_name(), plugin)
        if plugin == "shape":
            expected = "expected a mesh, a sphere, a rectangle or a disk"
            raise _refused(self._paths[shape], shape, expected)
        path, own, described = self._begin(shape, plugin)
        self._no_medium(path, shape.interior_medium() or shape.exterior_medium())
        if shape.is_sensor():
            raise _refused(path, shape.sensor(), "remove the sensor from the shape")
        if plugin == "mesh":
            self._mesh(shape, path, own, described)
        else:
            described["to_world"] = self._matrix(shape, path, own)
        # Mitsuba has turned a sphere inside out by now, and a disk around.
        mirrored = plugin == "sphere" and np.linalg.det(numbers(own.values["to_world"])[:3, :3]) < 0
        flipped = plugin != "disk" and bool(shape.has_flipped_normals()) != bool(mirrored)
        described["flip_normals"] = flipped
        described["bsdf"] = self._bsdf(shape.bsdf())
        emitter = shape.emitter()
        if emitter is not None:
            described["emitter"] = self._area(emitter)
        return described

    def _mesh(self, mesh: Any, path: str, own: Parts, described: Description) -> None:
        positions = self._number(
            mesh, "vertex_positions", f"{path}.positions", own.values["vertex_positions"], (-1, 3)
        )
        faces = numbers(own.values["faces"]).reshape(-1, 3).astype(np.int64)
        described |= {"positions": positions, "faces": faces}
        normals = numbers(own.values["vertex_normals"]).reshape(-1, 3)
        # Where vertices part, normals that faces share turn with all of them.
        moves = any(dr.grad_enabled(own.values[key]) for key in ("vertex_positions", "vertex_normals"))
        shared = len(faces) > 0 and np.bincount(faces.ravel()).max() > 1
        described["face_normals"] = bool(
            mesh.has_face_normals()
            or not len(normals)
            or (_is_flat(positions.value, faces, normals) and not (moves and shared))
        )
        if not described["face_normals"]:
            described["normals"] = self._number(
                mesh, "vertex_normals", f"{path}.normals", normals, (-1, 3)
            )
        uvs = numbers(own.values["vertex_texcoords"]).reshape(-1, 2)
        if len(uvs):
            described["uvs"] = uvs
        counts = {"vertex": len(positions.value), "face": len(faces)}
        for key, value in own.values.items():
            if key.startswith(("vertex_", "face_")) and key not in _BUFFERS:
                rows = counts[key.split("_")[0]]
                attribute = numbers(value).reshape(rows, -1)
                if attribute.shape[1] in (1, 3):
                    described[key] = self._number(
                        mesh, key, f"{path}.{key}", attribute, attribute.shape
                    )

    def _matrix(self, owner: Any, path: str, own: Parts) -> Number:
        value = own.values["to_world"]
        return self._number(owner, "to_world", f"{path}.to_world", value, (4, 4))

    def _bsdf(self, bsdf: Any) -> Description:
        if bsdf in self.converted.objects:
            return {"type": "ref", "id": self.converted.objects[bsdf]}
        plugin, words = self._plugin(bsdf, "bsdf", _BSDFS)
        path, own, described = self._begin(bsdf, plugin)
        for word in words:
            described[word] = self._word(bsdf, word)
        for key, value in own.values.items():
            if key.endswith("_sampling_rate"):
                continue
            ours = "int_ior" if key == "eta" and plugin != "principled" else key
            described[ours] = self._number(bsdf, key, f"{path}.{ours}.value", value, ())
            if ours == "int_ior":
                # Mitsuba keeps the ratio.
                described["ext_ior"] = 1.0
        for key, child in own.objects.items():
            if isinstance(child, mi.BSDF):
                described[key] = self._bsdf(child)
            else:
                described[key] = self._texture(child, f"{path}.{key}")
        if plugin in ("normalmap", "bumpmap"):
            texture = own.objects["normalmap" if plugin == "normalmap" else "nested_texture"]
            nested = own.objects["nested_bsdf"]
            stored = parts(texture).values.get("data")
            data = None if stored is None else _bitmap.texels(texture, stored, raw=True)
            flips, shadows = self._answer(
                bsdf, "limits", lambda: _normals.limits(bsdf, nested, texture, data)
            )
            described["flip_invalid_normals"] = flips is not False
            described["use_shadowing_function"] = shadows is not False
        return described

    def _answer(self, owner: Any, question: str, ask: Callable[[], Answer]) -> Answer:
        """What asking says, which does not change once it is known."""
        known = self._answers.get((owner, question))
        if known is None or None in known:
            # As long as the numbers are such that it makes no difference.
            known = self._answers[owner, question] = ask()
        return known

    def _texture(self, texture: Any, slot: str) -> Any:
        """What stands in a slot with this name: a texture, a colour or a number."""
        kind = texture.class_name()
        value = parts(texture).values.get("value")
        self.converted.objects.setdefault(texture, self._paths.get(texture, slot))
        if kind == "UniformSpectrum":
            return self._number(texture, "value", f"{slot}.value", value, ())
        if kind == "SRGBReflectanceSpectrum":
            colour = self._number(texture, "value", f"{slot}.value", value, (3,))
            return {"type": "rgb", "value": colour}
        if kind == "MeshAttribute":
            return self._mesh_attribute(texture)
        if texture in self._textures:
            return {"type": "ref", "id": self._paths[texture]}
        self._textures.add(texture)
        if kind.startswith("BitmapTexture"):
            return self._bitmap(texture)
        if kind == "Checkerboard":
            path, own, described = self._begin(texture, "checkerboard")
            described["to_uv"] = numbers(own.values["to_uv"]).reshape(3, 3)
            for key, child in own.objects.items():
                described[key] = self._texture(child, f"{path}.{key}")
            return described
        expected = "expected a colour, a bitmap, a checkerboard or an attribute of a mesh"
        raise _refused(self._paths.get(texture, slot), texture, expected)

    def _bitmap(self, texture: Any) -> Description:
        path, own, described = self._begin(texture, "bitmap")
        raw = self._word(texture, "raw")
        data = _bitmap.texels(texture, own.values["data"], raw=bool(raw))
        described["data"] = self._number(texture, "data", f"{path}.data", data, data.shape)
        described["raw"] = True
        described["to_uv"] = numbers(own.values["to_uv"]).reshape(3, 3)
        lookup, wrap = self._answer(
            texture,
            "lookup",
            lambda: (_bitmap.filter_type(texture, data), _bitmap.wrap_mode(texture, data)),
        )
        described["filter_type"] = lookup or "bilinear"
        described["wrap_mode"] = wrap or "repeat"
        return described

    def _mesh_attribute(self, texture: Any) -> Description:
        _, own, described = self._begin(texture, "mesh_attribute")
        # Written without an id: it is another texture on every shape.
        del described["id"]
        described["name"] = self._word(texture, "name")
        described["scale"] = float(numbers(own.values["scale"]).item())
        return described

    def _area(self, emitter: Any) -> Description:
        if emitter.class_name() != "AreaLight":
            raise _refused(self._paths[emitter], emitter, "expected an area emitter")
        path, own, described = self._begin(emitter, "area")
        del described["id"]
        self._is_sampled(emitter, path, own)
        described["radiance"] = self._texture(own.objects["radiance"], f"{path}.radiance")
        return described

    def _emitter(self, emitter: Any) -> Description:
        kinds = {
            "ConstantBackgroundEmitter": "constant",
            "EnvironmentMapEmitter": "envmap",
            "PointLight": "point",
            "SpotLight": "spot",
            "DirectionalEmitter": "directional",
        }
        plugin = self._plugin(emitter, "emitter", kinds)
        path, own, described = self._begin(emitter, plugin)
        self._is_sampled(emitter, path, own)
        for key, child in own.objects.items():
            if key == "texture":
                # Without one Mitsuba makes one of 1.
                if child.class_name() != "UniformSpectrum" or _value(child) != 1.0:
                    raise _refused(path, child, "remove the texture of the spot light")
                continue
            described[key] = self._texture(child, f"{path}.{key}")
        for key, value in own.values.items():
            if key == "sampling_weight":
                continue
            if key == "to_world":
                described[key] = numbers(value).reshape(4, 4)
            elif key == "position":
                described[key] = numbers(value).reshape(3)
            elif key == "data":
                data = numbers(value)[:, 1:-1]
                number = Number(emitter, key, f"{path}.data", data, halo=True)
                self.converted.numbers.append(number)
                described[key] = number
            else:
                described[key] = self._number(emitter, key, f"{path}.{key}.value", value, ())
        return described

    def _is_sampled(self, emitter: Any, path: str, own: Parts) -> None:
        # Other weights change the noise alone.
        if numbers(own.values["sampling_weight"]).item() <= 0.0:
            raise _refused(path, emitter, "its sampling_weight is 0; expected a number above")

    def _plugin(self, owner: Any, kind: str, known: Mapping[str, Any], path: str = "") -> Any:
        name = owner.class_name()
        if name not in known:
            plugins = sorted(p if isinstance(p, str) else p[0] for p in known.values())
            path = path or self._paths.get(owner, kind)
            raise _refused(path, owner, f"expected one of {', '.join(plugins)}")
        return known[name]

    def _word(self, owner: Any, name: str) -> Any:
        """What the text of an object says of a property that it tells nowhere else."""
        found = re.search(rf'^ ? ?{name} = "?([^\s",]+)"?,?$', str(owner), re.MULTILINE)
        if found is None:
            raise _refused(self._paths[owner], owner, f"its {name} cannot be told")
        return {"0": False, "1": True}.get(found[1], found[1])

    def _no_medium(self, path: str, medium: Any) -> None:
        if medium is not None:
            raise _refused(path, medium, "media are not rendered; remove it")


_BUFFERS = ("vertex_positions", "vertex_normals", "vertex_texcoords")


def _is_flat(positions: Array, faces: Any, normals: Array) -> bool:
    a, b, c = (positions[faces[:, i]] for i in range(3))
    crosses = np.cross(b - a, c - a)
    lengths = np.linalg.norm(crosses, axis=1)
    # A triangle without area has no normal.
    crosses, faces = crosses[lengths > 0] / lengths[lengths > 0, np.newaxis], faces[lengths > 0]
    cosines = np.einsum("fi,fci->fc", crosses, normals[faces])
    return bool((cosines > 1.0 - _FLAT).all())


def _value(texture: Any) -> float:
    return float(numbers(parts(texture).values["value"]).item())


def _refused(path: str, owner: Any, reason: str) -> LoadError:
    name = type(owner).__name__ if not hasattr(owner, "class_name") else owner.class_name()
    return LoadError(f"{path}: Mitsuba's {name} cannot be converted; {reason}", None, None, None)

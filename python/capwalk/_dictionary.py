"""Scenes as Mitsuba's dictionaries: written as Mitsuba's XML, and then read like a file."""

from __future__ import annotations

import difflib
import json
import os
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from numbers import Integral, Real
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from . import _capwalk
from ._functions import warned
from ._numbers import Array
from .errors import LoadError

Scene = _capwalk.Scene

# The tag of each plugin. All of Mitsuba 3, so that what cannot be rendered is refused by name.
_PLUGINS = {
    plugin: tag
    for tag, plugins in {
        "integrator": "aov depth direct direct_projective direct_reparam moment path prb prb_basic "
        "prb_projective prb_reparam prbvolpath ptracer stokes volpath volpathmis volprim_rf_basic",
        "sensor": "batch distant irradiancemeter orthographic perspective radiancemeter thinlens",
        "film": "hdrfilm specfilm",
        "rfilter": "box catmullrom gaussian lanczos mitchell tent",
        "sampler": "independent ldsampler multijitter orthogonal sobol stratified",
        "shape": "blender bsplinecurve cube cylinder disk ellipsoids ellipsoidsmesh gltf instance "
        "linearcurve merge mesh obj ply rectangle sdfgrid serialized shapegroup sphere",
        "bsdf": " ".join(_capwalk.bsdf_plugins()),
        "emitter": "area constant directional directionalarea envmap point projector spot sunsky "
        "timed_sunsky",
        "texture": "bitmap blackbody checkerboard d65 gltf_texture irregular mesh_attribute "
        "rawconstant regular srgb uniform volume",
        "volume": "constvolume gridvolume",
        "medium": "heterogeneous homogeneous",
        "phase": "blendphase hg isotropic rayleigh sggx tabphase",
    }.items()
    for plugin in plugins.split()
}

# What is no plugin.
_VALUES = ("rgb", "spectrum", "ref", "resources")

# As in scene files.
_DEEPEST = 30

# A property: its name, its value, and where this stands in the dictionary.
_Entry = tuple[str, object, str]


def load_dict(dictionary: Mapping[str, object], *, folder: str | os.PathLike[str] = ".") -> Scene:
    """The scene in a dictionary as ``mitsuba.load_dict`` takes it. Mitsuba is not needed.

    >>> import capwalk as cw
    >>> view = cw.Transform().look_at(origin=[0, 1, 5], target=[0, 0, 0], up=[0, 1, 0])
    >>> scene = cw.load_dict({
    ...     "type": "scene",
    ...     "integrator": {"type": "path", "max_depth": 3},
    ...     "sensor": {"type": "perspective", "fov": 30, "to_world": view},
    ...     "ball": {
    ...         "type": "sphere",
    ...         "bsdf": {"type": "diffuse", "reflectance": 0.8},
    ...     },
    ...     "sky": {"type": "constant"},
    ... })
    >>> "ball.positions" in cw.traverse(scene)
    True

    Keys are the names of objects, unless these have an ``"id"``. Numbers, vectors, matrices and
    texels may be Python's, NumPy's or Mitsuba's. Transforms are (4, 4), or have a ``matrix``, like
    :class:`Transform` and Mitsuba's. Beyond scene files:

    * textures of the type ``"bitmap"`` and emitters of the type ``"envmap"`` may have, instead of
      a ``"filename"``, a ``"bitmap"``, an array (height, width) or (height, width, channels) whose
      8-bit numbers are decoded from sRGB unless it is ``"raw"``, or ``"data"``, which are linear;
    * shapes of the type ``"mesh"``, such as :func:`load_mesh` gives, have ``"positions"``, (V, 3),
      world units, ``"faces"``, (F, 3), and perhaps ``"normals"``, (V, 3), ``"uvs"``, (V, 2), and
      attributes ``"vertex_..."``, (V, 1) or (V, 3), and ``"face_..."``, (F, 1) or (F, 3).

    Properties that have no effect, or are read as something else, give a :class:`SceneWarning`.

    :param folder: the folder to which file names are relative.
    :raises LoadError: the dictionary is not a scene. The message begins with the place:
        ``dictionary["ball"]["bsdf"]``.
    """
    with tempfile.TemporaryDirectory(prefix="capwalk-") as files:
        writer = _Writer(dictionary, Path(files))
        return warned(_loaded("\n".join(writer.lines), os.fspath(folder), writer.places))


def _loaded(text: str, folder: str, places: list[str]) -> Scene:
    return _capwalk.load_lines(text, folder, places)


class _Writer:
    """A dictionary as lines of XML."""

    lines: list[str]
    places: list[str]
    """Where in the dictionary each line comes from."""

    def __init__(self, dictionary: Mapping[str, object], files: Path) -> None:
        self.lines, self.places = [], []
        self._files = files
        # What a reference may say, and the id that this has in the text.
        self._ids: dict[str, str] = {}
        # Ids that only paths give are written where something refers to them.
        self._wanted: set[str] = set()
        root = "dictionary"
        if not isinstance(dictionary, Mapping):
            raise _error(root, f"is {_shown(dictionary)}", "expected a dictionary")
        if dictionary.get("type", "scene") != "scene":
            raise _error(
                f'{root}["type"]',
                f"is {_shown(dictionary['type'])}",
                'expected "scene"; put the object into {"type": "scene", ...}',
            )
        self._find_ids(dictionary, "", root)
        self._line(root, '<scene version="3.0.0">')
        for key, value, place in _entries(dictionary, root):
            self._property(key, value, place, key, top=True)
        self._line(root, "</scene>")

    def _find_ids(self, parent: Mapping[str, object], prefix: str, above: str) -> None:
        if prefix.count(".") > _DEEPEST:
            raise _error(above, f"is nested more than {_DEEPEST} deep", "scenes need six levels")
        for key, value, place in _entries(parent, above):
            if not isinstance(value, Mapping):
                continue
            path = f"{prefix}{key}"
            if value.get("type") == "ref":
                self._wanted.add(_text(value.get("id"), place))
            if value.get("type") in _VALUES:
                continue
            own = _text(value.get("id", path), place)
            for name in {path, own}:
                if self._ids.setdefault(name, own) != own:
                    raise _error(place, f'the id "{name}" is taken', "give each object its own id")
            self._find_ids(value, f"{path}.", place)

    def _property(self, key: str, value: object, place: str, path: str, *, top: bool) -> None:
        """Writes what a key means. Objects in the scene itself are called by it."""
        if isinstance(value, Mapping):
            if "type" not in value:
                raise _error(place, "has no type", 'add "type", the name of a plugin')
            match value["type"]:
                case "ref":
                    self._reference(key, value, place, top=top)
                case "rgb" | "spectrum":
                    self._colour(key, value, place)
                case "resources":
                    self._line(place, _tag("path", value=_text(value.get("path"), place)))
                case _:
                    self._object(key, value, place, path, top=top)
            return
        if _is_object(value):
            raise _error(
                place, f"is {_shown(value)}, an object of Mitsuba's", "give its dictionary"
            )
        self._line(place, _value(key, value, place))

    def _object(
        self, key: str, value: Mapping[str, object], place: str, path: str, *, top: bool
    ) -> None:
        plugin = value["type"]
        if not isinstance(plugin, str) or plugin not in _PLUGINS:
            near = difflib.get_close_matches(str(plugin), [*_PLUGINS, *_VALUES], 3)
            raise _error(
                place,
                f"unknown plugin {_shown(plugin)}",
                f"did you mean {' or '.join(map(_shown, near))}?"
                if near
                else "expected the name of one of Mitsuba's plugins",
            )
        tag = _PLUGINS[plugin]
        entries = list(_entries(value, place))
        if plugin == "mesh":
            plugin, entries = "ply", self._mesh(entries, place)
        elif plugin in ("bitmap", "envmap"):
            entries = self._bitmap(entries, place)
        attributes = {"type": plugin}
        if "id" in value or top or path in self._wanted:
            attributes["id"] = self._ids[path]
        if not top:
            attributes["name"] = key
        self._line(place, _tag(tag, attributes, open=True))
        for name, child, where in entries:
            self._property(name, child, where, f"{path}.{name}", top=False)
        self._line(place, f"</{tag}>")

    def _reference(self, key: str, value: Mapping[str, object], place: str, *, top: bool) -> None:
        _only(value, ("type", "id"), place)
        wanted = _text(value.get("id"), place)
        if wanted not in self._ids:
            near = difflib.get_close_matches(wanted, self._ids, 3)
            raise _error(
                place,
                f'there is no object with the id "{wanted}"',
                f"did you mean {' or '.join(map(_shown, near))}?"
                if near
                else "give the key or the id of an object",
            )
        name = {} if top else {"name": key}
        self._line(place, _tag("ref", name, id=self._ids[wanted]))

    def _colour(self, key: str, value: Mapping[str, object], place: str) -> None:
        kind = str(value["type"])
        _only(value, ("type", "value") if kind == "rgb" else ("type", "value", "filename"), place)
        if "filename" in value:
            filename = _text(value["filename"], place)
            self._line(place, _tag("spectrum", name=key, filename=filename))
            return
        given = value.get("value")
        numbers = _numbers(given, place, "expected numbers")
        if kind == "spectrum" and numbers.ndim == 2 and numbers.shape[1] == 2:
            text = ", ".join(f"{wavelength!r}:{x!r}" for wavelength, x in numbers.tolist())
        elif numbers.shape in ((), (1,)) or (kind == "rgb" and numbers.shape == (3,)):
            text = _joined(numbers)
        else:
            expected = "three numbers or one" if kind == "rgb" else "one number"
            raise _error(place, f"has the shape {numbers.shape}", f"expected {expected}")
        self._line(place, _tag(kind, name=key, value=text))

    def _mesh(self, entries: list[_Entry], place: str) -> list[_Entry]:
        """Writes the arrays of a mesh to a file."""
        arrays, faces, kept = mesh_arrays(entries, place)
        file = self._file("ply")
        _capwalk.write_mesh(str(file), arrays, faces)
        return [("filename", str(file), place), *kept]

    def _bitmap(self, entries: list[_Entry], place: str) -> list[_Entry]:
        """Writes the texels of a bitmap to a file."""
        arrays = [entry for entry in entries if entry[0] in ("bitmap", "data")]
        if not arrays:
            return entries
        if len(arrays) > 1 or any(name == "filename" for name, _, _ in entries):
            raise _error(place, "has more than one image", "give a filename, a bitmap or data")
        [(name, value, where)] = arrays
        raw = name == "data" or any(name == "raw" and value for name, value, _ in entries)
        file = self._file("exr")
        _capwalk.write_images(str(file), [("value", _texels(value, where, raw=raw))], [], [], None)
        kept = [entry for entry in entries if entry is not arrays[0]]
        return [("filename", str(file), where), *kept]

    def _file(self, ending: str) -> Path:
        return self._files / f"{len(self.lines)}.{ending}"

    def _line(self, place: str, text: str) -> None:
        self.lines.append(text)
        self.places.append(place)


# Numbers in a row, where an array is no attribute.
_WIDTHS = {"positions": (3,), "faces": (3,), "normals": (3,), "uvs": (2,)}


def mesh_arrays(
    entries: Sequence[_Entry], place: str
) -> tuple[list[tuple[str, Array]], NDArray[np.uint32], list[_Entry]]:
    """The arrays of a mesh by their names, its faces, and the entries that are none of them."""
    arrays = {name: (value, where) for name, value, where in entries if _is_of_mesh(name)}
    for name in ("positions", "faces"):
        if name not in arrays:
            raise _error(place, f"has no {name}", f'add "{name}", an array (n, 3)')
    read = {name: _rows(name, *arrays[name]) for name in ("positions", "faces")}
    vertices, faces = len(read["positions"]), read["faces"]
    if (faces < 0).any() or (faces >= vertices).any() or (faces % 1 != 0).any():
        expected = f"expected whole numbers from 0 to {vertices - 1}"
        raise _error(arrays["faces"][1], "names other vertices than there are", expected)
    for name, (value, where) in arrays.items():
        count = len(faces) if name.startswith("face") else vertices
        read[name] = _rows(name, value, where, count)
    kept = [entry for entry in entries if entry[0] not in arrays]
    indices = read.pop("faces").astype(np.uint32)
    return list(read.items()), indices, kept


def _is_of_mesh(name: str) -> bool:
    is_attribute = name.startswith(("vertex_", "face_")) and name != "face_normals"
    return name in _WIDTHS or is_attribute


def _rows(name: str, value: object, place: str, count: int | None = None) -> Array:
    """An array of a mesh, with so many rows if that is known."""
    rows = _numbers(value, place, "expected an array of numbers")
    widths = _WIDTHS.get(name, (1, 3))
    if rows.ndim != 2 or rows.shape[1] not in widths or count not in (None, len(rows)):
        shapes = " or ".join(f"({'n' if count is None else count}, {width})" for width in widths)
        raise _error(place, f"has the shape {rows.shape}", f"expected {shapes}")
    return rows


def _entries(parent: Mapping[str, object], place: str) -> Iterator[_Entry]:
    """What an object has besides its type and id."""
    for key, value in parent.items():
        if not isinstance(key, str):
            raise _error(place, f"has the key {_shown(key)}", "expected strings as keys")
        if key in ("type", "id"):
            continue
        if "." in key:
            # As in Mitsuba.
            raise _error(
                place, f"the key {_shown(key)} contains a dot", "dots separate the names of paths"
            )
        yield key, value, f"{place}[{json.dumps(key, ensure_ascii=False)}]"


def _value(name: str, value: object, place: str) -> str:
    """The element of a property that is no object."""
    if isinstance(value, (bool, np.bool_)):
        return _tag("boolean", name=name, value=str(bool(value)).lower())
    if isinstance(value, Integral):
        return _tag("integer", name=name, value=str(int(value)))
    if isinstance(value, (str, os.PathLike)):
        return _tag("string", name=name, value=_text(value, place))
    expected = "expected a dictionary, a number, a boolean, a string, three numbers, or a transform"
    # Mitsuba's vectors have something else called "matrix".
    is_array = hasattr(value, "__array__")
    numbers = _numbers(value if is_array else getattr(value, "matrix", value), place, expected)
    if numbers.ndim > 1 and numbers.shape[-1] == 1:
        # A value of Mitsuba's vectorized variants.
        numbers = numbers[..., 0]
    match numbers.shape:
        case () | (1,):
            return _tag("float", name=name, value=_joined(numbers))
        case (3,):
            tag = "rgb" if "Color3" in type(value).__name__ else "vector"
            return _tag(tag, name=name, value=_joined(numbers))
        case (3, 3) if name == "to_uv":
            # Of the plane, with the translation in its last column.
            whole = np.eye(4)
            whole[np.ix_((0, 1, 3), (0, 1, 3))] = numbers
            numbers = whole
        case (4, 4):
            pass
        case shape:
            raise _error(place, f"is an array of the shape {shape}", expected)
    matrix = _tag("matrix", value=_joined(numbers.ravel()))
    return f"{_tag('transform', open=True, name=name)}{matrix}</transform>"


def _numbers(value: object, place: str, expected: str) -> Array:
    """An array of finite numbers."""
    array: NDArray[Any]
    try:
        array = np.asarray(value)
    except (TypeError, ValueError):
        raise _error(place, f"is {_shown(value)}", expected) from None
    if array.dtype.kind not in "buif":
        raise _error(place, f"is {_shown(value)}", expected)
    array = array.astype(np.float64)
    wrong = array[~np.isfinite(array)]
    if wrong.size:
        what = "is" if array.size == 1 else f"contains {wrong.size} times"
        raise _error(place, f"{what} {wrong[0]}", "expected finite numbers")
    return array


def _is_object(value: object) -> bool:
    """True if a value is a plugin of Mitsuba's, rather than numbers."""
    return hasattr(value, "class_name") and hasattr(value, "traverse")


def _texels(value: object, place: str, *, raw: bool) -> Array:
    """Linear colours, (height, width, 3)."""
    expected = "expected an array (height, width) or (height, width, channels)"
    pixels = np.asarray(value)
    numbers = _numbers(pixels, place, expected)
    if numbers.ndim == 2:
        numbers = numbers[..., np.newaxis]
    if numbers.ndim != 3 or not 1 <= numbers.shape[2] <= 4 or not numbers.size:
        raise _error(place, f"has the shape {numbers.shape}", expected)
    if pixels.dtype.kind == "i":
        expected = "expected bytes (uint8) or floating point"
        raise _error(place, f"is an image of {pixels.dtype}", expected)
    if "XYZ" in str(getattr(value, "pixel_format", str)()):
        raise _error(place, "has colours in XYZ", "convert it to RGB")
    # Without a word about it, bytes are encoded and all else is linear.
    encoded = getattr(value, "srgb_gamma", lambda: pixels.dtype == np.uint8)()
    if pixels.dtype.kind == "u":
        numbers = numbers / np.iinfo(pixels.dtype).max
    if encoded and not raw:
        bright = ((numbers.clip(0.0) + 0.055) / 1.055) ** 2.4
        numbers = np.where(numbers <= 0.04045, numbers / 12.92, bright)
    # Two channels are grey and opacity, four are a colour and opacity, which has no effect.
    colours = numbers[..., :3] if numbers.shape[2] > 2 else numbers[..., :1]
    return np.ascontiguousarray(np.broadcast_to(colours, (*colours.shape[:2], 3)))


def _tag(
    tag: str, attributes: Mapping[str, str] | None = None, *, open: bool = False, **more: str
) -> str:
    attributes = {**(attributes or {}), **more}
    # A dollar sign would be a parameter.
    texts = (f" {name}={quoteattr(text)}" for name, text in attributes.items())
    return f"<{tag}{''.join(texts)}{'' if open else '/'}>".replace("$", "\\$")


def _text(value: object, place: str) -> str:
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if not isinstance(value, str):
        raise _error(place, f"is {_shown(value)}", "expected a string")
    return value


def _joined(numbers: Array) -> str:
    return ", ".join(map(repr, numbers.ravel().tolist()))


def _only(value: Mapping[str, object], known: tuple[str, ...], place: str) -> None:
    for key in value:
        if key not in known:
            has = ", ".join(map(_shown, known))
            raise _error(place, f"unknown key {_shown(key)}", f"its keys are {has}")


def _shown(value: object) -> str:
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if value is None or isinstance(value, (Real, complex)):
        return repr(value)
    return f"a {type(value).__name__}"


def _error(place: str, problem: str, help: str) -> LoadError:
    return LoadError(f"{place}: {problem}\n  {help}", None, None, None)

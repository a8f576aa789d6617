"""Meshes and images in files, as arrays."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from numpy.typing import ArrayLike

from . import _capwalk
from ._dictionary import mesh_arrays
from ._glb import ATTRIBUTES, glb_bytes
from ._numbers import Array, numbers
from ._obj import KEYWORDS, obj_bytes
from ._options import LARGEST_COUNT, integer
from .errors import ArgumentError, LoadError, MeshError, SceneWarning

_WRITERS = {".obj": (KEYWORDS, obj_bytes), ".glb": (ATTRIBUTES, glb_bytes)}
"""What of a mesh a format has a place for, by names and numbers in a row, and the bytes of a file. The
module writes ``.ply`` files, which have a place for all arrays."""


def load_mesh(
    path: str | os.PathLike[str],
    *,
    node: int | str | None = None,
    mesh: int | str | None = None,
    primitive: int | None = None,
    shape_index: int | None = None,
) -> dict[str, Any]:
    """The mesh in a file, ``.ply``, ``.obj``, ``.gltf``, ``.glb`` or Mitsuba's ``.serialized``, as a shape
    for :func:`load_dict`::

        mesh = cw.load_mesh("bunny.ply")
        mesh["positions"] *= 0.1
        scene = cw.load_dict({..., "bunny": {**mesh, "bsdf": {"type": "diffuse"}}})

    Besides its type, ``"mesh"``, it has ``"positions"``, (V, 3), ``"faces"``, (F, 3), whole numbers from
    0, and if they are in the file ``"normals"``, (V, 3), of length 1, ``"uvs"``, (V, 2), and
    attributes ``"vertex_..."`` and ``"face_..."``, such as ``"vertex_color"``. Polygons are divided
    into triangles. Rows of bitmaps begin at v = 0, so v of OBJ files is turned round. A glTF file
    without normals has ``"face_normals"``.

    Materials and textures of files are not read, nor are further meshes of an OBJ file told apart:
    it is one mesh.

    :param node: of a glTF file with several meshes, the node by its name or number.
    :param mesh: the mesh, likewise.
    :param primitive: the primitive of that mesh, by its number.
    :param shape_index: the number of a mesh in a ``.serialized`` file; by default 0.
    :raises MeshError: the file is not there, or is no mesh, or there are several.
    """
    path = os.fspath(path)
    arrays, faces, remarks = _capwalk.read_mesh(
        path,
        _named("node", node),
        _named("mesh", mesh),
        _number("primitive", primitive),
        _number("shape_index", shape_index),
    )
    for remark in remarks:
        warnings.warn(f"{path} {remark}", SceneWarning, stacklevel=2)
    shape: dict[str, Any] = {"type": "mesh", **dict(arrays), "faces": faces}
    if path.lower().endswith((".gltf", ".glb")) and "normals" not in shape:
        shape["face_normals"] = True
    return shape


def save_mesh(path: str | os.PathLike[str], mesh: Mapping[str, object]) -> None:
    """Writes a mesh to a file in the format of its ending, whole or not at all. A shape of a scene::

        positions = cw.traverse(scene)["bunny.positions"]
        cw.save_mesh("bunny.glb", {"positions": positions, "faces": scene.faces("bunny")})

    :func:`load_mesh` gives the same arrays, with normals made unit, as far as the format has a place
    for them:

    * ``.ply``: all of them, in double precision;
    * ``.obj``: positions, normals and texture coordinates, with all digits of double precision, but
      for v, which is rounded as it is turned round. Vertices are numbered anew when such a file is
      read, in the order in which faces use them, and those without a face are left out;
    * ``.glb``, binary glTF: these and ``"vertex_color"``, (V, 3), in single precision. Without
      normals such a mesh has ``"face_normals"``.

    Axes and units are written as they are, in world space if the positions are those of a scene.

    :param mesh: its arrays, named as by :func:`load_mesh`: ``"positions"``, (V, 3), and ``"faces"``,
        (F, 3), and perhaps ``"normals"``, (V, 3), ``"uvs"``, (V, 2), ``"vertex_..."`` and
        ``"face_..."``.
    :raises ArgumentError: an array is missing, has another shape or no place in the format, there
        is no face, or a name has blanks.
    :raises MeshError: the file cannot be written, or its name has another ending.
    """
    if not isinstance(mesh, Mapping):
        raise TypeError(f"the mesh is a {type(mesh).__name__}; expected a dictionary of arrays")
    path = os.fspath(path)
    ending = os.path.splitext(path)[1].lower()
    if ending not in (".ply", *_WRITERS):
        raise MeshError(
            f"the name {path} does not tell a format of meshes that is written; expected the ending "
            ".ply, .obj or .glb: choose one of these, and convert the file if a program needs another"
        )
    is_flat = ending == ".glb" and mesh.get("face_normals") is True and "normals" not in mesh
    entries = [
        (name, value, f'mesh["{name}"]')
        for name, value in mesh.items()
        if not (name == "type" and value == "mesh" or name == "face_normals" and is_flat)
    ]
    try:
        arrays, faces, others = mesh_arrays(entries, "mesh")
    except LoadError as error:
        raise ArgumentError(str(error)) from None
    left_over = [name for name, _, _ in others]
    if ending in _WRITERS:
        places, made = _WRITERS[ending]
        left_over += [name for name, array in arrays if (name, array.shape[1]) not in places]
    if left_over:
        names = ", ".join(f'"{name}"' for name in left_over)
        article = "an" if ending == ".obj" else "a"
        raise ArgumentError(
            f"{article} {ending} file has no place for {names}; leave them out of the mesh"
            + ("" if others else ", or write a .ply file")
        )
    for name, _ in arrays:
        if not name.isprintable() or " " in name:
            raise ArgumentError(
                f"a .ply file has no place for blanks in the name {name!r}; rename the array"
            )
    if len(faces) == 0:
        raise ArgumentError("the mesh has no faces; expected at least one, or no file can be read")
    if ending in _WRITERS:
        _write(path, made(dict(arrays), faces))
    else:
        _capwalk.write_mesh(path, arrays, faces)


def _write(path: str, data: bytes) -> None:
    """Writes a file under a temporary name, and moves it to its place when it is complete."""
    place = Path(path)
    # As files of the module are called meanwhile.
    temporary = place.with_name(f".{place.name}.{os.getpid()}.capwalk-tmp")
    try:
        try:
            temporary.write_bytes(data)
            temporary.replace(place)
        finally:
            temporary.unlink(missing_ok=True)
    except OSError as error:
        raise MeshError(f"cannot write {path}: {error.strerror}") from None


def save_image(path: str | os.PathLike[str], image: ArrayLike) -> None:
    """Writes an image, linear RGB, (height, width, 3), or (height, width) for equal channels, such as a
    target or a texture: to an ``.exr`` or ``.npz`` file its numbers in single precision, as
    :func:`load_image` reads them; to a ``.png`` or ``.svg`` file with 8 bits in sRGB, clamped to 0 and 1.

    :raises ArgumentError: the image has another shape.
    :raises ImageError: the file cannot be written, or its name has another ending.
    """
    _capwalk.write_images(os.fspath(path), [("value", numbers("the image", image))], [], [], None)


def load_image(
    path: str | os.PathLike[str], *, layer: str | None = None, raw: bool = False
) -> Array:
    """The image in a file, ``.exr``, ``.npz``, ``.png``, ``.jpg``, ``.bmp``, ``.tga`` or ``.hdr``, as linear
    RGB, (height, width, 3), as a target for rendered ones. Greys are equal in all channels.

    Files with 8 or 16 bits are decoded from sRGB; colour profiles in them are not regarded. The
    others are linear: their numbers are as they are, negative, infinite or NaN in EXR and NPZ files,
    too. Images of capwalk are written by ``save``, such as :meth:`Image.save`, others by
    :func:`save_image`.

    :param layer: one of the layers of a file, such as ``"gradient"``, or of the groups of channels
        of an EXR file; by default ``"value"``, which are its channels R, G, B, or else the only one.
        ``"A"`` is the opacity, by which colours are not multiplied; 1 if a file with 8 or 16 bits
        has none.
    :param raw: whether 8 or 16 bits are taken as they are, from 0 to 1: for normals, masks and the
        like.
    :raises ImageError: the file is not there or no image, or has no such layer.
    """
    if not isinstance(raw, bool):
        raise TypeError(f"raw is {raw!r}; expected True or False")
    return _capwalk.read_image(os.fspath(path), layer, raw)


def _named(name: str, value: int | str | None) -> int | str | None:
    return value if isinstance(value, str) else _number(name, value)


def _number(name: str, value: int | None) -> int | None:
    return None if value is None else integer(name, value, 0, LARGEST_COUNT)

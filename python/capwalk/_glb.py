"""A mesh as the bytes of a binary glTF file, glTF 2.0, section 4."""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._numbers import Array
from .errors import ArgumentError

ATTRIBUTES = {
    ("positions", 3): "POSITION",
    ("normals", 3): "NORMAL",
    ("uvs", 2): "TEXCOORD_0",
    ("vertex_color", 3): "COLOR_0",
}
"""What the arrays of vertices are called there, by name and numbers in a row. Others have no place."""

# What glTF has numbers for.
_ARRAY_BUFFER, _ELEMENT_ARRAY_BUFFER = 34962, 34963
_UNSIGNED_INT, _FLOAT = 5125, 5126

_LARGEST = 2**32 - 1
"""Bytes of a file: its header counts them in 32 bits."""


def glb_bytes(arrays: Mapping[str, Array], faces: NDArray[np.uint32]) -> bytes:
    """The file: one mesh, placed by one node without a transform, in single precision."""
    views: list[dict[str, int]] = []
    accessors: list[dict[str, Any]] = []
    binary = bytearray()

    def added(numbers: NDArray[Any], target: int, **accessor: Any) -> int:
        """The number of the accessor of an array, which is appended to the buffer. All are
        multiples of 4 bytes long, so each begins at one, as it must."""
        view = {"buffer": 0, "byteOffset": len(binary), "byteLength": numbers.nbytes}
        views.append({**view, "target": target})
        accessors.append({"bufferView": len(views) - 1, **accessor})
        binary.extend(numbers.tobytes())
        return len(accessors) - 1

    attributes: dict[str, int] = {}
    for name, array in arrays.items():
        count, width = array.shape
        with np.errstate(over="ignore"):
            single = array.astype("<f4")
        if not np.isfinite(single).all():
            raise ArgumentError(
                f'mesh["{name}"] has numbers beyond single precision, which .glb files have; scale '
                "them, or write a .ply file"
            )
        # Required of positions.
        ends = {"min": single.min(0).tolist(), "max": single.max(0).tolist()}
        attributes[ATTRIBUTES[name, width]] = added(
            single,
            _ARRAY_BUFFER,
            componentType=_FLOAT,
            count=count,
            type=f"VEC{width}",
            **(ends if name == "positions" else {}),
        )
    indices = added(
        faces.astype("<u4"),
        _ELEMENT_ARRAY_BUFFER,
        componentType=_UNSIGNED_INT,
        count=faces.size,
        type="SCALAR",
    )
    primitive: dict[str, Any] = {"attributes": attributes, "indices": indices}
    materials: dict[str, Any] = {}
    if "uvs" in arrays:
        # The default material, in words: without any, some programs leave texture coordinates out.
        materials = {"materials": [{}]}
        primitive["material"] = 0
    text = json.dumps(
        {
            "asset": {"version": "2.0", "generator": "capwalk"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [primitive]}],
            **materials,
            "accessors": accessors,
            "bufferViews": views,
            "buffers": [{"byteLength": len(binary)}],
        }
    ).encode("ascii")
    text += b" " * (-len(text) % 4)
    length = 12 + 8 + len(text) + 8 + len(binary)
    if length > _LARGEST:
        raise ArgumentError(
            f"the mesh takes {length} bytes, and a .glb file has at most {_LARGEST}; write a .ply file"
        )
    return b"".join(
        [
            struct.pack("<4sII", b"glTF", 2, length),
            struct.pack("<I4s", len(text), b"JSON"),
            text,
            struct.pack("<I4s", len(binary), b"BIN\0"),
            binary,
        ]
    )

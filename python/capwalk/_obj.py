"""A mesh as the text of an OBJ file."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from ._numbers import Array

KEYWORDS = {("positions", 3): "v", ("uvs", 2): "vt", ("normals", 3): "vn"}
"""How the lines of an array begin, by its name and numbers in a row. Others have no place."""


def obj_bytes(arrays: Mapping[str, Array], faces: NDArray[np.uint32]) -> bytes:
    """The file. Its numbers have all digits that double precision needs."""
    columns = dict(arrays)
    if "uvs" in columns:
        # There v points up.
        u, v = columns["uvs"].T
        columns["uvs"] = np.column_stack([u, 1.0 - v])
    lines = ["# capwalk"]
    for (name, _), keyword in KEYWORDS.items():
        rows = columns[name].tolist() if name in columns else []
        lines += [f"{keyword} {' '.join(map(repr, row))}" for row in rows]
    # A corner is position/uv/normal, counted from 1; what is missing at the end is left out.
    form = "/".join("{0}" if name in columns else "" for name, _ in KEYWORDS).rstrip("/")
    corners = [form.format(vertex + 1) for vertex in range(len(columns["positions"]))]
    lines += [f"f {corners[a]} {corners[b]} {corners[c]}" for a, b, c in faces.tolist()]
    return "\n".join([*lines, ""]).encode("ascii")

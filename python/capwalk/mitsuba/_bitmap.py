"""What a loaded bitmap does not tell: how it is looked up. It is asked where answers differ."""

from __future__ import annotations

import itertools
from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from .._numbers import Array


def texels(texture: Any, stored: Any, *, raw: bool) -> Array:
    """The texels of a bitmap as linear numbers, (height, width, channels)."""
    pixels = np.asarray(stored)
    if pixels.dtype != np.uint8:
        return pixels.astype(np.float64)
    linear = pixels / 255.0
    decoded = np.where(linear <= 0.04045, linear / 12.92, ((linear + 0.055) / 1.055) ** 2.4)
    if raw:
        return linear
    # Bytes are decoded as they are looked up, unless the image was linear.
    row, column, channel = _largest(decoded - linear)
    found = _look_up(texture, pixels.shape, column, row)[channel]
    likelier = min((linear, decoded), key=lambda data: abs(data[row, column, channel] - found))
    return np.asarray(likelier)


def filter_type(texture: Any, data: Array) -> str | None:
    """``"bilinear"`` or ``"nearest"``; ``None`` where they are the same."""
    steps = [np.diff(data, axis=axis) for axis in (1, 0)]
    across, along = (np.abs(step).max(initial=0.0) for step in steps)
    if across == along == 0.0:
        return None
    # A quarter of a texel away from the centre towards the most different neighbour.
    horizontal = across >= along
    row, column, channel = _largest(steps[0] if horizontal else steps[1])
    shift = (0.25, 0.0) if horizontal else (0.0, 0.25)
    found = _look_up(texture, data.shape, column + shift[0], row + shift[1])[channel]
    texel = data[row, column, channel]
    neighbour = data[row, column + 1, channel] if horizontal else data[row + 1, column, channel]
    return (
        "nearest" if abs(found - texel) < abs(found - (0.75 * texel + 0.25 * neighbour)) else "bilinear"
    )


def wrap_mode(texture: Any, data: Array) -> str | None:
    """``"repeat"``, ``"mirror"`` or ``"clamp"``; ``None`` where some of them are the same."""
    possible = {"repeat", "mirror", "clamp"}
    for axis in (1, 0):
        # The tile before the first one, at the centres of texels.
        tiles = {
            "repeat": data,
            "mirror": np.flip(data, axis),
            "clamp": np.broadcast_to(np.take(data, [0], axis), data.shape),
        }
        for one, other in itertools.combinations(tiles, 2):
            difference = tiles[one] - tiles[other]
            if not {one, other} <= possible or not difference.any():
                continue
            row, column, channel = _largest(difference)
            x, y = (column - data.shape[1], row) if axis else (column, row - data.shape[0])
            found = _look_up(texture, data.shape, x, y)[channel]
            wrong = max(
                (one, other), key=lambda mode: abs(tiles[mode][row, column, channel] - found)
            )
            possible.remove(wrong)
    return possible.pop() if len(possible) == 1 else None


def _largest(differences: Array) -> tuple[int, int, int]:
    row, column, channel = np.unravel_index(np.abs(differences).argmax(), differences.shape)
    return int(row), int(column), int(channel)


def uv(texture: Any, shape: tuple[int, ...], column: float, row: float) -> tuple[float, float]:
    """Texture coordinates of a place counted in texels, integers being their centres."""
    # Lookups begin with the texture's own transform.
    to_uv = np.asarray(mi.traverse(texture)["to_uv"].matrix, dtype=np.float64).reshape(3, 3)
    u, v, _ = np.linalg.solve(to_uv, [(column + 0.5) / shape[1], (row + 0.5) / shape[0], 1.0])
    return float(u), float(v)


def _look_up(texture: Any, shape: tuple[int, ...], column: float, row: float) -> Array:
    """What a texture says at a place counted in texels."""
    place = dr.zeros(mi.SurfaceInteraction3f)
    place.uv = mi.Point2f(*uv(texture, shape, column, row))
    found = texture.eval_1(place) if shape[2] == 1 else texture.eval_3(place)
    return np.asarray(found, dtype=np.float64).reshape(shape[2])

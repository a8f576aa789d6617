"""What loaded normal and bump maps do not tell: two flags. Their samples are compared with those
of the material inside them."""

from __future__ import annotations

from typing import Any

import drjit as dr
import mitsuba as mi
import numpy as np

from .._numbers import Array
from ._bitmap import uv

# Samples of directions that are compared, spread over the square.
_SAMPLES = [(x, y) for x in (0.2, 0.5, 0.8) for y in (0.1, 0.4, 0.7, 0.95)]

# Differences below are rounding.
_SAME = 1e-3


def limits(bsdf: Any, nested: Any, texture: Any, data: Array | None) -> tuple[bool | None, ...]:
    """``flip_invalid_normals`` and ``use_shadowing_function``; ``None`` where nothing tells.

    :param data: texels of the texture, if it is a bitmap.
    """
    places = [(0.5, 0.5)] if data is None else _steep(bsdf, texture, data)
    normals = [(_normal(bsdf, texture, u, v), u, v) for u, v in places]
    # Tilted, but not so much that nothing is seen of it.
    normal, u, v = max(normals, key=lambda place: _tilt(place[0]) * (_tilt(place[0]) < 0.9))
    tilt = _tilt(normal)
    if tilt < _SAME:
        return None, None
    # From halfway between where the tilted surface is seen no more and where none is.
    angle = 0.5 * np.arcsin(tilt)
    hidden = np.array([*(-np.cos(angle) / tilt * normal[:2]), np.sin(angle)])
    turned = normal * [-1.0, -1.0, 1.0]
    apart = [
        (flipped, found)
        for sample in _SAMPLES
        for flipped, found, _, _ in [_sampled(bsdf, nested, u, v, hidden, turned, sample)]
        for kept, _, _, _ in [_sampled(bsdf, nested, u, v, hidden, normal, sample)]
        if not np.allclose(flipped, kept, atol=_SAME)
    ]
    flips = all(np.allclose(*both, atol=_SAME) for both in apart) if apart else None
    # Mirrors show light along the map's normal only.
    seen = [_sampled(bsdf, nested, u, v, normal, normal, sample)[2:] for sample in _SAMPLES]
    lit = [(inside, outside) for inside, outside in seen if inside > 0.0 and outside > 0.0]
    # The function is below one for light that leaves away from the surface's own normal.
    shadows = any(outside < (1.0 - 1e-5) * inside for inside, outside in lit) if lit else None
    return flips, shadows


def _sampled(
    bsdf: Any,
    nested: Any,
    u: float,
    v: float,
    wi: Array,
    normal: Array,
    sample: tuple[float, float],
) -> tuple[Array, Array, float, float]:
    """A direction that the material inside would give under this normal, the one that the map
    gives, zeros for none, and the largest weights of both."""
    context, place = mi.BSDFContext(), _place(u, v)
    place.wi = mi.Vector3f(*wi.tolist())
    tangent = np.array([1.0, 0.0, 0.0]) - normal[0] * normal
    tangent /= np.linalg.norm(tangent)
    frame = np.stack([tangent, np.cross(normal, tangent), normal])
    inside = _place(u, v)
    inside.sh_frame = mi.Frame3f(*(mi.Vector3f(*row.tolist()) for row in frame))
    inside.wi = mi.Vector3f(*(frame @ wi).tolist())
    square = mi.Point2f(*sample)
    # Vectorized variants compile one program for all samples.
    dr.make_opaque(place, inside, square)
    expected, weight = _drawn(nested.sample(context, inside, 0.3, square, True))
    world = frame.T @ expected
    if expected[2] * world[2] <= 0.0:
        world, weight = np.zeros(3), 0.0
    found, found_weight = _drawn(bsdf.sample(context, place, 0.3, square, True))
    return world, found, weight, found_weight


def _drawn(drawn: tuple[Any, Any]) -> tuple[Array, float]:
    sample, weight = drawn
    largest = float(np.asarray(weight, dtype=np.float64).max())
    direction = np.asarray(sample.wo, dtype=np.float64).reshape(3)
    return (direction, largest) if largest > 0.0 else (np.zeros(3), 0.0)


def _place(u: float, v: float) -> Any:
    place = dr.zeros(mi.SurfaceInteraction3f)
    place.uv = mi.Point2f(u, v)
    place.n = mi.Normal3f(0, 0, 1)
    place.sh_frame = mi.Frame3f(mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0), mi.Vector3f(0, 0, 1))
    place.dp_du, place.dp_dv = mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0)
    return place


def _normal(bsdf: Any, texture: Any, u: float, v: float) -> Array:
    """The map's normal on a square of side one."""
    place = _place(u, v)
    if bsdf.class_name() == "NormalMap":
        normal = 2.0 * np.asarray(texture.eval_3(place), dtype=np.float64).reshape(3) - 1.0
    else:
        scale = float(np.asarray(mi.traverse(bsdf)["scale"]).item())
        slope = scale * np.asarray(texture.eval_1_grad(place), dtype=np.float64).reshape(2)
        normal = np.array([-slope[0], -slope[1], 1.0])
    return np.asarray(normal / np.linalg.norm(normal))


def _tilt(normal: Array) -> float:
    return float(np.hypot(normal[0], normal[1]))


def _steep(bsdf: Any, texture: Any, data: Array) -> list[tuple[float, float]]:
    """Some places in a bitmap, from those where it is steepest to where it is less so."""
    if bsdf.class_name() == "NormalMap":
        directions = 2.0 * data - 1.0
        steepness = np.hypot(directions[..., 0], directions[..., 1]) / np.abs(directions[..., 2])
        shift = 0.0
    else:
        # Between two texels.
        steepness = np.abs(np.diff(data[..., 0], axis=1))
        shift = 0.5
    order = np.argsort(steepness, axis=None)[::-1]
    chosen = order[np.linspace(0, len(order) - 1, 8).astype(int) // 2]
    rows, columns = np.unravel_index(chosen, steepness.shape)
    return [uv(texture, data.shape, x + shift, y) for x, y in zip(columns, rows)]

"""Transforms with Mitsuba's names, for dictionaries without Mitsuba."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ._numbers import Array
from .errors import ArgumentError

# How far the length of an axis may be from 1: rounded digits. As in scene files.
ROUNDED_AXIS = 2e-3


class Transform:
    """An affine transform, like ``mitsuba.ScalarTransform4f``: the last step in the chain is
    applied first.

    >>> import capwalk as cw
    >>> cw.Transform().translate([0, 2, 0]).rotate([1, 0, 0], 90).scale(3).matrix.round(6)
    array([[ 3.,  0.,  0.,  0.],
           [ 0.,  0., -3.,  2.],
           [ 0.,  3.,  0.,  0.],
           [ 0.,  0.,  0.,  1.]])
    """

    matrix: Array
    """(4, 4), acts on columns; the last row is 0, 0, 0, 1."""

    def __init__(self, matrix: ArrayLike | None = None) -> None:
        """The identity, or the transform with a matrix, (4, 4)."""
        self.matrix = np.eye(4) if matrix is None else np.array(matrix, dtype=np.float64)
        if self.matrix.shape != (4, 4):
            raise ArgumentError(f"the matrix has the shape {self.matrix.shape}; expected (4, 4)")

    def translate(self, by: ArrayLike) -> Transform:
        """This transform after a translation, world units."""
        step = np.eye(4)
        step[:3, 3] = _vector("by", by)
        return Transform(self.matrix @ step)

    def rotate(self, axis: ArrayLike, angle: float) -> Transform:
        """This transform after a rotation about an axis of length 1 by an angle in degrees,
        counter-clockwise when the axis points at the viewer."""
        axis = _vector("axis", axis)
        length = np.linalg.norm(axis)
        if abs(length - 1.0) > ROUNDED_AXIS:
            raise ArgumentError(f"the axis of the rotation has the length {length:.4g}; expected 1")
        x, y, z = axis / length
        cos, sin = np.cos(np.radians(angle)), np.sin(np.radians(angle))
        # Rodrigues: cos 1 + sin [a]x + (1 - cos) a aT.
        cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        step = np.eye(4)
        step[:3, :3] = cos * np.eye(3) + sin * cross + (1.0 - cos) * np.outer((x, y, z), (x, y, z))
        return Transform(self.matrix @ step)

    def scale(self, by: ArrayLike) -> Transform:
        """This transform after a scale: one number, or one along each axis."""
        factors = np.broadcast_to(np.asarray(by, dtype=np.float64), 3) if np.ndim(by) == 0 else by
        return Transform(self.matrix @ np.diag([*_vector("by", factors), 1.0]))

    def look_at(self, origin: ArrayLike, target: ArrayLike, up: ArrayLike) -> Transform:
        """This transform after the one that puts a camera at ``origin``, looking at ``target`` (its
        +z) with ``up`` upwards (its +y)."""
        origin, target, up = _vector("origin", origin), _vector("target", target), _vector("up", up)
        forward = target - origin
        left = np.cross(up, forward)
        if not left.any():
            raise ArgumentError(
                "the view has no direction, or up is parallel to it; origin and target must "
                "differ, and up must not be parallel to the line between them"
            )
        forward, left = forward / np.linalg.norm(forward), left / np.linalg.norm(left)
        step = np.eye(4)
        step[:3] = np.stack([left, np.cross(forward, left), forward, origin], axis=1)
        return Transform(self.matrix @ step)

    def __matmul__(self, other: Transform) -> Transform:
        """``other`` first, then this."""
        return Transform(self.matrix @ other.matrix)

    def __repr__(self) -> str:
        return f"capwalk.Transform({self.matrix.tolist()})"


def _vector(name: str, value: ArrayLike) -> Array:
    vector = np.asarray(value, dtype=np.float64)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise ArgumentError(f"{name} is {value!r}; expected three finite numbers")
    return vector

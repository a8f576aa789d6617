"""Results: arrays with their standard errors, which notebooks display."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from . import _capwalk
from ._method import Method
from ._numbers import Array


Files = tuple[os.PathLike[str], ...]
"""Files that were read, which are never written."""

Layers = list[tuple[str, Array]]
Notes = list[tuple[str, str]]
"""What is said of a file, by keys."""


@dataclass(frozen=True, eq=False, repr=False)
class Image:
    """An image and its standard errors. ``numpy.asarray(image)`` is its value."""

    value: Array
    """Radiance, linear RGB, (height, width, 3)."""
    stderr: Array
    """Standard error of each number; NaN for a single sample per pixel."""
    statistics: Mapping[str, Any]
    """What was done: ``samples``, ``complete``, ``non_finite``, ``cone_queries``."""
    device: str = "cpu"
    """Where it was rendered: ``"cpu"``, or the name of the GPU."""
    _files: Files = ()
    """What the scene was read from."""

    def __repr__(self) -> str:
        return f"<capwalk.Image: {_described(self.value, self.stderr)}>"

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        return _as_array(self.value, dtype, copy)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes an .exr or .npz file with all layers in single precision, or a .png or
        .svg file with the image.

        :raises ArgumentError: the scene was read from this file.
        :raises ImageError: the file cannot be written, or its name has another ending.
        """
        layers = [("value", self.value), ("value_stderr", self.stderr)]
        notes = [] if self.device == "cpu" else [("device", self.device)]
        _capwalk.write_images(os.fspath(path), layers, notes, list(self._files), None)

    def _repr_png_(self) -> bytes:
        # As previews are enlarged.
        factor = -(-_capwalk.LEAST_WIDTH // self.value.shape[1])
        return _capwalk.png(self.value.repeat(factor, axis=0).repeat(factor, axis=1), None)


@dataclass(frozen=True, eq=False, repr=False)
class GradientImage:
    """The derivative of an image along one direction, and the image. ``numpy.asarray(derivative)``
    is the derivative."""

    gradient: Array
    """Derivative of each pixel per unit of the parameter, (height, width, 3)."""
    stderr: Array
    """Standard error of each number of the derivative; NaN for a single sample per pixel."""
    value: Array
    """The image itself, (height, width, 3)."""
    value_stderr: Array
    """Standard error of the image."""
    method: Method
    """The method that was chosen."""
    statistics: Mapping[str, Any]
    """What was done: ``samples``, ``complete``, ``non_finite``, ``cone_queries``, ``dips``
    (rays that dip below faces where surfaces are concave) and what is therefore ``missing`` (None: no such ray was met)."""
    device: str = "cpu"
    """Where it was computed: ``"cpu"``, or the name of the GPU."""
    _files: Files = ()
    """What the scene was read from."""
    _along: str = ""
    """The parameter, as it was given; "" for velocities of arrays."""

    def __repr__(self) -> str:
        described = _described(self.gradient, self.stderr)
        return f"<capwalk.GradientImage: {described}, method {self.method.name}>"

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        return _as_array(self.gradient, dtype, copy)

    def save(self, path: str | os.PathLike[str], *, limit: float | None = None) -> None:
        """Writes an .exr or .npz file with all layers in single precision, or a .png or .svg file as
        notebooks show it: the image beside the derivative in false colours, blue below zero and red
        above. In SVG, type is text.

        The title names the parameter and its unit. The colour bar ends where 99 % of the pixels with a
        derivative are within it, and is logarithmic if that is far above their median. Narrow images
        are enlarged by a whole factor, to at least 384 pixels.

        :param limit: where the colours end on both sides, spread evenly, above 0: the same for
            derivatives that are to be compared.
        :raises ArgumentError: the scene was read from this file.
        :raises ImageError: the file cannot be written, its name has another ending, or the limit of a
            picture is wrong.
        """
        files = list(self._files)
        _capwalk.write_images(os.fspath(path), self._layers(), self._notes(), files, limit)

    def _repr_png_(self) -> bytes:
        return _capwalk.preview(self._layers(), self._notes())

    def _layers(self) -> Layers:
        return [
            ("gradient", self.gradient),
            ("stderr", self.stderr),
            ("value", self.value),
            ("value_stderr", self.value_stderr),
        ]

    def _notes(self) -> Notes:
        notes = [("parameter", self._along)] if self._along else []
        return notes if self.device == "cpu" else [*notes, ("device", self.device)]


class Gradients(dict[str, Array]):
    """Gradients of a loss by the names of the arrays, each in the shape of its array."""

    stderr: dict[str, Array]
    """Standard error of each number, by the same names."""
    method: Method
    """The method that was chosen; of several views that of the first which was sampled."""
    statistics: Mapping[str, Any]
    """What was done: ``samples``, ``complete``, ``non_finite``, ``cone_queries``, ``dips``
    (rays that dip below faces where surfaces are concave) and what is therefore ``missing`` (None: no such ray was met)."""
    device: str
    """Where it was computed: ``"cpu"``, or the name of the GPU."""

    def __init__(
        self,
        values: Mapping[str, Array],
        stderr: Mapping[str, Array],
        method: Method,
        statistics: Mapping[str, Any],
        device: str = "cpu",
    ) -> None:
        super().__init__(values)
        self.stderr, self.method, self.statistics = dict(stderr), method, statistics
        self.device = device


@dataclass(frozen=True, eq=False, repr=False)
class Check:
    """The comparison of a gradient with central differences. Prints as a verdict with its
    numbers."""

    verdict: str
    """``"right"``, ``"wrong"`` or ``"inconclusive"``."""
    reason: str | None
    """In which respects they differ, if the gradient is wrong; if that is inconclusive because the
    differences are larger than noise explains, by how much."""
    samples_factor: float | None
    """How many times the samples would be enough, if that is inconclusive; infinite if there
    is nothing to see."""
    scale_factor: float
    """Regression of the reference on the gradient: 1 for a right gradient."""
    scale_factor_error: float
    """Standard error of ``scale_factor``."""
    mean_z2: float
    """Mean of the squared differences over their variances: 1 for right errors."""
    mean_z2_error: float
    """Standard error of ``mean_z2``."""
    sign: float
    """Sum of the differences over its standard error."""
    relative_l1: float
    """Mean absolute difference over the mean absolute reference."""
    relative_l1_of_noise: float
    """What ``relative_l1`` would be from noise alone."""
    correlation: float
    """Correlation of both images."""
    pixels: int
    """Pixels that are compared: those with noise, and those that differ amid noise."""
    worst: list[tuple[int, int, float]]
    """Column, row and z of the pixels that differ most."""
    coplanar: list[tuple[str, str]]
    """Shapes that have faces in one plane which overlap, and that move against each other: where
    that is seen, the image has no derivative."""
    touching: list[tuple[str, str]]
    """Shapes with an edge that lies on a face of the other shape and moves off it: where that is
    seen, the image has no derivative."""
    edge_on: list[tuple[str, int]]
    """Faces, by shape and number, that the camera sees exactly edge-on and moves against: where
    they are seen, the image has no derivative."""
    step: float
    """How far the parameter moved on each side."""
    sides: str
    """``"both"`` for central differences; ``"above"`` or ``"below"`` for one-sided ones, where the
    parameter is at the end of what it can be."""
    spp: int
    """Samples per pixel of the gradient."""
    reference_spp: int
    """Samples per pixel of the reference, on each side."""
    references: int
    """How many references were made: 2 if the first contradicted the gradient or left a doubt of
    it, up to 4 if they contradicted each other as well; one or two more before it is called wrong. The one
    that decided is here."""
    text: str
    """All of this in words, as the command line prints it."""
    statistics: Mapping[str, Any]
    """What was done for the gradient."""
    reference_statistics: Mapping[str, Any]
    """What was done for the reference."""
    gradient: Array
    """The gradient, (height, width, 3)."""
    stderr: Array
    """Its standard errors."""
    reference: Array
    """Finite differences, (height, width, 3)."""
    reference_stderr: Array
    """Their standard errors."""

    @property
    def right(self) -> bool:
        """True if they agree, and a factor wrong by 10 % would have been seen."""
        return self.verdict == "right"

    def __repr__(self) -> str:
        return f"<capwalk.Check: {self.text.splitlines()[-1]}>"

    def __str__(self) -> str:
        return self.text


def _described(value: Array, stderr: Array) -> str:
    height, width, _ = value.shape
    return (
        f"{width} x {height} pixels, mean {np.mean(value):.4g}, "
        f"standard error {np.sqrt(np.mean(np.square(stderr))):.2g} a number"
    )


def _as_array(array: Array, dtype: DTypeLike | None, copy: bool | None) -> NDArray[Any]:
    if copy is False and dtype is not None and np.dtype(dtype) != array.dtype:
        raise ValueError(f"the numbers are {array.dtype}; another type needs a copy")
    return np.array(array, dtype=dtype) if copy else np.asarray(array, dtype=dtype)

"""The keywords of all functions: how images are rendered and derivatives estimated. For the type
of a function that passes them on::

    from typing import Unpack  # Python 3.11; before, typing_extensions

    import capwalk as cw
    from capwalk.options import GradientOptions

    def sum_of_gradient(scene: cw.Scene, name: str, **options: Unpack[GradientOptions]) -> float:
        return cw.gradient(scene, name, **options).gradient.sum()
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, TypedDict

from ._method import Method
from ._progress import Progress

if TYPE_CHECKING:
    from typing_extensions import Unpack as Unpack
elif sys.version_info >= (3, 11):
    from typing import Unpack
else:

    class Unpack:
        """Stands for that of ``typing`` where there is none, for those who ask for the types."""

        def __class_getitem__(cls, keywords):
            return keywords


Sensor = int | str
"""A sensor of a scene, by number from 0 or by name."""


class SampleOptions(TypedDict, total=False):
    """Keywords of everything that renders."""

    aov: str | None
    """An AOV that is rendered instead of radiance: ``"depth"``, ``"position"``, ``"uv"``,
    ``"geo_normal"``, ``"sh_normal"``, ``"albedo"``, ``"mask"``."""
    spp: int | None
    """Samples per pixel, at least 1; by default the scene's."""
    progress: Progress
    """``True`` for a bar, or a function that gets the work done and the total."""


class ThreadOptions(TypedDict, total=False):
    """Keywords of everything that works in this process alone."""

    threads: int | None
    """Worker threads; by default all cores. They change no bit."""


class MethodOptions(TypedDict, total=False):
    """Keywords of everything that differentiates: how derivatives are estimated."""

    method: str | Method
    """``"auto"``, the default, chooses the method with the least variance × time, which is
    ``"walk"`` (the paper's) or ``"edges"``; or a :class:`capwalk.Method` from an earlier call."""
    steps: int | None
    """Steps of a walk, 1 to 1000; this and the next two for ``"walk"`` and ``"edges"``."""
    max_angle: float | None
    """The walk's angular cutoff, degrees, above 0 and at most 180."""
    antithetic: bool | None
    """Whether walks average samples at opposite points of the rim."""


class ViewsOptions(SampleOptions, total=False):
    """Keywords of :meth:`capwalk.parallel.Workers.render_views`: these and
    :class:`SampleOptions`."""

    seed: int | None
    """Of all random numbers, 0 to 2**64 - 1; by default the scene's."""


class ViewGradientsOptions(ViewsOptions, MethodOptions, total=False):
    """Keywords of :meth:`capwalk.parallel.Workers.backward_views`: :class:`ViewsOptions` and
    :class:`MethodOptions`."""


class ImageOptions(ViewsOptions, total=False):
    """Keywords of :meth:`capwalk.parallel.Workers.render`: these and :class:`ViewsOptions`."""

    sensor: Sensor
    """Which of the scene's sensors, by number from 0 or by name; by default the first."""


class PartsOptions(ImageOptions, MethodOptions, total=False):
    """Keywords of :meth:`capwalk.parallel.Workers.gradient` and ``backward``:
    :class:`ImageOptions` and :class:`MethodOptions`."""


class RenderOptions(ImageOptions, ThreadOptions, total=False):
    """Keywords of :func:`capwalk.render`: these, :class:`ImageOptions` and
    :class:`ThreadOptions`."""

    device: str
    """``"cpu"``, the default; ``"gpu"``, a GPU or software Vulkan, for scenes with diffuse
    surfaces, metals, plastics, area emitters and environments; or ``"auto"``, a GPU with double
    precision if there is one that supports the scene, else the CPU, with a
    :class:`capwalk.DeviceWarning` that says why if there is a GPU. A GPU takes the same samples
    as the CPU and rounds differently: nearly all of them agree within 0.02 %. The result's
    ``device`` names the device."""


class GradientOptions(RenderOptions, MethodOptions, total=False):
    """Keywords of :func:`capwalk.gradient` and :func:`capwalk.backward`: :class:`RenderOptions` and
    :class:`MethodOptions`."""


class CheckOptions(ImageOptions, ThreadOptions, MethodOptions, total=False):
    """Keywords of :func:`capwalk.check`: these, :class:`ImageOptions`, :class:`ThreadOptions` and
    :class:`MethodOptions`."""

    reference_spp: int | None
    """Samples per pixel of the first differences, on each side; by default as many as the noise
    of gradient and reference calls for."""
    step: float | None
    """How far the parameter moves on each side, in its own units; by default one that
    fits the scene, and in each further reference a quarter of the one before."""


class FunctionOptions(SampleOptions, ThreadOptions, MethodOptions, total=False):
    """Keywords of :func:`capwalk.torch.render` and :func:`capwalk.jax.render` besides seeds: these,
    :class:`SampleOptions`, :class:`ThreadOptions` and :class:`MethodOptions`."""

    sensor: Sensor
    """Which of the scene's sensors, by number from 0 or by name; by default the first."""
    views: Sequence[Sensor] | None
    """Several of the scene's sensors instead, of images of one size: the result is
    (views, height, width, 3), and gradients are those of all views together. Each view has the seeds
    ``capwalk.parallel.view_seed(seed, i)`` and ``view_seed(seed_grad, i)``, where ``i`` is its place in
    the list, so that their noise is independent."""
    spp_grad: int | None
    """Samples per pixel of the derivatives; by default ``spp``."""

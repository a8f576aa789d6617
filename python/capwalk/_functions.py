"""Loading, rendering and differentiating."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _capwalk
from ._method import Method
from ._numbers import Array, numbers
from ._options import LARGEST_COUNT, check_names, checked, integer
from ._progress import shown
from ._results import Check, GradientImage, Gradients, Image
from .errors import ArgumentError, DeviceWarning, SceneWarning, UnreliableWarning
from .options import CheckOptions, GradientOptions, RenderOptions, Unpack

Scene = _capwalk.Scene
Along = str | Mapping[str, ArrayLike]


def load_file(path: str | os.PathLike[str], /, **defines: object) -> Scene:
    """The scene in a Mitsuba 3 XML file or a glTF file (``.gltf``, ``.glb``), or the built-in scene
    of this name (``"leaf"``, ``"ball"``, ``"box-room"``, ``"lattice-shadow"``).

    Keyword arguments are values of ``$name`` in the file and take precedence over its
    ``<default>``. Properties that have no effect, or are read as something else, give a
    :class:`SceneWarning`.

    :raises LoadError: the file is not a scene; with ``file``, ``line`` and ``column``.
    """
    return warned(_capwalk.load_file(os.fspath(path), _texts(defines)))


def load_string(text: str, folder: str | os.PathLike[str] = ".", /, **defines: object) -> Scene:
    """The scene in a string of Mitsuba's XML. File names in it are relative to ``folder``.

    :raises LoadError: the text is not a scene; with ``line`` and ``column``.
    """
    return warned(_capwalk.load_string(text, os.fspath(folder), _texts(defines)))


def render(scene: Scene, **options: Unpack[RenderOptions]) -> Image:
    """The image of a scene with its standard errors.

    The same scene, ``spp`` and ``seed`` give the same bits on the same device, whatever ``threads``
    is.

    :param options: how, see :class:`capwalk.options.RenderOptions`: ``sensor``, ``aov``, ``spp``,
        ``seed``, ``threads``, ``progress``, ``device``.
    :raises ArgumentError: ``device="gpu"`` for a scene that needs something the GPU does not
        support, which the message names; an unknown device.
    :raises DeviceError: ``device="gpu"`` if there is none; a GPU that fails.
    """
    check_names("render", RenderOptions, options)
    with shown(options.get("progress"), "render") as told:
        asked = checked(scene, options, progress=told)
        (value, stderr), statistics, (device, remark) = _capwalk.render(scene, asked)
    warn_of(statistics)
    warn_of_device(remark)
    return Image(value, stderr, statistics, device, _files=tuple(scene._files))


def gradient(scene: Scene, along: Along, **options: Unpack[GradientOptions]) -> GradientImage:
    """The derivative of the image along one direction (forward mode), without bias, with its
    standard errors.

    :param along: an expression such as ``"ball.translate.x"`` or ``"a.scale - 2*b.scale"``, or
        velocities of arrays by their names: ``{"ball.positions": array of shape (V, 3)}``.
    :param options: how, see :class:`capwalk.options.GradientOptions`: those of :func:`render`,
        and ``method``, ``steps``, ``max_angle``, ``antithetic``. GPUs do not support all
        derivatives: for others ``device="auto"`` uses the CPU, and ``"gpu"`` raises
        :class:`ArgumentError` with the reason.
    :raises Refused: the derivative could only be estimated with a bias; with ``reason`` and
        ``instead``.
    :raises ParameterError: a name is not a parameter.
    :raises ArgumentError: velocities with another shape than the array, or any other wrong
        argument.
    """
    check_names("gradient", GradientOptions, options)
    with shown(options.get("progress"), "gradient") as told:
        asked = checked(scene, options, progress=told)
        found = _capwalk.gradient(scene, direction(along), asked)
    value, gradient, chosen, statistics, (device, remark) = found
    warn_of(statistics)
    warn_of_device(remark)
    made, files = Method(*chosen), tuple(scene._files)
    name = along if isinstance(along, str) else ""
    return GradientImage(
        *gradient, *value, made, statistics, device, _files=files, _along=name
    )


def backward(
    scene: Scene,
    adjoint: ArrayLike,
    names: Sequence[str] | None = None,
    **options: Unpack[GradientOptions],
) -> Gradients:
    """The gradient of ``(adjoint * image).sum()`` with respect to arrays of the scene, all in
    one pass (reverse mode), without bias.

    :param adjoint: derivative of a loss with respect to each pixel, (height, width, 3). Its
        noise must be independent of ``seed``: render the image that it comes from with another
        one, or the product of both is biased.
    :param names: of the arrays; by default all that can be differentiated with respect to, with
        a warning if some cannot. Numbers such as ``"ball.translate.x"`` and sums of them are
        allowed.
    :param options: those of :func:`gradient`. The default ``seed`` differs from the scene's, so
        the noise is independent of an image that :func:`render` made with its default seed.
    :return: the gradients by name, each in the shape of its array, and their ``stderr``.

    Raises the same exceptions as :func:`gradient`.
    """
    check_names("backward", GradientOptions, options)
    with shown(options.get("progress"), "backward") as told:
        asked = checked(scene, options, progress=told, independent=True)
        wanted = wanted_names(scene, names, asked.sensor)
        found = _capwalk.backward(scene, numbers("adjoint", adjoint), wanted, asked)
    values, errors, chosen, statistics, (device, remark) = found
    warn_of(statistics)
    warn_of_device(remark)
    return Gradients(values, errors, Method(*chosen), statistics, device)


def check(scene: Scene, along: Along, **options: Unpack[CheckOptions]) -> Check:
    """A gradient against finite differences of the image, with a verdict.

    Noisy pixels get more samples, in the time of ``spp`` samples of each pixel.

    If the differences contradict the gradient or cast doubt on it, a second reference with four
    times their samples decides; if it contradicts the first, a third or a fourth one.

    :param options: how, see :class:`capwalk.options.CheckOptions`: those of :func:`gradient` but
        ``device``, and ``reference_spp`` and ``step``.

    Raises the same exceptions as :func:`gradient`.
    """
    check_names("check", CheckOptions, options)
    reference_spp = options.get("reference_spp")
    if reference_spp is not None:
        reference_spp = integer("reference_spp", reference_spp, 1, LARGEST_COUNT)
    with shown(options.get("progress"), "check") as told:
        asked = checked(scene, options, progress=told)
        gradient, reference, found = _capwalk.check(
            scene, direction(along), asked, reference_spp, options.get("step")
        )
    warn_of(found["statistics"])
    warn_of(found["reference_statistics"])
    return Check(
        gradient=gradient[0],
        stderr=gradient[1],
        reference=reference[0],
        reference_stderr=reference[1],
        **found,
    )


def direction(along: Along) -> str | dict[str, Array]:
    """The direction of a derivative, as the module takes it."""
    if isinstance(along, str):
        return along
    if not isinstance(along, Mapping):
        raise TypeError(
            f"the direction is a {type(along).__name__}; expected the name of a parameter, or a "
            "dict of velocities by the names of arrays"
        )
    for name in along:
        if not isinstance(name, str):
            raise TypeError(f"the name of an array is {name!r}; expected a string")
    return {name: numbers(name, velocities) for name, velocities in along.items()}


def wanted_names(scene: Scene, names: Sequence[str] | None, sensor: int) -> list[str]:
    """What is differentiated with respect to."""
    if isinstance(names, str):
        raise TypeError(f"names is the string {names!r}; expected a list of names: [{names!r}]")
    if names is not None:
        return list(names)
    allowed, refused, reason = scene._gradient_names(sensor)
    if refused:
        text = f"{', '.join(refused)} are left out: {reason}"
        if not allowed:
            raise ArgumentError(f"nothing in this scene can be differentiated: {text}")
        warnings.warn(text, UnreliableWarning, stacklevel=3)
    return allowed


def warned(scene: Scene) -> Scene:
    """A scene that was just loaded, after warnings for all properties without effect in its
    file."""
    for warning in scene.warnings:
        warnings.warn(warning, SceneWarning, stacklevel=3)
    return scene


def warn_of_device(remark: str | None) -> None:
    """For the caller of the function that calls this."""
    if remark is not None:
        warnings.warn(remark, DeviceWarning, stacklevel=3)


def warn_of(statistics: Mapping[str, Any]) -> None:
    """Warns of samples that are infinite or NaN, and of what is missing in a gradient."""
    if statistics["missing"]:
        warnings.warn(statistics["missing"], UnreliableWarning, stacklevel=3)
    if statistics["non_finite"]:
        text = f"{statistics['non_finite']} of {statistics['samples']} samples were infinite or NaN"
        text += ", and count as zero"
        if statistics["too_many_non_finite"]:
            text += ": too many, do not use these images"
        warnings.warn(text, UnreliableWarning, stacklevel=3)


def _texts(defines: Mapping[str, object]) -> dict[str, str]:
    def text(name: str, value: object) -> str:
        if isinstance(value, bool | np.bool_):
            return "true" if value else "false"
        if isinstance(value, str | int | float | np.integer | np.floating):
            return str(value)
        raise TypeError(f"{name} is {value!r}; expected a string, a number, True or False")

    return {name: text(name, value) for name, value in defines.items()}

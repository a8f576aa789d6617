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
from ._options import LARGEST_COUNT, integer, options
from ._progress import Progress, shown
from ._results import Check, Gradients, Picture, Slope
from .errors import ArgumentError, DeviceWarning, SceneWarning, UnreliableWarning

Scene = _capwalk.Scene
Along = str | Mapping[str, ArrayLike]
Sensor = int | str


def load_file(path: str | os.PathLike[str], /, **defines: object) -> Scene:
    """The scene in a Mitsuba 3 XML file, or the built-in scene of this name (``"leaf"``,
    ``"ball"``, ``"box-room"``, ``"lattice-shadow"``).

    Keyword arguments are values of ``$name`` in the file and win over its ``<default>``. What
    has no effect, or is read as something else, is a :class:`SceneWarning`.

    :raises LoadError: the file is no scene; with ``file``, ``line`` and ``column``.
    """
    return warned(_capwalk.load_file(os.fspath(path), _texts(defines)))


def load_string(text: str, folder: str | os.PathLike[str] = ".", /, **defines: object) -> Scene:
    """The scene in a text of Mitsuba's XML. Files in it are relative to ``folder``.

    :raises LoadError: the text is no scene; with ``line`` and ``column``.
    """
    return warned(_capwalk.load_string(text, os.fspath(folder), _texts(defines)))


def check_device(device: object) -> None:
    if not isinstance(device, str):
        raise TypeError(f"device is {device!r}; expected a name")


def warn_of_device(remark: str | None) -> None:
    """For the caller of the function that calls this."""
    if remark is not None:
        warnings.warn(remark, DeviceWarning, stacklevel=3)


def render(
    scene: Scene,
    *,
    sensor: Sensor = 0,
    aov: str | None = None,
    spp: int | None = None,
    seed: int | None = None,
    threads: int | None = None,
    progress: Progress = None,
    device: str = "cpu",
) -> Picture:
    """The image of a scene with its standard errors.

    The same scene, ``spp`` and ``seed`` give the same bits on one device, whatever ``threads`` is;
    ``"cpu"`` is one device, on every machine.

    :param sensor: which of the scene's sensors, by number from 0 or by name.
    :param aov: what is shown of the surfaces that are seen, instead of their light: ``"depth"``,
        ``"position"``, ``"uv"``, ``"geo_normal"``, ``"sh_normal"``, ``"albedo"``, ``"mask"``.
    :param spp: samples per pixel, at least 1; by default the scene's.
    :param seed: of all random numbers, 0 to 2**64 - 1; by default the scene's.
    :param threads: worker threads; by default all cores.
    :param progress: ``True`` for a bar, or a function of what is done and what there is to do.
    :param device: ``"cpu"``, the processor; ``"gpu"``, a GPU or software Vulkan, for scenes with
        diffuse surfaces, metals, plastics, area emitters and environments; or ``"auto"``, a GPU with double
        precision if there is one that has all that the scene needs, else the processor, with a
        :class:`DeviceWarning` that says why if there is a GPU. A GPU takes the samples of the
        processor and rounds differently: nearly all of them agree within 0.02 %.
        ``picture.device`` says where it was.
    :raises ArgumentError: ``"gpu"`` for a scene that needs what the GPU does not have, which the
        message names; a device of another name.
    :raises DeviceError: ``"gpu"`` where there is none; a GPU that fails.
    """
    check_device(device)
    with shown(progress, "render") as told:
        asked = options(scene, sensor, spp, seed, aov=aov, threads=threads, progress=told)
        ((value, stderr), statistics), adapter, remark = _capwalk.render(scene, asked, device)
    warn_of(statistics)
    warn_of_device(remark)
    return Picture(value, stderr, statistics, adapter or "cpu", _files=tuple(scene._files))


def gradient(
    scene: Scene,
    along: Along,
    *,
    sensor: Sensor = 0,
    aov: str | None = None,
    spp: int | None = None,
    seed: int | None = None,
    threads: int | None = None,
    progress: Progress = None,
    method: str | Method = "auto",
    steps: int | None = None,
    max_angle: float | None = None,
    antithetic: bool | None = None,
    allow_missing: Sequence[str] = (),
    device: str = "cpu",
) -> Slope:
    """The derivative of the image along one direction (forward mode), without bias, with its
    standard errors.

    :param along: an expression such as ``"ball.translate.x"`` or ``"a.scale - 2*b.scale"``, or
        velocities of arrays by their names: ``{"ball.positions": array of shape (V, 3)}``.
    :param sensor: which of the scene's sensors, by number from 0 or by name.
    :param aov: what is shown instead of light, see :func:`render`.
    :param spp: samples per pixel, at least 1; by default the scene's.
    :param seed: of all random numbers, 0 to 2**64 - 1; by default the scene's.
    :param threads: worker threads; by default all cores. They change no bit.
    :param progress: ``True`` for a bar, or a function of what is done and what there is to do.
    :param method: ``"auto"`` takes the method with the least variance × time, which is
        ``"walk"`` (the paper's) or ``"edges"``; or a :class:`Method` that was chosen before.
    :param steps: steps of a walk, for these two, at most 1000.
    :param max_angle: the walk's angular cutoff, degrees, above 0 and at most 180.
    :param antithetic: whether walks average opposite rim samples.
    :param allow_missing: ``("specular",)`` leaves out how silhouettes and hard shadows move that
        are seen in curved mirrors, through refracting glass, or after many reflections, instead of
        refusing the derivative; ``statistics["missing"]`` is the share of the radiance that
        arrives by paths with such events, whether something moves there or not.
    :param device: see :func:`render`. GPUs do not have all derivatives: for others ``"auto"`` takes
        the processor, and ``"gpu"`` raises :class:`ArgumentError` with the reason.
    :raises Refused: the derivative could only be estimated with a bias; with ``reason`` and
        ``instead``.
    :raises ParameterError: a name means no parameter.
    :raises ArgumentError: velocities of another shape than the array's, and all else.
    """
    check_device(device)
    with shown(progress, "gradient") as told:
        asked = options(
            scene,
            sensor,
            spp,
            seed,
            aov=aov,
            threads=threads,
            progress=told,
            method=method,
            steps=steps,
            max_angle=max_angle,
            antithetic=antithetic,
            allow_missing=allow_missing,
        )
        found, adapter, remark = _capwalk.gradient(scene, direction(along), asked, device)
    value, slope, chosen, statistics = found
    warn_of(statistics)
    warn_of_device(remark)
    made, files = Method(*chosen), tuple(scene._files)
    return Slope(*slope, *value, made, statistics, adapter or "cpu", _files=files)


def backward(
    scene: Scene,
    adjoint: ArrayLike,
    names: Sequence[str] | None = None,
    *,
    sensor: Sensor = 0,
    aov: str | None = None,
    spp: int | None = None,
    seed: int | None = None,
    threads: int | None = None,
    progress: Progress = None,
    method: str | Method = "auto",
    steps: int | None = None,
    max_angle: float | None = None,
    antithetic: bool | None = None,
    allow_missing: Sequence[str] = (),
    device: str = "cpu",
) -> Gradients:
    """The gradient of ``(adjoint * image).sum()`` with respect to arrays of the scene, all in
    one pass (reverse mode), without bias.

    :param adjoint: derivative of a loss with respect to each pixel, (height, width, 3). Its
        noise must be independent of ``seed``: render the image that it comes from with another
        one, or the product of both is biased.
    :param names: of the arrays; by default all that can be differentiated with respect to, with
        a warning if some cannot. Numbers such as ``"ball.translate.x"`` and sums of them are
        allowed.
    :param seed: of all random numbers, 0 to 2**64 - 1; by default one that no image has which
        is rendered with the scene's.
    :return: the gradients by name, each in the shape of its array, and their ``stderr``.

    The other parameters, and what is raised, are those of :func:`gradient`.
    """
    check_device(device)
    with shown(progress, "backward") as told:
        asked = options(
            scene,
            sensor,
            spp,
            seed,
            independent=True,
            aov=aov,
            threads=threads,
            progress=told,
            method=method,
            steps=steps,
            max_angle=max_angle,
            antithetic=antithetic,
            allow_missing=allow_missing,
        )
        wanted = wanted_names(scene, names, asked.sensor)
        found, adapter, remark = _capwalk.backward(
            scene, numbers("adjoint", adjoint), wanted, asked, device
        )
    values, errors, chosen, statistics = found
    warn_of(statistics)
    warn_of_device(remark)
    return Gradients(values, errors, Method(*chosen), statistics, adapter or "cpu")


def check(
    scene: Scene,
    along: Along,
    *,
    sensor: Sensor = 0,
    aov: str | None = None,
    spp: int | None = None,
    reference_spp: int | None = None,
    step: float | None = None,
    seed: int | None = None,
    threads: int | None = None,
    progress: Progress = None,
    method: str | Method = "auto",
    steps: int | None = None,
    max_angle: float | None = None,
    antithetic: bool | None = None,
    allow_missing: Sequence[str] = (),
) -> Check:
    """A gradient against finite differences of the image, with a verdict.

    Pixels get more or fewer samples by how noisy they are, in the time of ``spp`` of each.

    Where the differences contradict the gradient or leave a doubt of it, a second reference with
    four times their samples decides; if it contradicts the first, a third one or a fourth.

    :param reference_spp: samples per pixel of the first differences, on each side; by default as
        many as suit the noise of both.
    :param step: how far the parameter moves on each side, in its own units; by default what
        fits the scene, and in each further reference a quarter of that of the one before.

    The other parameters, and what is raised, are those of :func:`gradient`.
    """
    if reference_spp is not None:
        reference_spp = integer("reference_spp", reference_spp, 1, LARGEST_COUNT)
    with shown(progress, "check") as told:
        asked = options(
            scene,
            sensor,
            spp,
            seed,
            aov=aov,
            threads=threads,
            progress=told,
            method=method,
            steps=steps,
            max_angle=max_angle,
            antithetic=antithetic,
            allow_missing=allow_missing,
        )
        slope, reference, found = _capwalk.check(
            scene, direction(along), asked, reference_spp, step
        )
    warn_of(found["statistics"])
    warn_of(found["reference_statistics"])
    return Check(
        gradient=slope[0],
        stderr=slope[1],
        reference=reference[0],
        reference_stderr=reference[1],
        **found,
    )


def direction(along: Along) -> str | dict[str, Array]:
    """What the image changes along, as the module takes it."""
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
    """A scene that was just loaded, after a warning for all that its file says in vain."""
    for warning in scene.warnings:
        warnings.warn(warning, SceneWarning, stacklevel=3)
    return scene


def warn_of(statistics: Mapping[str, Any]) -> None:
    """Warns of samples that are no numbers, and of what is left out."""
    if statistics.get("missing"):
        text = statistics["missing_text"]
        warnings.warn(f"the derivative is incomplete: {text}", UnreliableWarning, stacklevel=3)
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

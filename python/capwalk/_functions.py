"""Loading, rendering and differentiating."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _capwalk
from ._options import integer, options
from ._progress import Progress, shown
from ._results import Array, Check, Gradients, Picture, Slope
from .errors import ArgumentError, SceneWarning, UnreliableWarning

Scene = _capwalk.Scene
Along = str | Mapping[str, ArrayLike]


def load_file(path: str | os.PathLike[str], **defines: object) -> Scene:
    """The scene in a Mitsuba 3 XML file, or the built-in scene of this name (``"leaf"``,
    ``"ball"``, ``"box-room"``, ``"lattice"``, ``"lattice-shadow"``).

    Keyword arguments are values of ``$name`` in the file and win over its ``<default>``. What
    has no effect, or is read as something else, is a :class:`SceneWarning`.

    :raises LoadError: the file is no scene; with ``file``, ``line`` and ``column``.
    """
    return _warned(_capwalk.load_file(os.fspath(path), _texts(defines)))


def load_string(text: str, *, folder: str | os.PathLike[str] = ".", **defines: object) -> Scene:
    """The scene in a text of Mitsuba's XML. Files in it are relative to ``folder``.

    :raises LoadError: the text is no scene; with ``line`` and ``column``.
    """
    return _warned(_capwalk.load_string(text, os.fspath(folder), _texts(defines)))


def render(
    scene: Scene,
    *,
    spp: int | None = None,
    seed: int | None = None,
    threads: int | None = None,
    progress: Progress = None,
) -> Picture:
    """The image of a scene with its standard errors.

    The same scene, ``spp`` and ``seed`` give the same bits, whatever ``threads`` is.

    :param spp: samples per pixel, at least 1; by default the scene's.
    :param seed: of all random numbers, 0 to 2**64 - 1; by default the scene's.
    :param threads: worker threads; by default all cores.
    :param progress: ``True`` for a bar, or a function of what is done and what there is to do.
    """
    with shown(progress, "render") as told:
        (value, stderr), statistics = _capwalk.render(
            scene, options(scene, spp, seed, threads, told)
        )
    _warn_of(statistics)
    return Picture(value, stderr, statistics)


def gradient(
    scene: Scene,
    along: Along,
    *,
    spp: int | None = None,
    seed: int | None = None,
    threads: int | None = None,
    progress: Progress = None,
    method: str = "auto",
    steps: int | None = None,
    max_angle: float | None = None,
    antithetic: bool | None = None,
) -> Slope:
    """The derivative of the image along one direction (forward mode), without bias, with its
    standard errors.

    :param along: an expression such as ``"ball.translate.x"`` or ``"a.scale - 2*b.scale"``, or
        velocities of arrays by their names: ``{"ball.positions": array of shape (V, 3)}``.
    :param spp: samples per pixel, at least 1; by default the scene's.
    :param seed: of all random numbers, 0 to 2**64 - 1; by default the scene's.
    :param threads: worker threads; by default all cores. They change no bit.
    :param progress: ``True`` for a bar, or a function of what is done and what there is to do.
    :param method: ``"auto"`` takes the method with the least variance × time, which is
        ``"walk"`` (the paper's) or ``"edges"``.
    :param steps: steps of a walk, for these two.
    :param max_angle: the walk's angular cutoff, degrees, above 0 and at most 180.
    :param antithetic: whether walks average opposite rim samples.
    :raises Refused: the derivative could only be estimated with a bias; with ``reason`` and
        ``instead``.
    :raises ParameterError: a name means no parameter.
    """
    with shown(progress, "gradient") as told:
        value, slope, chosen, statistics = _capwalk.gradient(
            scene,
            _direction(along),
            options(
                scene,
                spp,
                seed,
                threads,
                told,
                method=method,
                steps=steps,
                max_angle=max_angle,
                antithetic=antithetic,
            ),
        )
    _warn_of(statistics)
    return Slope(*slope, *value, chosen["method"], statistics)


def backward(
    scene: Scene,
    adjoint: ArrayLike,
    names: Sequence[str] | None = None,
    *,
    spp: int | None = None,
    seed: int | None = None,
    threads: int | None = None,
    progress: Progress = None,
    method: str = "auto",
    steps: int | None = None,
    max_angle: float | None = None,
    antithetic: bool | None = None,
) -> Gradients:
    """The gradient of ``(adjoint * image).sum()`` with respect to arrays of the scene, all in
    one pass (reverse mode), without bias.

    :param adjoint: derivative of a loss with respect to each pixel, (height, width, 3). Its
        noise must be independent of ``seed``: render the image that it comes from with another
        one, or the product of both is biased.
    :param names: of the arrays; by default all of :func:`traverse`. Numbers such as
        ``"ball.translate.x"`` and sums of them are allowed.
    :return: the gradients by name, each in the shape of its array, and their ``stderr``.

    The other parameters, and what is raised, are those of :func:`gradient`.
    """
    if isinstance(names, str):
        raise TypeError(f"names is the string {names!r}; expected a list of names: [{names!r}]")
    wanted = [n for n, _, _, _, alias, _ in scene.arrays() if alias is None]
    if names is not None:
        wanted = list(names)
    with shown(progress, "backward") as told:
        values, errors, statistics = _capwalk.backward(
            scene,
            _numbers("adjoint", adjoint),
            wanted,
            options(
                scene,
                spp,
                seed,
                threads,
                told,
                method=method,
                steps=steps,
                max_angle=max_angle,
                antithetic=antithetic,
            ),
        )
    _warn_of(statistics)
    return Gradients(values, errors, statistics)


def check(
    scene: Scene,
    along: Along,
    *,
    spp: int | None = None,
    reference_spp: int | None = None,
    step: float | None = None,
    seed: int | None = None,
    threads: int | None = None,
    progress: Progress = None,
    method: str = "auto",
    steps: int | None = None,
    max_angle: float | None = None,
    antithetic: bool | None = None,
) -> Check:
    """A gradient against central differences of the image, with a verdict.

    :param reference_spp: samples per pixel of the differences, on each side; by default four
        times ``spp``.
    :param step: how far the parameter moves on each side, in its own units; by default what
        fits the scene.

    The other parameters, and what is raised, are those of :func:`gradient`.
    """
    if reference_spp is not None:
        reference_spp = integer("reference_spp", reference_spp, 1, 2**32 - 1)
    with shown(progress, "check") as told:
        slope, reference, numbers = _capwalk.check(
            scene,
            _direction(along),
            options(
                scene,
                spp,
                seed,
                threads,
                told,
                method=method,
                steps=steps,
                max_angle=max_angle,
                antithetic=antithetic,
            ),
            reference_spp,
            step,
        )
    return Check(
        gradient=slope[0],
        stderr=slope[1],
        reference=reference[0],
        reference_stderr=reference[1],
        **numbers,
    )


def _direction(along: Along) -> str | dict[str, Array]:
    if isinstance(along, str):
        return along
    if not isinstance(along, Mapping):
        raise TypeError(
            f"the direction is a {type(along).__name__}; expected the name of a parameter, or a "
            "dict of velocities by the names of arrays"
        )
    return {name: _numbers(name, velocities) for name, velocities in along.items()}


def _numbers(what: str, value: ArrayLike) -> Array:
    try:
        return np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ArgumentError(f"{what} is no array of numbers: {error}") from error


def _texts(defines: Mapping[str, object]) -> dict[str, str]:
    words = {True: "true", False: "false"}
    return {
        name: words[value] if isinstance(value, bool) else str(value)
        for name, value in defines.items()
    }


def _warned(scene: Scene) -> Scene:
    for warning in scene.warnings:
        warnings.warn(warning, SceneWarning, stacklevel=3)
    return scene


def _warn_of(statistics: Mapping[str, Any]) -> None:
    if statistics["too_many_non_finite"]:
        text = f"{statistics['non_finite']} of {statistics['samples']} samples were infinite or NaN"
        warnings.warn(f"{text} and count as zero", UnreliableWarning, stacklevel=3)

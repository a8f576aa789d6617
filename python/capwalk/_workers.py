"""Images and gradients in parts, by any kind of worker."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Generator, Mapping, Sequence
from contextlib import closing
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _capwalk
from ._functions import Along, Scene, direction, wanted_names, warn_of
from ._method import Method
from ._numbers import Array, numbers
from ._options import Options, check_names, checked, integer, sensor_numbers
from ._parts import Asked, Job
from ._progress import shown
from ._results import GradientImage, Gradients, Image
from .errors import ArgumentError
from .options import ImageOptions, PartsOptions, Sensor, ViewGradientsOptions, ViewsOptions, Unpack

MOST_PARTS = 64
"""16 batches of samples of 4 bands of pixels are not cut further."""

Finished = Generator[tuple[int, bytes], None, None]
"""The number of a job, and a part of it."""


class Workers(ABC):
    """Renders and differentiates in parts. The same arguments give the same bits as the functions
    of :mod:`capwalk`, and raise the same exceptions.

    Scenes are sent to each worker once, later only their changes. Changing a scene while it is
    rendered raises a :class:`BusyError`.
    """

    def __init__(self, parts: int, threads: int) -> None:
        self._parts = integer("parts", parts, 1, MOST_PARTS)
        self._threads = integer("threads", threads, 1, 1024)

    def render(self, scene: Scene, **options: Unpack[ImageOptions]) -> Image:
        """The image of a scene with its standard errors, see :func:`capwalk.render`."""
        check_names("render", ImageOptions, options)
        asked = checked(scene, options, threads=self._threads)
        work: list[tuple[Asked, Options]] = [(None, asked)]
        [((value, stderr), statistics, _)] = self._done("render", scene, work, options)
        warn_of(statistics)
        return Image(value, stderr, statistics, _files=tuple(scene._files))

    def gradient(
        self,
        scene: Scene,
        along: Along,
        **options: Unpack[PartsOptions],
    ) -> GradientImage:
        """The derivative of the image along one direction, see :func:`capwalk.gradient`. With
        ``method="auto"`` this process chooses the method first, on all of its cores."""
        check_names("gradient", PartsOptions, options)
        asked = checked(scene, options, threads=self._threads)
        work = [(direction(along), asked)]
        [result] = self._done("gradient", scene, work, options)
        (value, value_stderr), (gradient, stderr), chosen, statistics, _ = result
        warn_of(statistics)
        made, files = Method(*chosen), tuple(scene._files)
        name = along if isinstance(along, str) else ""
        return GradientImage(
            gradient, stderr, value, value_stderr, made, statistics, _files=files, _along=name
        )

    def backward(
        self,
        scene: Scene,
        adjoint: ArrayLike,
        names: Sequence[str] | None = None,
        **options: Unpack[PartsOptions],
    ) -> Gradients:
        """The gradient of ``(adjoint * image).sum()`` with respect to arrays of the scene, see
        :func:`capwalk.backward`. With ``method="auto"`` this process chooses the method first,
        on all of its cores."""
        check_names("backward", PartsOptions, options)
        asked = checked(scene, options, threads=self._threads, independent=True)
        wanted = wanted_names(scene, names, asked.sensor)
        work = [((numbers("adjoint", adjoint), wanted), asked)]
        [(values, errors, chosen, statistics, _)] = self._done("backward", scene, work, options)
        warn_of(statistics)
        return Gradients(values, errors, Method(*chosen), statistics)

    def render_views(
        self,
        scene: Scene,
        sensors: Sequence[Sensor] | None = None,
        **options: Unpack[ViewsOptions],
    ) -> list[Image]:
        """The images of several sensors, whose parts are all computed together.

        :param sensors: by number from 0 or by name; by default all of the scene's.
        :param options: those of :meth:`render` but ``sensor``; ``seed`` is that of the first view,
            the others have :func:`view_seed`, so that their noise is independent.
        :return: an image for each sensor, in their order, each as :meth:`render` gives it.
        """
        check_names("render_views", ViewsOptions, options)
        work: list[tuple[Asked, Options]] = []
        for view, sensor in enumerate(_sensors(scene, sensors)):
            asked = checked(scene, {**options, "sensor": sensor}, threads=self._threads)
            work.append((None, replace(asked, seed=view_seed(asked.seed, view))))
        results = self._done("render", scene, work, options)
        warn_of(_together([statistics for _, statistics, _ in results]))
        files = tuple(scene._files)
        return [
            Image(value, stderr, statistics, _files=files)
            for (value, stderr), statistics, _ in results
        ]

    def backward_views(
        self,
        scene: Scene,
        adjoints: Sequence[ArrayLike],
        names: Sequence[str] | None = None,
        *,
        sensors: Sequence[Sensor] | None = None,
        **options: Unpack[ViewGradientsOptions],
    ) -> Gradients:
        """The gradient of a loss of the images of several sensors, whose parts are all computed
        together: the sum of the results of :meth:`backward` for each, in the order of the sensors,
        with the standard errors of the sum. Arrays of a sensor, such as ``"left.to_world"``, change
        its own image only; if that image is not requested, their gradient is zero. A sum of numbers
        must not contain those of a sensor.

        :param adjoints: derivative of the loss with respect to each pixel, (height, width, 3),
            for each sensor.
        :param sensors: by number from 0 or by name; by default all of the scene's.
        :param options: those of :meth:`backward` but ``sensor``; ``seed`` is that of the first
            view, the others have :func:`view_seed`, so that their noise is independent.
        """
        check_names("backward_views", ViewGradientsOptions, options)
        views = _sensors(scene, sensors)
        if len(adjoints) != len(views):
            raise ArgumentError(
                f"there are {len(adjoints)} adjoints for {len(views)} sensors; expected one for "
                "each"
            )
        ids = [name for name, _, _, _ in scene._sensors()]
        # Of sensors whose images are not among these. Typos are errors.
        unseen: dict[str, list[int]] = {}
        if names is not None and not isinstance(names, str):
            names = list(names)
            for name in names:
                owner = _owner(ids, name)
                if owner is not None and owner not in views:
                    unseen[name] = scene._gradient_shape(name, owner)
        work: list[tuple[Asked, Options]] = []
        for view, (sensor, adjoint) in enumerate(zip(views, adjoints)):
            of_view = {**options, "sensor": sensor}
            asked = checked(scene, of_view, threads=self._threads, independent=True)
            asked = replace(asked, seed=view_seed(asked.seed, view))
            wanted = _seen(ids, wanted_names(scene, names, sensor), sensor)
            image = numbers(f"adjoints[{view}]", adjoint)
            # A view of which nothing is wanted is not sampled.
            if wanted:
                work.append(((image, wanted), asked))
        if not work:
            raise ArgumentError("none of these images changes with any of the names")
        results = self._done("backward", scene, work, options)
        statistics = _together([statistics for *_, statistics, _ in results])
        warn_of(statistics)
        values: dict[str, Array] = {}
        stderr: dict[str, Array] = {}
        for of_view, errors, *_ in results:
            for name, value in of_view.items():
                values[name] = values.get(name, 0.0) + value
                stderr[name] = np.hypot(stderr.get(name, 0.0), errors[name])
        values.update({name: np.zeros(shape) for name, shape in unseen.items()})
        stderr.update({name: np.zeros(shape) for name, shape in unseen.items()})
        _, _, first, *_ = results[0]
        return Gradients(values, stderr, Method(*first), statistics)

    def _done(
        self,
        what: str,
        scene: Scene,
        work: Sequence[tuple[Asked, Options]],
        given: Mapping[str, Any],
    ) -> list[Any]:
        """What the functions of `_capwalk` give, for each work."""
        jobs = []
        for asked, how in work:
            revision = scene.revision
            # Not by each worker. It refuses what is refused, too.
            chosen = _capwalk.choose(scene, asked, replace(how, threads=None))
            settings = None if chosen is None else chosen[1]
            jobs.append(Job(scene, asked, replace(how, chosen=settings), revision))
        parts: list[list[bytes]] = [[] for _ in jobs]
        samples = [job.samples for job in jobs]
        done, total = 0, sum(samples) * self._parts
        with shown(given.get("progress"), what) as told, closing(self._finished(jobs)) as finished:
            for number, part in finished:
                parts[number].append(part)
                done += samples[number]
                if told is not None:
                    told(done // self._parts, total // self._parts)
        return [job.merged(parts) for job, parts in zip(jobs, parts)]

    @abstractmethod
    def _finished(self, jobs: Sequence[Job]) -> Finished:
        """All parts of all jobs, as they are finished. Stops what is left when it is closed."""


def view_seed(seed: int, view: int) -> int:
    """The seed of a view among several, by its number from 0: ``seed`` plus so many times 2**64
    divided by the golden ratio, modulo 2**64. So the seeds of views never collide with nearby seeds
    such as ``seed + 1``, and the first is ``seed``.

    >>> view_seed(7, 0), view_seed(7, 1)
    (7, 11400714819323198492)
    """
    return _capwalk.view_seed(seed, view)


def _sensors(scene: Scene, sensors: Sequence[Sensor] | None) -> list[int]:
    """The numbers of the sensors."""
    if sensors is None:
        return list(range(len(scene._sensors())))
    return sensor_numbers(scene, "sensors", sensors)


def _owner(ids: Sequence[str], name: str) -> int | None:
    """The number of the sensor of which an array or a number is; ``None`` for those of the scene,
    and for sums, which are not looked into."""
    owners = [i for i, id in enumerate(ids) if name.startswith(f"{id}.")]
    owner = max(owners, key=lambda i: len(ids[i]), default=None)
    if owner is None or not re.fullmatch(r"[\w.\[\], ]+", name[len(ids[owner]) :]):
        return None
    return owner


def _seen(ids: Sequence[str], names: Sequence[str], sensor: int) -> list[str]:
    """The names as the scene has them, without those of other sensors, on which the image does
    not depend. Without one of that name, ``sensor`` is the one that renders."""
    if len(ids) == 1:
        return list(names)
    seen = []
    for name in names:
        if name.startswith("sensor.") and "sensor" not in ids:
            name = ids[sensor] + name.removeprefix("sensor")
        if _owner(ids, name) in (None, sensor):
            seen.append(name)
    return seen


def _together(statistics: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """The statistics of all views."""

    def first(texts: Sequence[str | None]) -> str | None:
        return next(filter(None, texts), None)

    merged = {"complete": all, "too_many_non_finite": any, "missing": first}
    return {
        name: merged.get(name, sum)([of_view[name] for of_view in statistics])
        for name in statistics[0]
    }

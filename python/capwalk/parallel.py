"""Images and gradients by the workers of a :class:`concurrent.futures.Executor`.

>>> from concurrent.futures import ThreadPoolExecutor
>>> import numpy as np
>>> import capwalk as cw, capwalk.parallel
>>> scene = cw.load_file("leaf")
>>> scene.resize(16, 12)
>>> with ThreadPoolExecutor(2) as executor:
...     workers = capwalk.parallel.Pool(executor)
...     picture = workers.render(scene, spp=4)
>>> bool(np.array_equal(picture, cw.render(scene, spp=4)))
True

The samples are cut into parts, whose results are merged to the bits of the whole: those of
:func:`capwalk.render` and its like, however many parts and workers there are.
"""

from __future__ import annotations

import os
import pickle
import re
import tempfile
import threading
import weakref
from abc import ABC, abstractmethod
from collections.abc import Generator, Mapping, Sequence
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    ThreadPoolExecutor,
    wait,
)
from contextlib import closing, suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _capwalk
from ._functions import Along, Scene, Sensor, direction, wanted_names, warn_of
from ._numbers import Array, numbers
from ._options import LARGEST_SEED, Options, integer, options
from ._parts import Asked, Job, Sender, SentJob
from ._progress import Progress, shown
from ._results import Gradients, Picture, Slope
from .errors import ArgumentError, Error

__all__ = ["Pool", "WorkerError", "Workers", "view_seed"]

MOST_PARTS = 64
"""16 batches of samples of 4 bands of pixels are not cut further."""

Finished = Generator[tuple[int, bytes], None, None]
"""The number of a job, and a part of it."""


class WorkerError(Error, RuntimeError):
    """A worker that was lost: killed, out of memory, or on a machine that is gone."""


class Workers(ABC):
    """Renders and differentiates by parts. The same arguments give the same bits as the
    functions of :mod:`capwalk`; what is raised is the same, too.

    Scenes are sent to each worker once, later what has changed of them. They must not be
    changed while they are rendered, which is a :class:`BusyError`.
    """

    def __init__(self, parts: int, threads: int) -> None:
        self._parts = integer("parts", parts, 1, MOST_PARTS)
        self._threads = integer("threads", threads, 1, 1024)

    def render(
        self,
        scene: Scene,
        *,
        sensor: Sensor = 0,
        aov: str | None = None,
        spp: int | None = None,
        seed: int | None = None,
        progress: Progress = None,
    ) -> Picture:
        """The image of a scene with its standard errors, see :func:`capwalk.render`."""
        asked = options(scene, sensor, spp, seed, aov=aov, threads=self._threads)
        [((value, stderr), statistics)] = self._done("render", scene, [(None, asked)], progress)
        warn_of(statistics)
        return Picture(value, stderr, statistics)

    def gradient(
        self,
        scene: Scene,
        along: Along,
        *,
        sensor: Sensor = 0,
        aov: str | None = None,
        spp: int | None = None,
        seed: int | None = None,
        progress: Progress = None,
        method: str = "auto",
        steps: int | None = None,
        max_angle: float | None = None,
        antithetic: bool | None = None,
    ) -> Slope:
        """The derivative of the image along one direction, see :func:`capwalk.gradient`. With
        ``method="auto"`` this process chooses the method first, on all of its cores."""
        asked = options(
            scene,
            sensor,
            spp,
            seed,
            aov=aov,
            threads=self._threads,
            method=method,
            steps=steps,
            max_angle=max_angle,
            antithetic=antithetic,
        )
        work = [(direction(along), asked)]
        [result] = self._done("gradient", scene, work, progress)
        (value, value_stderr), (slope, stderr), chosen, statistics = result
        warn_of(statistics)
        return Slope(slope, stderr, value, value_stderr, chosen, statistics)

    def backward(
        self,
        scene: Scene,
        adjoint: ArrayLike,
        names: Sequence[str] | None = None,
        *,
        sensor: Sensor = 0,
        aov: str | None = None,
        spp: int | None = None,
        seed: int | None = None,
        progress: Progress = None,
        method: str = "auto",
        steps: int | None = None,
        max_angle: float | None = None,
        antithetic: bool | None = None,
    ) -> Gradients:
        """The gradient of ``(adjoint * image).sum()`` with respect to arrays of the scene, see
        :func:`capwalk.backward`. With ``method="auto"`` this process chooses the method first,
        on all of its cores."""
        asked = options(
            scene,
            sensor,
            spp,
            seed,
            independent=True,
            aov=aov,
            threads=self._threads,
            method=method,
            steps=steps,
            max_angle=max_angle,
            antithetic=antithetic,
        )
        wanted = wanted_names(scene, names, asked.sensor)
        work = [((numbers("adjoint", adjoint), wanted), asked)]
        [(values, errors, statistics)] = self._done("backward", scene, work, progress)
        warn_of(statistics)
        return Gradients(values, errors, statistics)

    def render_views(
        self,
        scene: Scene,
        sensors: Sequence[Sensor] | None = None,
        *,
        aov: str | None = None,
        spp: int | None = None,
        seed: int | None = None,
        progress: Progress = None,
    ) -> list[Picture]:
        """The images of several sensors, all of whose parts are done at once.

        :param sensors: by number from 0 or by name; by default all of the scene's.
        :param seed: of the first view; the others have :func:`view_seed`, so that their noise
            is independent.
        :return: an image for each sensor, in their order, each as :meth:`render` gives it.
        """
        work: list[tuple[Asked, Options]] = []
        for view, sensor in enumerate(_sensors(scene, sensors)):
            asked = options(scene, sensor, spp, seed, aov=aov, threads=self._threads)
            work.append((None, replace(asked, seed=view_seed(asked.seed, view))))
        results = self._done("render", scene, work, progress)
        warn_of(_together([statistics for _, statistics in results]))
        return [Picture(value, stderr, statistics) for (value, stderr), statistics in results]

    def backward_views(
        self,
        scene: Scene,
        adjoints: Sequence[ArrayLike],
        names: Sequence[str] | None = None,
        *,
        sensors: Sequence[Sensor] | None = None,
        aov: str | None = None,
        spp: int | None = None,
        seed: int | None = None,
        progress: Progress = None,
        method: str = "auto",
        steps: int | None = None,
        max_angle: float | None = None,
        antithetic: bool | None = None,
    ) -> Gradients:
        """The gradient of a loss of the images of several sensors, all of whose parts are done
        at once: the sum of what :meth:`backward` gives for each, added in the order of the
        sensors, with the standard errors of the sum. Arrays of a sensor, such as
        ``"left.to_world"``, change its own image only.

        :param adjoints: derivative of the loss with respect to each pixel, (height, width, 3),
            for each sensor.
        :param sensors: by number from 0 or by name; by default all of the scene's.
        :param seed: of the first view; the others have :func:`view_seed`, so that their noise
            is independent.
        """
        views = _sensors(scene, sensors)
        if len(adjoints) != len(views):
            raise ArgumentError(
                f"there are {len(adjoints)} adjoints for {len(views)} sensors; expected one for "
                "each"
            )
        work: list[tuple[Asked, Options]] = []
        for view, (sensor, adjoint) in enumerate(zip(views, adjoints)):
            asked = options(
                scene,
                sensor,
                spp,
                seed,
                independent=True,
                aov=aov,
                threads=self._threads,
                method=method,
                steps=steps,
                max_angle=max_angle,
                antithetic=antithetic,
            )
            asked = replace(asked, seed=view_seed(asked.seed, view))
            wanted = wanted_names(scene, names, sensor)
            if len(views) > 1:
                wanted = _seen(scene, wanted, sensor, in_own_words=names is None)
            work.append(((numbers(f"adjoints[{view}]", adjoint), wanted), asked))
        results = self._done("backward", scene, work, progress)
        statistics = _together([statistics for _, _, statistics in results])
        warn_of(statistics)
        values: dict[str, Array] = {}
        stderr: dict[str, Array] = {}
        for of_view, errors, _ in results:
            for name, value in of_view.items():
                values[name] = values.get(name, 0.0) + value
                stderr[name] = np.hypot(stderr.get(name, 0.0), errors[name])
        return Gradients(values, stderr, statistics)

    def _done(
        self,
        what: str,
        scene: Scene,
        work: Sequence[tuple[Asked, Options]],
        progress: Progress,
    ) -> list[Any]:
        """What the functions of `_capwalk` give, for each work."""
        jobs = []
        for asked, how in work:
            revision = scene.revision
            # Not by each worker. It refuses what is refused, too.
            chosen = _capwalk.choose(scene, asked, replace(how, threads=None))
            jobs.append(Job(scene, asked, replace(how, chosen=chosen), revision))
        parts: list[list[bytes]] = [[] for _ in jobs]
        samples = [job.samples for job in jobs]
        done, total = 0, sum(samples) * self._parts
        with shown(progress, what) as told, closing(self._finished(jobs)) as finished:
            for number, part in finished:
                parts[number].append(part)
                done += samples[number]
                if told is not None:
                    told(done // self._parts, total // self._parts)
        return [job.merged(parts) for job, parts in zip(jobs, parts)]

    @abstractmethod
    def _finished(self, jobs: Sequence[Job]) -> Finished:
        """All parts of all jobs, as they are finished. Stops what is left when it is closed."""


class Pool(Workers):
    """The workers of an executor: a thread pool, a process pool, or anything else of which
    ``submit`` gives a :class:`concurrent.futures.Future`, such as those of mpi4py and Dask.

    The executor is yours: it is not shut down, and may be used for other things meanwhile.
    Other processes read scenes and adjoints from files in the folder for temporary files. Those
    that have no such file, on other machines, are sent what they need.

    :param parts: that images and gradients are cut into, 1 to 64. Take a few for each worker.
    :param threads: of each worker.

    All methods raise :class:`WorkerError` when a worker is lost, with which a process pool is.
    """

    def __init__(self, executor: Executor, *, parts: int = 16, threads: int = 1) -> None:
        super().__init__(parts, threads)
        self._executor = executor
        self._sender = Sender(_put)

    def _finished(self, jobs: Sequence[Job]) -> Finished:
        stop = threading.Event()
        pending: dict[Future[Any], _Task] = {}

        def submit(task: _Task) -> None:
            pending[self._executor.submit(task)] = task

        try:
            for number, job in enumerate(jobs):
                work = self._work(job, stop)
                for index in range(self._parts):
                    submit(_Task(work, number, index, self._parts))
            while pending:
                # Ctrl-C is not answered everywhere while a thread waits.
                finished, _ = wait(pending, timeout=0.2, return_when=FIRST_COMPLETED)
                for future in finished:
                    task, answer = pending.pop(future), future.result()
                    if isinstance(answer, _Missing):
                        submit(task.with_content(answer.key))
                    else:
                        yield task.job, answer
        except BrokenExecutor as error:
            raise WorkerError(
                "a worker was lost, perhaps killed for its memory, and the executor cannot be "
                f"used any more ({error}); make another one and try again"
            ) from error
        finally:
            stop.set()
            for future in pending:
                future.cancel()

    def _work(self, job: Job, stop: threading.Event) -> Job | SentJob:
        if not isinstance(self._executor, ThreadPoolExecutor):
            return self._sender.sent(job)

        # Threads have the scene. Their work is stopped by an exception.
        def check(done: int, total: int) -> None:
            if stop.is_set():
                raise CancelledError

        return replace(job, options=replace(job.options, progress=check))


def view_seed(seed: int, view: int) -> int:
    """The seed of a view among several, by its number from 0: ``seed`` plus so many times
    2**64 divided by the golden ratio, modulo 2**64. So the seeds of views are nobody's
    neighbours in a row of seeds, and that of the first is ``seed``.

    >>> view_seed(7, 0), view_seed(7, 1)
    (7, 11400714819323198492)
    """
    return (seed + view * 0x9E37_79B9_7F4A_7C15) & LARGEST_SEED


@dataclass(frozen=True)
class _Task:
    """A part as an executor gets it."""

    work: Job | SentJob
    job: int
    index: int
    count: int

    def __call__(self) -> bytes | _Missing:
        try:
            return self.work.part(self.index, self.count)
        except _MissingError as error:
            return _Missing(error.key)

    def with_content(self, key: str) -> _Task:
        """The same with what is in a file."""
        parcels = {name: getattr(self.work, name) for name in ("scene", "changes", "work")}
        [name] = [name for name, parcel in parcels.items() if parcel and parcel.key == key]
        return replace(self, work=replace(self.work, **{name: parcels[name].with_content()}))


@dataclass(frozen=True)
class _Missing:
    """The answer of a worker that has no file of this name."""

    key: str


class _MissingError(Exception):
    """There is no file of this name."""

    def __init__(self, key: str) -> None:
        super().__init__(key)
        self.key = key


@dataclass(frozen=True)
class _File:
    """A parcel in a temporary file, for the processes of this machine."""

    key: str
    """The path, which no other machine has by chance."""
    content: bytes | None = None
    """What is in the file, for those who have it not."""

    def open(self) -> Any:
        return pickle.loads(self._read() if self.content is None else self.content)

    def with_content(self) -> _File:
        return replace(self, content=self._read())

    def _read(self) -> bytes:
        try:
            with open(self.key, "rb") as file:
                return file.read()
        except OSError:
            raise _MissingError(self.key) from None


def _put(content: object) -> _File:
    unique = os.urandom(16).hex()
    with tempfile.NamedTemporaryFile(prefix=f"capwalk-{unique}-", delete=False) as file:
        parcel = _File(file.name)
        weakref.finalize(parcel, _remove, file.name, os.getpid())
        pickle.dump(content, file, protocol=pickle.HIGHEST_PROTOCOL)
    return parcel


def _remove(path: str, owner: int) -> None:
    # A forked process has the parcel, too.
    if os.getpid() == owner:
        with suppress(OSError):
            os.remove(path)


def _sensors(scene: Scene, sensors: Sequence[Sensor] | None) -> list[int]:
    """The numbers of the sensors."""
    if isinstance(sensors, str):
        raise TypeError(f"sensors is the string {sensors!r}; expected a list: [{sensors!r}]")
    if sensors is None:
        return list(range(len(scene._sensors())))
    if not sensors:
        raise ArgumentError("there are no sensors in the list; expected one at least")
    return [options(scene, sensor, None, None).sensor for sensor in sensors]


def _seen(scene: Scene, names: Sequence[str], sensor: int, *, in_own_words: bool) -> list[str]:
    """The names as the scene has them, without those of other sensors, on which the image does
    not depend. In its own words a sensor is called ``sensor``."""
    ids = [name for name, _, _, _ in scene._sensors()]
    seen = []
    for name in names:
        owner, _, array = name.partition(".")
        if owner == "sensor" and (in_own_words or owner not in ids):
            owner = ids[sensor]
            name = f"{owner}.{array}"
        is_of_another = owner in ids and owner != ids[sensor]
        # Sums of numbers are not looked into.
        if not is_of_another or not re.fullmatch(r"[\w.]+", name):
            seen.append(name)
    return seen


def _together(statistics: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """The statistics of all views."""
    merged = {"complete": all, "too_many_non_finite": any}
    return {
        name: merged.get(name, sum)([of_view[name] for of_view in statistics])
        for name in statistics[0]
    }

"""Images and gradients computed by the workers of a :class:`concurrent.futures.Executor`.

>>> from concurrent.futures import ThreadPoolExecutor
>>> import numpy as np
>>> import capwalk as cw, capwalk.parallel
>>> scene = cw.load_file("leaf")
>>> scene.resize(16, 12)
>>> with ThreadPoolExecutor(2) as executor:
...     workers = capwalk.parallel.Pool(executor)
...     image = workers.render(scene, spp=4)
>>> bool(np.array_equal(image, cw.render(scene, spp=4)))
True

The samples are divided into parts. Merged results equal those of :func:`capwalk.render`,
:func:`capwalk.gradient` and :func:`capwalk.backward` to the bit, for any number of parts and
workers.
"""

from __future__ import annotations

import os
import pickle
import tempfile
import threading
import weakref
from collections.abc import Sequence
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    ThreadPoolExecutor,
    wait,
)
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

from ._parts import Job, Sender, SentJob
from ._workers import Finished, Workers, view_seed
from .errors import WorkerError

__all__ = ["Pool", "Workers", "view_seed"]


class Pool(Workers):
    """The workers of an executor: a thread pool, a process pool, or anything else of which
    ``submit`` gives a :class:`concurrent.futures.Future`, such as those of mpi4py and Dask.

    The executor stays yours: it is not shut down, and may be used for other things meanwhile. Other
    processes read scenes and adjoints from temporary files. Workers on other machines, which cannot
    read these files, are sent their content.

    :param parts: number of parts of an image or gradient, 1 to 64. Use a few for each worker.
    :param threads: of each worker.

    All methods raise :class:`WorkerError` when a worker is lost; a process pool is unusable then.
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

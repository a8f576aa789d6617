"""Images and gradients by all machines of a `Ray <https://www.ray.io>`_ cluster::

    import capwalk as cw, capwalk.ray

    scene = cw.load_file("ball.xml")
    with capwalk.ray.Cluster() as cluster:
        image = cluster.render(scene, spp=4096, progress=True)
        gradients = cluster.backward(scene, 2 * (image.value - target), ["ball.positions"])

Results equal those of :func:`capwalk.render`, :func:`capwalk.gradient` and :func:`capwalk.backward`
to the bit, for any number of workers, even if some of them are lost meanwhile. All machines need
the same version of capwalk.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Any

import ray  # type: ignore[import-not-found, unused-ignore]

from ._closing import Closing
from ._options import integer
from ._parts import Job, Sender, SentJob
from ._workers import Finished, Workers, view_seed
from .errors import ArgumentError, Error, WorkerError

__all__ = ["Cluster", "view_seed"]


class Cluster(Closing, Workers):
    """The processes of a Ray cluster. Parts are Ray tasks: a free process takes the next one, and
    parts that were lost with a process or a machine are computed again by another.

    A scene is sent to each machine and each process once, and kept there; an update sends only the
    changes. A new process, such as the replacement of a lost one, fetches what it needs before it
    begins.

    Connects to Ray unless ``ray.init`` was called before, and then disconnects when it is closed.

    :param workers: number of parts that are computed at the same time, at least 1; by default as
        many as the cluster can run.
    :param threads: of each worker; Ray reserves as many cores for it.
    :param parts: number of parts of an image or gradient, 1 to 64. Use a few for each worker.
    :param address: where Ray runs; by default where ``ray.init`` finds it, or else it is started on
        this machine.
    :param retries: how often a part is computed again if its worker was lost; -1 for any number.
        After that a :class:`WorkerError` is raised, because the scene may be too large for any
        worker.
    """

    def __init__(
        self,
        workers: int | None = None,
        *,
        threads: int = 1,
        parts: int = 16,
        address: str | None = None,
        retries: int = 3,
    ) -> None:
        super().__init__(parts, threads)
        self._workers = None if workers is None else integer("workers", workers, 1, 2**16)
        retries = integer("retries", retries, -1, 2**16)
        self._connected = not ray.is_initialized()
        if self._connected:
            ray.init(address=address)
        elif address is not None:
            raise ArgumentError(
                f"Ray is connected already; leave out the address {address}, or call "
                "ray.shutdown() before"
            )
        part: Any = ray.remote(_part)
        self._part = part.options(num_cpus=self._threads, max_retries=retries, name="capwalk")
        self._sender: Sender | None = Sender(_put)

    def close(self) -> None:
        """Releases the scenes, and disconnects from Ray if this object has connected to it. It
        cannot be used afterwards."""
        self._sender = None
        if self._connected:
            self._connected = False
            ray.shutdown()

    def _finished(self, jobs: Sequence[Job]) -> Finished:
        if self._sender is None:
            raise Error("this cluster was closed; make another one")
        sent = [self._sender.sent(job) for job in jobs]
        tasks = ((job, index) for job in range(len(sent)) for index in range(self._parts))
        at_once = len(sent) * self._parts if self._workers is None else self._workers
        pending: dict[Any, int] = {}
        results: list[tuple[int, bytes]] = []
        try:
            while True:
                for job, index in islice(tasks, at_once - len(pending)):
                    pending[self._part.remote(sent[job], index, self._parts)] = job
                # Not before: whoever takes these may take time.
                yield from results
                if not pending:
                    return
                finished, _ = ray.wait(list(pending))
                results = [(pending.pop(task), ray.get(task)) for task in finished]
        except ray.exceptions.RayError as error:
            raised = getattr(error, "cause", None)
            if isinstance(raised, Exception) and not isinstance(raised, ray.exceptions.RayError):
                # By the work itself, in a worker.
                raise raised from error
            first_line = str(error).partition("\n")[0]
            raise WorkerError(
                f"a part was given up because its workers were lost: {first_line}"
            ) from error
        finally:
            for task in pending:
                ray.cancel(task)


@dataclass(frozen=True)
class _Stored:
    """A parcel in Ray's object store."""

    key: str
    reference: Any

    def open(self) -> Any:
        return ray.get(self.reference)


def _put(content: object) -> _Stored:
    reference = ray.put(content)
    return _Stored(reference.hex(), reference)


def _part(work: SentJob, index: int, count: int) -> bytes:
    return work.part(index, count)

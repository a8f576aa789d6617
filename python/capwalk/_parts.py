"""Parts of an image or a gradient, and what other processes need to compute them."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Protocol
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from . import _capwalk
from ._numbers import Array
from ._options import Options
from .errors import BusyError

Scene = _capwalk.Scene
Asked = str | dict[str, Array] | tuple[Array, list[str]] | None
"""The direction of a gradient, the adjoint and the names of a backward pass, or an image."""
Rows = NDArray[np.uint8]

SCENES = 4
"""A worker keeps so many scenes: as many may be rendered in turn without being sent again."""

ROW = 64
"""What has changed of a scene is sent in rows of so many bytes, eight numbers."""


@dataclass(frozen=True)
class Job:
    """An image or a gradient."""

    scene: Scene
    asked: Asked
    options: Options
    revision: int
    """The scene's when this was asked for."""

    @property
    def samples(self) -> int:
        """Samples of all pixels."""
        _, (width, height), _, _ = self.scene._sensors()[self.options.sensor]
        return self.options.spp * width * height

    def part(self, index: int, count: int) -> bytes:
        """One of ``count`` parts, in this process."""
        return _capwalk.part(self.scene, self.asked, self.options, index, count)

    def merged(self, parts: list[bytes]) -> Any:
        """What the function of `_capwalk` gives, from all parts in any order."""
        if self.scene.revision != self.revision:
            raise BusyError(
                "the scene was changed by another thread before all of its parts were done; "
                "change a copy of it"
            )
        return _capwalk.merge(self.scene, self.asked, self.options, parts)


class Parcel(Protocol):
    """Something that is sent once, for all parts and workers that need it."""

    @property
    def key(self) -> str:
        """Tells it from all other parcels."""

    def open(self) -> Any:
        """What is in it, in any process."""


@dataclass(frozen=True)
class SentJob:
    """A job as other processes get it, in which it is the same."""

    scene: Parcel
    """The scene when it was sent first: rows, count of bytes, name."""
    changes: Parcel | None
    """What has changed since: numbers of rows, rows."""
    work: Parcel
    """What is asked for, and options."""

    def part(self, index: int, count: int) -> bytes:
        """One of ``count`` parts, in the process of a worker."""
        asked, options = _KEPT.work(self.work)
        scene = _KEPT.scene(self.scene, self.changes)
        return _capwalk.part(scene, asked, options, index, count)


@dataclass(frozen=True)
class _SentScene:
    """What was sent of a scene, and when."""

    rows: Rows
    size: int
    scene: Parcel
    changes: Parcel | None
    revision: int


class Sender:
    """Sends each scene once, then what has changed of it. ``put`` makes parcels.

    Changes are those of the bytes that a scene is pickled to, so that workers have all of it
    to the last digit, whichever of its states they have seen.
    """

    def __init__(self, put: Callable[[object], Parcel]) -> None:
        self._put = put
        self._scenes: WeakKeyDictionary[Scene, _SentScene] = WeakKeyDictionary()
        self._lock = threading.Lock()

    def sent(self, job: Job) -> SentJob:
        """The job for other processes, while this is kept."""
        with self._lock:
            sent = self._sent(job.scene)
        return SentJob(sent.scene, sent.changes, self._put((job.asked, job.options)))

    def _sent(self, scene: Scene) -> _SentScene:
        before = self._scenes.get(scene)
        revision = scene.revision
        if before is not None and before.revision == revision:
            return before
        pickled: Any = scene.__reduce__()
        _, (content, name) = pickled
        rows, size = _rows(content), len(content)
        if before is not None and before.size == size:
            changed = np.flatnonzero((rows != before.rows).any(axis=1)).astype(np.uint32)
            changes = self._put((changed, rows[changed]))
            sent = _SentScene(before.rows, size, before.scene, changes, revision)
        else:
            sent = _SentScene(rows, size, self._put((rows, size, name)), None, revision)
        self._scenes[scene] = sent
        return sent


def _rows(content: bytes) -> Rows:
    rows = -(-len(content) // ROW)
    return np.frombuffer(content.ljust(rows * ROW, b"\0"), np.uint8).reshape(rows, ROW)


@dataclass
class _KeptScene:
    """A scene in the process of a worker."""

    first: tuple[Rows, int, str]
    scene: Scene | None = None
    changes: str | None = None
    """The key of what has changed in it."""


@dataclass
class _Kept(threading.local):
    """What a worker keeps from part to part. Each thread is a worker: none waits for another's
    scene to be changed."""

    scenes: OrderedDict[str, _KeptScene] = field(default_factory=OrderedDict)
    """The last few, by the keys of their parcels, the last one last."""
    last_work: tuple[str, Any] = ("", None)

    def work(self, parcel: Parcel) -> Any:
        if self.last_work[0] != parcel.key:
            self.last_work = parcel.key, parcel.open()
        return self.last_work[1]

    def scene(self, first: Parcel, changes: Parcel | None) -> Scene:
        kept = self.scenes.get(first.key)
        if kept is None:
            kept = self.scenes[first.key] = _KeptScene(first.open())
            if len(self.scenes) > SCENES:
                self.scenes.popitem(last=False)
        self.scenes.move_to_end(first.key)
        wanted = None if changes is None else changes.key
        if kept.scene is not None and kept.changes == wanted:
            return kept.scene
        rows, size, name = kept.first
        if changes is not None:
            numbers, changed = changes.open()
            rows = rows.copy()
            rows[numbers] = changed
        content = rows.reshape(-1)[:size].tobytes()
        # It is nobody's scene if this is interrupted.
        scene, kept.scene = kept.scene, None
        if scene is None:
            scene = Scene.from_bytes(content, name)
        else:
            # Refits trees, and builds none.
            scene._replace(content)
        kept.changes = wanted
        kept.scene = scene
        return scene


_KEPT = _Kept()

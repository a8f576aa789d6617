"""Progress of long work."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

Told = Callable[[int, int], object]
Progress = bool | Told | None
"""``True`` for a bar, or a function that is called with what is done and what there is to do."""


@contextmanager
def shown(progress: Progress, what: str, unit: str = "sample") -> Iterator[Told | None]:
    """The function to be called with the progress, if one is wanted."""
    if callable(progress):
        yield progress
    elif progress is True:
        with _bar(what, unit) as bar:
            yield bar
    elif progress is None or progress is False:
        yield None
    else:
        raise TypeError(f"progress is {progress!r}; expected True, False or a function")


@contextmanager
def _bar(what: str, unit: str) -> Iterator[Told]:
    try:
        from tqdm.auto import tqdm  # type: ignore[import-untyped, unused-ignore]
    except ImportError:
        tqdm = None
    if tqdm is None:
        try:
            yield lambda done, total: _line(what, done, total)
        finally:
            print(file=sys.stderr)
        return
    with tqdm(desc=what, unit=unit, unit_scale=True) as bar:

        def show(done: int, total: int) -> None:
            bar.total = total
            bar.update(done - bar.n)

        yield show


def _line(what: str, done: int, total: int) -> None:
    share = done / total if total else 0.0
    print(f"\r{what}: {share:4.0%}", end="", file=sys.stderr, flush=True)

"""The folder of an optimisation, read while it is written."""

from __future__ import annotations

import csv
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

if sys.platform == "win32":
    import msvcrt
else:
    import fcntl

COLUMNS = (
    "iteration",
    "loss",
    "loss_stderr",
    "loss_noise",
    "gradient_norm",
    "gradient_noise",
    "step_norm",
    "lr",
    "descent",
    "descent_variance_by_image",
    "descent_variance_by_gradient",
    "spp",
    "spp_grad",
)
"""Of ``record.csv``. Those of views and parameters follow."""

OFTEN = 0.5
"""How long to wait before a folder is read again, seconds."""

BEGINS_WITHIN = 60.0
"""How long to wait for a run that has not begun, seconds. It loads its scenes before it takes its
folder."""


@dataclass
class RunFolder:
    """What an optimisation has written so far, each thing once."""

    path: Path
    _lines: list[bytes] = field(default_factory=list)
    """Of ``record.csv``. A run that is resumed writes the same lines again, but for the last one, which
    gets a step."""
    _pictures: set[Path] = field(default_factory=set)

    @property
    def record(self) -> Path:
        """The table of iterations."""
        return self.path / "record.csv"

    @property
    def scene(self) -> Path:
        """The result, which is there when the run has ended."""
        return self.path / "scene.xml"

    def is_written(self) -> bool:
        """True while a process writes there: it holds a lock, which the system releases when the process
        ends, however it ends."""
        try:
            with (self.path / ".lock").open("rb") as file:
                if sys.platform == "win32":
                    msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
                    msvcrt.locking(file.fileno(), msvcrt.LK_UNLCK, 1)
                else:
                    fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            return True
        except OSError as error:
            # Otherwise no run was there, or the file system has no locks.
            return sys.platform == "win32" and isinstance(error, PermissionError)
        return False

    def until_it_ends(self, has_begun: bool = False) -> Iterator[None]:
        """Comes back whenever there may be something new, and a last time when the run has ended, or
        when none has begun within a minute."""
        given_up = time.monotonic() + BEGINS_WITHIN
        goes_on = True
        while goes_on:
            is_written = self.is_written()
            has_begun |= is_written
            goes_on = is_written or not (has_begun or time.monotonic() > given_up)
            yield
            if goes_on:
                time.sleep(OFTEN)

    def new_rows(self) -> Iterator[dict[str, float]]:
        """The rows that were written since the last call, by column, without empty cells."""
        if not self.record.exists():
            return
        # A line that is just being written is for the next time.
        *lines, _ = self.record.read_bytes().split(b"\n")
        old, self._lines[: len(lines)] = self._lines[:], lines
        was = [*old, *[b""] * len(lines)]
        table = csv.reader(line.decode("utf-8") for line in lines)
        for i, row in enumerate(table):
            if i == 0:
                header = row
            elif lines[i] != was[i]:
                cells = zip(header, row, strict=True)
                yield {name: float(cell) for name, cell in cells if cell}

    def new_pictures(self) -> Iterator[tuple[int, str, Path]]:
        """The pictures that were drawn since the last call, with their iterations and views ("" if there
        is one)."""
        new = set(self.path.glob("images/[0-9]*.png")) - self._pictures
        self._pictures |= new
        for file in sorted(new):
            number, _, view = file.stem.partition("-")
            yield int(number), view, file

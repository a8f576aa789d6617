"""The folder of an optimisation, read while it is written."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

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

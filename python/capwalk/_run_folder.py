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
    _header: list[str] = field(default_factory=list)
    _position: int = 0
    """In ``record.csv``, bytes. A run that is resumed writes the same bytes again."""
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
        with self.record.open("rb") as file:
            file.seek(self._position)
            text = file.read()
        # A line that is just being written is for the next time.
        text = text[: text.rfind(b"\n") + 1]
        self._position += len(text)
        for row in csv.reader(text.decode("utf-8").splitlines()):
            if self._header:
                cells = zip(self._header, row, strict=True)
                yield {name: float(cell) for name, cell in cells if cell}
            else:
                self._header = row

    def new_pictures(self) -> Iterator[tuple[int, str, Path]]:
        """The pictures that were drawn since the last call, with their iterations and views ("" if there
        is one)."""
        new = set(self.path.glob("images/[0-9]*.png")) - self._pictures
        self._pictures |= new
        for file in sorted(new):
            number, _, view = file.stem.partition("-")
            yield int(number), view, file

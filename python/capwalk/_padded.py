"""Pictures of one size."""

from __future__ import annotations

import io
from pathlib import Path

# It comes with rerun-sdk.
import PIL.Image  # type: ignore[import-not-found, unused-ignore]

SPARE = 128
"""Pixels for wider pictures that follow the first one: the numbers at a colour bar are of any length."""


class Padded:
    """Pictures as PNG files of the first one's size and some more, white at the right: for the viewer
    of Rerun, pictures that follow each other are frames of a video, all of one size."""

    def __init__(self) -> None:
        self._size = (0, 0)

    def png(self, file: Path) -> bytes:
        """A picture, padded. One that is too large begins a larger size."""
        with PIL.Image.open(file) as picture:
            width, height = picture.size
            if width > self._size[0] or height > self._size[1]:
                self._size = (max(width + SPARE, self._size[0]), max(height, self._size[1]))
            canvas = PIL.Image.new("RGB", self._size, "white")
            canvas.paste(picture)
        contents = io.BytesIO()
        canvas.save(contents, "PNG")
        return contents.getvalue()

"""Where something stands in a file, for messages."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from .errors import ArgumentError, LoadError


@dataclass(frozen=True)
class Place:
    """A file, or a line or a record of it."""

    file: Path
    record: str | None = None
    """``"camera 3"``, for example."""
    line: int | None = None
    """From 1, of a text."""

    def error(self, message: str, column: int | None = None) -> LoadError:
        """The exception that says what is wrong here, what was expected and what to do."""
        parts = [str(self.file), None if self.line is None else f"line {self.line}", self.record]
        text = ": ".join([*(part for part in parts if part), message])
        return LoadError(text, str(self.file), self.line, column)

    def bytes(self) -> bytes:
        """The contents of the file."""
        try:
            return self.file.read_bytes()
        except OSError as error:
            raise self.error(f"cannot be read: {error.strerror}") from None

    @contextmanager
    def of_arguments(self) -> Iterator[None]:
        """Arguments inside come from here, and so does what is wrong with them."""
        try:
            yield
        except ArgumentError as error:
            raise self.error(str(error)) from None

"""The exceptions and warnings of capwalk. Every exception is an :class:`Error`."""

from __future__ import annotations


class Error(Exception):
    """The base class of all exceptions of capwalk."""


class LoadError(Error):
    """A scene that cannot be loaded, or cameras. The message says where, what was expected and what to
    do."""

    file: str | None
    """The file itself, or the file that it refers to; ``None`` for a text."""
    line: int | None
    """Line in the file, from 1; ``None`` for the file as a whole."""
    column: int | None
    """Character in the line, from 1; ``None`` for the file as a whole."""

    def __init__(
        self, message: str, file: str | None, line: int | None, column: int | None
    ) -> None:
        super().__init__(message)
        self.file, self.line, self.column = file, line, column

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (str(self), self.file, self.line, self.column)


class Refused(Error):
    """A derivative that could only be estimated with a bias."""

    reason: str
    """What was found where, and what of it is not differentiated."""
    instead: str | None
    """What to do instead."""

    def __init__(self, message: str, reason: str, instead: str | None) -> None:
        super().__init__(message)
        self.reason, self.instead = reason, instead

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (str(self), self.reason, self.instead)


class ParameterError(Error, KeyError):
    """A name that is not a parameter of the scene, or numbers that a parameter cannot have."""

    # A KeyError shows its message in quotes.
    __str__ = Exception.__str__


class ArgumentError(Error, ValueError):
    """An argument of the wrong shape or out of its range."""


class ImageError(Error, OSError):
    """A file that cannot be read or written as an image."""


class MeshError(Error, OSError):
    """A file that cannot be read or written as a mesh. The message says where, what was expected and
    what to do."""


class BusyError(Error, RuntimeError):
    """A scene that another thread is changing or rendering."""


class DeviceError(Error, RuntimeError):
    """A requested GPU that is not there, fails or is lost, or a package that was built without
    support for GPUs. The next image looks for a GPU again."""


class WorkerError(Error, RuntimeError):
    """A worker that was lost: killed, out of memory, or on a machine that is down."""


class UnreliableWarning(UserWarning):
    """A result that may be unreliable; the message says why."""


class DeviceWarning(UserWarning):
    """Work that ran on the CPU although there is a GPU (``device="auto"``); the message says
    why."""


class SceneWarning(UserWarning):
    """A property of a scene file that has no effect, or is read as something else."""

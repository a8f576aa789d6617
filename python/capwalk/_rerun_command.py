"""The command ``python -m capwalk.rerun``."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from .errors import Error
from .rerun import Log

CONNECTS_WITHIN = 10.0
"""How long to wait for the viewer, seconds."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Shows the folder of an optimisation in the viewer of Rerun. Returns the exit status: 0, or 1
    with one line on the standard error."""
    given = _parser().parse_args(arguments)
    folder: Path = given.folder
    try:
        # Before a viewer opens.
        if folder.exists() and not folder.is_dir():
            raise NotADirectoryError(f"{folder} is no folder; expected that of an optimisation")
        if not given.follow and not (folder / "record.csv").exists():
            text = f"there is no {folder / 'record.csv'}; expected the folder of an optimisation"
            raise FileNotFoundError(f"{text}, or --follow to wait for one")
        log = _log(given)
        # An error now if there is no viewer, and not at the end of the run.
        log.stream.flush(timeout_sec=CONNECTS_WITHIN)
        with log:
            log.run(folder, follow=given.follow, begun=given.begun)
    except KeyboardInterrupt:
        return 0
    except (OSError, RuntimeError, ValueError, Error) as error:
        print(f"capwalk.rerun: {error}", file=sys.stderr)
        return 1
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m capwalk.rerun",
        description="Shows the folder of an optimisation by `capwalk optimize` in the viewer of "
        "Rerun, which is started if it does not run.",
    )
    parser.add_argument("folder", metavar="FOLDER", type=Path, help="what -o of the run names")
    parser.add_argument(
        "--follow",
        action="store_true",
        help="go on while the optimisation writes; wait for up to a minute if none has begun",
    )
    parser.add_argument(
        "--begun",
        action="store_true",
        help="with --follow: the optimisation has begun, so if none writes it is over",
    )
    place = parser.add_mutually_exclusive_group()
    place.add_argument("--save", metavar="FILE.rrd", help="write a recording instead")
    place.add_argument("--connect", metavar="URL", help="show it in this viewer, which runs")
    return parser


def _log(given: argparse.Namespace) -> Log:
    if given.save is not None:
        return Log.save(given.save)
    if given.connect is not None:
        return Log.connect(given.connect)
    with _files_closed():
        return Log.spawn()


@contextmanager
def _files_closed() -> Iterator[None]:
    """Processes that are started here write to terminals of this one alone. The viewer stays open: a pipe that
    it held would never end."""
    kept: list[tuple[int, int]] = []
    nothing = os.open(os.devnull, os.O_WRONLY)
    try:
        for number in (1, 2):
            if not os.isatty(number):
                kept.append((number, os.dup(number)))
                os.dup2(nothing, number)
        yield
    finally:
        for number, before in kept:
            os.dup2(before, number)
            os.close(before)
        os.close(nothing)

"""Jobs of inverse rendering."""

from __future__ import annotations

import csv
import os
import warnings
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from . import _capwalk
from ._functions import Scene, load_file
from ._progress import Progress, shown
from ._report import page, pictures_in
from .errors import SceneWarning, UnreliableWarning


@dataclass(frozen=True)
class Optimization:
    """What :func:`optimize` found."""

    parameters: dict[str, NDArray[np.float64]]
    """The values by name, each in the shape of its parameter; of vertices, all positions."""
    record: dict[str, NDArray[np.float64]]
    """For each iteration, the columns of ``record.csv``: ``"loss"``, ``"loss_stderr"``,
    ``"descent"``, ``"spp"`` and more; NaN where there is nothing."""
    stopped: str
    """Why there are no more iterations."""
    folder: Path
    """Where everything is written down."""

    def scene(self) -> Scene:
        """The scene with these values."""
        return load_file(self.folder / "scene.xml")

    def report(self, path: str | os.PathLike[str] | None = None) -> Path:
        """Writes one HTML page with the curves of the record and the pictures of the run, and nothing
        outside it: by default ``report.html`` in the folder. Returns where it is. Pictures are there
        if the job asks for them (``images``).
        """
        file = self.folder / "report.html" if path is None else Path(path)
        pictures = pictures_in(self.folder / "images")
        title = f"Optimisation in {self.folder.name}"
        text = page(title, self.stopped, self.record, self.parameters, pictures)
        file.write_text(text, encoding="utf-8")
        return file


def optimize(
    job: str | os.PathLike[str],
    output: str | os.PathLike[str] | None = None,
    *,
    resume: bool = False,
    threads: int | None = None,
    progress: Progress = None,
) -> Optimization:
    """Runs the job of inverse rendering in a TOML file, as the command ``capwalk optimize`` does:
    looks for the parameters of a scene for which its images match given ones. Keys of the file,
    and what is written, are on the page `Inverse rendering <../optimize.html>`_. With a table
    ``[samples]`` in it, the samples of each step follow the noise of the gradient.

    :param job: the file.
    :param output: the folder for all results; by default the job's ``output``.
    :param resume: go on with the run in that folder, if there is one.
    :param threads: worker threads, which change no bit.
    :param progress: as for :func:`render`, counted in iterations.
    :raises LoadError: the job, or a scene that it names, cannot be read, or the derivative is
        refused; with ``file``, ``line`` and ``column``.
    :raises ArgumentError: the folder has other results.

    A :class:`UnreliableWarning` says that a guard stopped the run, that something was not
    finite, or what is missing in gradients. After Ctrl-C, ``resume=True`` goes on.
    """
    with shown(progress, "optimize", "iteration") as told:
        path, folder = os.fspath(job), None if output is None else os.fspath(output)
        stopped, unreliable, folder, of_files = _capwalk.optimize(path, folder, resume, threads, told)
    for warning in of_files:
        warnings.warn(warning, SceneWarning, stacklevel=2)
    for warning in unreliable:
        warnings.warn(warning, UnreliableWarning, stacklevel=2)
    results = Path(folder)
    with np.load(results / "parameters.npz") as file:
        parameters = {name: file[name] for name in file.files if name != "metadata"}
    with (results / "record.csv").open(newline="") as lines:
        rows = list(csv.reader(lines))
    cells = [[float(cell or "nan") for cell in row] for row in rows[1:]]
    columns = np.array(cells).reshape(-1, len(rows[0])).T
    record = dict(zip(rows[0], columns, strict=True))
    return Optimization(parameters, record, stopped, results)

"""Optimisations in the viewer of `Rerun <https://rerun.io>`_, live or from a file: images, meshes,
cameras, gradients, losses and parameters by iteration. Needs ``rerun-sdk``: ``pip install
'capwalk[rerun]'``. ``python -m capwalk.rerun FOLDER`` shows the folder of an optimisation.

>>> import os
>>> import capwalk as cw, capwalk.rerun
>>> import numpy as np
>>> scene = cw.load_file("leaf")
>>> scene.resize(32, 24)
>>> target = cw.render(scene, spp=64).value
>>> params, name, adam = cw.traverse(scene), "leaf.positions", cw.Adam(lr=0.01)
>>> params.update({name: params[name] + [0.1, 0.0, 0.0]})
>>> with capwalk.rerun.Log.save("leaf.rrd") as log:      # or Log.spawn(), which opens the viewer
...     for step in range(3):
...         image = cw.render(scene, spp=2, seed=2 * step)
...         difference = image.value - target
...         adjoint = 2 * difference / difference.size
...         grads = cw.backward(scene, adjoint, [name], spp=2, seed=2 * step + 1)
...         log.iteration(step)
...         log.loss(np.square(difference).mean())
...         log.image(image, target)
...         log.scene(scene, grads)
...         log.parameters({name: params[name]}, grads)
...         adam.step(params, grads)
...         params.update()
>>> os.remove("leaf.rrd")
"""

from __future__ import annotations

import copy
import math
import os
import re
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

try:
    import rerun as rr  # type: ignore[import-not-found, unused-ignore]
    import rerun.blueprint as rrb  # type: ignore[import-not-found, unused-ignore]
except ImportError as error:
    missing = "capwalk.rerun needs Rerun: pip install 'capwalk[rerun]'"
    if __name__ == "__main__":
        sys.exit(missing)
    raise ImportError(missing) from error

from . import _capwalk
from ._closing import Closing
from ._functions import load_file
from ._given import array_of, number_of, pixels_of, vectors_of
from ._layout import TIMELINE, Layout
from ._numbers import Array
from ._options import integer
from ._padded import Padded
from ._parameters import traverse
from ._results import GradientImage, Image
from ._run_folder import COLUMNS, RunFolder
from .errors import ArgumentError

__all__ = ["Log"]

MOST_CURVES = 16
"""Arrays with more numbers than this have one curve."""

NEARLY_ALL = 99
"""The percentile of lengths that counts as the longest, so that outliers do not decide it."""

ARROW = {"positions": 0.5, "translate": 1.5}
"""The length of nearly the longest arrow of a shape, in its radii; one from the centre is to be
seen outside."""

FRUSTUM = 0.2
"""How far from a camera its image is shown, in distances from the camera to the scene."""

CERTAIN = 2.0
"""How many standard errors the gradient of a vertex is at least, if its arrow has a colour."""

CERTAIN_COLOUR, UNCERTAIN_COLOUR = (255, 90, 0), (130, 130, 130)

MESH_REFLECTANCE = 0.5
"""Of shapes whose BSDF has no reflectance, or is not their own."""


class Log(Closing):
    """What happens in an optimisation, for the viewer of Rerun. :meth:`iteration` begins an
    iteration. What is logged then is shown there, and later until something else is logged in its
    place.

    The viewer gets a layout with a place for everything that was logged: images beside each other,
    meshes and cameras in 3-D, curves. It gets another one if something new is logged later.

    **False colours** keep the scale that they have first, so that they fade as differences get
    smaller. Titles say where they end.

    **NaN and infinite numbers** are magenta in images, gaps in curves, and named in the panel
    "notes".

    Arrays may be those of NumPy or JAX, or tensors of PyTorch on any device. All calls of a log are
    made in one thread. A log is a context manager, which closes it.

    :param stream: the recording; for several viewers and files, or what else Rerun can do.
    :param layout: False if the viewer shall not get a layout.
    """

    stream: rr.RecordingStream
    """The recording, for anything else to be logged."""

    def __init__(self, stream: rr.RecordingStream, *, layout: bool = True) -> None:
        self.stream = stream
        self._sends_layout = layout
        self._layout, self._sent = Layout(), Layout()
        self._last: dict[str, NDArray[Any]] = {}
        """What was logged last, by path."""
        self._first: dict[str, Array] = {}
        """Parameters as they were logged first."""
        self._limits: dict[str, float] = {}
        """By path."""
        self._runs: dict[Path, RunFolder] = {}
        self._padded: dict[str, Padded] = {}
        self.iteration(0)

    @classmethod
    def save(cls, path: str | os.PathLike[str]) -> Log:
        """A log that is written into a file, ``run.rrd``. The command ``rerun run.rrd`` shows
        it."""
        stream = rr.RecordingStream("capwalk")
        stream.save(os.fspath(path))
        return cls(stream)

    @classmethod
    def spawn(cls) -> Log:
        """A log that the viewer on this machine shows, which is started if it does not run."""
        stream = rr.RecordingStream("capwalk")
        stream.spawn()
        return cls(stream)

    @classmethod
    def connect(cls, url: str | None = None) -> Log:
        """A log that a running viewer shows, such as ``"rerun+http://192.168.0.2:9876/proxy"``; by
        default the one on this machine."""
        stream = rr.RecordingStream("capwalk")
        stream.connect_grpc(url)
        return cls(stream)

    def close(self) -> None:
        """Sends what is left, and disconnects from viewer or file."""
        self._lay_out()
        # Without a limit it may wait forever for a viewer that is gone.
        self.stream.flush(timeout_sec=60.0)
        self.stream.disconnect()

    def iteration(self, number: int) -> None:
        """Begins an iteration, from 0."""
        self._lay_out()
        self.stream.set_time(TIMELINE, sequence=integer("the iteration", number, 0, 2**62))

    def image(
        self,
        image: Image | GradientImage | ArrayLike,
        target: Image | ArrayLike | None = None,
        *,
        sensor: str = "sensor",
    ) -> None:
        """Logs an image, (height, width, 3), linear; with a target also that and the difference; of
        a :class:`capwalk.GradientImage` also the derivative and its standard error.

        Differences, derivatives and errors are the means of the channels in false colours, from
        blue below zero to red above. An error has the scale of its derivative.

        :param sensor: the one that it was rendered for, by name: :meth:`scene` shows the image in
            its frustum.
        :raises ArgumentError: an image of another shape.
        """
        value = pixels_of("the image", image.value if isinstance(image, GradientImage) else image)
        self._show(sensor, "image", value)
        if target is not None:
            wanted = pixels_of("the target", target)
            if wanted.shape != value.shape:
                text = f"the target has the shape {wanted.shape}"
                raise ArgumentError(f"{text}; expected {value.shape}, that of the image")
            self._show(sensor, "target", wanted)
            self._show_signed(sensor, "difference", value - wanted)
        if isinstance(image, GradientImage):
            self._show_signed(sensor, "derivative", image.gradient)
            self._show_signed(sensor, "standard error", image.stderr, limit_of="derivative")

    def scene(
        self,
        scene: _capwalk.Scene,
        gradients: Mapping[str, ArrayLike] | None = None,
        *,
        params: Mapping[str, ArrayLike] | None = None,
    ) -> None:
        """Logs the meshes of a scene and its cameras, as far as they changed.

        :param gradients: of a loss, by the names of arrays. Those of ``<shape>.positions`` are
            arrows at the vertices, that of ``<shape>.translate`` is one at the centre. They point
            where the loss falls, against the gradient, and their lengths compare vertices, not
            iterations. Those of less than two standard errors are grey, if there is a ``stderr`` as
            :func:`capwalk.backward` returns it. Other gradients have no arrows, see
            :meth:`parameters`.
        :param params: arrays in place of those of the scene, as for :func:`capwalk.torch.render`.
        :raises ArgumentError: a gradient of another shape than its array.

        Frusta are those of sensors with a field of view, without crop and with the principal point
        in the middle. Other sensors are an arrow along their view.
        """
        if params:
            scene = scene.copy()
            traverse(scene).update({name: array_of(name, value) for name, value in params.items()})
        if not self._layout.has_scene:
            self._layout.has_scene = True
            self.stream.log("world", rr.ViewCoordinates.RIGHT_HAND_Y_UP, static=True)
        arrays = traverse(scene)
        shapes = [name.removesuffix(".positions") for name in arrays if name.endswith(".positions")]
        for shape in shapes:
            self._mesh(shape, scene.faces(shape), arrays)
        centres = [arrays[f"{shape}.positions"].mean(axis=0) for shape in shapes]
        centre = np.mean(centres, axis=0) if centres else np.zeros(3)
        for sensor, size, _, _ in scene._sensors():
            self._camera(sensor, size, arrays, centre)
        errors = getattr(gradients, "stderr", {})
        first = {name: alias or name for name, _, _, _, alias, _ in scene._arrays()}
        for name, gradient in (gradients or {}).items():
            shape, _, kind = first.get(name, name).rpartition(".")
            if shape in shapes and kind in ARROW:
                positions = arrays[f"{shape}.positions"]
                self._arrows(shape, kind, positions, gradient, errors.get(name))

    def parameters(
        self, values: Mapping[str, ArrayLike], gradients: Mapping[str, ArrayLike] | None = None
    ) -> None:
        """Logs numbers as curves, by the names of their arrays. An array with more than 16 numbers
        has one curve: how far they are from where they were logged first (root mean square).

        :param gradients: of a loss, by the same names. Their curves are their lengths and, if there
            is a ``stderr`` as :func:`capwalk.backward` returns it, the lengths that noise alone
            would have about.
        :raises ArgumentError: an array of another size than before.
        """
        for name, given in values.items():
            value = array_of(name, given).ravel()
            first = self._first.setdefault(name, value.copy())
            if value.size != first.size:
                text = f"{name} has {value.size} numbers"
                raise ArgumentError(f"{text}; expected {first.size}, as many as before")
            if value.size > MOST_CURVES:
                change = np.sqrt(np.square(value - first).mean())
                self._curve("parameters", name, {f"{name}, change": change})
            elif value.size == 1:
                self._curve("parameters", name, {name: value[0]})
            else:
                self._curve("parameters", name, {f"{name}[{i}]": x for i, x in enumerate(value)})
        errors = getattr(gradients, "stderr", {})
        for name, gradient in (gradients or {}).items():
            lengths = {name: np.linalg.norm(array_of(f"the gradient of {name}", gradient))}
            if name in errors:
                lengths[f"{name}, noise"] = np.linalg.norm(errors[name])
            self._curve("gradients", name, lengths)

    def loss(
        self, value: ArrayLike, stderr: ArrayLike | None = None, *, name: str = "loss"
    ) -> None:
        """Logs a loss, one number, as a curve; with its standard error between two more.

        :param name: of this loss, if there are several.
        :raises ArgumentError: more than one number.
        """
        loss = number_of(name, value)
        self._curve("loss", name, {name: loss})
        if stderr is not None:
            error = number_of(f"the standard error of {name}", stderr)
            ends = {f"{name} - stderr": loss - error, f"{name} + stderr": loss + error}
            self._curve("loss", f"{name} stderr", ends)

    def follow(self, folder: str | os.PathLike[str]) -> Callable[[int, int], None]:
        """A function for ``progress`` of :func:`capwalk.optimize` that logs each iteration of the
        run in a folder, its ``output``, when it is done::

            cw.optimize("job.toml", "results", progress=log.follow("results"))
            log.run("results")                    # what is left, and the scene that was found
        """
        run = self._run(folder)
        return lambda done, total: self._log_new(run)

    def run(
        self, folder: str | os.PathLike[str], *, follow: bool = False, begun: bool = False
    ) -> None:
        """Logs what an optimisation by :func:`capwalk.optimize` or ``capwalk optimize`` has written
        into its folder so far, without what was logged before: of ``record.csv`` losses, lengths of
        the gradient, parameters of up to four numbers and samples per pixel; the pictures in
        ``images``; and the scene that was found, if the run has ended.

        :param follow: go on while another process writes there, twice a second, and return when it
            has ended, by itself or because it was killed. If none writes there yet, wait for up to a
            minute until one begins.
        :param begun: with ``follow``: it has begun, so if none writes there it has ended.
        :raises FileNotFoundError: there is no run in this folder.
        """
        run = self._run(folder)
        if follow:
            for _ in run.until_it_ends(begun):
                self._log_new(run)
                self._lay_out()
        if not run.record.exists():
            raise FileNotFoundError(
                f"there is no {run.record}; expected the folder of an optimisation"
            )
        self._log_new(run)
        if run.scene.exists():
            self.scene(load_file(run.scene))

    def blueprint(self) -> rrb.Blueprint:
        """The layout of everything that was logged so far."""
        return self._layout.blueprint()

    def _lay_out(self) -> None:
        """Sends the layout if the viewer has another one."""
        if self._sends_layout and self._layout != self._sent:
            self.stream.send_blueprint(self.blueprint())
            self._sent = copy.deepcopy(self._layout)

    def _show(
        self, sensor: str, kind: str, value: Array, limit: float | None = None, title: str = ""
    ) -> None:
        """Logs an image as it is saved, with a limit in false colours, if it is not the one before."""
        # In a frustum there is only the image.
        path = _path(*(["world", "cameras"] if kind == "image" else ["images"]), sensor, kind)
        self._layout.images.setdefault(sensor, {})[path] = title or kind
        if self._is_new(path, value):
            self._note_non_finite(f"{kind} of {sensor}", value)
            contents = _capwalk.png(value, limit)
            self.stream.log(path, rr.EncodedImage(contents=contents, media_type="image/png"))

    def _show_signed(self, sensor: str, kind: str, value: Array, limit_of: str = "") -> None:
        """Logs an image in false colours, with a limit of its own or that of another one."""
        limit = self._limit(_path("images", sensor, limit_of or kind), value)
        self._show(sensor, kind, value, limit, f"{kind}, ±{limit:.2g}")

    def _limit(self, path: str, value: Array) -> float:
        """The limit of false colours when there were some first; 1 before."""
        if path not in self._limits and np.nan_to_num(value.mean(axis=2), posinf=0, neginf=0).any():
            self._limits[path] = _capwalk.limit(value)
        return self._limits.get(path, 1.0)

    def _mesh(self, shape: str, faces: NDArray[np.uint32], arrays: Mapping[str, Array]) -> None:
        """Logs the faces of a shape, in the colour of its reflectance if that is one."""
        positions, normals = arrays[f"{shape}.positions"], arrays.get(f"{shape}.normals")
        own = re.compile(rf"{re.escape(shape)}\.bsdf\.(.+\.)?reflectance\.value")
        colours = [arrays[name] for name in arrays if own.fullmatch(name)]
        colour = np.resize(colours[0] if colours else MESH_REFLECTANCE, (1, 1, 3))
        path = _path("world", "shapes", shape)
        parts = [positions, colour, faces, *([] if normals is None else [normals])]
        if not self._is_new(path, np.concatenate([part.ravel() for part in parts])):
            return
        if normals is None:
            # Each face is flat, so that no two of them share a corner.
            corners = positions[faces]
            sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            positions, normals = corners.reshape(-1, 3), np.repeat(_unit(sides), 3, axis=0)
            faces = np.arange(len(positions), dtype=np.uint32).reshape(-1, 3)
        mesh = rr.Mesh3D(
            vertex_positions=positions,
            triangle_indices=faces,
            vertex_normals=normals,
            albedo_factor=_srgb(colour).ravel(),
        )
        self.stream.log(path, mesh)

    def _camera(
        self, sensor: str, size: tuple[int, int], arrays: Mapping[str, Array], centre: Array
    ) -> None:
        """Logs a sensor, which has x to the left, y up and z forward."""
        to_world, x_fov = arrays[f"{sensor}.to_world"], arrays.get(f"{sensor}.x_fov")
        left, up, forward, origin = to_world[:3].T
        distance = float((centre - origin) @ forward)
        if self._layout.eye is None and distance > 0.0:
            # Behind it and beside it, with what it sees in the middle.
            eye = origin + 0.4 * distance * (up - left - forward)
            self._layout.eye = (tuple(eye), tuple(origin + distance * forward))
        path = _path("world", "cameras", sensor)
        fov = [] if x_fov is None else [x_fov.item()]
        if not self._is_new(path, np.array([*to_world.ravel(), *size, *fov])):
            return
        self.stream.log(path, rr.Transform3D(translation=origin, mat3x3=to_world[:3, :3]))
        if x_fov is None:
            self.stream.log(path, rr.Arrows3D(vectors=[[0.0, 0.0, 1.0]], labels=[sensor]))
            return
        width, height = size
        pinhole = rr.Pinhole(
            focal_length=0.5 * width / math.tan(0.5 * math.radians(x_fov.item())),
            width=width,
            height=height,
            camera_xyz=rr.ViewCoordinates.LUF,
            image_plane_distance=FRUSTUM * distance if distance > 0.0 else None,
        )
        self.stream.log(path, pinhole)

    def _arrows(
        self, shape: str, kind: str, positions: Array, given: ArrayLike, stderr: ArrayLike | None
    ) -> None:
        """Logs the gradient with respect to the vertices of a shape, or to where it is."""
        name = f"the gradient of {shape}.{kind}"
        centre = positions.mean(axis=0)
        origins = positions if kind == "positions" else centre[None]
        gradient = vectors_of(name, given, len(origins))
        self._note_non_finite(name, gradient)
        lengths = np.linalg.norm(gradient, axis=1)
        is_certain = np.full(len(gradient), True)
        if stderr is not None:
            errors = vectors_of(f"the standard error of {name}", stderr, len(origins))
            is_certain = lengths >= CERTAIN * np.linalg.norm(errors, axis=1)
        # One of NaN has no direction.
        shown = np.isfinite(lengths) & (lengths > 0.0)
        path = _path("world", "shapes", shape, f"gradient of {kind}")
        radius = np.linalg.norm(positions - centre, axis=1).max()
        longest = np.percentile(lengths[shown], NEARLY_ALL) if shown.any() else 1.0
        arrows = rr.Arrows3D(
            origins=origins[shown],
            vectors=-(ARROW[kind] * radius / longest) * gradient[shown],
            colors=np.where(is_certain[shown, None], CERTAIN_COLOUR, UNCERTAIN_COLOUR),
        )
        self.stream.log(path, arrows)

    def _curve(self, kind: str, name: str, points: Mapping[str, Any]) -> None:
        """Logs a point of each of some curves, by their names."""
        path = _path(kind, name)
        if self._is_new(f"names of {path}", np.array(list(points))):
            self.stream.log(path, rr.SeriesLines(names=list(points)), static=True)
        if kind not in self._layout.curves:
            self._layout.curves.append(kind)
        values = np.array(list(points.values()), dtype=np.float64)
        self._note_non_finite(name, values)
        self.stream.log(path, rr.Scalars(values))

    def _note_non_finite(self, what: str, values: Array) -> None:
        count = int((~np.isfinite(values)).sum())
        if count > 0:
            self._layout.has_notes = True
            text = f"{what}: {count:,} of {values.size:,} numbers are NaN or infinite"
            self.stream.log("notes", rr.TextLog(text, level=rr.TextLogLevel.WARN))

    def _is_new(self, path: str, value: NDArray[Any]) -> bool:
        """False if it is what was logged there last."""
        last = self._last.get(path)
        self._last[path] = value.copy()
        return last is None or last.shape != value.shape or last.tobytes() != value.tobytes()

    def _run(self, folder: str | os.PathLike[str]) -> RunFolder:
        path = Path(folder).absolute()
        return self._runs.setdefault(path, RunFolder(path))

    def _log_new(self, run: RunFolder) -> None:
        """Logs the iterations of a run that were not logged yet, and its pictures."""
        for row in run.new_rows():
            self.iteration(int(row["iteration"]))
            self.loss(row["loss"], row.get("loss_stderr"))
            for name, value in row.items():
                if re.fullmatch(r"loss of view \d+", name):
                    self.loss(value, name=name)
                elif name not in COLUMNS:
                    self.parameters({name: value})
            if "gradient_norm" in row:
                lengths = {"all": row["gradient_norm"], "noise": row["gradient_noise"]}
                self._curve("gradients", "all", lengths)
            samples = {"of the image": row["spp"], "of the gradient": row["spp_grad"]}
            self._curve("samples per pixel", "all", samples)
        for iteration, view, file in run.new_pictures():
            self.iteration(iteration)
            title, sensor = "image, target, difference", view or "run"
            path = _path("images", sensor, title)
            self._layout.images.setdefault(sensor, {})[path] = title
            contents = self._padded.setdefault(path, Padded()).png(file)
            self.stream.log(path, rr.EncodedImage(contents=contents, media_type="image/png"))


def _path(*parts: str) -> str:
    """The path of an entity, of parts with any characters."""
    path: str = rr.new_entity_path(list(parts))
    return path


def _unit(vectors: Array) -> Array:
    """Vectors of length 1, or 0."""
    lengths = np.linalg.norm(vectors, axis=1, keepdims=True)
    return vectors / np.where(lengths > 0.0, lengths, 1.0)


def _srgb(linear: Array) -> Array:
    """Linear colours from 0 to 1 as sRGB (IEC 61966-2-1)."""
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


if __name__ == "__main__":
    from ._rerun_command import main

    sys.exit(main())

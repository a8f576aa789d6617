"""Sensors for :func:`capwalk.load_dict` from the intrinsics and extrinsics of calibrated photographs.

>>> import capwalk as cw
>>> camera = cw.cameras.from_colmap(
...     "SIMPLE_PINHOLE", [40, 16, 12], (32, 24), qvec=[1, 0, 0, 0], tvec=[0, 0, 5]
... )
>>> scene = cw.load_dict({
...     "type": "scene",
...     "integrator": {"type": "direct"},
...     "sensor": camera,
...     "ball": {"type": "sphere"},
...     "sky": {"type": "constant"},
... })
>>> scene.size
(32, 24)

What they return is a dictionary of the type ``"perspective"`` with ``fov``, ``principal_point_offset_x``
and ``_y``, ``to_world``, (4, 4), and a ``film`` of the photograph's size, to which anything that such
a sensor may have can be added: ``camera["film"]["rfilter"] = {"type": "box"}``. For further photographs
of a scene with the same intrinsics, set the sensor's ``to_world`` to ``camera["to_world"]``.

The cameras of a whole capture are read from the files of COLMAP by :func:`load_colmap`, and of
nerfstudio, instant-ngp and NeRF by :func:`load_transforms`.

What the sensor cannot express is refused: lenses that distort, pixels that are not square, and skew.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._colmap import parameter_names, read_photographs
from ._frames import read_frames
from ._numbers import Array, numbers
from ._options import integer, real
from ._transform import ROUNDED_AXIS
from .errors import ArgumentError

__all__ = ["from_colmap", "from_opencv", "from_opengl", "load_colmap", "load_transforms"]

_FOCAL_BLUR = 0.01
"""Pixels by which the two focal lengths may displace the image of a point: less than calibrations
know."""

_RIGID = 1e-3
"""How far a rotation R may be from one, in the entries of R Rᵀ. As in scene files."""

_MOST_PIXELS = 2**26
"""Of a film, as in scene files."""


def from_opencv(
    K: ArrayLike,
    world_to_camera: ArrayLike,
    size: tuple[int, int],
    *,
    distortion: ArrayLike | None = None,
    first_pixel: float = 0.0,
) -> dict[str, Any]:
    """The sensor that maps a world-space point p to the pixel K [R|t] p, with x to the right, y
    down and z forward, as in OpenCV.

    :param K: the intrinsics, (3, 3), pixels: ``[[fx, 0, cx], [0, fy, cy], [0, 0, 1]]``, where ``fy``
        is ``fx``.
    :param world_to_camera: [R|t], (3, 4) or (4, 4). Of ``cv2.solvePnP`` and ``cv2.calibrateCamera``,
        ``np.hstack([cv2.Rodrigues(rvec)[0], tvec])``.
    :param size: width and height of the photograph, pixels.
    :param distortion: OpenCV's ``distCoeffs``, which must be zero.
    :param first_pixel: the coordinates, x and y, of the centre of the first pixel: 0 as in OpenCV,
        or 0.5 if (0, 0) is the corner of the image.
    :raises ArgumentError: the sensor cannot express the camera, with what to do instead; or any
        wrong argument.
    """
    if distortion is not None and numbers("distortion", distortion).any():
        raise ArgumentError(
            f"distortion is {np.asarray(distortion).ravel().tolist()}; sensors are pinhole cameras "
            "without distortion: undistort the photographs, for instance by cv2.undistort, and leave "
            "distortion out"
        )
    pose = _pose("world_to_camera", world_to_camera)
    return _sensor(_intrinsics(K), np.linalg.inv(pose), size, first_pixel)


def from_opengl(
    K: ArrayLike,
    camera_to_world: ArrayLike,
    size: tuple[int, int],
    *,
    first_pixel: float = 0.5,
) -> dict[str, Any]:
    """The sensor of a camera whose axes are those of OpenGL: x to the right, y up, and z
    *backward*, as also in Blender and in the ``transforms.json`` of NeRF.

    :param K: the intrinsics, (3, 3), pixels, as of :func:`from_opencv`: x to the right and y down in
        the image. Of a field of view, ``fx = fy = width / (2 * tan(camera_angle_x / 2))`` and the
        principal point is the middle, ``(width / 2, height / 2)``.
    :param camera_to_world: the pose, (3, 4) or (4, 4), NeRF's ``transform_matrix``; of a view matrix
        its inverse.
    :param size: width and height of the photograph, pixels.
    :param first_pixel: the coordinates, x and y, of the centre of the first pixel: 0.5 if (0, 0)
        is the corner of the image.
    :raises ArgumentError: the sensor cannot express the camera, with what to do instead; or any
        wrong argument.
    """
    pose = _pose("camera_to_world", camera_to_world)
    return _sensor(_intrinsics(K), pose @ np.diag([1.0, -1.0, -1.0, 1.0]), size, first_pixel)


def from_colmap(
    model: str,
    params: Sequence[float] | Array,
    size: tuple[int, int],
    *,
    qvec: ArrayLike,
    tvec: ArrayLike,
) -> dict[str, Any]:
    """The sensor of an image of a COLMAP reconstruction.

    :param model: ``"SIMPLE_PINHOLE"`` or ``"PINHOLE"``, as in ``cameras.txt``.
    :param params: its parameters, pixels: f, cx, cy, or fx, fy, cx, cy.
    :param size: width and height of the image, pixels.
    :param qvec: the rotation from world to camera as a unit quaternion (w, x, y, z), as in
        ``images.txt``; pycolmap's ``Rotation3d.quat`` has w last.
    :param tvec: the translation from world to camera, (3,).
    :raises ArgumentError: the sensor cannot express the camera, with what to do instead; or any
        wrong argument.
    """
    names = parameter_names(model)
    given = numbers("params", params)
    if given.shape != (len(names),):
        expected = ", ".join(names)
        raise ArgumentError(f"params has the shape {given.shape}; expected {expected} of a {model}")
    fx, fy, cx, cy = given[[0, 0, 1, 2]] if model == "SIMPLE_PINHOLE" else given
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = _rotation(qvec), _numbers("tvec", tvec, (3,))
    K = _intrinsics([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])
    return _sensor(K, np.linalg.inv(pose), size, 0.5)


def load_colmap(folder: str | os.PathLike[str]) -> dict[str, dict[str, Any]]:
    """The sensors of the images of a COLMAP reconstruction, by the images' names, in the order of
    these::

        sensors = cw.cameras.load_colmap("dense/sparse")
        photographs = {name: cw.load_image(f"dense/images/{name}") for name in sensors}

    The world is the reconstruction's, in its units.

    :param folder: a model: ``cameras.bin`` and ``images.bin``, or if these are not there
        ``cameras.txt`` and ``images.txt``. All cameras must be of the model ``SIMPLE_PINHOLE`` or
        ``PINHOLE``, with square pixels. ``colmap image_undistorter`` makes such a model in
        ``sparse``, and images in ``images``; pixels are square if the photographs were calibrated
        with one focal length, as by ``SIMPLE_RADIAL``, and ``--max_image_size`` is not given.
    :return: for each image a dictionary as of :func:`from_colmap`. Names are relative to the folder
        of images; those with a dot cannot be keys of a scene's dictionary.
    :raises LoadError: there is no model, a file is damaged, or a sensor cannot express a camera; with
        ``file``, of a text its ``line``, and what to do.
    """
    sensors = {}
    for photograph in sorted(read_photographs(Path(folder)), key=lambda found: found.name):
        camera, pose = photograph.camera, {"qvec": photograph.qvec, "tvec": photograph.tvec}
        if photograph.name in sensors:
            raise photograph.place.error(f'there are two images "{photograph.name}"; remove one')
        with camera.place.of_arguments():
            from_colmap(camera.model, camera.params, camera.size, qvec=[1, 0, 0, 0], tvec=[0, 0, 0])
        with photograph.place.of_arguments():
            sensor = from_colmap(camera.model, camera.params, camera.size, **pose)
        sensors[photograph.name] = sensor
    return sensors


def load_transforms(
    path: str | os.PathLike[str], *, size: tuple[int, int] | None = None
) -> dict[str, dict[str, Any]]:
    """The sensors of the frames in a ``transforms.json`` of nerfstudio, instant-ngp or NeRF, by their
    ``file_path``, in the order of the file::

        sensors = cw.cameras.load_transforms("capture")
        photographs = {name: cw.load_image(f"capture/{name}") for name in sensors}

    Intrinsics, in pixels, are those of a frame, or else of the file: the focal lengths ``fl_x`` and
    ``fl_y``, or the fields of view ``camera_angle_x`` and ``camera_angle_y``, in radians, where x alone
    stands for both; the principal point ``cx`` and ``cy``, from the corner of the image, by default
    its middle. ``transform_matrix`` is from camera to world, with OpenGL's axes, see
    :func:`from_opengl`. The world is the file's, in its units: neither an ``applied_transform`` is
    undone, nor are the poses scaled to fit a box.

    :param path: the file, or the folder that has a ``transforms.json``.
    :param size: width and height of the images, pixels, where the file has no ``w`` and ``h``.
    :return: for each frame a dictionary as of :func:`from_opengl`. Paths are relative to the folder
        of the file, and in NeRF's own files have no ending; those with a dot cannot be keys of a
        scene's dictionary.
    :raises LoadError: there is no such file, it is damaged, or a sensor cannot express a camera, such
        as one whose ``k1`` is not 0; with ``file``, the frame, and what to do.
    """
    sensors = {}
    for frame in read_frames(Path(path), None if size is None else _size(size)):
        if frame.name in sensors:
            raise frame.place.error(f'a frame before it has the same file_path "{frame.name}"')
        with frame.place.of_arguments():
            sensors[frame.name] = from_opengl(frame.K, frame.camera_to_world, frame.size)
    return sensors


def _sensor(
    K: Array, camera_to_world: NDArray[Any], size: tuple[int, int], first_pixel: float
) -> dict[str, Any]:
    """The sensor with these intrinsics at this pose, with OpenCV's axes."""
    width, height = _size(size)
    # Measured from the corner of the image.
    corner = 0.5 - real("first_pixel", first_pixel)
    (fx, fy), (cx, cy) = K[[0, 1], [0, 1]], K[:2, 2] + corner
    # y/z of the farthest row is at most this over fy.
    farthest = max(abs(cy), abs(height - cy))
    displaced = farthest * abs(fx - fy) / fy
    if displaced > _FOCAL_BLUR:
        raise ArgumentError(
            f"fx is {fx:.9g} and fy is {fy:.9g}; pixels of sensors are square, which would displace "
            f"the image by up to {displaced:.3g} pixels: resize the photograph to the height "
            f"{height * fx / fy:.9g}, and its fy and cy with it, or pass one focal length if that "
            "displacement is acceptable"
        )
    return {
        "type": "perspective",
        "fov": float(np.degrees(2.0 * np.arctan2(width, 2.0 * fx))),
        "fov_axis": "x",
        "principal_point_offset_x": float(0.5 - cx / width),
        "principal_point_offset_y": float(0.5 - cy / height),
        # A sensor has x to the left and y up.
        "to_world": camera_to_world @ np.diag([-1.0, -1.0, 1.0, 1.0]),
        "film": {"type": "hdrfilm", "width": width, "height": height},
    }


def _size(size: tuple[int, int]) -> tuple[int, int]:
    """Width and height of a film."""
    if np.shape(size) != (2,):
        raise ArgumentError(f"size is {size!r}; expected width and height in pixels")
    width, height = size
    return integer("the width", width, 1, _MOST_PIXELS), integer("the height", height, 1, _MOST_PIXELS)


def _intrinsics(K: ArrayLike) -> Array:
    matrix = _numbers("K", K, (3, 3))
    if (matrix[2] != [0.0, 0.0, 1.0]).any() or matrix[1, 0] != 0.0:
        raise ArgumentError(
            f"K is {matrix.tolist()}; expected [[fx, 0, cx], [0, fy, cy], [0, 0, 1]], perhaps of its "
            "transpose"
        )
    if matrix[0, 1] != 0.0:
        raise ArgumentError(
            f"K has the skew {matrix[0, 1]:.9g}; axes of sensors are at right angles: calibrate "
            "without skew"
        )
    if not (matrix[0, 0] > 0.0 and matrix[1, 1] > 0.0):
        raise ArgumentError(
            f"fx is {matrix[0, 0]:.9g} and fy is {matrix[1, 1]:.9g}; expected focal lengths above 0, "
            "in pixels"
        )
    return matrix


def _pose(name: str, value: ArrayLike) -> Array:
    """A rotation and a translation, (4, 4)."""
    pose = _numbers(name, value, (3, 4), (4, 4))
    if pose.shape == (3, 4):
        pose = np.vstack([pose, [0.0, 0.0, 0.0, 1.0]])
    rotation = pose[:3, :3]
    if (pose[3] != [0.0, 0.0, 0.0, 1.0]).any():
        raise ArgumentError(f"the last row of {name} is {pose[3].tolist()}; expected [0, 0, 0, 1]")
    if np.abs(rotation @ rotation.T - np.eye(3)).max() > _RIGID:
        raise ArgumentError(
            f"{name} scales or shears; expected a rotation and a translation: scale the positions of "
            "the cameras and the scene instead"
        )
    if np.linalg.det(rotation) < 0.0:
        raise ArgumentError(
            f"{name} mirrors (its determinant is negative); expected a rotation: an axis may have "
            "another sign, see the conventions of from_opencv and from_opengl"
        )
    return pose


def _rotation(qvec: ArrayLike) -> Array:
    """The matrix of a unit quaternion (w, x, y, z)."""
    quaternion = _numbers("qvec", qvec, (4,))
    length = float(np.linalg.norm(quaternion))
    if abs(length - 1.0) > ROUNDED_AXIS:
        raise ArgumentError(
            f"qvec has the length {length:.4g}; expected a unit quaternion w, x, y, z"
        )
    w, *axis = quaternion / length
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    # Rodrigues by half the angle: 1 + 2 w [v]x + 2 [v]x².
    rotation: Array = np.eye(3) + 2.0 * w * cross + 2.0 * cross @ cross
    return rotation


def _numbers(name: str, value: ArrayLike, *shapes: tuple[int, ...]) -> Array:
    """Finite numbers in one of these shapes."""
    array = numbers(name, value)
    if array.shape not in shapes:
        expected = " or ".join(map(str, shapes))
        raise ArgumentError(f"{name} has the shape {array.shape}; expected {expected}")
    if not np.isfinite(array).all():
        raise ArgumentError(f"{name} is {array.tolist()}; expected finite numbers")
    return array

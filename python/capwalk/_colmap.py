"""The cameras and images of a COLMAP model, text or binary, see COLMAP's documentation, "Output
Format"."""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ._place import Place
from .errors import ArgumentError, LoadError

_PARAMETERS = {"SIMPLE_PINHOLE": ("f", "cx", "cy"), "PINHOLE": ("fx", "fy", "cx", "cy")}
"""The models without distortion, and their parameters."""

_NUMBERED = (
    "SIMPLE_PINHOLE PINHOLE SIMPLE_RADIAL RADIAL OPENCV OPENCV_FISHEYE FULL_OPENCV FOV "
    "SIMPLE_RADIAL_FISHEYE RADIAL_FISHEYE THIN_PRISM_FISHEYE RAD_TAN_THIN_PRISM_FISHEYE "
    "SIMPLE_DIVISION DIVISION SIMPLE_FISHEYE FISHEYE EUCM EQUIRECTANGULAR"
).split()
"""All models by their numbers in binary files, from 0."""

_POINT = struct.calcsize("<ddQ")
"""Bytes of one of the points that an image has: x, y and the number of the point in space."""


@dataclass(frozen=True)
class Camera:
    """The intrinsics of images."""

    place: Place
    model: str
    size: tuple[int, int]
    params: tuple[float, ...]


@dataclass(frozen=True)
class Photograph:
    """An image: its name, its camera and its pose, from world to camera."""

    place: Place
    name: str
    camera: Camera
    qvec: tuple[float, ...]
    tvec: tuple[float, ...]


_Cameras = dict[int, Camera]


def parameter_names(model: str) -> tuple[str, ...]:
    """The parameters of a camera model without distortion. Refuses all others."""
    if model not in _PARAMETERS:
        raise ArgumentError(
            f"the camera model is {model!r}; sensors are pinhole cameras without distortion: expected "
            f'{" or ".join(map(repr, _PARAMETERS))}, which "colmap image_undistorter" makes of all others'
        )
    return _PARAMETERS[model]


def read_photographs(folder: Path) -> list[Photograph]:
    """The images of the model in a folder, in the order of the file."""
    for ending, read_cameras, read_images in (
        (".bin", _binary_cameras, _binary_images),
        (".txt", _text_cameras, _text_images),
    ):
        cameras, images = (Place(folder / f"{name}{ending}") for name in ("cameras", "images"))
        if cameras.file.is_file() and images.file.is_file():
            found = list(read_images(images, dict(read_cameras(cameras))))
            if not found:
                raise images.error("has no images; expected those of a reconstruction")
            return found
    raise Place(folder).error(
        "is no COLMAP model; expected cameras.bin and images.bin, or cameras.txt and images.txt: give "
        "the folder that has them, often sparse/0 or dense/sparse"
    )


def _text_cameras(place: Place) -> Iterator[tuple[int, Camera]]:
    for here, line in _lines(place):
        if not _is_record(line):
            continue
        try:
            number, model, width, height, *params = line.split()
            key, size = int(number), (int(width), int(height))
            values = tuple(map(float, params))
        except ValueError:
            raise _unreadable(here, "CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]") from None
        with here.of_arguments():
            parameter_names(model)
        yield key, Camera(here, model, size, values)


def _text_images(place: Place, cameras: _Cameras) -> Iterator[Photograph]:
    lines = _lines(place)
    for here, line in lines:
        if not _is_record(line):
            continue
        try:
            # A name may have blanks.
            _, qw, qx, qy, qz, tx, ty, tz, number, name = line.split(maxsplit=9)
            key = int(number)
            qvec = tuple(map(float, (qw, qx, qy, qz)))
            tvec = tuple(map(float, (tx, ty, tz)))
        except ValueError:
            raise _unreadable(here, "IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME") from None
        yield Photograph(here, name, _camera(here, cameras, key), qvec, tvec)
        # Its points. Without them, the next image would be taken for these.
        under, points = next(lines, (here, ""))
        if len(points.split()) % 3 or not _are_numbers(points):
            raise _unreadable(under, "the points of the image above, X, Y, POINT3D_ID, or an empty line")


def _are_numbers(line: str) -> bool:
    try:
        return all(math.isfinite(float(word)) for word in line.split())
    except ValueError:
        return False


def _lines(place: Place) -> Iterator[tuple[Place, str]]:
    """The lines of a text, without blanks around them."""
    for number, line in enumerate(_text(place.bytes()).split("\n"), 1):
        yield Place(place.file, line=number), line.strip()


def _text(data: bytes) -> str:
    """Names of files need be no text."""
    return data.decode("utf-8", "surrogateescape")


def _is_record(line: str) -> bool:
    return bool(line) and not line.startswith("#")


def _unreadable(place: Place, expected: str) -> LoadError:
    return place.error(f"expected {expected}; export the model anew by colmap model_converter")


def _camera(place: Place, cameras: _Cameras, key: int) -> Camera:
    if key not in cameras:
        raise place.error(f"the file of cameras has no camera {key}; copy both files anew")
    return cameras[key]


def _binary_cameras(place: Place) -> Iterator[tuple[int, Camera]]:
    data = _Bytes(place)
    for _ in range(data.number("Q", "the number of cameras")):
        key, index, width, height = data.take("IiQQ", "a camera")
        here = Place(place.file, f"camera {key}")
        model = _NUMBERED[index] if 0 <= index < len(_NUMBERED) else f"number {index}"
        with here.of_arguments():
            count = len(parameter_names(model))
        params = data.take(f"{count}d", f"camera {key}")
        yield key, Camera(here, model, (width, height), params)
    data.end()


def _binary_images(place: Place, cameras: _Cameras) -> Iterator[Photograph]:
    data = _Bytes(place)
    for _ in range(data.number("Q", "the number of images")):
        number, *pose, key = data.take("I7dI", "an image")
        name = data.name(f"image {number}")
        here = Place(place.file, f'image {number} "{name}"')
        data.skip(data.number("Q", here.record) * _POINT, here.record)
        yield Photograph(here, name, _camera(here, cameras, key), tuple(pose[:4]), tuple(pose[4:]))
    data.end()


class _Bytes:
    """What is left of a binary file, little-endian. ``what`` is being read, for messages."""

    def __init__(self, place: Place) -> None:
        self._place, self._data, self._at = place, place.bytes(), 0

    def take(self, layout: str, what: str | None) -> tuple[Any, ...]:
        """The next numbers."""
        start = self._at
        self.skip(struct.calcsize(f"<{layout}"), what)
        return struct.unpack_from(f"<{layout}", self._data, start)

    def number(self, layout: str, what: str | None) -> int:
        """The next number."""
        return int(self.take(layout, what)[0])

    def name(self, what: str) -> str:
        """The next text, which a zero ends."""
        end = self._data.find(0, self._at)
        start = self._at
        self.skip((end - start if end >= 0 else len(self._data)) + 1, what)
        return _text(self._data[start:end])

    def skip(self, count: int, what: str | None) -> None:
        """Goes on behind so many bytes."""
        self._at += count
        if self._at > len(self._data):
            raise self._place.error(f"ends within {what}, as if it was cut off; copy it anew")

    def end(self) -> None:
        """Refuses what comes behind the last record."""
        left = len(self._data) - self._at
        if left:
            raise self._place.error(f"has {left} bytes behind its last record; copy it anew")

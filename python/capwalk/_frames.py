"""The frames of a ``transforms.json``, as nerfstudio, instant-ngp and NeRF have it."""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ._place import Place

_NAME = "transforms.json"

_PINHOLES = ("OPENCV", "PINHOLE", "SIMPLE_PINHOLE")
"""The values of ``camera_model`` that are pinhole cameras if nothing below is there."""

_LENS = (
    "k1 k2 k3 k4 k5 k6 p1 p2 distortion_params is_fisheye ftheta_p0 latlong equirectangular "
    "rolling_shutter"
).split()
"""What a pinhole camera has not, unless it is zero or false."""


@dataclass(frozen=True)
class Frame:
    """An image: its path, its intrinsics in pixels from the corner, and its pose with OpenGL's axes."""

    place: Place
    name: str
    K: list[list[float]]
    camera_to_world: Any
    """As it stands in the file."""
    size: tuple[int, int]


def read_frames(path: Path, size: tuple[int, int] | None) -> Iterator[Frame]:
    """The frames of a file, or of the one in a folder. Without width and height there they have
    ``size``."""
    place = Place(path / _NAME if path.is_dir() else path)
    try:
        whole = json.loads(place.bytes())
    except (ValueError, RecursionError) as error:
        here, column = place, None
        if isinstance(error, json.JSONDecodeError):
            here, column = Place(place.file, line=error.lineno), error.colno
        raise here.error(f"is not JSON: {error}; export it anew", column) from None
    frames = whole.get("frames") if isinstance(whole, dict) else None
    if not isinstance(frames, list) or not frames:
        raise place.error('has no "frames"; expected a list of frames, as nerfstudio writes it')
    for index, frame in enumerate(frames):
        here = Place(place.file, f"frames[{index}]")
        if not isinstance(frame, dict) or not isinstance(frame.get("file_path"), str):
            raise here.error('has no "file_path"; expected the path of an image')
        here = Place(place.file, f'frames[{index}] "{frame["file_path"]}"')
        if "transform_matrix" not in frame:
            raise here.error('has no "transform_matrix"; expected one from camera to world, 4 by 4')
        yield _frame(here, _own(whole, frame), size)


def _own(whole: Mapping[str, Any], frame: Mapping[str, Any]) -> dict[str, Any]:
    """The values of a frame, and of the file where it has none. A focal length and an angle mean the same."""
    same = [{f"fl_{axis}", f"camera_angle_{axis}"} for axis in "xy"]
    hidden = set().union(*(names for names in same if names & frame.keys()))
    return {**{name: value for name, value in whole.items() if name not in hidden}, **frame}


def _frame(place: Place, values: Mapping[str, Any], size: tuple[int, int] | None) -> Frame:
    """A frame of these values, its own or else the file's."""
    model = values.get("camera_model", _PINHOLES[0])
    lens = [name for name in _LENS if _is_something(values.get(name))]
    if model not in _PINHOLES or lens:
        what = f"{lens[0]} is {values[lens[0]]!r}" if lens else f"camera_model is {model!r}"
        raise place.error(
            f"{what}; sensors are pinhole cameras without distortion: undistort the images, for "
            'instance by "colmap image_undistorter", and use the cameras of these'
        )
    if "w" in values and "h" in values:
        width, height = (_pixels(place, name, values[name]) for name in ("w", "h"))
    elif size is not None:
        width, height = size
    else:
        raise place.error('has no "w" and "h"; give size=(width, height) of the images, in pixels')
    fx, fy = (_focal(place, values, *axis) for axis in (("x", width), ("y", height)))
    if fx is None:
        raise place.error('has no "fl_x" or "camera_angle_x"; add one of them, in pixels or radians')
    cx, cy = (
        _number(place, name, values[name]) if name in values else length / 2
        for name, length in (("cx", width), ("cy", height))
    )
    K = [[fx, 0.0, cx], [0.0, fx if fy is None else fy, cy], [0.0, 0.0, 1.0]]
    return Frame(place, values["file_path"], K, values["transform_matrix"], (width, height))


def _focal(place: Place, values: Mapping[str, Any], axis: str, pixels: int) -> float | None:
    """The focal length along an axis in pixels, if it is there."""
    focal, angle = f"fl_{axis}", f"camera_angle_{axis}"
    if focal in values:
        return _number(place, focal, values[focal])
    if angle in values:
        radians = _number(place, angle, values[angle])
        if not 0.0 < radians < math.pi:
            raise place.error(f"{angle} is {radians!r}; expected an angle between 0 and pi, in radians")
        return pixels / (2.0 * math.tan(radians / 2.0))
    return None


def _is_something(value: Any) -> bool:
    """Whether a value is there and not zero throughout."""
    return any(map(_is_something, value)) if isinstance(value, list) else bool(value)


def _number(place: Place, name: str, value: Any) -> float:
    number = math.nan if isinstance(value, bool) else value
    if not isinstance(number, (int, float)) or not abs(number) <= sys.float_info.max:
        raise place.error(f"{name} is {value!r}; expected a finite number")
    return float(number)


def _pixels(place: Place, name: str, value: Any) -> int:
    """Some programs write numbers of pixels with a point."""
    number = _number(place, name, value)
    if not number.is_integer():
        raise place.error(f"{name} is {value!r}; expected a whole number of pixels")
    return int(number)

"""The cameras of captures in the files of COLMAP, nerfstudio, instant-ngp and NeRF."""

from __future__ import annotations

import json
import pickle
import struct
from pathlib import Path
from typing import Any

import capwalk as cw
import numpy as np
import pytest

SIZE = (64, 48)

CAMERAS: dict[int, tuple[int, str, tuple[int, int], list[float]]] = {
    7: (0, "SIMPLE_PINHOLE", SIZE, [70.0, 20.5, 30.0]),
    2: (1, "PINHOLE", (80, 60), [90.0, 90.0, 40.0, 30.25]),
}
"""The number of the model, its name, the size and the parameters, by the number of the camera."""

K = {
    7: np.array([[70.0, 0.0, 20.5], [0.0, 70.0, 30.0], [0.0, 0.0, 1.0]]),
    2: np.array([[90.0, 0.0, 40.0], [0.0, 90.0, 30.25], [0.0, 0.0, 1.0]]),
}

AXIS = np.array([2.0, -3.0, 6.0]) / 7.0

POINT = np.array([0.2, -0.1, 0.4])
"""Which all images see."""

Pose = tuple[int, float, list[float]]

POSES: dict[str, Pose] = {
    "right/b 2.jpg": (7, 20.0, [0.3, -0.4, 4.0]),
    "left/a.jpg": (2, -35.0, [-0.2, 0.1, 5.0]),
    "right/a.jpg": (7, 5.0, [0.1, 0.2, 6.0]),
}
"""The number of the camera, and the pose from world to camera: degrees about the axis, a shift."""


def matrix(pose: Pose) -> np.ndarray[Any, Any]:
    return cw.Transform().translate(pose[2]).rotate(AXIS, pose[1]).matrix


def qvec(pose: Pose) -> list[float]:
    half = np.radians(pose[1]) / 2.0
    return [np.cos(half), *np.sin(half) * AXIS]


def write_text(folder: Path) -> None:
    folder.mkdir(exist_ok=True)
    cameras = ["# Camera list", "#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]"]
    for key, (_, model, (width, height), params) in CAMERAS.items():
        cameras.append(f"{key} {model} {width} {height} {' '.join(map(repr, params))}")
    (folder / "cameras.txt").write_text("\n".join([*cameras, ""]))
    images = ["# Image list", "", "#   IMAGE_ID, QW, ..."]
    for number, (name, pose) in enumerate(POSES.items(), 3):
        numbers = " ".join(map(repr, map(float, [*qvec(pose), *pose[2]])))
        images.append(f"{number} {numbers} {pose[0]} {name}")
        images.append("1.5 2.5 -1 3.5 4.5 17" if number == 4 else "")
    (folder / "images.txt").write_text("\r\n".join(images))


def write_binary(folder: Path) -> None:
    folder.mkdir(exist_ok=True)
    data = struct.pack("<Q", len(CAMERAS))
    for key, (index, _, size, params) in CAMERAS.items():
        data += struct.pack(f"<IiQQ{len(params)}d", key, index, *size, *params)
    (folder / "cameras.bin").write_bytes(data)
    data = struct.pack("<Q", len(POSES))
    for number, (name, pose) in enumerate(POSES.items(), 3):
        data += struct.pack("<I7dI", number, *qvec(pose), *pose[2], pose[0])
        data += name.encode() + b"\0"
        points = [(1.5, 2.5, 2**64 - 1), (3.5, 4.5, 17)] if number == 4 else []
        data += struct.pack("<Q", len(points))
        data += b"".join(struct.pack("<ddQ", *point) for point in points)
    (folder / "images.bin").write_bytes(data)


def frames() -> dict[str, Any]:
    """The same cameras as frames: intrinsics of one for the file, those of the other by frame."""
    listed = []
    for name, pose in POSES.items():
        # OpenGL's y and z point the other way.
        to_world = np.linalg.inv(matrix(pose)) * [1.0, -1.0, -1.0, 1.0]
        frame: dict[str, Any] = {"file_path": name, "transform_matrix": to_world.tolist()}
        if pose[0] == 2:
            frame |= {"fl_x": 90.0, "fl_y": 90.0, "cx": 40, "cy": 30.25, "w": 80, "h": 60}
        listed.append(frame)
    return {
        "camera_model": "OPENCV",
        # Some programs write pixels with a point.
        "w": 64.0,
        "h": 48.0,
        "fl_x": 70.0,
        "cx": 20.5,
        "cy": 30,
        "k1": 0,
        "p2": 0.0,
        "is_fisheye": False,
        "applied_transform": [[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0]],
        "frames": listed,
    }


def write_frames(folder: Path, changed: dict[str, Any]) -> None:
    folder.mkdir(exist_ok=True)
    (folder / "transforms.json").write_text(json.dumps(changed))


def capture(kind: str, folder: Path) -> dict[str, dict[str, Any]]:
    """The sensors in files of this kind."""
    if kind == "json":
        write_frames(folder, frames())
        return cw.cameras.load_transforms(folder)
    (write_text if kind == "text" else write_binary)(folder)
    return cw.cameras.load_colmap(folder)


def assert_equal(
    sensors: dict[str, dict[str, Any]], expected: dict[str, dict[str, Any]], rounding: float
) -> None:
    assert sensors.keys() == expected.keys()
    for name, sensor in sensors.items():
        assert sensor.keys() == expected[name].keys()
        for key, value in sensor.items():
            other = expected[name][key]
            if isinstance(value, (str, dict)):
                assert value == other
            else:
                assert np.abs(np.subtract(value, other)).max() <= rounding


def test_all_files_say_the_same(tmp_path: Path) -> None:
    text, binary, json = (capture(kind, tmp_path / kind) for kind in ("text", "binary", "json"))
    assert list(text) == sorted(POSES) and list(json) == list(POSES)
    assert_equal(text, binary, 0.0)
    assert_equal(json, binary, 1e-12)
    # COLMAP prefers the binary files, too.
    (tmp_path / "binary/cameras.txt").write_text("nothing")
    (tmp_path / "binary/images.txt").write_text("nothing")
    assert_equal(cw.cameras.load_colmap(tmp_path / "binary"), binary, 0.0)
    file = tmp_path / "json/transforms.json"
    assert_equal(cw.cameras.load_transforms(str(file)), json, 0.0)


@pytest.mark.parametrize("kind", ["text", "binary", "json"])
@pytest.mark.parametrize("name", POSES)
def test_a_point_is_seen_where_the_numbers_say(kind: str, name: str, tmp_path: Path) -> None:
    """As the middle of a small ball's image. Perspective moves that by the distance from the principal
    point, at most 11 pixels here, times the square of radius over depth: by 0.007 pixels."""
    sensor = capture(kind, tmp_path)[name]
    sensor["film"]["rfilter"] = {"type": "box"}
    ball = {"type": "sphere", "center": POINT, "radius": 0.1}
    scene = cw.load_dict(
        {"type": "scene", "integrator": {"type": "direct"}, "sensor": sensor, "ball": ball}
    )
    assert scene.size == CAMERAS[POSES[name][0]][2]
    mask = cw.render(scene, aov="mask", spp=2048, seed=1).value[..., 0]
    rows, columns = np.indices(mask.shape) + 0.5
    seen = np.array([(mask * columns).sum(), (mask * rows).sum()]) / mask.sum()
    x, y, z = K[POSES[name][0]] @ (matrix(POSES[name]) @ [*POINT, 1.0])[:3]
    # The eight or so pixels at the edge of the ball have errors of 1/90 at most, at 1.7 pixels from
    # the middle of an area of 4: together 0.013, of which this is more than three times.
    assert np.abs(seen - [x / z, y / z]).max() < 0.045


@pytest.mark.parametrize(
    ("file", "old", "new", "line", "error"),
    [
        ("cameras", "7 SIMPLE_PINHOLE", "7 RADIAL", 3, "model is 'RADIAL'; .* image_undistorter"),
        ("cameras", "2 PINHOLE", "2 OPENCV", 4, "line 4: the camera model is 'OPENCV'"),
        ("cameras", " 30.25", "", 4, r"shape \(3,\); expected fx, fy, cx, cy of a PINHOLE"),
        ("cameras", " 30.25", " x", 4, "expected CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS"),
        ("cameras", "90.0 90.0", "90.0 95.0", 4, "fx is 90 and fy is 95; .* resize the photograph"),
        ("cameras", "64 48", "0 48", 3, "the width is 0"),
        ("cameras", "7 SIMPLE", "8 SIMPLE", None, "images.txt: line 4: .* no camera 7; copy both"),
        ("images", "left/a.jpg", "", 6, "expected IMAGE_ID, QW, .*NAME; export the model anew"),
        ("images", " 0.1 5.0 2 left", " 0.1 nan 2 left", 6, "tvec is .* expected finite"),
        ("images", "5 0.99", "5 0.5", 8, "line 8: qvec has the length 0.5"),
        ("images", "1.5 2.5 -1 3.5 4.5 17\r\n", "", 7, "line 7: expected the points of the image ab"),
        # Another image, whose name has two blanks.
        ("images", "1.5 2.5 -1 3.5 4.5 17\r\n", "3 1 0 0 0 0 0 1 7 a b c\r\n", 7, "expected the points"),
        ("images", "right/b 2.jpg", "right/a.jpg", 8, 'two images "right/a.jpg"; remove one'),
    ],
)
def test_wrong_text_has_a_line(
    file: str, old: str, new: str, line: int | None, error: str, tmp_path: Path
) -> None:
    write_text(tmp_path)
    path = tmp_path / f"{file}.txt"
    text = path.read_bytes().decode()
    assert text.count(old) == 1
    path.write_bytes(text.replace(old, new).encode())
    with pytest.raises(cw.LoadError, match=error) as raised:
        cw.cameras.load_colmap(tmp_path)
    if line is not None:
        assert (raised.value.file, raised.value.line) == (str(path), line)
        assert str(raised.value).startswith(f"{path}: line {line}: ")
    assert pickle.loads(pickle.dumps(raised.value)).line == raised.value.line


def test_wrong_binary_files_name_the_record(tmp_path: Path) -> None:
    write_binary(tmp_path)
    for name in ("cameras.bin", "images.bin"):
        path = tmp_path / name
        whole = path.read_bytes()
        for length in range(len(whole)):
            path.write_bytes(whole[:length])
            with pytest.raises(cw.LoadError, match=f"{name}: .*ends within .*copy it anew"):
                cw.cameras.load_colmap(tmp_path)
        path.write_bytes(whole + b"more")
        with pytest.raises(cw.LoadError, match=f"{name}: has 4 bytes behind its last record"):
            cw.cameras.load_colmap(tmp_path)
        path.write_bytes(whole)

    cameras, images = tmp_path / "cameras.bin", tmp_path / "images.bin"
    whole = cameras.read_bytes()
    for index, model in ((4, "OPENCV"), (99, "number 99"), (-1, "number -1")):
        cameras.write_bytes(whole[:12] + struct.pack("<i", index) + whole[16:])
        error = f"cameras.bin: camera 7: the camera model is '{model}'; .*image_undistorter"
        with pytest.raises(cw.LoadError, match=error):
            cw.cameras.load_colmap(tmp_path)
    cameras.write_bytes(whole)
    whole = images.read_bytes()
    # The first number of the first quaternion.
    images.write_bytes(whole[:12] + struct.pack("<d", 3.0) + whole[20:])
    with pytest.raises(cw.LoadError, match='images.bin: image 3 "right/b 2.jpg": qvec has the len'):
        cw.cameras.load_colmap(tmp_path)
    images.write_bytes(struct.pack("<Q", 0))
    with pytest.raises(cw.LoadError, match="images.bin: has no images"):
        cw.cameras.load_colmap(tmp_path)
    images.unlink()
    with pytest.raises(cw.LoadError, match="is no COLMAP model; expected cameras.bin and .* sparse"):
        cw.cameras.load_colmap(tmp_path)


def test_fields_of_view_stand_for_focal_lengths(tmp_path: Path) -> None:
    """As in the files of NeRF, without sizes: the principal point is the middle."""
    whole = frames()
    [frame, *_] = whole["frames"]
    angle = 2 * np.arctan(64 / 2 / 70.0)
    write_frames(tmp_path, {"camera_angle_x": angle, "frames": [frame]})
    with pytest.raises(cw.LoadError, match=r'"right/b 2.jpg": has no "w" and "h"; give size='):
        cw.cameras.load_transforms(tmp_path)
    [sensor] = cw.cameras.load_transforms(tmp_path, size=SIZE).values()
    k = [[70, 0, 32], [0, 70, 24], [0, 0, 1]]
    expected = cw.cameras.from_opengl(k, frame["transform_matrix"], SIZE)
    assert_equal({"": sensor}, {"": expected}, 1e-12)
    # A frame's own angle counts, and not the focal length of the file.
    write_frames(tmp_path, {"fl_x": 35.0, "frames": [frame | {"camera_angle_x": angle}]})
    assert_equal(cw.cameras.load_transforms(tmp_path, size=SIZE), {frame["file_path"]: expected}, 1e-12)
    with pytest.raises(cw.ArgumentError, match="size is 64; expected width and height"):
        cw.cameras.load_transforms(tmp_path, size=64)  # type: ignore[arg-type]
    # The field of view along y is another one.
    narrow = {"camera_angle_x": angle, "camera_angle_y": angle, "frames": [frame]}
    write_frames(tmp_path, narrow)
    with pytest.raises(cw.LoadError, match="fx is 70 and fy is 52.5; pixels of sensors are square"):
        cw.cameras.load_transforms(tmp_path, size=SIZE)


@pytest.mark.parametrize(
    ("change", "error"),
    [
        ({"k1": 0.05}, r'frames\[0\] "right/b 2.jpg": k1 is 0.05; .*undistort the images'),
        ({"distortion_params": [0, 0.1]}, r"distortion_params is \[0, 0.1\]; sensors are pinhole"),
        ({"rolling_shutter": [0, 0, 1, 0]}, "rolling_shutter is "),
        ({"camera_model": "OPENCV_FISHEYE"}, "camera_model is 'OPENCV_FISHEYE'; sensors are pin"),
        ({"frames": []}, 'transforms.json: has no "frames"'),
        ({"frames": {}}, 'has no "frames"'),
        ({"frames": [3]}, r'frames\[0\]: has no "file_path"'),
        ({"frames": [{"file_path": "a"}]}, r'frames\[0\] "a": has no "transform_matrix"'),
        ({"fl_x": None}, "fl_x is None; expected a finite number"),
        ({"fl_x": "70"}, "fl_x is '70'; expected a finite number"),
        ({"fl_x": 10**400}, "fl_x is 1000.* expected a finite number"),
        ({"fl_x": float("nan")}, "fl_x is nan; expected a finite number"),
        ({"fl_x": -70}, "fx is -70 and fy is -70; expected focal lengths above 0"),
        ({"fl_y": 75}, "fx is 70 and fy is 75; pixels of sensors are square"),
        ({"w": 64.5}, "w is 64.5; expected a whole number of pixels"),
        ({"cx": True}, "cx is True; expected a finite number"),
    ],
)
def test_wrong_frames_are_named(change: dict[str, Any], error: str, tmp_path: Path) -> None:
    write_frames(tmp_path, frames() | change)
    with pytest.raises(cw.LoadError, match=error) as raised:
        cw.cameras.load_transforms(tmp_path)
    assert raised.value.file == str(tmp_path / "transforms.json")


def test_wrong_poses_and_files(tmp_path: Path) -> None:
    def refused(error: str) -> cw.LoadError:
        with pytest.raises(cw.LoadError, match=error) as caught:
            cw.cameras.load_transforms(tmp_path)
        return caught.value

    refused("transforms.json: cannot be read: ")
    whole = frames()
    del whole["fl_x"]
    write_frames(tmp_path, whole)
    refused('"right/b 2.jpg": has no "fl_x" or "camera_angle_x"; add one of them')
    write_frames(tmp_path, whole | {"camera_angle_x": 0})
    refused("camera_angle_x is 0.0; expected an angle between 0 and pi, in radians")
    for pose, error in (
        ((2 * np.eye(4)).tolist(), "the last row of camera_to_world"),
        ([[2.0, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0]], "camera_to_world scales or shears"),
        ([[1.0], [2, 3]], "camera_to_world is no array of numbers"),
        ("here", "expected real numbers"),
    ):
        whole = frames()
        whole["frames"][1]["transform_matrix"] = pose
        write_frames(tmp_path, whole)
        refused(rf'frames\[1\] "left/a.jpg": .*{error}')
    whole = frames()
    whole["frames"][1]["file_path"] = "right/b 2.jpg"
    write_frames(tmp_path, whole)
    refused(r'frames\[1\] "right/b 2.jpg": a frame before it has the same file_path')
    file = tmp_path / "transforms.json"
    file.write_text('{"w": 64,\n "h" 48}')
    raised = refused("transforms.json: line 2: is not JSON: Expecting ':'")
    assert (raised.line, raised.column) == (2, 6)
    file.write_bytes(b"\xff\xfe\xfd")
    refused("transforms.json: is not JSON: ")
    file.write_text("[" * 100_000)
    refused("transforms.json: .*is not JSON: ")

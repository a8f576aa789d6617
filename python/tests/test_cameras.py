"""Cameras from intrinsics and extrinsics: points are seen where K [R|t] says."""

from __future__ import annotations

from typing import Any

import capwalk as cw
import numpy as np
import pytest
from numpy.typing import NDArray

WIDTH, HEIGHT = 64, 48
SIZE = (WIDTH, HEIGHT)
K = np.array([[70.0, 0.0, 20.5], [0.0, 70.0, 30.0], [0.0, 0.0, 1.0]])
"""Of a principal point off the middle, with (0, 0) at the corner of the image."""

AXIS, ANGLE = np.array([2.0, -3.0, 6.0]) / 7.0, 50.0
POSE = cw.Transform().translate([0.3, -0.4, 0.5]).rotate(AXIS, ANGLE).matrix
"""From world to camera."""

HALF = np.radians(ANGLE) / 2.0
QVEC, TVEC = [np.cos(HALF), *np.sin(HALF) * AXIS], POSE[:3, 3]

BACK = np.linalg.inv(POSE)
"""From camera to world."""


def opencv(k: Any = K, pose: Any = POSE, size: Any = SIZE, **more: Any) -> dict[str, Any]:
    return cw.cameras.from_opencv(k, pose, size, **more)


def sensors() -> dict[str, dict[str, Any]]:
    """The same camera in each convention."""
    of_middle = K - [[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]]
    right_up_backward = BACK * [1.0, -1.0, -1.0, 1.0]
    colmap: dict[str, Any] = {"qvec": QVEC, "tvec": TVEC}
    return {
        "opencv": opencv(of_middle),
        "3 x 4": opencv(of_middle, POSE[:3], distortion=np.zeros((1, 5))),
        "corner": opencv(first_pixel=0.5),
        "opengl": cw.cameras.from_opengl(K, right_up_backward, SIZE),
        "pinhole": cw.cameras.from_colmap("PINHOLE", [70, 70, 20.5, 30], SIZE, **colmap),
        "simple": cw.cameras.from_colmap("SIMPLE_PINHOLE", [70, 20.5, 30], SIZE, **colmap),
    }


@pytest.mark.parametrize("convention", sensors())
def test_points_are_seen_where_the_matrices_say(convention: str) -> None:
    """Each pixel of the AOV has the position of one sample, which is anywhere in that pixel."""
    sensor = sensors()[convention]
    sensor["film"]["rfilter"] = {"type": "box"}
    world = {"type": "sphere", "radius": 9.0}
    integrator = {"type": "direct"}
    scene = cw.load_dict({"type": "scene", "a": integrator, "sensor": sensor, "world": world})
    positions = cw.render(scene, aov="position", spp=1).value
    seen = positions @ POSE[:3, :3].T + POSE[:3, 3]
    assert (seen[..., 2] > 1.0).all()
    x, y, _ = np.moveaxis(seen @ K.T / seen[..., 2:], 2, 0)
    off = np.stack([x - np.arange(WIDTH) - 0.5, y - np.arange(HEIGHT)[:, None] - 0.5])
    rounding = 1e-9
    assert np.abs(off).max() < 0.5 + rounding
    # The variance of a uniform number is 1/12; beyond five standard errors by chance once in a
    # million.
    assert np.abs(off.mean(axis=(1, 2))).max() < 5 * np.sqrt(1 / 12 / (WIDTH * HEIGHT))


@pytest.mark.parametrize("convention", sensors())
def test_matrices_come_back(convention: str) -> None:
    sensor = sensors()[convention]
    focal = WIDTH / 2 / np.tan(np.radians(sensor["fov"]) / 2)
    offsets = np.array([sensor["principal_point_offset_x"], sensor["principal_point_offset_y"]])
    k: NDArray[np.float64] = np.diag([focal, focal, 1.0])
    k[:2, 2] = (0.5 - offsets) * SIZE
    assert np.allclose(k, K, rtol=1e-12, atol=1e-12)
    # Left and up are right and down.
    pose = np.linalg.inv(sensor["to_world"] * [-1.0, -1.0, 1.0, 1.0])
    assert np.allclose(pose, POSE, rtol=1e-12, atol=1e-12)


def test_focal_lengths_may_differ_by_what_no_pixel_shows() -> None:
    assert opencv(K + np.diag([0.0, 0.02, 0.0]))["fov"] == opencv()["fov"]
    # The farthest row is 30.5 above the principal point, or 37.5 below it: its tangent is over 72.
    for cy, pixels in ((30.0, 0.847), (10.0, 1.04)):
        error = f"the image by up to {pixels} pixels: resize the photograph to the height 46.66"
        with pytest.raises(cw.ArgumentError, match=error):
            opencv(changed(1, 2, cy, K + np.diag([0.0, 2.0, 0.0])))


def changed(i: int, j: int, value: float, of: NDArray[np.float64] = K) -> NDArray[np.float64]:
    matrix = of.copy()
    matrix[i, j] = value
    return matrix


@pytest.mark.parametrize(
    ("wrong", "error"),
    [
        ({"k": changed(0, 1, 0.5)}, "skew 0.5; axes of sensors are at right angles"),
        ({"k": K.T}, "perhaps of its transpose"),
        ({"k": changed(0, 0, -70.0)}, "fx is -70 and fy is 70; expected focal lengths above 0"),
        ({"k": changed(0, 2, np.nan)}, "expected finite numbers"),
        ({"k": np.eye(4)}, r"K has the shape \(4, 4\); expected \(3, 3\)"),
        ({"pose": 2 * POSE[:3]}, "world_to_camera scales or shears"),
        ({"pose": np.diag([1.0, 1.0, -1.0, 1.0])}, "world_to_camera mirrors"),
        ({"pose": POSE.T}, r"the last row of world_to_camera is \[0.3"),
        ({"pose": POSE[:3, :3]}, r"shape \(3, 3\); expected \(3, 4\) or \(4, 4\)"),
        ({"size": 64}, "size is 64; expected width and height"),
        ({"size": (64, 0)}, "the height is 0; expected 1 to"),
        ({"distortion": [0.1, 0, 0, 0]}, r"distortion is \[0.1, .*cv2.undistort"),
    ],
)
def test_what_a_sensor_cannot_express_is_refused(wrong: dict[str, Any], error: str) -> None:
    with pytest.raises(cw.ArgumentError, match=error):
        opencv(**wrong)


def test_what_colmap_can_express_and_a_sensor_cannot() -> None:
    def colmap(model: str, params: list[float], qvec: list[float]) -> None:
        cw.cameras.from_colmap(model, params, SIZE, qvec=qvec, tvec=[0, 0, 0])

    unit = [1.0, 0.0, 0.0, 0.0]
    with pytest.raises(
        cw.ArgumentError, match="'SIMPLE_PINHOLE' or 'PINHOLE', which .*undistorter"
    ):
        colmap("OPENCV", [70, 70, 20, 30, 0, 0, 0, 0], unit)
    with pytest.raises(cw.ArgumentError, match=r"shape \(4,\); expected f, cx, cy of a SIMPLE"):
        colmap("SIMPLE_PINHOLE", [70, 70, 20, 30], unit)
    with pytest.raises(cw.ArgumentError, match="qvec has the length 2"):
        colmap("SIMPLE_PINHOLE", [70, 20, 30], [2.0, 0.0, 0.0, 0.0])

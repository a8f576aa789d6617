"""Steps of an optimisation."""

from __future__ import annotations

import capwalk as cw
import numpy as np
import pytest
from numpy.typing import ArrayLike


def test_adam_takes_the_steps_by_hand() -> None:
    """The first step is the rate; with uniform rates the gradient keeps its direction."""
    values = {"x": np.array([1.0, -1.0]), "still": np.zeros(2)}
    cw.Adam(lr=0.1).step(values, {"x": [4.0, -0.01]})
    assert np.allclose(values["x"], [0.9, -0.9], atol=1e-6)
    assert not values["still"].any()
    values = {"x": np.array([1.0, -1.0])}
    uniform = cw.Adam(lr=0.1, uniform=True)
    uniform.step(values, {"x": [4.0, -1.0]})
    assert np.allclose(values["x"], [0.9, -0.975])


def test_adam_steps_through_a_scene(scene: cw.Scene) -> None:
    params = cw.traverse(scene)
    before = params["floor.bsdf.reflectance.value"].copy()
    cw.Adam(lr=0.01).step(params, {"floor.bsdf.reflectance.value": [1.0, 0.0, -1.0]})
    params.update()
    after = scene._values("floor.bsdf.reflectance.value")
    assert np.allclose(after - before, [-0.01, 0.0, 0.01])


def test_wrong_gradients_leave_all_as_it_was() -> None:
    adam, values = cw.Adam(lr=0.1), {"x": np.ones(2), "y": np.ones(3)}
    cases: list[tuple[ArrayLike, str]] = [
        (np.ones(2), r"shape \(2,\); expected \(3,\)"),
        ([1.0, np.nan, 0.0], "infinite numbers or NaN"),
    ]
    for wrong, message in cases:
        with pytest.raises(cw.ArgumentError, match=message):
            adam.step(values, {"x": np.ones(2), "y": wrong})
    assert values["x"].tolist() == [1.0, 1.0]


def test_large_steps_there_and_back(scene: cw.Scene) -> None:
    """For a cube, whose plugin has three vertices at each corner in other renderers."""
    corners = cw.traverse(scene)["box.positions"]
    faces = scene.faces("box")
    # Each triangle with vertices of its own, as a mesh with seams has them.
    x = corners[faces].reshape(-1, 3)
    split = np.arange(len(x)).reshape(-1, 3)
    large = cw.LargeSteps(x, split, lambda_=7.0)
    u = large.to_differential(x)
    assert u.shape == (8, 3)
    assert np.allclose(large.from_differential(u), x)
    # A step in u moves neighbours, too; and the gradient is the transpose.
    step = np.zeros_like(u)
    step[0, 0] = 1.0
    moved = large.from_differential(u + step) - x
    assert (moved[:, 0] > 0).all() and np.allclose(moved[:, 1:], 0)
    covector = np.random.default_rng(1).normal(size=x.shape)
    assert np.isclose((covector * moved).sum(), large.gradient(covector)[0, 0])


@pytest.mark.parametrize(
    ("positions", "faces", "lambda_", "message"),
    [
        (np.ones((3, 2)), [[0, 1, 2]], 1.0, "rows of three"),
        (np.eye(3), [[0, 1, 3]], 1.0, "beyond the 3"),
        (np.eye(3), [[0.0, 1.0, 2.0]], 1.0, "expected integers"),
        (np.eye(3), [[0, 1, 2]], -1.0, "at least 0"),
        (np.full((3, 3), np.inf), [[0, 1, 2]], 1.0, "infinite"),
    ],
)
def test_wrong_meshes(positions: object, faces: object, lambda_: float, message: str) -> None:
    with pytest.raises(cw.ArgumentError, match=message):
        cw.LargeSteps(positions, faces, lambda_)  # type: ignore[arg-type]


def test_faces_of_unknown_shapes(scene: cw.Scene) -> None:
    with pytest.raises(cw.ArgumentError, match='no shape "bx"; there are floor, box, lamp'):
        scene.faces("bx")

"""Steps of an optimisation."""

from __future__ import annotations

from typing import Any

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


@pytest.mark.parametrize("shape", [(5, 8, 3), (8, 5), (1, 6, 1), (1, 1)])
@pytest.mark.parametrize("order", [0.3, 0.75, 2.0])
def test_sobolev_gradients_are_linear_symmetric_and_positive(
    shape: tuple[int, ...], order: float
) -> None:
    """As a matrix; its eigenvectors are cosines."""
    count = int(np.prod(shape))
    units = np.eye(count).reshape(count, *shape)
    matrix = np.stack([cw.sobolev_gradient(unit, order).ravel() for unit in units], axis=1)
    np.testing.assert_allclose(matrix, matrix.T, atol=1e-14)
    height, width = shape[:2]
    k, longest = np.mgrid[:height, :width], max(shape[:2])
    squares = (k[0] * longest / height) ** 2 + (k[1] * longest / width) ** 2
    expected = np.repeat((1 + squares) ** -order, count // (height * width))
    np.testing.assert_allclose(np.linalg.eigvalsh(matrix), np.sort(expected.ravel()), rtol=1e-9)
    given = np.random.default_rng(3).normal(size=shape)
    np.testing.assert_allclose(
        cw.sobolev_gradient(given, order).ravel(), matrix @ given.ravel(), atol=1e-13
    )
    constant = np.full(shape, 0.7)
    np.testing.assert_allclose(cw.sobolev_gradient(constant, order), constant, rtol=1e-12)


def test_sobolev_gradients_do_not_depend_on_the_resolution() -> None:
    """The density of a gradient, which is per texel, is smoothed the same."""
    y, x = np.mgrid[:64, :64] / 64
    fine = np.exp(-20 * ((x - 0.3) ** 2 + (y - 0.6) ** 2))
    coarse = fine.reshape(32, 2, 32, 2).sum(axis=(1, 3))
    smooth = cw.sobolev_gradient(fine).reshape(32, 2, 32, 2).sum(axis=(1, 3))
    np.testing.assert_allclose(cw.sobolev_gradient(coarse), smooth, atol=2e-3 * smooth.max())


def test_textures_are_found_with_few_samples() -> None:
    """Where single texels drown in noise: after the same samples their error is less than half, and the
    difference 20 standard errors over seeds."""
    view = cw.Transform().look_at(origin=[0, 0, 3], target=[0, 0, 0], up=[0, 1, 0])
    grey = {"type": "bitmap", "data": np.full((16, 16, 3), 0.5)}
    scene = cw.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "direct"},
            "view": {"type": "perspective", "fov": 38, "to_world": view},
            "sky": {"type": "constant"},
            "wall": {"type": "rectangle", "bsdf": {"type": "diffuse", "reflectance": grey}},
        }
    )
    scene.resize(16, 16)
    name, params = "wall.bsdf.reflectance.data", cw.traverse(scene)
    y, x = np.mgrid[:16, :16] / 16
    truth = 0.5 + 0.3 * np.stack([np.sin(4 * x), np.cos(5 * y), np.sin(4 * x - 3 * y)], axis=2)
    params.update({name: truth})
    target = cw.render(scene, spp=256, seed=1).value

    def error(seed: int, smooth: bool) -> float:
        params.update({name: np.full_like(truth, 0.5)})
        adam = cw.Adam(lr=0.05)
        for step in range(40):
            first = 2 + 2 * (100 * seed + step)
            image = cw.render(scene, spp=2, seed=first).value
            adjoint = 2 * (image - target) / image.size
            gradient = cw.backward(scene, adjoint, [name], spp=2, seed=first + 1)[name]
            adam.step(params, {name: cw.sobolev_gradient(gradient) if smooth else gradient})
            params[name] = np.clip(params[name], 0, 1)
            params.update()
        return float(np.sqrt(np.square(params[name] - truth).mean()))

    without, smooth = (
        np.array([error(seed, way) for seed in range(6)]) for way in (False, True)
    )
    gains = without - smooth
    assert gains.mean() > 20 * gains.std(ddof=1) / np.sqrt(len(gains))
    assert (2 * smooth < without).all()


def test_sobolev_gradients_are_gradients_of_tensors() -> None:
    torch: Any = pytest.importorskip("torch")
    texture = torch.zeros(4, 6, 3, requires_grad=True)
    texture.register_hook(lambda g: torch.from_numpy(cw.sobolev_gradient(g.numpy())).to(g))
    weights = torch.arange(72.0).reshape(4, 6, 3)
    (texture * weights).sum().backward()
    np.testing.assert_allclose(texture.grad, cw.sobolev_gradient(weights), rtol=1e-6)


def test_wrong_sobolev_gradients_are_refused() -> None:
    for gradient, order, message in [
        (np.ones(3), 0.75, "expected .height, width"),
        (np.ones((0, 3, 3)), 0.75, "expected .height, width"),
        (np.full((2, 2), np.inf), 0.75, "infinite"),
        (np.ones((2, 2)), 0.0, "order is 0.0"),
        (np.ones((2, 2)), np.nan, "order is nan"),
    ]:
        with pytest.raises(cw.ArgumentError, match=message):
            cw.sobolev_gradient(gradient, order)

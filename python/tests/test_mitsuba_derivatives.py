"""capwalk inside Mitsuba 3: derivatives, against differences of Mitsuba's own images."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

mi = pytest.importorskip("mitsuba")
dr = pytest.importorskip("drjit")
import capwalk.mitsuba._integrator as integrator_module  # noqa: E402  It needs Mitsuba.
from capwalk.mitsuba._convert import convert  # noqa: E402
from llvm import has_llvm  # noqa: E402
from mitsuba_scenes import (  # noqa: E402
    SCALAR,
    SCENES,
    VECTORIZED,
    Description,
    flat_mesh,
    random,
    scene,
    sensor,
    smooth_mesh,
    turned,
)


pytestmark = pytest.mark.skipif(not has_llvm(), reason="Mitsuba cannot render with LLVM here")


@pytest.fixture(autouse=True)
def vectorized() -> Iterator[None]:
    mi.set_variant(VECTORIZED)
    mi.set_log_level(mi.LogLevel.Error)
    yield
    mi.set_variant(SCALAR)


def weights(shape: tuple[int, ...]) -> Any:
    """Weights of a loss that tell where things are in the image."""
    y, x, c = np.meshgrid(*(np.linspace(-1, 1, n) for n in shape), indexing="ij")
    return np.sin(2 * x + y) + 0.5 * y + 0.2 * c


Move = Callable[[Any, Any], None]


def derivatives(
    description: Description, move: Move, kind: str, spp: int, seeds: int, mode: str = "reverse"
) -> Any:
    """Derivatives of a weighted sum of the image by one number, one for each seed."""
    integrator = mi.load_dict({"type": kind, "max_depth": 3})
    loaded = mi.load_dict(description)
    params = mi.traverse(loaded)
    found = []
    for seed in range(1, seeds + 1):
        number = mi.Float(0.0)
        dr.enable_grad(number)
        move(params, number)
        params.update()
        image = mi.render(loaded, params, integrator=integrator, spp=spp, seed=seed)
        loss = dr.sum(image * mi.TensorXf(weights(image.shape).astype(np.float32)))
        if mode == "reverse":
            dr.backward(loss)
            found.append(float(dr.grad(number)[0]))
        else:
            dr.forward(number)
            found.append(float(np.asarray(dr.grad(loss)).item()))
    return np.array(found)


def differences(
    description: Callable[[], Description], move: Move, step: float, spp: int, seeds: int
) -> Any:
    """Central differences of the same by Mitsuba's path, one for each seed."""
    integrator = mi.load_dict({"type": "path", "max_depth": 3})
    found = []
    for seed in range(1, seeds + 1):
        sums = []
        for side in (step, -step):
            # With meshes of its own: they are moved.
            loaded = mi.load_dict(description())
            params = mi.traverse(loaded)
            move(params, mi.Float(side))
            params.update()
            # Common random numbers.
            image = np.asarray(mi.render(loaded, integrator=integrator, spp=spp, seed=seed))
            sums.append((image.astype(np.float64) * weights(image.shape)).sum())
        found.append((sums[0] - sums[1]) / (2 * step))
    return np.array(found)


def colour(key: str, value: tuple[float, float, float]) -> Move:
    def move(params: Any, x: Any) -> None:
        params[key] = mi.Color3f(*value) + mi.Color3f(x, 0.5 * x, 0)

    return move


def grey(params: Any, x: Any) -> None:
    params["ball.bsdf.reflectance.value"] = 0.5 + x


def shift(key: str, *direction: float) -> Move:
    def move(params: Any, x: Any) -> None:
        by = mi.Vector3f(*(x * d for d in direction))
        if key.endswith("to_world"):
            params[key] = mi.Transform4f().translate(by) @ mi.Transform4f(dr.detach(params[key]))
        else:
            points = dr.unravel(mi.Point3f, dr.detach(params[key]))
            params[key] = dr.ravel(points + by)

    return move


def bend(key: str) -> Move:
    """Moves each vertex another way, so that normals change."""

    def move(params: Any, x: Any) -> None:
        points = dr.unravel(mi.Point3f, dr.detach(params[key]))
        params[key] = dr.ravel(points * (1 + 0.3 * x * mi.Vector3f(points.y, 0, 1)))

    return move


def fold(key: str) -> Move:
    """Raises the middle of a sheet."""

    def move(params: Any, x: Any) -> None:
        points = dr.unravel(mi.Point3f, dr.detach(params[key]))
        up = dr.select(dr.abs(points.x) < 0.1, x, 0)
        params[key] = dr.ravel(points + mi.Vector3f(0, up, 0))

    return move


def texels(params: Any, x: Any) -> None:
    data = dr.detach(params["ball.bsdf.reflectance.data"])
    params["ball.bsdf.reflectance.data"] = data + x * mi.TensorXf(random(4, 5, 3) - 0.3)


# Scene, what moves, step of the differences, and samples for them and for ours.
MOVES: dict[str, tuple[Callable[[], Description], Move, float, int, int]] = {
    "colour": (scene, colour("floor.bsdf.reflectance.value", (0.7, 0.5, 0.3)), 0.05, 256, 32),
    "radiance": (scene, colour("lamp.emitter.radiance.value", (10, 9, 8)), 0.5, 256, 32),
    "grey": (scene, grey, 0.05, 256, 32),
    "texels": (SCENES["bitmap, mirrored"], texels, 0.05, 256, 32),
    "sphere": (scene, shift("ball.to_world", 1, 0.5, 0), 0.05, 2048, 32),
    "cube": (
        lambda: scene(ball={"type": "cube", "to_world": turned(("translate", [0.2, 1.3, 0]))}),
        shift("ball.vertex_positions", 1, 0.5, 0),
        0.05,
        2048,
        32,
    ),
    # Flat as it is, with normals that faces share: they turn with all of them.
    "sheet, folded": (flat_mesh, fold("ball.vertex_positions"), 0.02, 2048, 64),
    "lamp": (scene, shift("lamp.to_world", 1, 0, 0.5), 0.1, 2048, 32),
    "normals": (smooth_mesh, bend("ball.vertex_positions"), 0.05, 2048, 32),
}


# Curved shapes have many triangles, and take their time.
CASES = [(name, mode) for name in MOVES for mode in ("reverse", "forward")]
CASES = [case for case in CASES if case not in (("sphere", "forward"), ("lamp", "reverse"))]


@pytest.mark.parametrize(("name", "mode"), CASES)
def test_derivatives_are_those_of_mitsubas_images(name: str, mode: str) -> None:
    make, move, step, samples, spp = MOVES[name]
    small = {"type": "hdrfilm", "width": 12, "height": 9, "rfilter": {"type": "box"}}

    def description() -> Description:
        return {**make(), "sensor": sensor(film=small)}

    reference = differences(description, move, step, samples, 4)
    ours = derivatives(description(), move, "capwalk", spp, 4, mode)
    error = np.sqrt(sum(each.var(ddof=1) / len(each) for each in (ours, reference)))
    size = abs(reference.mean())
    told = f"{reference.mean():.4g}, {ours.mean():.4g} ± {error:.2g}"
    # One that is wrong by the half of it is seen.
    assert error < 0.1 * size, told
    assert abs(ours.mean() - reference.mean()) < 5 * error + 0.01 * size, told


def test_normals_that_faces_share_turn_with_all_of_them() -> None:
    """A flat mesh has the normals of its faces as long as it stays flat."""
    loaded = mi.load_dict(flat_mesh())
    params = mi.traverse(loaded)

    def is_flat() -> bool:
        described = convert(loaded, loaded.sensors(), {"type": "path"}).plain()
        [mesh] = [shape for shape in described.values() if "faces" in shape]
        return bool(mesh["face_normals"])

    assert is_flat()
    number = mi.Float(0.0)
    dr.enable_grad(number)
    fold("ball.vertex_positions")(params, number)
    params.update()
    assert not is_flat()


def test_image_and_gradient_have_different_seeds(monkeypatch: pytest.MonkeyPatch) -> None:
    used: list[int] = []

    def watched(function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any, **options: Any) -> Any:
            used.append(options["seed"])
            return function(*arguments, **options)

        return call

    for name in ("render", "backward"):
        monkeypatch.setattr(integrator_module, name, watched(getattr(integrator_module, name)))
    loaded = mi.load_dict(scene())
    params = mi.traverse(loaded)
    dr.enable_grad(params["floor.bsdf.reflectance.value"])
    ours = mi.load_dict({"type": "capwalk"})
    dr.backward(dr.mean(mi.render(loaded, params, integrator=ours, spp=1, seed=5)))
    assert len(used) == 2 and used[0] == 5 and used[1] != 5


def test_parameters_without_derivatives_are_refused() -> None:
    loaded = mi.load_dict(SCENES["bitmap, clamped"]())
    params = mi.traverse(loaded)
    dr.enable_grad(params["sensor.principal_point_offset_x"])
    params.update()
    ours = mi.load_dict({"type": "capwalk"})
    image = mi.render(loaded, params, integrator=ours, spp=1)
    with pytest.raises(Exception) as caught:
        dr.backward(dr.mean(image))
    assert "sensor.principal_point_offset_x has no derivative in capwalk" in all_messages(
        caught.value
    )


def all_messages(error: BaseException | None) -> str:
    """The messages of an exception and of those that it comes from."""
    return "" if error is None else f"{error}\n{all_messages(error.__cause__)}"


def test_a_colour_and_a_place_are_recovered() -> None:
    """A script as for Mitsuba's own integrators, but for the integrator's name."""
    integrator = mi.load_dict({"type": "capwalk", "max_depth": 2})
    box = {"type": "cube", "to_world": turned(("translate", [0.3, 1, 0]), ("scale", 0.6))}
    loaded = mi.load_dict(scene(ball=box))
    target = mi.render(loaded, integrator=integrator, spp=256, seed=1000)
    params = mi.traverse(loaded)
    key, positions = "floor.bsdf.reflectance.value", "ball.vertex_positions"
    start = dr.unravel(mi.Point3f, params[positions])
    opt = mi.ad.Adam(lr=0.05)
    opt["colour"] = mi.Color3f(0.3, 0.3, 0.6)
    opt["shift"] = mi.Vector3f(-0.4, 0.2, 0.0)
    for step in range(25):
        opt["colour"] = dr.clip(opt["colour"], 0.01, 0.99)
        params[key] = opt["colour"]
        params[positions] = dr.ravel(start + opt["shift"])
        params.update()
        image = mi.render(loaded, params, integrator=integrator, spp=8, seed=step)
        dr.backward(dr.mean(dr.square(image - target)))
        opt.step()
    assert np.allclose(np.asarray(opt["colour"]).ravel(), [0.7, 0.5, 0.3], atol=0.06)
    assert np.allclose(np.asarray(opt["shift"]).ravel()[:2], 0.0, atol=0.06)

"""The numbers of a scene."""

from __future__ import annotations

import capwalk as cw
import numpy as np
import pytest


def test_update_moves_the_scene(scene: cw.Scene) -> None:
    before = cw.render(scene).value
    params = cw.traverse(scene)
    params["box.positions"] += [0.3, 0.0, 0.0]
    # Nothing before the update.
    assert np.array_equal(cw.render(scene).value, before)
    params.update()
    moved = cw.render(scene).value
    assert not np.array_equal(moved, before)
    params["box.positions"] -= [0.3, 0.0, 0.0]
    params.update()
    assert np.allclose(cw.render(scene).value, before, atol=1e-9)


def test_translations_move_shapes_and_take_them_back(scene: cw.Scene) -> None:
    before, place = cw.render(scene).value, scene._values("box.to_world")
    params = cw.traverse(scene)
    assert params["box.translate"].tolist() == [0.0, 0.0, 0.0]
    offset = np.array([0.3, 0.1, -0.2])
    params["box.translate"] = offset
    params.update()
    moved = scene.copy()
    # From where it is now; and the matrix went with it.
    assert params["box.translate"].tolist() == [0.0, 0.0, 0.0]
    assert np.allclose(params["box.to_world"][:3, 3] - place[:3, 3], offset, atol=1e-14)
    params.update({"box.translate": -offset})
    assert np.allclose(cw.render(scene).value, before, atol=1e-9)
    cw.traverse(scene).update({"box.positions": scene._values("box.positions") + offset})
    by_vertices = cw.render(scene).value
    assert np.allclose(cw.render(moved).value, by_vertices, atol=1e-9)
    assert not np.allclose(by_vertices, before, atol=1e-3)
    for other in ("box.positions", "box.to_world"):
        both = {"box.translate": offset, other: scene._values(other)}
        with pytest.raises(cw.ArgumentError, match="both place box"):
            params.update(both)


def test_update_answers_like_a_new_scene(scene: cw.Scene) -> None:
    positions = scene._values("box.positions") * 1.1
    colour = [0.1, 0.9, 0.2]
    params = cw.traverse(scene)
    params.update({"box.positions": positions, "floor.bsdf.reflectance.value": colour})
    anew = scene.copy()
    one = cw.gradient(scene, "box.translate.x", seed=5)
    other = cw.gradient(anew, "box.translate.x", seed=5)
    assert np.array_equal(one.gradient, other.gradient)
    # A copy changes by itself.
    cw.traverse(anew).update({"floor.bsdf.reflectance.value": [0.5, 0.5, 0.5]})
    assert scene._values("floor.bsdf.reflectance.value").tolist() == colour


def test_all_changes_or_none(scene: cw.Scene) -> None:
    params = cw.traverse(scene)
    before = scene._values("box.positions")
    params["box.positions"] = before + 1.0
    params["floor.bsdf.reflectance.value"] = [-1.0, 0.0, 0.0]
    with pytest.raises(cw.Error):
        params.update()
    assert np.array_equal(scene._values("box.positions"), before)
    # What was refused is forgotten.
    params.update()
    assert np.array_equal(scene._values("box.positions"), before)


def test_mapping(scene: cw.Scene) -> None:
    params = cw.traverse(scene)
    assert "box.positions" in params and "sphere.positions" not in params
    assert len(params) == len(list(params)) > 8
    table = repr(params)
    assert "box.positions" in table and "world units" in table
    with pytest.raises(TypeError):
        del params["box.positions"]
    # Flat arrays as Mitsuba has them, and a number for an array of one.
    params["box.positions"] = scene._values("box.positions").ravel() * 2
    params["sensor.x_fov"] = 50.0
    params.update()
    assert scene._values("sensor.x_fov")[0] == pytest.approx(50.0)


def test_colours_are_recovered(scene: cw.Scene) -> None:
    """A few steps down a gradient, with independent seeds for image and gradient."""
    name = "floor.bsdf.reflectance.value"
    target = cw.render(scene, spp=256, seed=99).value
    params = cw.traverse(scene)
    params[name] = [0.2, 0.2, 0.2]
    params.update()

    def loss() -> float:
        return float(((cw.render(scene, spp=64, seed=7).value - target) ** 2).sum())

    start = loss()
    for step in range(12):
        adjoint = 2 * (cw.render(scene, seed=2 * step).value - target)
        gradients = cw.backward(scene, adjoint, [name], seed=2 * step + 1)
        params[name] -= 0.004 * gradients[name]
        params.update()
    assert loss() < 0.05 * start
    assert np.abs(params[name] - [0.7, 0.5, 0.3]).max() < 0.1


def test_reading_changes_nothing(scene: cw.Scene) -> None:
    """What was only read is not written back over what others have set."""
    colour = "floor.bsdf.reflectance.value"
    params, others = cw.traverse(scene), cw.traverse(scene)
    before = params[colour].copy()
    others.update({colour: [0.1, 0.2, 0.3]})
    # What was read is read again where the scene has changed.
    assert params[colour].tolist() == [0.1, 0.2, 0.3]
    params.update({"box.positions": params["box.positions"] + 0.1})
    assert scene._values(colour).tolist() == [0.1, 0.2, 0.3]
    params[colour] = before
    params.update()
    assert np.array_equal(scene._values(colour), before)


def test_a_refused_mapping_leaves_nothing_behind(scene: cw.Scene) -> None:
    params = cw.traverse(scene)
    before = scene._values("box.positions")
    with pytest.raises(cw.ArgumentError):
        params.update({"box.positions": before + 1, "box.to_world": [1.0, 2.0]})
    params.update()
    assert np.array_equal(scene._values("box.positions"), before)


def test_a_busy_scene_keeps_what_was_set(scene: cw.Scene) -> None:
    params = cw.traverse(scene)
    moved = params["box.positions"] + 0.2
    params["box.positions"] = moved

    def change(done: int, total: int) -> None:
        with pytest.raises(cw.BusyError, match="change a copy"):
            params.update()

    cw.render(scene, progress=change)
    params.update()
    assert np.array_equal(scene._values("box.positions"), moved)


def test_mitsubas_names(scene: cw.Scene) -> None:
    params = cw.traverse(scene)
    assert "box.vertex_positions" in params and "box.vertex_positions" not in list(params)
    params["box.vertex_positions"] += 0.1
    params.update()
    assert np.array_equal(params["box.positions"], params["box.vertex_positions"])
    ones = np.ones((18, 24, 3))
    names = ["box.vertex_positions", "box.positions"]
    gradients = cw.backward(scene, ones, names, spp=4)
    assert np.array_equal(gradients[names[0]], gradients[names[1]])
    params.keep(r"box\..*")
    of_shape = {"box.positions", "box.to_world", "box.translate"}
    assert set(params) == {*of_shape, "box.bsdf.reflectance.value"}

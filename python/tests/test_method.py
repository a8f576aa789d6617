"""Methods that were chosen before."""

from __future__ import annotations

import pickle
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

import capwalk as cw
from capwalk import _capwalk, _functional
from capwalk.parallel import Pool

BOX = "box.translate.x"
NAMES = ["box.positions"]


@pytest.fixture
def adjoint() -> np.ndarray:
    return np.linspace(-1, 1, 18 * 24 * 3).reshape(18, 24, 3)


def test_a_chosen_method_gives_the_same(scene: cw.Scene) -> None:
    first = cw.gradient(scene, BOX, spp=8)
    assert first.method.name in ("walk", "edges")
    method = pickle.loads(pickle.dumps(first.method))
    again = cw.gradient(scene, BOX, spp=8, method=method)
    assert np.array_equal(again.gradient, first.gradient)
    assert again.method == first.method
    # The samples are those that are asked for now, not those of the pilot's call.
    more = cw.gradient(scene, BOX, spp=12, seed=5, method=method)
    assert more.statistics["samples"] == 12 * 18 * 24
    assert not np.array_equal(more.value, cw.gradient(scene, BOX, spp=12, method=method).value)


def test_settings_belong_to_it(scene: cw.Scene) -> None:
    wide, narrow = (
        cw.gradient(scene, BOX, spp=4, method="walk", max_angle=angle) for angle in (90.0, 1.0)
    )
    assert wide.method != narrow.method
    again = cw.gradient(scene, BOX, spp=4, method=narrow.method)
    assert np.array_equal(again.gradient, narrow.gradient)
    assert not np.array_equal(again.gradient, wide.gradient)
    with pytest.raises(cw.ArgumentError, match='give its name with them: method="walk"'):
        cw.gradient(scene, BOX, method=wide.method, steps=3)


def test_scenes_keep_them(scene: cw.Scene, adjoint: np.ndarray) -> None:
    first = cw.backward(scene, adjoint, NAMES, spp=64, seed=1)
    params = cw.traverse(scene)
    params["box.positions"] = params["box.positions"] + 0.01
    params.update()
    kept = cw.backward(scene, -adjoint, NAMES, spp=64, seed=2)
    assert kept.method == first.method
    # That is all that is left of what was before.
    anew = cw.backward(scene.copy(), -adjoint, NAMES, spp=64, seed=2, method=first.method)
    assert np.array_equal(kept["box.positions"], anew["box.positions"])


def test_functions_choose_for_the_scene(
    scene: cw.Scene, adjoint: np.ndarray, monkeypatch: pytest.MonkeyPatch
) -> None:
    choices: list[tuple[Any, ...]] = []
    choose = _capwalk.choose

    def counted(*asked: Any) -> Any:
        choices.append(asked)
        return choose(*asked)

    monkeypatch.setattr(_capwalk, "choose", counted)
    values = cw.traverse(scene)["box.positions"]

    def pulled(scene: cw.Scene, moved: float, seed: int) -> np.ndarray:
        work = _functional.Work(scene, {"box.positions": values.shape}, spp=4, spp_grad=64)
        return work.pull(seed, [values + moved], [True], adjoint)[0]

    pulled(scene, 0.2, 1)
    second = pulled(scene, 0.1, 2)
    assert len(choices) == 1
    # Whatever was asked for before.
    assert np.array_equal(pulled(scene.copy(), 0.1, 2), second)
    assert len(choices) == 2


def test_gradients_of_losses_have_one(scene: cw.Scene, adjoint: np.ndarray) -> None:
    first = cw.backward(scene, adjoint, NAMES, spp=8)
    again = cw.backward(scene, adjoint, NAMES, spp=8, method=first.method)
    assert np.array_equal(again["box.positions"], first["box.positions"])
    with ThreadPoolExecutor(2) as executor:
        parts = Pool(executor).backward(scene, adjoint, NAMES, spp=8, method=first.method)
        assert np.array_equal(parts["box.positions"], first["box.positions"])
        assert parts.method == first.method
        views = Pool(executor).backward_views(scene, [adjoint], NAMES, spp=8, method=first.method)
        assert views.method == first.method
        assert np.array_equal(views["box.positions"], first["box.positions"])
    check = cw.check(scene, BOX, spp=8, method=first.method)
    same = cw.gradient(scene, BOX, spp=8, method=first.method)
    assert np.array_equal(check.gradient, same.gradient)

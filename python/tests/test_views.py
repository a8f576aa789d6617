"""Several sensors, what they show besides light, and scenes in other places."""

from __future__ import annotations

import copy
import pickle

import capwalk as cw
import numpy as np
import pytest
from conftest import SCENE
from numpy.typing import ArrayLike

LEFT = """<sensor type="perspective" id="left">
<transform name="to_world"><lookat origin="-3, 3, 6" target="0, 0.5, 0" up="0, 1, 0"/></transform>
<film type="hdrfilm"><integer name="width" value="20"/><integer name="height" value="10"/></film>
<sampler type="independent"><integer name="sample_count" value="8"/></sampler></sensor></scene>"""


@pytest.fixture
def two() -> cw.Scene:
    """The scene of the other tests with a second sensor."""
    return cw.load_string(SCENE.replace("</scene>", LEFT))


def two_of_one_size() -> cw.Scene:
    """The same with 24 x 18 pixels each."""
    left = LEFT.replace('value="20"', 'value="24"').replace('value="10"', 'value="18"')
    return cw.load_string(SCENE.replace("</scene>", left))


def test_sensors(two: cw.Scene) -> None:
    image = cw.render(two, sensor="left")
    assert image.value.shape == (10, 20, 3)
    assert np.array_equal(image.value, cw.render(two, sensor=1, spp=8).value)
    assert cw.render(two).value.shape == (18, 24, 3)
    derivative = cw.gradient(two, "box.translate.x", sensor="left", method="walk", max_angle=10)
    ones = np.ones((10, 20, 3))
    gradients = cw.backward(two, ones, ["box.positions", "left.to_world"], sensor="left", seed=0)
    assert derivative.gradient.shape == (10, 20, 3) and gradients["left.to_world"].any()
    with pytest.raises(cw.ArgumentError, match="expected 24 x 18"):
        cw.backward(two, ones)


def test_all_gradients_of_a_view(two: cw.Scene) -> None:
    """A sensor goes by its own name."""
    gradients = cw.backward(two, np.ones((10, 20, 3)), sensor="left", spp=2)
    assert "left.to_world" in gradients and "box.positions" in gradients
    assert not any(name.startswith("sensor.") for name in gradients)


def test_sensors_change_by_themselves(two: cw.Scene) -> None:
    before = [cw.render(two, sensor=i).value for i in (0, 1)]
    params = cw.traverse(two)
    assert "left.to_world" in params and "sensor_0.to_world" in params
    moved = params["left.to_world"] + np.eye(4)[:, 3] * np.array([[0.3], [0], [0], [0]])
    params.update({"left.to_world": moved})
    assert np.array_equal(cw.render(two, sensor=0).value, before[0])
    assert not np.array_equal(cw.render(two, sensor=1).value, before[1])
    params.update({"floor.bsdf.reflectance.value": [0.1, 0.1, 0.1]})
    assert not np.array_equal(cw.render(two, sensor=0).value, before[0])


def test_a_sensor_called_sensor_is_meant() -> None:
    """Not whichever renders, where one has that name."""
    first, second = '<sensor type="perspective" id="eye">', LEFT.replace('"left"', '"sensor"')
    text = SCENE.replace('<sensor type="perspective">', first).replace("</scene>", second)
    scene = cw.load_string(text)
    for along in ("sensor.translate.x", "box.scale - 2*sensor.translate.x"):
        with pytest.raises(cw.ParameterError, match="is of another sensor; the image of eye"):
            cw.gradient(scene, along)
    with pytest.raises(cw.ParameterError, match="is of another sensor"):
        cw.backward(scene, np.ones((18, 24, 3)), ["box.positions", "sensor.to_world"])
    gradients = cw.backward(scene, np.ones((10, 20, 3)), ["sensor.to_world"], sensor="sensor", spp=2)
    assert gradients["sensor.to_world"].any()
    # Where none has it, whichever renders is.
    scene = cw.load_string(SCENE.replace("</scene>", LEFT))
    for sensor in ("sensor_0", "left"):
        cw.gradient(scene, "sensor.translate.x", sensor=sensor, spp=2)
    with pytest.raises(cw.ParameterError, match="did you mean `sensor.translate"):
        cw.gradient(scene, "sensor.tranlate.x", spp=2)


@pytest.mark.parametrize("aov", ["depth", "position", "uv", "geo_normal", "sh_normal", "albedo"])
def test_aovs(scene: cw.Scene, aov: str) -> None:
    assert cw.render(scene, aov=aov, spp=4).value.any()


def test_masks_have_derivatives(scene: cw.Scene) -> None:
    """Where the box comes into sight, the depth falls and the albedo changes."""
    mask = cw.render(scene, aov="mask", spp=16).value
    assert 0.5 < mask.mean() <= 1.0
    verdict = cw.check(scene, "box.translate.x", aov="albedo", spp=2048)
    assert verdict.right, str(verdict)


def test_scenes_travel(two: cw.Scene) -> None:
    cw.traverse(two).update({"box.positions": two._values("box.positions") * 1.1})
    for other in (pickle.loads(pickle.dumps(two)), copy.copy(two), copy.deepcopy(two)):
        for sensor in (0, "left"):
            original, copied = (cw.render(each, sensor=sensor, spp=4) for each in (two, other))
            assert np.array_equal(original.value, copied.value)
    with pytest.raises(cw.Error, match="damaged: they are too few"):
        cw.Scene.from_bytes(b"?", "two")


def test_the_adjoint_is_independent_by_default(scene: cw.Scene) -> None:
    """The seed of a gradient is not that of the image its adjoint comes from."""
    adjoint = cw.render(scene, spp=4).value
    names = ["floor.bsdf.reflectance.value"]
    by_default = cw.backward(scene, adjoint, names, spp=4)
    same_seed = cw.backward(scene, adjoint, names, spp=4, seed=0)
    assert not np.array_equal(by_default[names[0]], same_seed[names[0]])


def test_memory_layouts(scene: cw.Scene) -> None:
    """Arrays that lie anyhow in memory are taken for what they are."""
    velocities = np.arange(24.0).reshape(8, 3) % 2
    packed = np.zeros(24, dtype=[("flag", "u1"), ("number", "f8")])
    packed["number"] = velocities.ravel()
    same: list[ArrayLike] = [
        velocities,
        np.asfortranarray(velocities),
        velocities.astype(">f8"),
        velocities.astype(np.int8),
        np.repeat(velocities, 2, axis=1)[:, ::2],
        packed["number"][:, None].reshape(8, 3),
        velocities.tolist(),
    ]
    images = [cw.gradient(scene, {"box.positions": v}, spp=4) for v in same]
    for image in images:
        assert np.array_equal(image.gradient, images[0].gradient)

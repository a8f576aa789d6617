"""Images, derivatives and gradients: that they are what the library computes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import capwalk as cw
import numpy as np
import pytest

MIRROR_BALL = """<scene version="3.0.0"><integrator type="path"><integer name="max_depth" value="3"/></integrator>
<sensor type="perspective"><float name="fov" value="20"/>
<transform name="to_world"><lookat origin="0, 0, 4" target="0, 0, 0" up="0, 1, 0"/></transform>
<film type="hdrfilm"><integer name="width" value="12"/><integer name="height" value="9"/>
<rfilter type="box"/></film>
<sampler type="independent"><integer name="sample_count" value="128"/></sampler></sensor>
<shape type="sphere" id="ball"><bsdf type="conductor"/></shape>
<shape type="cube" id="box"><transform name="to_world"><scale value="0.8"/><rotate z="1" angle="20"/>
<translate x="2" y="0.3" z="3"/></transform>
<bsdf type="diffuse"><rgb name="reflectance" value="0.1"/></bsdf></shape>
<emitter type="constant"/></scene>"""
"""A dark box beside the camera, which sees it in a mirror ball only."""


def test_image_is_an_array_with_errors(scene: cw.Scene) -> None:
    image = cw.render(scene, seed=3)
    assert image.value.shape == image.stderr.shape == (18, 24, 3)
    assert np.array_equal(np.asarray(image), image.value)
    assert np.asarray(image, dtype=np.float32).dtype == np.float32
    assert image.statistics["samples"] == 16 * 18 * 24
    # Two images differ by their errors.
    other = cw.render(scene, seed=4, spp=64)
    error = np.hypot(image.stderr, other.stderr)
    lit = error > 0
    z = (image.value - other.value)[lit] / error[lit]
    assert 0.5 < np.mean(z**2) < 2.0


def test_same_bits_for_any_number_of_threads(scene: cw.Scene) -> None:
    one = cw.gradient(scene, "box.translate.x", threads=1)
    four = cw.gradient(scene, "box.translate.x", threads=4)
    assert np.array_equal(one.gradient, four.gradient)
    assert np.array_equal(one.stderr, four.stderr)


def test_gradient_agrees_with_differences(scene: cw.Scene) -> None:
    verdict = cw.check(scene, "box.translate.x", spp=128, reference_spp=4096)
    assert verdict.right, str(verdict)
    assert abs(verdict.scale_factor - 1) < 0.1
    assert verdict.gradient.shape == verdict.reference.shape == (18, 24, 3)
    assert "right: they agree" in str(verdict)


def test_velocities_are_a_direction(scene: cw.Scene) -> None:
    along_x = np.zeros(scene._values("box.positions").shape)
    along_x[:, 0] = 1.0
    one = cw.gradient(scene, "box.translate.x")
    other = cw.gradient(scene, {"box.positions": along_x})
    assert np.array_equal(one.gradient, other.gradient)
    # Two arrays at once add up, and other layouts and types are understood.
    both = cw.gradient(
        scene,
        {
            "box.positions": np.asfortranarray(along_x.astype(np.float32)),
            "floor.bsdf.reflectance.value": [1, 0, 0],
        },
        method="edges",
        spp=64,
    )
    sum_ = cw.gradient(
        scene,
        "box.translate.x + floor.bsdf.reflectance.value.r",
        method="edges",
        spp=64,
    )
    assert np.allclose(both.gradient, sum_.gradient, rtol=1e-9, atol=1e-9)


def test_check_names_shapes_that_lie_on_each_other(scene: cw.Scene) -> None:
    apart = cw.check(scene, "box.translate.y", spp=2)
    assert apart.coplanar == [] and apart.touching == [] and apart.edge_on == []
    assert "note" not in str(apart)
    cw.traverse(scene).update({"box.translate": [0.0, -0.7, 0.0]})
    verdict = cw.check(scene, "box.translate.y", spp=2)
    assert [sorted(pair) for pair in verdict.coplanar] == [["box", "floor"]]
    assert str(verdict).startswith("note: ") and "faces in one plane" in str(verdict)
    assert "note" not in repr(verdict)


def test_forward_is_reverse(scene: cw.Scene) -> None:
    adjoint = np.random.default_rng(1).normal(size=(18, 24, 3))
    names = ["box.positions", "box.translate.x", "box.translate"]
    # With the cutoff given; a pilot may find another one for each.
    derivative = cw.gradient(scene, "box.translate.x", method="walk", max_angle=10.0)
    gradients = cw.backward(scene, adjoint, names, method="walk", max_angle=10.0, seed=0)
    forward = (adjoint * derivative.gradient).sum()
    assert np.isclose(gradients["box.translate.x"], forward, rtol=1e-9)
    assert np.isclose(gradients["box.positions"][:, 0].sum(), forward, rtol=1e-9)
    by_vector = gradients["box.translate"]
    assert by_vector.shape == (3,) and np.isclose(by_vector[0], forward, rtol=1e-9)
    assert np.allclose(by_vector, gradients["box.positions"].sum(axis=0), rtol=1e-9)
    along = cw.gradient(scene, {"box.translate": [1.0, 0.0, 0.0]})
    assert np.array_equal(along.gradient, cw.gradient(scene, "box.translate.x").gradient)
    # Forward mode draws edges by how they move, too: equal within errors.
    derivative = cw.gradient(scene, "box.translate.x", method="edges", spp=256)
    gradients = cw.backward(scene, adjoint, names, method="edges", spp=256, seed=1)
    difference = gradients["box.translate.x"] - (adjoint * derivative.gradient).sum()
    forward_error = np.sqrt(np.square(adjoint * derivative.stderr).sum())
    # Channels of a pixel share their noise: at most sqrt(3) as much.
    error = np.hypot(np.sqrt(3) * forward_error, gradients.stderr["box.translate.x"])
    assert 0 < abs(difference) < 4 * error
    assert gradients.stderr["box.positions"].shape == gradients["box.positions"].shape


def test_motion_seen_in_a_mirror_ball_alone() -> None:
    scene = cw.load_string(MIRROR_BALL)
    derivative = cw.gradient(scene, "box.scale")
    gradients = cw.backward(scene, np.ones((9, 12, 3)), ["box.scale"])
    forward = derivative.gradient.sum()
    forward_error = np.sqrt(np.square(derivative.stderr).sum())
    # Channels of a pixel share their noise: at most sqrt(3) as much.
    error = np.hypot(np.sqrt(3) * forward_error, gradients.stderr["box.scale"])
    # A larger box hides more of the sky.
    assert forward < -4 * error < -abs(gradients["box.scale"] - forward)


def test_grey_adjoints(scene: cw.Scene) -> None:
    grey = np.random.default_rng(2).normal(size=(18, 24))
    names = ["box.translate.x"]
    gradients = [
        cw.backward(scene, adjoint, names, method="edges", spp=2)["box.translate.x"]
        for adjoint in (grey, grey[..., None], np.repeat(grey[..., None], 3, axis=2))
    ]
    assert gradients[0] == gradients[1] == gradients[2] != 0
    with pytest.raises(ValueError, match="for equal channels"):
        cw.backward(scene, np.ones((18, 24, 2)), names)


def test_all_arrays_by_default(scene: cw.Scene) -> None:
    gradients = cw.backward(scene, np.ones((18, 24, 3)), spp=2)
    assert list(gradients) == list(cw.traverse(scene))


def test_previews(scene: cw.Scene, tmp_path: Path) -> None:
    derivative = cw.gradient(scene, "box.translate.x")
    assert derivative._repr_png_().startswith(b"\x89PNG")
    assert cw.render(scene)._repr_png_().startswith(b"\x89PNG")
    for ending in ["exr", "npz", "png"]:
        derivative.save(tmp_path / f"derivative.{ending}")
        assert (tmp_path / f"derivative.{ending}").stat().st_size > 100
    assert (tmp_path / "derivative.png").read_bytes() == derivative._repr_png_()
    saved = np.load(tmp_path / "derivative.npz")
    assert np.allclose(saved["gradient"], derivative.gradient, rtol=1e-6)
    assert {"gradient", "stderr", "value", "value_stderr"} <= set(saved)


def test_previews_can_be_read_in_a_talk(scene: cw.Scene, tmp_path: Path) -> None:
    """Small images are enlarged by a whole factor; a derivative has its image beside it, and a title."""
    image, derivative = cw.render(scene), cw.gradient(scene, "box.rotate.z")
    shown = decoded(image._repr_png_(), tmp_path)
    assert shown.shape == (16 * 18, 16 * 24, 3)
    image.save(tmp_path / "image.png")
    pixels = cw.load_image(tmp_path / "image.png", raw=True)
    np.testing.assert_array_equal(shown, pixels.repeat(16, axis=0).repeat(16, axis=1))
    both = decoded(derivative._repr_png_(), tmp_path)
    assert both.shape[0] > 16 * 18 and both.shape[1] > 2 * 16 * 24
    # The image that comes with it is there, in a frame of one pixel, below the title.
    cw.save_image(tmp_path / "value.png", derivative.value)
    pixels = cw.load_image(tmp_path / "value.png", raw=True).repeat(16, axis=0).repeat(16, axis=1)
    left, top = 12, 32
    np.testing.assert_allclose(both[top : top + 16 * 18, left : left + 16 * 24], pixels, atol=1 / 255)
    # Velocities have no name for a title.
    same = {"box.positions": np.cross([0, 0, 1], cw.traverse(scene)["box.positions"])}
    without = decoded(cw.gradient(scene, same)._repr_png_(), tmp_path)
    assert (both[:top] < 0.5).sum() > (without[:top] < 0.5).sum() > 0


def decoded(png: bytes, folder: Path) -> Any:
    """The pixels of a PNG file, (height, width, 3), 0 to 1."""
    (folder / "shown.png").write_bytes(png)
    return cw.load_image(folder / "shown.png", raw=True)


def test_size_and_defines() -> None:
    from conftest import SCENE

    scene = cw.load_string(SCENE, width=7, spp=3)
    assert list(scene.size) == [7, 18]
    assert cw.render(scene).statistics["samples"] == 3 * 7 * 18
    scene.resize(5, 4)
    assert cw.render(scene).value.shape == (4, 5, 3)


def test_pictures_in_files(scene: cw.Scene, tmp_path: Path) -> None:
    derivative = cw.gradient(scene, "box.rotate.y", spp=4)
    for limit, shown in [(None, False), (0.125, True)]:
        derivative.save(tmp_path / "picture.svg", limit=limit)
        text = (tmp_path / "picture.svg").read_text()
        assert ">gradient per radian of box.rotate.y<" in text
        assert (">0.125<" in text) == shown
    with pytest.raises(cw.ImageError, match="limit of its colours is 0"):
        derivative.save(tmp_path / "picture.svg", limit=0.0)

"""capwalk inside Mitsuba 3: its images, and how scenes are converted."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import capwalk as cw
import numpy as np
import pytest

mi = pytest.importorskip("mitsuba")
import capwalk.mitsuba  # noqa: E402  It needs Mitsuba.
from capwalk.mitsuba._convert import convert  # noqa: E402
from mitsuba_scenes import (  # noqa: E402
    SCALAR,
    SCENES,
    Description,
    of,
    on_square,
    random,
    scene,
    sensor,
    tilted_normals,
    turned,
)


@pytest.fixture(autouse=True)
def quiet() -> Iterator[None]:
    mi.set_variant(SCALAR)
    mi.set_log_level(mi.LogLevel.Error)
    yield
    mi.set_variant(SCALAR)


def images(loaded: Any, integrator: Any, spp: int, seeds: int, **more: Any) -> Any:
    """Independent images, (seeds, height, width, channels)."""
    return np.stack(
        [
            np.asarray(mi.render(loaded, integrator=integrator, seed=seed, spp=spp, **more))
            for seed in range(1, seeds + 1)
        ]
    ).astype(np.float64)


@pytest.mark.parametrize("name", SCENES)
def test_images_are_those_of_path(name: str) -> None:
    loaded = mi.load_dict(SCENES[name]())
    theirs, ours = (
        images(loaded, mi.load_dict({"type": kind, "max_depth": 4}), spp, 8)
        for kind, spp in (("path", 64), ("capwalk", 16))
    )
    assert theirs.shape == ours.shape
    # Means of blocks, whose noise is normal.
    count, height, width, channels = theirs.shape
    blocks = [
        each.reshape(count, height // 3, 3, width // 4, 4, channels).mean((2, 4))
        for each in (theirs, ours)
    ]
    variance = sum(block.var(0, ddof=1) for block in blocks) / count
    difference = blocks[0].mean(0) - blocks[1].mean(0)
    # Rounding, where there is no noise.
    z = difference / np.sqrt(variance + (1e-4 * blocks[0].mean()) ** 2)
    # Student's distribution with 14 degrees of freedom: 7/6 on average.
    assert np.mean(z**2) < 2.0, f"mean z² {np.mean(z**2):.2f}"
    assert np.abs(z).max() < 6.5, f"largest z {np.abs(z).max():.1f}"


@pytest.mark.parametrize("plugin", ["normalmap", "bumpmap"])
@pytest.mark.parametrize("inside", ["diffuse", "roughconductor", "conductor"])
@pytest.mark.parametrize("flips", [True, False])
@pytest.mark.parametrize("shadows", [True, False])
def test_flags_are_found_out(plugin: str, inside: str, flips: bool, shadows: bool) -> None:
    """Mitsuba does not tell how it treats the normals of maps."""
    pixels = tilted_normals() if plugin == "normalmap" else 0.3 * random(4, 4, 1)
    image = {"type": "bitmap", "raw": True, "bitmap": mi.Bitmap(pixels)}
    flags = {"flip_invalid_normals": flips, "use_shadowing_function": shadows}
    material = {"type": plugin, "normalmap": image, "inside": {"type": inside}, **flags}
    loaded = mi.load_dict(on_square(material))
    described = convert(loaded, loaded.sensors(), {"type": "path"}).description
    shapes = [part for key, part in described.items() if key.startswith("shape")]
    found = [shape["bsdf"] for shape in shapes if shape["id"] == "ball"]
    assert {key: found[0][key] for key in flags} == flags


@pytest.mark.parametrize("name", SCENES)
def test_numbers_are_those_of_mitsuba(name: str) -> None:
    """All that may change are parameters of ours, with the same values."""
    loaded = mi.load_dict(SCENES[name]())
    converted = convert(loaded, loaded.sensors(), {"type": "path"})
    ours = cw.traverse(cw.load_dict(converted.plain()))
    assert len(converted.numbers) > 5
    assert [number.name for number in converted.numbers if number.name not in ours] == []
    for number in converted.numbers:
        assert np.allclose(ours[number.name], number.value, atol=1e-6), number.name


def test_refractive_indices_are_ratios() -> None:
    loaded = mi.load_dict(of(type="plastic", int_ior=1.6, ext_ior=1.2))
    ours = cw.traverse(capwalk.mitsuba.to_capwalk(loaded))
    assert ours["ball.bsdf.int_ior.value"][0] == pytest.approx(1.6 / 1.2, rel=1e-6)
    assert ours["ball.bsdf.ext_ior.value"][0] == 1.0
    assert ours["sensor.x_fov"][0] == pytest.approx(40, rel=1e-6)


FILM = {"type": "hdrfilm", "width": 4, "height": 3}


@pytest.mark.parametrize(
    ("parts", "message"),
    [
        ({"ball": {"type": "cylinder"}}, "^ball: Mitsuba's Cylinder cannot be converted; expected"),
        (
            {"ball": {"type": "sphere", "bsdf": {"type": "principledthin"}}},
            "^ball.bsdf: Mitsuba's PrincipledThin cannot be converted; expected one of blendbsdf",
        ),
        (
            {
                "ball": {
                    "type": "sphere",
                    "bsdf": {"type": "dielectric"},
                    "interior": {"type": "homogeneous"},
                }
            },
            "^ball: Mitsuba's HomogeneousMedium cannot be converted; media are not rendered",
        ),
        (
            {"sky": {"type": "constant", "sampling_weight": 0.0}},
            "^sky: Mitsuba's ConstantBackgroundEmitter cannot be converted; its sampling_weight",
        ),
        ({"sun": {"type": "projector"}}, "^sun: Mitsuba's Projector cannot be converted"),
        (
            {"sensor": {"type": "perspective", "film": {**FILM, "rfilter": {"type": "mitchell"}}}},
            "^sensor.film: Mitsuba's MitchellNetravaliFilter cannot be converted",
        ),
        (
            {"sensor": {"type": "perspective", "film": {**FILM, "pixel_format": "rgba"}}},
            "^sensor.film: Mitsuba's pixel_format rgba cannot be converted; expected rgb",
        ),
        (
            {"sensor": {"type": "radiancemeter", "film": {**FILM, "width": 1, "height": 1}}},
            "^sensor: Mitsuba's RadianceMeter cannot be converted; expected one of orthographic",
        ),
    ],
)
def test_what_is_not_converted_is_refused_by_name(parts: Description, message: str) -> None:
    loaded = mi.load_dict(scene(**parts))
    with pytest.raises(cw.LoadError, match=message):
        mi.render(loaded, integrator=mi.load_dict({"type": "capwalk"}), spp=1)


def test_options() -> None:
    loaded = mi.load_dict(scene())
    direct = mi.load_dict({"type": "capwalk", "integrator": "direct", "threads": 1})
    deep = mi.load_dict({"type": "capwalk", "max_depth": 2})
    one, two = (images(loaded, each, 64, 4).mean() for each in (direct, deep))
    assert one == pytest.approx(two, rel=0.02)
    hidden = mi.load_dict({"type": "capwalk", "hide_emitters": True})
    seen = mi.load_dict(
        scene(lamp={**scene()["lamp"], "to_world": turned(("translate", [0, 1, 2]))})
    )
    assert images(seen, deep, 16, 1)[0, 8, 12, 0] > 9
    assert images(seen, hidden, 16, 1)[0, 8, 12, 0] < 1
    with pytest.raises(RuntimeError, match='expected "path" or "direct"'):
        mi.load_dict({"type": "capwalk", "integrator": "volpath"})
    with pytest.raises(RuntimeError, match="depth"):
        mi.load_dict({"type": "capwalk", "depth": 2})
    assert "max_depth" in str(deep)


def test_samples_and_seeds() -> None:
    loaded = mi.load_dict(scene())
    ours = mi.load_dict({"type": "capwalk"})
    as_written, sixteen, other = (
        np.asarray(mi.render(loaded, integrator=ours, spp=spp, seed=seed))
        for spp, seed in ((0, 3), (16, 3), (16, 4))
    )
    assert np.array_equal(as_written, sixteen)
    assert not np.array_equal(sixteen, other)


def test_several_sensors() -> None:
    """In the scene, also beside one that cannot be converted, and from elsewhere."""
    small = sensor(film={"type": "hdrfilm", "width": 5, "height": 4}, fov=20)
    meter = {"type": "radiancemeter", "film": {"type": "hdrfilm", "width": 1, "height": 1}}
    loaded = mi.load_dict(scene(second=meter, third=small))
    ours = mi.load_dict({"type": "capwalk"})
    shapes = [mi.render(loaded, integrator=ours, sensor=i, spp=1).shape for i in (0, 2)]
    assert [tuple(shape) for shape in shapes] == [(18, 24, 3), (4, 5, 3)]
    separate = mi.load_dict(small)
    inside, outside = (
        np.asarray(mi.render(loaded, integrator=ours, sensor=each, spp=4))
        for each in (2, separate)
    )
    assert np.array_equal(inside, outside)


def changes(params: Any) -> Iterator[None]:
    """Changes a scene step by step."""
    params["floor.bsdf.reflectance.value"] = mi.Color3f(0.1, 0.9, 0.2)
    yield
    params["ball.bsdf.reflectance.value"] = 0.9
    params["lamp.emitter.radiance.value"] = mi.Color3f(3, 4, 5)
    yield
    params["ball.to_world"] = mi.Transform4f().translate([0.5, 0, 0]) @ params["ball.to_world"]
    yield
    params["sensor.x_fov"] = 50.0
    params["sensor.to_world"] = mi.Transform4f().look_at([1, 3, 6], [0, 0.6, 0], [0, 1, 0])
    yield
    params["sensor.film.crop_size"] = mi.ScalarVector2u(12, 9)
    yield
    params["mesh.vertex_positions"] = np.asarray(params["mesh.vertex_positions"]) + np.float32(0.2)
    yield
    faces = np.asarray(params["mesh.faces"]).copy()
    # Without its top.
    faces[6:12] = faces[:6]
    params["mesh.faces"] = faces
    yield


def test_changes_of_the_scene_are_seen() -> None:
    corner = {"type": "cube", "to_world": turned(("translate", [-1, 1, 0]), ("scale", 0.4))}
    loaded = mi.load_dict(scene(mesh=corner))
    ours = mi.load_dict({"type": "capwalk"})
    before = np.asarray(mi.render(loaded, integrator=ours, spp=4))
    params = mi.traverse(loaded)
    for _ in changes(params):
        params.update()
        now, anew = (
            np.asarray(mi.render(loaded, integrator=each, spp=4))
            for each in (ours, mi.load_dict({"type": "capwalk"}))
        )
        assert now.shape != before.shape or not np.array_equal(now, before)
        assert np.allclose(now, anew, rtol=1e-4, atol=1e-5)
        before = now


def test_numbers_change_without_building(monkeypatch: pytest.MonkeyPatch) -> None:
    loaded = mi.load_dict(scene())
    ours = mi.load_dict({"type": "capwalk"})
    mi.render(loaded, integrator=ours, spp=1)
    monkeypatch.setattr("capwalk.mitsuba._integrator.load_dict", None)
    params = mi.traverse(loaded)
    for step in changes(params):
        assert step is None
        params.update()
        mi.render(loaded, integrator=ours, spp=1)
        if params["sensor.x_fov"] == 50.0:
            break


def test_parameters_have_mitsubas_names() -> None:
    loaded = mi.load_dict(scene(mesh={"type": "cube"}))
    ours = cw.traverse(capwalk.mitsuba.to_capwalk(loaded))
    theirs = [
        key
        for key in mi.traverse(loaded).keys()
        if key.endswith(("reflectance.value", "radiance.value", "to_world", "vertex_positions"))
    ]
    assert len(theirs) > 8
    assert [key for key in theirs if key not in ours] == []


def test_variants() -> None:
    """The integrator is known in all variants with colours, in whatever order they are used."""
    for variant in (SCALAR, "scalar_spectral", SCALAR):
        mi.set_variant(variant)
        if variant.endswith("_rgb"):
            assert "Capwalk" in str(mi.load_dict({"type": "capwalk"}))
        else:
            with pytest.raises(RuntimeError, match="capwalk"):
                mi.load_dict({"type": "capwalk"})

"""capwalk inside Mitsuba 3, against Mitsuba's own images and their differences."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import capwalk as cw
import numpy as np
import pytest

mi = pytest.importorskip("mitsuba")
dr = pytest.importorskip("drjit")
import capwalk.mitsuba  # noqa: E402  It needs Mitsuba.
from capwalk.mitsuba._convert import convert  # noqa: E402

SCALAR, VECTORIZED = "scalar_rgb", "llvm_ad_rgb"
Description = dict[str, Any]


def has_llvm() -> bool:
    try:
        mi.set_variant(VECTORIZED)
        dr.eval(mi.Float(1.0) + 1.0)
    except (ImportError, RuntimeError):
        return False
    return True


needs_llvm = pytest.mark.skipif(not has_llvm(), reason="LLVM is not installed")


@pytest.fixture(autouse=True)
def quiet() -> Iterator[None]:
    mi.set_variant(SCALAR)
    mi.set_log_level(mi.LogLevel.Error)
    yield
    mi.set_variant(SCALAR)


def turned(*steps: Any) -> Any:
    transform = mi.ScalarTransform4f()
    for step, *arguments in steps:
        transform = getattr(transform, step)(*arguments)
    return transform


def sensor(**parts: Any) -> Description:
    film = {"type": "hdrfilm", "width": 24, "height": 18, "rfilter": {"type": "box"}}
    view = turned(("look_at", [0, 3, 6], [0, 0.5, 0], [0, 1, 0]))
    own = {} if parts.get("type") == "orthographic" else {"fov": 40}
    sampler = {"type": "independent", "sample_count": 16}
    return {
        "type": "perspective",
        "to_world": view,
        "film": film,
        "sampler": sampler,
        **own,
        **parts,
    }


def scene(**parts: Any) -> Description:
    """A ball over a floor under a lamp, with these parts in place of others or beside them."""
    whole = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 4},
        "sensor": sensor(),
        "floor": {
            "type": "rectangle",
            "to_world": turned(("rotate", [1, 0, 0], -90), ("scale", 4)),
            "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.7, 0.5, 0.3]}},
        },
        "ball": {"type": "sphere", "center": [0.3, 1, 0], "radius": 0.8},
        "lamp": {
            "type": "rectangle",
            "to_world": turned(("translate", [0, 5, 0]), ("rotate", [1, 0, 0], 90)),
            "emitter": {"type": "area", "radiance": {"type": "rgb", "value": [10, 9, 8]}},
        },
        **parts,
    }
    return {key: part for key, part in whole.items() if part is not None}


SKY = {"sky": {"type": "constant", "radiance": {"type": "rgb", "value": [0.3, 0.4, 0.5]}}}


def of(**bsdf: Any) -> Description:
    """The scene with a ball of a material, under a sky."""
    return scene(ball={"type": "sphere", "center": [0.3, 1, 0], "radius": 0.8, "bsdf": bsdf}, **SKY)


def on_square(bsdf: Any, **shape: Any) -> Description:
    """The scene with a tilted square of a material."""
    tilted = turned(("translate", [0, 1, 0]), ("rotate", [1, 0, 0], -30), ("scale", 1.5))
    return scene(ball={"type": "rectangle", "to_world": tilted, "bsdf": bsdf, **shape}, **SKY)


def texture(**image: Any) -> Description:
    return on_square({"type": "diffuse", "reflectance": {"type": "bitmap", **image}})


def random(*shape: int) -> Any:
    return np.random.default_rng(7).random(shape).astype(np.float32)


def tilted_normals() -> Any:
    return random(4, 4, 3) * np.float32([0.8, 0.8, 0.0]) + np.float32([0.1, 0.1, 0.75])


TWO_SIDES = {
    "type": "twosided",
    "front": {"type": "diffuse", "reflectance": 0.8},
    "back": {"type": "diffuse", "reflectance": 0.1},
}


def smooth_mesh() -> Any:
    """A mesh with normals of its own, and attributes."""
    angles = np.meshgrid(np.linspace(0.1, 3.0, 9), np.linspace(0, 2 * np.pi, 13))
    theta, phi = (angle.ravel() for angle in angles)
    normals = np.stack([np.sin(theta) * np.cos(phi), np.cos(theta), np.sin(theta) * np.sin(phi)], 1)
    corner = (np.arange(12)[:, None] * 9 + np.arange(8)).ravel()
    faces = np.stack([corner, corner + 9, corner + 1, corner + 1, corner + 9, corner + 10], 1)
    props = mi.Properties()
    props["bsdf"] = mi.load_dict(
        {"type": "diffuse", "reflectance": {"type": "mesh_attribute", "name": "vertex_color"}}
    )
    mesh = mi.Mesh("mesh", len(normals), faces.size // 3, props, has_vertex_normals=True)
    params = mi.traverse(mesh)
    params["vertex_positions"] = (0.8 * normals + [0.3, 1, 0]).ravel()
    params["faces"] = faces.ravel().astype(np.uint32)
    params.update()
    params["vertex_normals"] = normals.ravel()
    params.update()
    mesh.add_attribute("vertex_color", 3, random(len(normals) * 3))
    return scene(ball=mesh)


SCENES: dict[str, Callable[[], Description]] = {
    "sphere": scene,
    "cube": lambda: scene(
        ball={
            "type": "cube",
            "to_world": turned(("translate", [0, 1, 0]), ("rotate", [0, 1, 0], 30)),
        }
    ),
    "disk from behind": lambda: scene(
        ball={
            "type": "disk",
            "to_world": turned(("translate", [0, 1, 0]), ("rotate", [1, 0, 0], -40)),
            "flip_normals": True,
            "bsdf": TWO_SIDES,
        }
    ),
    "rectangle from behind": lambda: on_square(TWO_SIDES, flip_normals=True),
    "sphere from inside": lambda: scene(
        ball={"type": "sphere", "center": [0, 1, 0], "flip_normals": True, "bsdf": TWO_SIDES}
    ),
    "mirrored sphere": lambda: scene(
        ball={
            "type": "sphere",
            "to_world": turned(("translate", [0, 1, 0]), ("scale", [-1, 1, 1])),
            "bsdf": TWO_SIDES,
        }
    ),
    "mesh with normals": smooth_mesh,
    "gold": lambda: of(type="conductor", material="Au"),
    "rough metal": lambda: of(
        type="roughconductor",
        alpha_u=0.2,
        alpha_v=0.5,
        distribution="ggx",
        specular_reflectance=0.8,
    ),
    "glass": lambda: of(type="dielectric", int_ior=1.6),
    "rough glass": lambda: of(type="roughdielectric", alpha=0.3, distribution="ggx"),
    "thin glass": lambda: of(type="thindielectric"),
    "plastic": lambda: of(type="plastic", nonlinear=True, diffuse_reflectance=0.7),
    "rough plastic": lambda: of(type="roughplastic", alpha=0.2, diffuse_reflectance=0.7),
    "principled": lambda: of(
        type="principled",
        base_color={"type": "rgb", "value": [0.1, 0.4, 0.8]},
        metallic=0.4,
        roughness=0.4,
        clearcoat=0.5,
        sheen=0.3,
        eta=1.7,
    ),
    "mask": lambda: of(type="mask", opacity=0.4, inner={"type": "diffuse"}),
    "blend": lambda: of(
        type="blendbsdf",
        weight=0.3,
        first={"type": "diffuse"},
        second={"type": "roughconductor", "alpha": 0.3},
    ),
    "normal map": lambda: on_square(
        {
            "type": "normalmap",
            "normalmap": {
                "type": "bitmap",
                "raw": True,
                "bitmap": mi.Bitmap(tilted_normals()),
            },
            "use_shadowing_function": False,
            "inner": {"type": "diffuse"},
        }
    ),
    "bitmap, mirrored": lambda: texture(
        bitmap=mi.Bitmap(random(4, 5, 3)),
        to_uv=turned(("scale", [2, 3, 1]), ("translate", [0.1, 0.2, 0])),
        filter_type="nearest",
        wrap_mode="mirror",
    ),
    "bitmap, clamped": lambda: texture(
        bitmap=mi.Bitmap(random(4, 5, 3)),
        to_uv=turned(("scale", [2, 3, 1]), ("translate", [-0.1, -0.2, 0])),
        wrap_mode="clamp",
    ),
    "bitmap of bytes": lambda: texture(bitmap=mi.Bitmap((random(4, 5, 3) * 255).astype(np.uint8))),
    "checkerboard": lambda: on_square(
        {
            "type": "diffuse",
            "reflectance": {
                "type": "checkerboard",
                "to_uv": turned(("scale", [3, 2, 1])),
                "color0": {"type": "rgb", "value": [0.9, 0.1, 0.1]},
            },
        }
    ),
    "environment": lambda: scene(
        lamp=None,
        sky={
            "type": "envmap",
            "bitmap": mi.Bitmap(random(8, 16, 3)),
            "scale": 2.0,
            "to_world": turned(("rotate", [0, 1, 0], 70)),
        },
    ),
    "point": lambda: scene(
        lamp=None, point={"type": "point", "position": [1, 3, 1], "intensity": 20.0}
    ),
    "spot": lambda: scene(
        lamp=None,
        spot={
            "type": "spot",
            "to_world": turned(("look_at", [1, 4, 1], [0, 0, 0], [1, 0, 0])),
            "intensity": 60.0,
            "cutoff_angle": 30,
        },
    ),
    "directional": lambda: scene(
        lamp=None, sun={"type": "directional", "direction": [1, -3, 1], "irradiance": 2.0}
    ),
    "lens": lambda: scene(
        sensor=sensor(type="thinlens", aperture_radius=0.4, focus_distance=6.0, fov_axis="y")
    ),
    "orthographic": lambda: scene(
        sensor=sensor(
            type="orthographic",
            to_world=turned(("look_at", [0, 3, 6], [0, 0.5, 0], [0, 1, 0]), ("scale", 3)),
        )
    ),
    "film": lambda: scene(
        sensor=sensor(
            fov_axis="diagonal",
            principal_point_offset_x=0.1,
            film={
                "type": "hdrfilm",
                "width": 30,
                "height": 24,
                "crop_offset_x": 3,
                "crop_offset_y": 4,
                "crop_width": 24,
                "crop_height": 18,
                "sample_border": True,
                "pixel_format": "luminance",
                "rfilter": {"type": "gaussian", "stddev": 0.6},
            },
        )
    ),
}


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
    elsewhere = mi.load_dict(small)
    inside, outside = (
        np.asarray(mi.render(loaded, integrator=ours, sensor=each, spp=4))
        for each in (2, elsewhere)
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
    "lamp": (scene, shift("lamp.to_world", 1, 0, 0.5), 0.1, 2048, 32),
    "normals": (smooth_mesh, bend("ball.vertex_positions"), 0.05, 2048, 32),
}


# Curved shapes have many triangles, and take their time.
CASES = [(name, mode) for name in MOVES for mode in ("reverse", "forward")]
CASES = [case for case in CASES if case not in (("sphere", "forward"), ("lamp", "reverse"))]


@needs_llvm
@pytest.mark.parametrize(("name", "mode"), CASES)
def test_derivatives_are_those_of_mitsubas_images(name: str, mode: str) -> None:
    mi.set_variant(VECTORIZED)
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


@needs_llvm
def test_image_and_gradient_have_different_seeds(monkeypatch: pytest.MonkeyPatch) -> None:
    mi.set_variant(VECTORIZED)
    import capwalk.mitsuba._integrator as integrator

    used: list[int] = []

    def watched(function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any, **options: Any) -> Any:
            used.append(options["seed"])
            return function(*arguments, **options)

        return call

    for name in ("render", "backward"):
        monkeypatch.setattr(integrator, name, watched(getattr(integrator, name)))
    loaded = mi.load_dict(scene())
    params = mi.traverse(loaded)
    dr.enable_grad(params["floor.bsdf.reflectance.value"])
    ours = mi.load_dict({"type": "capwalk"})
    dr.backward(dr.mean(mi.render(loaded, params, integrator=ours, spp=1, seed=5)))
    assert len(used) == 2 and used[0] == 5 and used[1] != 5


@needs_llvm
def test_parameters_without_derivatives_are_refused() -> None:
    mi.set_variant(VECTORIZED)
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


@needs_llvm
def test_a_colour_and_a_place_are_recovered() -> None:
    """A script as for Mitsuba's own integrators, but for the integrator's name."""
    mi.set_variant(VECTORIZED)
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

"""Scenes as dictionaries: the same as scene files, with places in messages."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import capwalk as cw
import numpy as np
import pytest

VIEW = cw.Transform().look_at(origin=[0, 3, 6], target=[0, 0.5, 0], up=[0, 1, 0])


def scene(**parts: object) -> dict[str, Any]:
    """A floor under an emitter, with these parts in place of others or beside them."""
    return {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 3},
        "sensor": {
            "type": "perspective",
            "fov": 40,
            "to_world": VIEW,
            "film": {"type": "hdrfilm", "width": 12, "height": 9, "rfilter": {"type": "box"}},
            "sampler": {"type": "independent", "sample_count": 8},
        },
        "floor": {
            "type": "rectangle",
            "to_world": cw.Transform().rotate([1, 0, 0], -90).scale(4),
            "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.7, 0.5, 0.3]}},
        },
        "lamp": {
            "type": "rectangle",
            "to_world": cw.Transform().translate([0, 5, 0]).rotate([1, 0, 0], 90),
            "emitter": {"type": "area", "radiance": {"type": "rgb", "value": 10.0}},
        },
        **parts,
    }


def xml(extra: str) -> str:
    """The same as a text."""

    def matrix(transform: cw.Transform) -> str:
        numbers = " ".join(map(repr, transform.matrix.ravel().tolist()))
        return f'<transform name="to_world"><matrix value="{numbers}"/></transform>'

    floor = cw.Transform().rotate([1, 0, 0], -90).scale(4)
    emitter = cw.Transform().translate([0, 5, 0]).rotate([1, 0, 0], 90)
    return f"""<scene version="3.0.0">
    <integrator type="path"><integer name="max_depth" value="3"/></integrator>
    <sensor type="perspective" id="sensor"><float name="fov" value="40"/>{matrix(VIEW)}
        <film type="hdrfilm"><integer name="width" value="12"/><integer name="height" value="9"/>
            <rfilter type="box"/></film>
        <sampler type="independent"><integer name="sample_count" value="8"/></sampler></sensor>
    <shape type="rectangle" id="floor">{matrix(floor)}
        <bsdf type="diffuse"><rgb name="reflectance" value="0.7, 0.5, 0.3"/></bsdf></shape>
    <shape type="rectangle" id="lamp">{matrix(emitter)}
        <emitter type="area"><rgb name="radiance" value="10"/></emitter></shape>
    {extra}</scene>"""


def same(one: cw.Scene, other: cw.Scene) -> bool:
    """True if two scenes have the same arrays, and images that agree to the bit."""
    names = list(cw.traverse(one))
    assert names == list(cw.traverse(other))
    assert cw.render(one).value.max() > 0
    return np.array_equal(cw.render(one).value, cw.render(other).value)


def test_a_dictionary_is_a_scene_file() -> None:
    """Materials by name and by path, textures, numbers of all kinds, options of shapes."""
    parts = scene(
        paint={
            "type": "twosided",
            "inner": {
                "type": "roughconductor",
                "alpha": np.float32(0.25),
                "distribution": "ggx",
                "specular_reflectance": {"type": "spectrum", "value": 0.5},
            },
        },
        ball={
            "type": "sphere",
            "center": np.array([0.5, 1, 0]),
            "radius": np.int64(1),
            "flip_normals": False,
            "any_name": {"type": "ref", "id": "paint"},
        },
        box={
            "type": "cube",
            "id": "the box",
            "to_world": (cw.Transform().translate([-1, 1, 0]).scale([0.5, 0.5, 0.25])).matrix,
            "bsdf": {
                "type": "diffuse",
                "reflectance": {
                    "type": "checkerboard",
                    "to_uv": cw.Transform().scale([4, 2, 1]),
                    "color0": 0.8,
                },
            },
        },
        other={"type": "disk", "bsdf": {"type": "ref", "id": "box.bsdf"}},
        sky={"type": "constant", "radiance": {"type": "rgb", "value": (0.1, 0.2, 0.3)}},
    )
    text = xml("""
    <bsdf type="twosided" id="paint"><bsdf type="roughconductor">
        <float name="alpha" value="0.25"/><string name="distribution" value="ggx"/>
        <spectrum name="specular_reflectance" value="0.5"/></bsdf></bsdf>
    <shape type="sphere" id="ball"><point name="center" value="0.5, 1, 0"/><ref id="paint"/></shape>
    <shape type="cube" id="the box">
        <transform name="to_world">
            <scale value="0.5, 0.5, 0.25"/><translate x="-1" y="1"/></transform>
        <bsdf type="diffuse" id="box.bsdf"><texture name="reflectance" type="checkerboard">
            <transform name="to_uv"><scale x="4" y="2"/></transform>
            <float name="color0" value="0.8"/></texture></bsdf></shape>
    <shape type="disk" id="other"><ref id="box.bsdf"/></shape>
    <emitter type="constant" id="sky"><rgb name="radiance" value="0.1, 0.2, 0.3"/></emitter>""")
    assert same(cw.load_dict(parts), cw.load_string(text))


def test_meshes_are_arrays() -> None:
    generator = np.random.default_rng(0)
    positions = np.array([[-1, 1, -1], [1, 1.1, -1], [1, 1, 1], [-1, 1.2, 1]])
    mesh: dict[str, Any] = {
        "type": "mesh",
        "positions": positions,
        "faces": [[0, 2, 1], [0, 3, 2]],
        "uvs": positions[:, ::2],
        "vertex_color": generator.random((4, 3)),
        "vertex_gloss": generator.random((4, 1)),
        "face_paint_color": generator.random((2, 3)),
    }
    painted = {"type": "mesh_attribute", "name": "vertex_color"}
    loaded = cw.load_dict(scene(roof={**mesh, "bsdf": {"type": "diffuse", "reflectance": painted}}))
    assert np.array_equal(cw.traverse(loaded)["roof.positions"], positions)
    for name in ("vertex_color", "vertex_gloss", "face_paint_color"):
        assert np.array_equal(cw.traverse(loaded)[f"roof.{name}"], mesh[name]), name
    # Normals are those that are given, those of the faces, or made of these.
    tilted = np.array([[0.6, 0.8, 0.0]] * 4)
    given = cw.load_dict(scene(roof={**mesh, "normals": tilted}))
    assert np.array_equal(cw.traverse(given)["roof.normals"], tilted)
    images = [cw.render(given).value]
    for flat in (False, True):
        shaped = cw.load_dict(scene(roof={**mesh, "face_normals": flat}))
        assert "roof.normals" not in cw.traverse(shaped)
        images.append(cw.render(shaped).value)
    assert not any(np.array_equal(a, b) for a, b in zip(images, images[1:]))


def test_bitmaps_are_arrays() -> None:
    pixels = np.random.default_rng(1).integers(0, 256, (3, 4, 3), dtype=np.uint8)

    def texels(**image: object) -> Any:
        paint = {"type": "diffuse", "reflectance": {"type": "bitmap", **image}}
        loaded = cw.load_dict(scene(roof={"type": "rectangle", "bsdf": paint}))
        return cw.traverse(loaded)["roof.bsdf.reflectance.data"]

    linear = pixels / 255.0
    decoded = np.where(linear <= 0.04045, linear / 12.92, ((linear + 0.055) / 1.055) ** 2.4)
    assert np.allclose(texels(bitmap=pixels), decoded, atol=1e-7)
    assert np.allclose(texels(bitmap=pixels, raw=True), linear, atol=1e-7)
    assert np.allclose(texels(bitmap=linear), linear, atol=1e-7)
    assert np.allclose(texels(data=linear), linear, atol=1e-7)
    # Opacity is left out, grey is three times the same.
    assert np.allclose(texels(bitmap=np.dstack([linear, linear[..., 0]])), linear, atol=1e-7)
    assert np.allclose(texels(data=linear[..., 0]), linear[..., :1], atol=1e-7)
    sky = {"type": "envmap", "bitmap": linear, "scale": 2.0}
    assert np.allclose(cw.traverse(cw.load_dict(scene(sky=sky)))["sky.data"], linear, atol=1e-7)


def test_files_are_found(tmp_path: Path) -> None:
    cw.render(cw.load_dict(scene()), spp=1).save(tmp_path / "a $image & more.exr")
    texture = {"type": "bitmap", "filename": "a $image & more.exr"}
    paint = {"type": "diffuse", "reflectance": texture}
    parts = scene(roof={"type": "rectangle", "bsdf": paint})
    one = cw.load_dict(parts, folder=tmp_path)
    texture["filename"] = tmp_path / "a $image & more.exr"  # type: ignore[assignment]
    other = cw.load_dict({"resources": {"type": "resources", "path": str(tmp_path)}, **parts})
    assert same(one, other)


SAMPLED = [(400, 0.1), (700, 0.5)]


@pytest.mark.parametrize(
    "spectrum",
    [
        {"type": "spectrum", "value": SAMPLED},
        {"type": "spectrum", "value": np.array(SAMPLED)},
        {"type": "irregular", "wavelengths": "400, 700", "values": "0.1, 0.5"},
        {"type": "irregular", "value": {"type": "spectrum", "value": SAMPLED}},
        {"type": "regular", "wavelength_min": 400, "wavelength_max": 700.0, "values": "0.1, 0.5"},
        {"type": "srgb", "color": {"type": "rgb", "value": [0.421193, 0.290558, 0.153908]}},
        {"type": "srgb", "color": [0.421193, 0.290558, 0.153908]},
        {"type": "rawconstant", "value": np.array([0.421193, 0.290558, 0.153908])},
    ],
)
def test_spectra_are_colours(spectrum: dict[str, Any]) -> None:
    """That of Mitsuba for each of them."""
    loaded = cw.load_dict(scene(paint={"type": "diffuse", "reflectance": spectrum}))
    colour = cw.traverse(loaded)["paint.reflectance.value"]
    assert np.allclose(colour, [0.421193, 0.290558, 0.153908], atol=1e-6)


def test_spectra_of_light_and_of_files(tmp_path: Path) -> None:
    (tmp_path / "light.spd").write_text("# nm, value\n400 0.1\n700 0.5\n")
    spectra: dict[str, dict[str, Any]] = {
        "file": {"type": "spectrum", "filename": "light.spd"},
        "values": {"type": "spectrum", "value": SAMPLED},
        "flat": {"type": "spectrum", "value": 2.0},
        "day": {"type": "d65", "scale": 2.0},
        "hot": {"type": "blackbody", "temperature": 3000.0},
    }
    for key, radiance in spectra.items():
        spectra[key] = {"type": "rectangle", "emitter": {"type": "area", "radiance": radiance}}
    arrays = cw.traverse(cw.load_dict(scene(**spectra), folder=tmp_path))
    colours = {key: arrays[f"{key}.emitter.radiance.value"] for key in spectra}
    assert np.allclose(colours["file"], colours["values"])
    assert np.allclose(colours["flat"], 2 * np.array([1.2048, 0.9483, 0.9089]), atol=1e-3)
    assert np.allclose(colours["day"], 2)
    assert colours["hot"][0] > colours["hot"][1] > colours["hot"][2] > 0


def test_colours_that_srgb_lacks_warn() -> None:
    """As in Mitsuba, which clamps them."""
    bright = {"type": "spectrum", "value": [(400, 1), (700, 2)]}
    with pytest.warns(cw.SceneWarning, match=r'\["reflectance"\]: .*a colour that sRGB lacks'):
        loaded = cw.load_dict(scene(paint={"type": "diffuse", "reflectance": bright}))
    assert np.array_equal(cw.traverse(loaded)["paint.reflectance.value"], [1, 1, 1])


def test_several_sensors() -> None:
    parts = scene()
    film = {**parts["sensor"]["film"], "width": 5}
    parts["other"] = {**parts["sensor"], "fov": 60.0, "film": film}
    loaded = cw.load_dict(parts)
    assert cw.render(loaded, spp=1).value.shape == (9, 12, 3)
    assert cw.render(loaded, sensor="other", spp=1).value.shape == (9, 5, 3)


def test_warnings_have_places() -> None:
    parts = scene()
    parts["sensor"]["focus_distance"] = 3.0
    with pytest.warns(cw.SceneWarning, match=r'^dictionary\["sensor"\]\["focus_distance"\]: '):
        cw.load_dict(parts)


BALL: dict[str, Any] = {"type": "sphere"}
MESH: dict[str, Any] = {"type": "mesh", "positions": np.eye(3), "faces": [[0, 1, 2]]}


class _Plugin:
    """An object as Mitsuba loads it."""

    def class_name(self) -> str:
        return "Sphere"

    def traverse(self, callback: object) -> None: ...


# The key in the scene, what stands there, the place, and what the message says besides.
WRONG: list[tuple[str, object, str, str]] = [
    ("ball", {"type": "sphre"}, "", 'unknown plugin "sphre"\n  did you mean "sphere"?'),
    ("ball", {"type": 3}, "", "unknown plugin 3"),
    ("ball", {"radius": 1}, "", "has no type"),
    ("ball", {"type": "sdfgrid"}, "", 'the shape "sdfgrid" is not supported'),
    ("ball", {**BALL, "bsdf": {"type": "hair"}}, '["bsdf"]', 'the bsdf "hair" is not supported'),
    ("ball", {**BALL, "raduis": 1}, '["raduis"]', 'did you mean "radius"?'),
    ("ball", {**BALL, "radius": "1"}, '["radius"]', "is a <string>"),
    ("ball", {**BALL, "radius": np.nan}, '["radius"]', "is nan"),
    ("ball", {**BALL, "center": [0, 1, np.inf]}, '["center"]', "contains 1 times inf"),
    ("ball", {**BALL, "center": [0, 1]}, '["center"]', "the shape (2,)"),
    ("ball", {**BALL, "center": [[0], [1, 2]]}, '["center"]', "is a list"),
    ("ball", {**BALL, "radius": None}, '["radius"]', "is None"),
    ("ball", {**BALL, "radius": 1j}, '["radius"]', "is 1j"),
    ("ball", {**BALL, "radius": b"1"}, '["radius"]', "is a bytes"),
    ("ball", {**BALL, "bsdf": _Plugin()}, '["bsdf"]', "give its dictionary"),
    ("ball", dict[Any, Any](BALL) | {3: 1}, "", "has the key 3"),
    ("ball", {**BALL, "a.b": 1}, "", '"a.b" contains a dot'),
    ("ball", {**BALL, "to_world": np.eye(3)}, '["to_world"]', "the shape (3, 3)"),
    ("ball", {**BALL, "id": 3}, "", "is 3"),
    ("ball", {**BALL, "id": "lamp"}, "", 'the id "lamp" is taken'),
    ("ball", {**BALL, "bsdf": {"type": "ref", "id": "lmp"}}, '["bsdf"]', 'did you mean "lamp"?'),
    ("ball", {**BALL, "bsdf": {"type": "ref"}}, '["bsdf"]', "is None"),
    (
        "paint",
        {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.1, 0.2]}},
        '["reflectance"]',
        "expected three numbers or one",
    ),
    (
        "paint",
        {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.1, 0.2, 1.5]}},
        '["reflectance"]',
        "expected numbers from 0 to 1",
    ),
    (
        "paint",
        {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.1, "unit": "m"}},
        '["reflectance"]',
        'unknown key "unit"',
    ),
    (
        "paint",
        {"type": "diffuse", "reflectance": {"type": "spectrum", "value": [(700, 0.1), (400, 0.5)]}},
        '["reflectance"]',
        "the wavelength 400 stands behind 700",
    ),
    ("mesh", {"type": "mesh", "positions": np.eye(3)}, "", "has no faces"),
    ("mesh", {**MESH, "positions": np.eye(2)}, '["positions"]', "expected (n, 3)"),
    ("mesh", {**MESH, "faces": [[0, 1, 3]]}, '["faces"]', "from 0 to 2"),
    ("mesh", {**MESH, "faces": [[0, 1, 0.5]]}, '["faces"]', "whole numbers"),
    ("mesh", {**MESH, "uvs": np.eye(2)}, '["uvs"]', "expected (3, 2)"),
    ("mesh", {**MESH, "vertex_color": np.ones((2, 3))}, '["vertex_color"]', "(3, 1) or (3, 3)"),
    ("sky", {"type": "envmap", "data": np.ones(3)}, '["data"]', "has the shape (3,)"),
    (
        "sky",
        {"type": "envmap", "data": np.ones((3, 3)), "filename": "a"},
        "",
        "more than one image",
    ),
]


@pytest.mark.parametrize("case", range(len(WRONG)))
def test_mistakes_have_places(case: int) -> None:
    key, value, place, message = WRONG[case]
    with pytest.raises(cw.LoadError) as caught:
        cw.load_dict(scene(**{key: value}))
    assert str(caught.value).startswith(f'dictionary["{key}"]{place}: ')
    assert message in str(caught.value)
    assert (caught.value.file, caught.value.line, caught.value.column) == (None, None, None)


def test_a_dictionary_in_itself() -> None:
    paint: dict[str, Any] = {"type": "twosided"}
    paint["inner"] = paint
    with pytest.raises(cw.LoadError, match="nested more than"):
        cw.load_dict(scene(paint=paint))


@pytest.mark.parametrize("root", [BALL, [BALL], None])
def test_the_root_is_a_scene(root: Any) -> None:
    with pytest.raises(cw.LoadError, match="expected"):
        cw.load_dict(root)


def test_transforms_are_those_of_mitsuba() -> None:
    mi = pytest.importorskip("mitsuba")
    mi.set_variant("scalar_rgb")

    def made(start: Any) -> Any:
        seen = start.look_at(origin=[1, 2, 3], target=[0, 1, 0], up=[0, 1, 0])
        return seen.rotate([0, 0.6, 0.8], 30).scale([1, 2, 3]).translate([1, 0, 2]).scale(2)

    theirs = np.asarray(made(mi.ScalarTransform4f()).matrix)
    assert np.allclose(made(cw.Transform()).matrix, theirs, atol=1e-5)
    product = cw.Transform().scale(2) @ cw.Transform().translate([1, 0, 0])
    assert np.array_equal(product.matrix, cw.Transform().scale(2).translate([1, 0, 0]).matrix)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        (lambda t: t.rotate([0, 2, 0], 30), "has the length 2; expected 1"),
        (lambda t: t.translate([0, 2]), "expected three finite numbers"),
        (lambda t: t.scale(np.nan), "expected three finite numbers"),
        (lambda t: t.look_at([0, 0, 0], [0, 1, 0], [0, 1, 0]), "up is parallel"),
        (lambda t: cw.Transform(np.eye(3)), r"expected \(4, 4\)"),
    ],
)
def test_transforms_that_are_none(wrong: Any, message: str) -> None:
    with pytest.raises(cw.ArgumentError, match=message):
        wrong(cw.Transform())


def test_values_of_mitsuba() -> None:
    """Its vectors, transforms and bitmaps, scalar and vectorized."""
    mi = pytest.importorskip("mitsuba")
    pixels = np.random.default_rng(1).integers(0, 256, (3, 4, 3), dtype=np.uint8)
    mi.set_variant("scalar_rgb")
    transform = mi.ScalarTransform4f().translate([1, 2, 0.5]).scale(2)
    texture = {"type": "bitmap", "bitmap": pixels}
    ours = {"radius": 0.5, "center": [0.5, 1, 2], "to_world": np.asarray(transform.matrix)}
    theirs = {"radius": 0.5, "center": mi.Point3f(0.5, 1, 2), "to_world": transform}
    loaded = []
    for bitmap, own in ((pixels, ours), (mi.Bitmap(pixels), theirs)):
        reflectance = {**texture, "bitmap": bitmap, "to_uv": mi.ScalarTransform3f().scale([2, 3])}
        paint = {"type": "diffuse", "reflectance": reflectance}
        loaded.append(cw.load_dict(scene(ball={**BALL, **own, "bsdf": paint})))
    assert same(*loaded)
    colour = {"type": "diffuse", "reflectance": mi.Color3f(0.1, 0.2, 0.3)}
    painted = cw.load_dict(scene(paint=colour))
    assert np.allclose(cw.traverse(painted)["paint.reflectance.value"], [0.1, 0.2, 0.3])
    # Mitsuba's own example, as it is.
    with pytest.warns(cw.SceneWarning, match="focus_distance"):
        assert cw.load_dict(mi.cornell_box()).size == (256, 256)

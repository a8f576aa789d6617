"""Meshes and images in files, as arrays and back."""

from __future__ import annotations

import json
import struct
import zlib
from pathlib import Path
from typing import Any

import capwalk as cw
import numpy as np
import pytest
from test_gltf import room

ROOT = Path(__file__).parents[2] / "tests"


def lit(shape: dict[str, Any]) -> cw.Scene:
    """A scene with a shape in a pattern of its texture coordinates, or in its colours."""
    view = cw.Transform().look_at(origin=[1.5, 2.5, 4], target=[0, 0, 0], up=[0, 1, 0])
    pattern = {"type": "checkerboard", "to_uv": cw.Transform().scale([2.0, 3.0, 1.0])}
    return cw.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "direct"},
            "sensor": {
                "type": "perspective",
                "fov": 40,
                "to_world": view,
                "film": {"type": "hdrfilm", "width": 24, "height": 18},
            },
            "shape": {
                "bsdf": {"type": "twosided", "inner": {"type": "diffuse", "reflectance": pattern}},
                **shape,
            },
            "lamp": {"type": "point", "position": [2, 4, 3], "intensity": 20.0},
        }
    )


def rendered(shape: dict[str, Any]) -> np.ndarray[Any, Any]:
    image = cw.render(lit(shape), spp=4).value
    assert image.any() and np.unique(image).size > 20
    return image


def coloured(name: str) -> dict[str, Any]:
    paint = {"type": "mesh_attribute", "name": name}
    return {"bsdf": {"type": "twosided", "inner": {"type": "diffuse", "reflectance": paint}}}


@pytest.mark.parametrize(
    ("file", "plugin", "more"),
    [
        ("scenes/seam_of_texture_coordinates/plane.obj", "obj", {}),
        ("parity/cone.ply", "ply", {}),
        ("parity/coloured.ply", "ply", coloured("vertex_color")),
        ("parity/coloured.ply", "ply", coloured("face_color")),
        ("parity/cup.serialized", "serialized", {}),
    ],
)
def test_meshes_are_those_that_scenes_read(
    file: str, plugin: str, more: dict[str, Any], tmp_path: Path
) -> None:
    """Also after they were written. Normals are made unit again, which rounds them."""
    path = ROOT / file
    expected = rendered({"type": plugin, "filename": str(path), **more})
    mesh = cw.load_mesh(path)
    assert np.allclose(rendered({**mesh, **more}), expected, rtol=1e-9, atol=1e-9)
    copy = tmp_path / "copy.PLY"
    cw.save_mesh(copy, mesh)
    again = cw.load_mesh(copy)
    assert list(again) == list(mesh)
    for name, array in mesh.items():
        rounding = 1e-15 if name == "normals" else 0.0
        assert name == "type" or np.abs(again[name] - array).max() <= rounding
    assert np.allclose(rendered({**again, **more}), expected, rtol=1e-9, atol=1e-9)


def single(rows: list[list[float]]) -> np.ndarray[Any, Any]:
    """Numbers in single precision."""
    return np.array(rows, dtype=np.float32)


def tent() -> dict[str, Any]:
    """Four vertices in single precision, which the faces use in order."""
    return {
        "type": "mesh",
        "positions": single([[0.1, 0, -1e-9], [1, 0.3, 0], [0, 1, 1e7], [0.7, 1 / 3, 0.5]]),
        "normals": np.eye(4, 3) + [0, 0, 0.75],
        "uvs": single([[0, 0.1], [1 / 3, 1], [-2, 0.25], [7, 3]]),
        "faces": [[0, 1, 2], [2, 1, 3]],
    }


@pytest.mark.parametrize("left_out", [[], ["uvs"], ["normals"], ["uvs", "normals"]])
@pytest.mark.parametrize("ending", ["ply", "OBJ", "glb"])
def test_written_meshes_come_back(ending: str, left_out: list[str], tmp_path: Path) -> None:
    mesh = {name: array for name, array in tent().items() if name not in left_out}
    file = tmp_path / f"tent.{ending}"
    cw.save_mesh(file, mesh)
    again = cw.load_mesh(file)
    assert again.pop("face_normals", False) == (ending == "glb" and "normals" in left_out)
    assert again.keys() == mesh.keys()
    if "normals" not in left_out:
        normals = again.pop("normals")
        unit = mesh["normals"] / np.linalg.norm(mesh["normals"], axis=1, keepdims=True)
        assert np.abs(normals - unit).max() < (1e-7 if ending == "glb" else 1e-15)
    assert all(np.array_equal(array, mesh[name]) for name, array in again.items())
    assert [path.name for path in tmp_path.iterdir()] == [file.name]


@pytest.mark.parametrize(
    ("left_out", "corner"),
    [([], "4/4/4"), (["uvs"], "4//4"), (["normals"], "4/4"), (["uvs", "normals"], "4")],
)
def test_corners_of_obj_files(left_out: list[str], corner: str, tmp_path: Path) -> None:
    mesh = {name: array for name, array in tent().items() if name not in left_out}
    cw.save_mesh(tmp_path / "tent.obj", mesh)
    assert (tmp_path / "tent.obj").read_text().split()[-1] == corner


def test_obj_files_have_all_digits(tmp_path: Path) -> None:
    positions = np.random.default_rng(1).normal(size=(3, 3)) * [1e-30, 1, 1e20]
    cw.save_mesh(tmp_path / "mesh.obj", {"positions": positions, "faces": [[0, 1, 2]]})
    assert np.array_equal(cw.load_mesh(tmp_path / "mesh.obj")["positions"], positions)


def test_vertices_of_obj_files_are_numbered_anew(tmp_path: Path) -> None:
    """In the order in which faces use them; the corners of faces stay what they were."""
    given = tent() | {"faces": [[3, 1, 0]]}
    files = tmp_path / "first.obj", tmp_path / "second.obj"
    cw.save_mesh(files[0], given)
    mesh = cw.load_mesh(files[0])
    assert np.array_equal(mesh["faces"], [[0, 1, 2]])
    for name in ("positions", "uvs"):
        assert np.array_equal(mesh[name], given[name][[3, 1, 0]])
    cw.save_mesh(files[1], mesh)
    again = cw.load_mesh(files[1])
    assert all(np.array_equal(again[name], array) for name, array in mesh.items())


def test_glb_files_are_as_gltf_asks(tmp_path: Path) -> None:
    file = tmp_path / "mesh.glb"
    colours = single([[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.5, 0.25, 0]])
    flat = {"face_normals": True, "vertex_color": colours}
    mesh = {name: array for name, array in tent().items() if name != "normals"} | flat
    cw.save_mesh(file, mesh)
    again = cw.load_mesh(file)
    assert again["face_normals"] is True and np.array_equal(again["vertex_color"], colours)
    data = file.read_bytes()
    assert struct.unpack_from("<4sII", data) == (b"glTF", 2, len(data))
    length, kind = struct.unpack_from("<I4s", data, 12)
    assert length % 4 == 0 and kind == b"JSON"
    gltf = json.loads(data[20 : 20 + length])
    size, kind = struct.unpack_from("<I4s", data, 20 + length)
    assert kind == b"BIN\0" and size == len(data) - 28 - length == gltf["buffers"][0]["byteLength"]
    [primitive] = gltf["meshes"][0]["primitives"]
    corners = gltf["accessors"][primitive["attributes"]["POSITION"]]
    assert corners["min"] == mesh["positions"].min(0).tolist()
    assert corners["max"] == mesh["positions"].max(0).tolist()
    assert all(view["byteOffset"] % 4 == 0 for view in gltf["bufferViews"])


def test_trimesh_reads_what_is_written(tmp_path: Path) -> None:
    """Except normals, which it computes itself whatever the format."""
    trimesh: Any = pytest.importorskip("trimesh")
    mesh = tent()
    for ending in ("ply", "obj", "glb"):
        cw.save_mesh(tmp_path / f"tent.{ending}", mesh)
        read = trimesh.load_mesh(tmp_path / f"tent.{ending}", process=False)
        assert np.array_equal(np.float32(read.vertices), mesh["positions"])
        assert np.array_equal(read.faces, mesh["faces"])
        if ending != "ply":
            # There v points up.
            u, v = read.visual.uv.T
            assert np.abs(np.column_stack([u, 1 - v]) - mesh["uvs"]).max() < 1e-6


def test_files_are_written_whole_or_not_at_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    for ending in ("obj", "glb"):
        file = tmp_path / f"mesh.{ending}"
        file.write_bytes(b"before")
        with monkeypatch.context() as patched:
            patched.setattr(Path, "replace", full)
            with pytest.raises(cw.MeshError, match=f"cannot write .*mesh.{ending}: No space"):
                cw.save_mesh(file, tent())
        assert file.read_bytes() == b"before"
        with pytest.raises(OSError, match=f"cannot write .*missing.mesh.{ending}: "):
            cw.save_mesh(tmp_path / f"missing/mesh.{ending}", tent())
    assert sorted(path.name for path in tmp_path.iterdir()) == ["mesh.glb", "mesh.obj"]


@pytest.mark.parametrize(
    ("ending", "more", "error"),
    [
        ("obj", {"vertex_color": np.ones((4, 3))}, 'an .obj file has no place for "vertex_color"'),
        ("obj", {"face_normals": True}, 'place for "face_normals"; leave them out of the mesh$'),
        ("glb", {"vertex_color": np.ones((4, 1))}, '"vertex_color"; .*, or write a .ply file$'),
        ("glb", {"face_heat": np.ones((2, 1))}, 'a .glb file has no place for "face_heat"'),
        ("glb", {"face_normals": True}, 'place for "face_normals"'),
        ("glb", {"uvs": np.full((4, 2), 1e300)}, r'mesh\["uvs"\] has numbers beyond single'),
    ],
)
def test_what_a_format_has_no_place_for_is_not_written(
    ending: str, more: dict[str, Any], error: str, tmp_path: Path
) -> None:
    with pytest.raises(cw.ArgumentError, match=error):
        cw.save_mesh(tmp_path / f"mesh.{ending}", tent() | more)
    assert not any(tmp_path.iterdir())


def test_one_mesh_of_several_is_chosen() -> None:
    path = ROOT / "parity/cup.serialized"
    cup, saucer = (cw.load_mesh(path, shape_index=i)["positions"] for i in (0, 1))
    assert np.array_equal(cup, cw.load_mesh(path)["positions"])
    assert cup.shape != saucer.shape
    with pytest.raises(cw.MeshError, match="cup.serialized: .*mesh"):
        cw.load_mesh(path, shape_index=7)
    with pytest.raises(cw.MeshError, match="has one mesh; node, mesh and primitive choose"):
        cw.load_mesh(ROOT / "parity/cone.ply", node="cone")


def test_meshes_in_gltf_files(tmp_path: Path) -> None:
    file = tmp_path / "walls.gltf"
    other = {"name": "Other", "mesh": 0, "translation": [0, 0, 2]}
    file.write_text(json.dumps(room(nodes=[{"name": "Wall", "mesh": 0}, other, {}])))
    with pytest.raises(cw.MeshError, match="walls.gltf: .*Wall"):
        cw.load_mesh(file)
    for node in ("Other", 1):
        mesh = cw.load_mesh(file, node=node)
        assert np.array_equal(mesh["positions"], [[-4, -4, 2], [4, -4, 2], [0, 8, 2]])
        assert np.array_equal(mesh["faces"], [[0, 1, 2]])
    assert mesh["face_normals"] is True
    text = file.read_bytes()
    text += b" " * (-len(text) % 4)
    sizes = struct.pack("<IIII", 2, 20 + len(text), len(text), 0x4E4F534A)
    file.with_suffix(".glb").write_bytes(b"glTF" + sizes + text)
    binary = cw.load_mesh(file.with_suffix(".glb"), node=1)
    assert np.array_equal(binary["positions"], mesh["positions"]) and binary["face_normals"]
    plugin = {"type": "gltf", "filename": str(file), "node": 1}
    white = {"bsdf": {"type": "twosided", "inner": {"type": "diffuse"}}}
    image, same = (cw.render(lit({**shape, **white}), spp=4).value for shape in (mesh, plugin))
    assert image.any() and np.array_equal(image, same)
    with pytest.raises(cw.ArgumentError, match='no place for "face_normals"; leave them out'):
        cw.save_mesh(tmp_path / "wall.ply", mesh)


def test_a_shape_of_a_scene_is_saved(tmp_path: Path, scene: cw.Scene) -> None:
    params = cw.traverse(scene)
    params.update({"box.translate": [0.1, 0.2, 0.3]})
    arrays: dict[str, Any] = {"positions": params["box.positions"], "faces": scene.faces("box")}
    cw.save_mesh(tmp_path / "box.ply", arrays)
    mesh = cw.load_mesh(tmp_path / "box.ply")
    assert mesh.keys() == {"type", "positions", "faces"}
    assert all(np.array_equal(mesh[name], array) for name, array in arrays.items())


@pytest.mark.parametrize(
    ("mesh", "error"),
    [
        ({"positions": np.eye(3)}, 'has no faces\n  add "faces"'),
        ({"positions": np.eye(3), "faces": [[0, 1, 3]]}, r'mesh\["faces"\]: names other vertices'),
        ({"positions": np.eye(3), "faces": [[0, 1, 2]], "uvs": np.eye(2)}, r"expected \(3, 2\)"),
        ({"positions": np.eye(3), "faces": [[0, 1, 2]], "bsdf": {}}, 'no place for "bsdf"'),
        ({"positions": np.eye(3), "faces": [[0, 1, 2]], "type": "ply"}, 'no place for "type"'),
        ({"positions": np.eye(3), "faces": np.zeros((0, 3))}, "the mesh has no faces"),
        (
            {"positions": np.eye(3), "faces": [[0, 1, 2]], "vertex_a b": np.ones((3, 1))},
            "blanks in the name 'vertex_a b'",
        ),
    ],
)
def test_what_is_no_mesh_is_not_written(mesh: dict[str, Any], error: str, tmp_path: Path) -> None:
    with pytest.raises(cw.ArgumentError, match=error):
        cw.save_mesh(tmp_path / "mesh.ply", mesh)
    assert not any(tmp_path.iterdir())


def test_files_that_are_no_meshes(tmp_path: Path) -> None:
    triangle = {"positions": np.eye(3), "faces": [[0, 1, 2]]}
    wrong = r"mesh.stl does not tell .* expected the ending \.ply, \.obj or \.glb: choose one"
    with pytest.raises(cw.MeshError, match=wrong):
        cw.save_mesh(tmp_path / "mesh.stl", triangle)
    with pytest.raises(OSError, match="cannot write .*mesh.ply: "):
        cw.save_mesh(tmp_path / "missing/mesh.ply", triangle)
    with pytest.raises(cw.MeshError, match=r"known endings: \.ply, \.obj, \.gltf"):
        cw.load_mesh(tmp_path / "mesh.stl")
    with pytest.raises(cw.MeshError, match="cannot read .*mesh.ply: "):
        cw.load_mesh(tmp_path / "mesh.ply")
    (tmp_path / "mesh.obj").write_text("v 0 0 0\nv 1 0 x\n")
    with pytest.raises(cw.MeshError, match="mesh.obj: line 2: "):
        cw.load_mesh(tmp_path / "mesh.obj")


def test_warnings_of_mesh_files(tmp_path: Path) -> None:
    header = ["ply", "format ascii 1.0", "element vertex 3"]
    header += [f"property float {x}" for x in "xyz"] + [f"property uchar {c}" for c in "rgb"]
    header += ["element face 1", "property list uchar int vertex_indices", "end_header"]
    rows = ["0 0 0 255 0 7", "1 0 0 255 0 7", "0 1 0 255 0 7", "3 0 1 2"]
    file = tmp_path / "bytes.ply"
    file.write_text("\n".join([*header, *rows, ""]))
    with pytest.warns(cw.SceneWarning, match='bytes.ply has whole numbers as "vertex_color"'):
        mesh = cw.load_mesh(file)
    assert np.array_equal(mesh["vertex_color"], [[255, 0, 7]] * 3)


def test_images_come_back(tmp_path: Path, scene: cw.Scene) -> None:
    """In single precision, a preview in 8 bits."""
    derivative = cw.gradient(scene, "box.translate.x", spp=4)
    image = cw.render(scene, spp=4)
    for ending in ("exr", "npz"):
        path = tmp_path / f"derivative.{ending}"
        derivative.save(path)
        for layer, expected in (("gradient", derivative.gradient), (None, derivative.value)):
            assert np.array_equal(cw.load_image(path, layer=layer), expected.astype(np.float32))
        with pytest.raises(cw.ImageError, match=r'no layer "depth"; its layers are .*gradient'):
            cw.load_image(path, layer="depth")
    image.save(tmp_path / "image.png")
    shown = cw.load_image(tmp_path / "image.png")
    assert shown.shape == (18, 24, 3)
    # Half a step of 8 bits is at most 1/510 of the encoded number, of which the slope of the decoded
    # one is at most 2.4 / 1.055.
    assert np.abs(shown - image.value.clip(0, 1)).max() < 1 / 510 * 2.4 / 1.055 * 1.01


def test_arrays_are_saved_as_images(tmp_path: Path) -> None:
    image = np.linspace(-0.5, 1.5, 4 * 3 * 3).reshape(4, 3, 3)
    for ending in ("exr", "npz"):
        cw.save_image(tmp_path / f"image.{ending}", image)
        assert np.array_equal(cw.load_image(tmp_path / f"image.{ending}"), image.astype(np.float32))
    cw.save_image(tmp_path / "image.png", image)
    shown = cw.load_image(tmp_path / "image.png")
    assert np.abs(shown - image.clip(0, 1)).max() < 0.005
    with pytest.raises(cw.ArgumentError, match="expected .height"):
        cw.save_image(tmp_path / "image.exr", image[0, 0])
    with pytest.raises(cw.ImageError, match="jpg"):
        cw.save_image(tmp_path / "image.jpg", image)


def test_colours_of_images() -> None:
    """As the textures of scenes have them."""
    path = ROOT / "parity/texels.png"
    linear, raw = cw.load_image(path), cw.load_image(path, raw=True)
    assert linear.min() >= 0 and raw.max() <= 1 and linear.shape == raw.shape
    assert np.allclose(raw * 255, np.round(raw * 255), atol=1e-9)
    decoded = np.where(raw <= 0.04045, raw / 12.92, ((raw + 0.055) / 1.055) ** 2.4)
    assert np.abs(linear - decoded).max() < 1e-12 and np.abs(linear - raw).max() > 0.05
    paint = {"type": "diffuse", "reflectance": {"type": "bitmap", "filename": str(path)}}
    scene = lit({"type": "rectangle", "bsdf": paint})
    [texels] = [array for name, array in cw.traverse(scene).items() if name.endswith("data")]
    assert np.array_equal(np.broadcast_to(texels, linear.shape), linear)


def png_of(width: int, height: int, rgba: bytes) -> bytes:
    """A PNG file with opacities."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return (
            struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        )

    rows = b"".join(b"\0" + rgba[4 * width * y : 4 * width * (y + 1)] for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    chunks = [(b"IHDR", header), (b"IDAT", zlib.compress(rows)), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*part) for part in chunks)


def test_opacity(tmp_path: Path) -> None:
    """It is never decoded, and colours are not multiplied by it."""
    file = tmp_path / "rgba.png"
    file.write_bytes(png_of(1, 2, bytes([255, 0, 0, 51, 0, 255, 0, 0])))
    assert np.array_equal(cw.load_image(file), [[[1, 0, 0]], [[0, 1, 0]]])
    assert np.array_equal(cw.load_image(file, layer="A"), [[[0.2] * 3], [[0.0] * 3]])
    assert (cw.load_image(ROOT / "parity/texels.png", layer="A") == 1).all()
    with pytest.raises(cw.ImageError, match='no layer "depth"; its layers are value, A'):
        cw.load_image(ROOT / "parity/texels.png", layer="depth")


def test_files_that_are_no_images(tmp_path: Path) -> None:
    (tmp_path / "image.png").write_bytes(b"\x89PNG nothing")
    with pytest.raises(OSError, match="cannot read .*image.png: "):
        cw.load_image(tmp_path / "image.png")
    with pytest.raises(cw.ImageError, match=r"known endings: \.exr, \.npz, \.png"):
        cw.load_image(tmp_path / "image.gif")
    with pytest.raises(cw.ImageError, match="missing.exr"):
        cw.load_image(tmp_path / "missing.exr")


def test_the_version_is_that_of_the_crates() -> None:
    manifest = ROOT.parent / "Cargo.toml"
    assert f'version = "{cw.__version__}"' in manifest.read_text()

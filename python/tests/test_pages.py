"""The Python code on the pages of the documentation runs, page by page, with few samples."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from llvm import has_llvm
from test_jobs import JOB

import capwalk as cw

ROOT = Path(__file__).parents[2]

PAGES = [
    path.relative_to(ROOT).as_posix()
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    if "```python" in path.read_text(encoding="utf-8")
]

NEEDS = {
    "docs/how-to/coming-from-nvdiffrast.md": ["torch"],
    "docs/how-to/coming-from-redner.md": ["torch"],
    "docs/how-to/custom-loss.md": ["torch"],
    "docs/how-to/many-views.md": ["torch"],
    "docs/how-to/meshes-and-cameras.md": ["trimesh"],
    "docs/how-to/remeshing.md": ["gpytoolbox"],
    "docs/how-to/see-it-work.md": ["rerun", "torch"],
    "docs/scene-files.md": ["drjit", "mitsuba"],
}
"""The packages that the code of a page imports besides NumPy."""

FEWER = {
    r"\bspp=\d+": "spp=2",
    r"range\(100\)": "range(2)",
    r"step in \(10, 20, 40, 80\)": "step == 1",
    r"height, fine = 512, 16": "height, fine = 8, 2",
}
"""What makes the code of all pages quick: fewer samples, steps and texels."""

BALL = """<scene version="3.0.0">
    <default name="radius" value="1"/>
    <integrator type="direct"/>
    <sensor type="perspective">
        <transform name="to_world"><lookat origin="0, 3, 9" target="0, 1, 0" up="0, 1, 0"/></transform>
        <film type="hdrfilm"><rfilter type="box"/></film>
        <sampler type="independent"><integer name="sample_count" value="2"/></sampler>
    </sensor>
    <shape type="rectangle" id="floor">
        <transform name="to_world"><rotate x="1" angle="-90"/><scale value="4"/></transform>
    </shape>
    <shape type="sphere" id="ball"><float name="radius" value="$radius"/></shape>
    <emitter type="constant"/>
</scene>"""
"""The file `ball.xml` of docs/python.md."""

WIDTH, HEIGHT = 8, 6
"""Of all images, pixels."""


def blocks(page: str) -> list[str]:
    """The Python code of a page, in order, without the indentation of lists."""
    text = (ROOT / page).read_text(encoding="utf-8")
    found = re.findall(r"^( *)```python\n(.*?)^ *```$", text, re.MULTILINE | re.DOTALL)
    return [re.sub(rf"^{indent}", "", code, flags=re.MULTILINE) for indent, code in found]


def given(page: str, number: int) -> dict[str, Any]:
    """What a block of code takes as given: the names that the text around it speaks of."""
    image = np.full((HEIGHT, WIDTH, 3), 0.2)
    names: dict[str, Any] = {"cw": cw, "np": np, "height": HEIGHT, "width": WIDTH, "step": 3, "target": image}
    room: dict[str, Any] = {"type": "scene", "integrator": {"type": "direct"}, "sky": {"type": "constant"}}
    match page:
        case "docs/how-to/textures.md":
            view = cw.Transform().look_at(origin=[0, 0, 5], target=[0, 0, 0], up=[0, 1, 0])
            names["room"] = room | {"view": {"type": "perspective", "to_world": view}}
        case "docs/how-to/many-views.md":
            names["room"] = room | {"ball": {"type": "sphere"}}
            names |= {"name": "ball.positions", "targets": [image, image]}
        case "docs/how-to/meshes-and-cameras.md":
            view = cw.Transform().look_at(origin=[0, 0, 5], target=[0, 0, 0], up=[0, 1, 0])
            names["room"] = room | {"view": {"type": "perspective", "to_world": view}}
            write_capture(Path("capture"), image)
            ball = cw.load_dict(names["room"] | {"ball": {"type": "sphere"}})
            positions = cw.traverse(ball)["ball.positions"]
            cw.save_mesh("start.ply", {"positions": positions, "faces": ball.faces("ball")})
        case "docs/how-to/remeshing.md":
            view = cw.Transform().look_at(origin=[0, 0, 5], target=[0, 0, 0], up=[0, 1, 0])
            names["room"] = room | {"view": {"type": "perspective", "to_world": view}}
            ball = cw.load_dict(names["room"] | {"ball": {"type": "sphere"}})
            names |= {"x": cw.traverse(ball)["ball.positions"], "faces": ball.faces("ball")}
        case "docs/how-to/see-it-work.md":
            # It renders its target.
            del names["target"]
            Path("job.toml").write_text(JOB, encoding="utf-8")
        case "docs/how-to/custom-loss.md":
            scene = cw.load_file("ball")
            names |= {"scene": scene, "mask": image[..., :1], "target_mask": image}
            if number in (0, 4):
                torch: Any = pytest.importorskip("torch")
                start = torch.from_numpy(np.asarray(cw.traverse(scene)["ball.positions"]))
                names |= {"torch": torch, "start": start, "positions": start.clone().requires_grad_()}
                names |= {"mask": torch.ones(HEIGHT, WIDTH, 1), "target": torch.from_numpy(image)}
    return names


def write_capture(folder: Path, image: Any) -> None:
    """Two equal photographs from five units away, and their cameras as COLMAP and nerfstudio write them."""
    for name in ("images", "sparse"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    files = ["a.png", "b.png"]
    poses = [f"{number} 1 0 0 0 0 0 5 1 {name}\n\n" for number, name in enumerate(files, 1)]
    (folder / "sparse/cameras.txt").write_text(f"1 SIMPLE_PINHOLE {WIDTH} {HEIGHT} 10 4 3\n")
    (folder / "sparse/images.txt").write_text("".join(poses))
    to_world = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]]
    frames = [{"file_path": f"images/{name}", "transform_matrix": to_world} for name in files]
    whole = {"fl_x": 10, "w": WIDTH, "h": HEIGHT, "frames": frames}
    (folder / "transforms.json").write_text(json.dumps(whole))
    for name in files:
        cw.save_image(folder / "images" / name, image)


@pytest.mark.parametrize("page", PAGES)
def test_code_runs(page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in NEEDS.get(page, []):
        pytest.importorskip(module)
    if "mitsuba" in NEEDS.get(page, []) and not has_llvm():
        pytest.skip("Mitsuba cannot render with LLVM here")
    monkeypatch.chdir(tmp_path)
    Path("ball.xml").write_text(BALL, encoding="utf-8")
    for name in ("load_file", "load_dict"):
        monkeypatch.setattr(cw, name, _small(getattr(cw, name)))
    names: dict[str, Any] = {}
    for number, code in enumerate(blocks(page)):
        names |= given(page, number)
        for long, short in FEWER.items():
            code = re.sub(long, short, code)
        exec(compile(code, f"{page}, block {number}", "exec"), names)


def _small(load: Any) -> Any:
    """A function that loads scenes, with few pixels."""

    def loaded(*args: Any, **kwargs: Any) -> cw.Scene:
        scene: cw.Scene = load(*args, **kwargs)
        scene.resize(WIDTH, HEIGHT)
        return scene

    return loaded

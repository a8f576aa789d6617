"""Optimisations whose sample counts follow the noise, beside fixed counts.

    python python/benchmarks/samples_by_noise.py CAPWALK [--jobs NAME ...] [--spp N[:M] ...]

CAPWALK is the program. Each of five jobs runs with each fixed count of samples per pixel, N of images
and M or else N of gradients, and with `[samples]`, begun with 4 of each. After every few iterations the
scene is rendered with many samples; its loss, less what noise adds to it, is the true one. What is
printed is a table: the samples (of images and gradients) and the seconds until the true loss is below a
level for good, and the loss at the end."""

from __future__ import annotations

import argparse
import csv
import json
import re
import subprocess
import tempfile
import tomllib
from pathlib import Path

import numpy as np
from PIL import Image

import capwalk as cw

EVERY = 10
"""True losses are known after so many iterations."""
EVALUATION = 512
"""Samples per pixel of true losses."""

POSE = """<scene version="3.0.0">
<integrator type="path"><integer name="max_depth" value="3"/></integrator>
{sensors}
<shape type="rectangle" id="floor"><transform name="to_world"><scale value="4"/></transform>
  <bsdf type="diffuse" id="floor_bsdf">{floor}</bsdf></shape>
<shape type="cube" id="box">
  <transform name="to_world"><scale x="0.5" y="0.3" z="0.4"/><translate z="0.6"/></transform>
  <bsdf type="roughconductor" id="metal"><string name="material" value="Al"/>
    <float name="alpha" value="0.3"/><rgb name="specular_reflectance" value="0.7"/></bsdf></shape>
<shape type="rectangle" id="lamp">
  <transform name="to_world">
    <lookat origin="1, -1.5, 3" target="0, 0, 0" up="0, 0, 1"/>
  </transform>
  <emitter type="area"><rgb name="radiance" value="8"/></emitter></shape>
<emitter type="constant"><rgb name="radiance" value="0.4"/></emitter>
</scene>"""

PLAIN = '<rgb name="reflectance" value="0.5"/>'
BITMAP = """<texture type="bitmap" name="reflectance"><string name="filename" value="grey.png"/>
  <transform name="to_uv"><scale x="1"/></transform></texture>"""


def sensor(origin: str) -> str:
    return f"""<sensor type="perspective"><float name="fov" value="35"/>
  <transform name="to_world"><lookat origin="{origin}" target="0, 0, 0.4" up="0, 0, 1"/></transform>
  <film type="hdrfilm"><integer name="width" value="48"/><integer name="height" value="36"/>
    <rfilter type="box"/></film></sensor>"""


SENSORS = [sensor("0.5, -4, 2"), sensor("-3, -2, 2.5")]
VIEWS = "\n".join(f"[[view]]\nsensor = {i}" for i in range(2))
COSINE = '[schedule]\ntype = "cosine"\nend = 0.1\n'

JOBS: dict[str, tuple[str, str, int, float]] = {
    # The leaf and the colour of the floor, from its shadow: 4 unknowns.
    "shadow": (
        "",
        """scene = "leaf"
size = [40, 30]
[target]
spp = 1024
[target.set]
"leaf.translate.x" = 0.2
"floor.bsdf.reflectance.value" = [0.5, 0.6, 0.3]
[[parameter]]
name = "leaf.translate.x"
[[parameter]]
name = "floor.bsdf.reflectance.value"
reparam = "sigmoid"
[optimizer]
lr = 0.1
""",
        80,
        1e-5,
    ),
    # Pose, tint and roughness of a box of rough metal, in two views: 10 unknowns.
    "pose": (
        POSE.format(sensors="\n".join(SENSORS), floor=PLAIN),
        """scene = "scene.xml"
[target]
spp = 1024
[target.set]
"box.translate" = [0.15, -0.1, 0.1]
"box.rotate.x" = 0.2
"box.rotate.y" = -0.1
"box.rotate.z" = 0.3
"metal.alpha.value" = 0.2
"metal.specular_reflectance.value" = [0.9, 0.6, 0.4]
[[parameter]]
name = "box.translate"
[[parameter]]
name = "box.rotate.x"
[[parameter]]
name = "box.rotate.y"
[[parameter]]
name = "box.rotate.z"
[[parameter]]
name = "metal.alpha.value"
bounds = [0.05, 0.8]
lr = 0.02
[[parameter]]
name = "metal.specular_reflectance.value"
bounds = [0, 1]
[optimizer]
lr = 0.03
"""
        + VIEWS,
        100,
        1e-4,
    ),
    # The camera's position and direction: 6 unknowns.
    "camera": (
        POSE.format(sensors=SENSORS[0], floor=PLAIN),
        """scene = "scene.xml"
[target]
spp = 1024
[target.set]
"sensor.translate" = [0.2, 0.1, -0.1]
"sensor.rotate" = [0.03, -0.02, 0.04]
[[parameter]]
name = "sensor.translate"
[[parameter]]
name = "sensor.rotate"
lr = 0.01
[optimizer]
lr = 0.03
""",
        100,
        1e-4,
    ),
    # The vertices at the rim of a sheet, from its shadow (figure 12 of the paper): 50 unknowns.
    "flower": ("", "", 150, 1e-4),
    # A texture under a lamp and a sky: 3,072 unknowns.
    "texture": (
        POSE.format(sensors=SENSORS[0], floor=BITMAP),
        """scene = "scene.xml"
[target]
scene = "wanted.xml"
spp = 1024
[[parameter]]
name = "floor_bsdf.reflectance.data"
bounds = [0, 1]
[optimizer]
lr = 0.03
""",
        100,
        1e-4,
    ),
}


def written(name: str, folder: Path, examples: Path) -> str:
    """Writes the files of a job, and returns its text without counts of samples."""
    scene, text, iterations, _ = JOBS[name]
    if name == "flower":
        for file in examples.iterdir():
            if file.is_file():
                (folder / file.name).write_bytes(file.read_bytes())
        lines = (examples / "job.toml").read_text().splitlines()
        dropped = ("spp =", "spp_grad", "iterations", "output", "seed")
        text = "\n".join(line for line in lines if not line.startswith(dropped))
        text = text.replace("[target]\n", "[target]\nspp = 1024\n", 1)
    elif scene:
        (folder / "scene.xml").write_text(scene)
    if name == "texture":
        colours = np.random.default_rng(1).uniform(60, 200, (8, 8, 3))
        blocks = np.kron(colours, np.ones((4, 4, 1)))
        for file, pixels in {"grey.png": np.full((32, 32, 3), 128.0), "wanted.png": blocks}.items():
            Image.fromarray(pixels.astype(np.uint8)).save(folder / file)
        (folder / "wanted.xml").write_text(scene.replace("grey.png", "wanted.png"))
    schedule = "" if "[schedule]" in text else COSINE
    return f"iterations = {iterations}\nimages = 0\nseed = 5\n{text}\n{schedule}"


def seen(scene: cw.Scene, seed: int) -> cw.Image:
    """What the first sensor sees."""
    return cw.render(scene, spp=EVALUATION, seed=seed)


def loss(a: cw.Image, b: cw.Image) -> float:
    """The mean square of differences, less what noise adds."""
    return float(np.mean((a.value - b.value) ** 2 - a.stderr**2 - b.stderr**2))


def wanted_image(capwalk: str, name: str, folder: Path) -> cw.Image:
    """What a job looks for."""
    if name == "flower":
        scene = cw.load_file(folder / "scene.xml", occluder="flower.obj")
    elif name == "texture":
        scene = cw.load_file(folder / "wanted.xml")
    else:
        # A job that starts there, and takes no step.
        job = (folder / "job.toml").read_text()
        for key, value in tomllib.loads(job)["target"]["set"].items():
            job = job.replace(f'name = "{key}"', f'name = "{key}"\nstart = {value}')
        (folder / "wanted.toml").write_text(re.sub("(?m)^iterations = .*$", "iterations = 0", job))
        subprocess.run([capwalk, "optimize", str(folder / "wanted.toml")], capture_output=True)
        scene = cw.load_file(folder / "wanted.out/scene.xml")
    return seen(scene, 7)


def measured(
    capwalk: str, name: str, examples: Path, counts: str, more: str
) -> list[tuple[int, float, float, float]]:
    """After every few iterations: samples of images and gradients, seconds, and the true loss."""
    with tempfile.TemporaryDirectory() as path:
        folder = Path(path)
        text = written(name, folder, examples)
        job, out = folder / "job.toml", folder / "job.out"
        spp, _, spp_grad = counts.partition(":")
        job.write_text(f"spp = {spp}\nspp_grad = {spp_grad or spp}\n{text}\n{more}")
        wanted = wanted_image(capwalk, name, folder)
        pixels = wanted.value[..., 0].size * max(text.count("[[view]]"), 1)
        found = []
        while True:
            command = [capwalk, "optimize", str(job), "--json", "--resume", "--threads", "1"]
            command += ["--pause-after", str(EVERY)]
            done = subprocess.run(command, capture_output=True, text=True)
            if done.returncode != 0:
                raise SystemExit(f"{name}: {done.stderr}")
            with (out / "record.csv").open() as file:
                rows = [row for row in csv.DictReader(file) if row["step_norm"]]
            samples = sum(int(row["spp"]) + int(row["spp_grad"]) for row in rows) * pixels
            with (out / "timing.csv").open() as file:
                seconds = sum(float(row["seconds"]) for row in csv.DictReader(file))
            scene = cw.load_file(out / "scene.xml")
            found.append((samples, seconds, loss(seen(scene, 11), wanted), len(rows)))
            stopped = json.loads(done.stdout)["stopped"]
            if not stopped.startswith("paused"):
                print(f"  {name}, {counts} {more!r}: {stopped}", flush=True)
                return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("capwalk")
    parser.add_argument("--jobs", nargs="+", default=list(JOBS))
    parser.add_argument("--spp", nargs="*", default=["2", "4", "16", "32:2"])
    parser.add_argument("--theta", nargs="+", type=float, default=[0.9])
    chosen = parser.parse_args()
    examples = Path(__file__).parents[2] / "examples/jobs/flower"
    print("| job | samples per pixel | million samples to the level | seconds | loss at the end | steps |")
    print("|---|---|---|---|---|---|")
    for name in chosen.jobs:
        level = JOBS[name][3]
        ways = [(spp, "") for spp in chosen.spp]
        ways += [("4", f"[samples]\ntheta = {t}") for t in chosen.theta]
        for spp, more in ways:
            found = measured(chosen.capwalk, name, examples, spp, more)
            # Below the level for good.
            above = [i for i, (_, _, loss, _) in enumerate(found) if loss > level]
            first = above[-1] + 1 if above else 0
            reached = "- | -"
            if first < len(found):
                reached = f"{found[first][0] / 1e6:.3g} | {found[first][1]:.2f}"
            way = more.splitlines()[1] if more else spp
            print(f"| {name} | {way} | {reached} | {found[-1][2]:.2e} | {found[-1][3]} |", flush=True)


if __name__ == "__main__":
    main()

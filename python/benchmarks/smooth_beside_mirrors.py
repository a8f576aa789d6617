"""Finely tessellated shapes that move beside mirrors and panes, or before a mirror that moves: the variance of the derivative by seed.

    python python/benchmarks/smooth_beside_mirrors.py CAPWALK [--seeds N] [--size W H] [--spp N]
        [--check N] [--scenes NAME ...] [--methods NAME ...]

CAPWALK is the program. Each line is one scene and method: the median of the variance per sample over the
seeds, the smallest and the largest, the mean derivative of the image with its spread over the seeds, and
the factor from the gradient to central differences by a check of N samples per pixel, with its verdict."""

from __future__ import annotations

import argparse
import json
import math
import subprocess
import tempfile
from pathlib import Path
from statistics import mean, median, stdev
from typing import Any

HEAD = """<scene version="3.0.0">
<integrator type="path"><integer name="max_depth" value="3"/></integrator>
<sensor type="perspective">
  <float name="fov" value="36"/>
  <transform name="to_world"><lookat origin="1.5, 2.6, 5" target="0, 0.6, -0.6" up="0, 1, 0"/></transform>
  <film type="hdrfilm"><rfilter type="box"/></film>
  <sampler type="independent"/>
</sensor>
"""
DIFFUSE = '<bsdf type="diffuse"><rgb name="reflectance" value="{}"/></bsdf>'
MIRROR = '<bsdf type="conductor"><string name="material" value="none"/></bsdf>'
METAL = '<bsdf type="roughconductor"><string name="material" value="none"/><float name="alpha" value="0.2"/></bsdf>'
BLUE = DIFFUSE.format("0.2, 0.4, 0.7")
EMITTER = '<emitter type="area"><rgb name="radiance" value="40"/></emitter>'
SKY = '<emitter type="constant"><rgb name="radiance" value="0.5, 0.65, 0.9"/></emitter>\n'


def shape(kind: str, name: str, place: str, rest: str) -> str:
    """A shape, placed by what is inside of its transform."""
    return f'<shape type="{kind}" id="{name}"><transform name="to_world">{place}</transform>{rest}</shape>\n'


def floor(material: str) -> str:
    """A wide floor."""
    return shape("rectangle", "floor", '<scale value="3"/><rotate x="1" angle="-90"/><translate z="2"/>', material)


def wall(name: str, turn: str = "", place: str = "", width: str = "2, 0.6, 1", height: float = 0.8, z: float = -2) -> str:
    """An upright mirror behind the ball."""
    move = f'<translate y="{height}" z="{z}"/>'
    return shape("rectangle", name, f'<scale value="{width}"/>{turn}{move}{place}', MIRROR)


def ball(height: float = 0.8) -> str:
    """A ball of 60,500 triangles."""
    return shape("sphere", "ball", f'<scale value="0.5"/><translate y="{height}"/>', BLUE)


GREY_FLOOR = floor(DIFFUSE.format("0.6, 0.6, 0.55"))
LIGHT = shape("rectangle", "lamp", '<scale value="0.5"/><rotate x="1" angle="90"/><translate x="-1" y="5"/>', EMITTER)
SIDE = wall("side", '<rotate y="1" angle="55"/>', '<translate x="-2.2" z="1.2"/>')
PANE = shape(
    "rectangle",
    "pane",
    '<scale value="0.8"/><rotate y="1" angle="90"/><translate x="-0.9" y="0.9"/>',
    '<bsdf type="thindielectric"/>',
)
CYLINDER = (
    '<shape type="cylinder" id="ball"><point name="p0" value="-0.4, 0.6, 0.2"/><point name="p1" value="0.4, 1, -0.2"/>'
    f'<float name="radius" value="0.35"/>{BLUE}</shape>\n'
)
WAVY = '<shape type="obj" id="ball"><string name="filename" value="wavy.obj"/>' + BLUE + "</shape>\n"

SCENES = {
    "mirror behind (the tutorial's)": GREY_FLOOR + wall("mirror") + ball() + LIGHT,
    "pane beside": GREY_FLOOR + PANE + ball() + LIGHT,
    "mirror as floor, sky": floor(MIRROR) + ball() + SKY,
    "mirror as wall": GREY_FLOOR + wall("mirror", width="3, 1.5, 1", height=1.5, z=-1) + ball() + LIGHT,
    "cylinder": GREY_FLOOR + wall("mirror") + CYLINDER + LIGHT,
    "on the floor": GREY_FLOOR + wall("mirror") + ball(0.5) + LIGHT,
    "two mirrors": GREY_FLOOR + wall("mirror") + SIDE + ball() + LIGHT,
    "wavy ball": GREY_FLOOR + wall("mirror") + WAVY + LIGHT,
    "rough metal as floor": floor(METAL) + wall("mirror") + ball() + LIGHT,
    "mirror turns": GREY_FLOOR + wall("mirror") + ball() + LIGHT,
}

MOVES = {"mirror turns": "mirror.rotate.y"}
"""What moves, where it is not the ball."""

ROWS, COLUMNS = 126, 254
"""Of the wavy ball: 64,000 triangles or so."""


def wavy() -> str:
    """A ball with waves, and so with hollows, as an OBJ file with normals."""

    def place(row: int, column: int) -> tuple[float, float, float]:
        polar, turn = math.pi * row / ROWS, 2.0 * math.pi * column / COLUMNS
        x, y, z = math.sin(polar) * math.cos(turn), math.cos(polar), math.sin(polar) * math.sin(turn)
        radius = 0.45 * (1.0 + 0.12 * math.sin(7.0 * x) * math.cos(6.0 * y) * math.sin(5.0 * z + 1.0))
        return radius * x, radius * y, radius * z

    def subtract(a: tuple[float, ...], b: tuple[float, ...]) -> list[float]:
        return [p - q for p, q in zip(a, b)]

    inner = range(1, ROWS)
    points = [place(0, 0), *(place(row, column) for row in inner for column in range(COLUMNS)), place(ROWS, 0)]
    at = lambda row, column: 1 + (row - 1) * COLUMNS + column % COLUMNS  # noqa: E731
    last = len(points) - 1
    faces = [(0, at(1, column + 1), at(1, column)) for column in range(COLUMNS)]
    for row in range(1, ROWS - 1):
        for column in range(COLUMNS):
            a, b, c, d = at(row, column), at(row, column + 1), at(row + 1, column), at(row + 1, column + 1)
            faces += [(a, b, c), (b, d, c)]
    faces += [(last, at(ROWS - 1, column), at(ROWS - 1, column + 1)) for column in range(COLUMNS)]
    normals = [[0.0, 0.0, 0.0] for _ in points]
    for a, b, c in faces:
        (ux, uy, uz), (vx, vy, vz) = subtract(points[b], points[a]), subtract(points[c], points[a])
        for corner in (a, b, c):
            for axis, part in enumerate((uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)):
                normals[corner][axis] += part
    lines = [f"v {x:.9g} {y + 0.8:.9g} {z:.9g}" for x, y, z in points]
    lines += ["vn {:.9g} {:.9g} {:.9g}".format(*(part / math.hypot(*normal) for part in normal)) for normal in normals]
    lines += ["f " + " ".join(f"{i + 1}//{i + 1}" for i in face) for face in faces]
    return "\n".join(lines) + "\n"


def main() -> None:
    """Measures what is asked for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("capwalk", type=Path)
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--size", type=int, nargs=2, default=[48, 36])
    parser.add_argument("--spp", type=int, default=32)
    parser.add_argument("--check", type=int, default=128)
    parser.add_argument("--scenes", nargs="*", default=list(SCENES))
    parser.add_argument("--methods", nargs="*", default=["auto", "walk", "edges"])
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "wavy.obj").write_text(wavy())
        for scene in chosen.scenes:
            file = Path(folder, "scene.xml")
            file.write_text(HEAD + SCENES[scene] + "</scene>\n")
            for method in chosen.methods:

                def result_of(command: str, samples: int, seed: int, scene: str = scene, file: Path = file, method: str = method) -> dict[str, Any]:
                    """What a command says of the scene; exit status 1 and 2 are verdicts."""
                    words = [command, file, "-p", MOVES.get(scene, "ball.translate.x"), "--method", method, "--seed", seed, "--threads", 1]
                    words += ["--size", "{}x{}".format(*chosen.size), "--spp", samples, "--json"]
                    words += ["-o", Path(folder, "out.exr")]
                    run = subprocess.run([chosen.capwalk, *map(str, words)], capture_output=True, text=True)
                    if run.returncode not in (0, 1, 2):
                        raise SystemExit(run.stderr)
                    answer: dict[str, Any] = json.loads(run.stdout)
                    return answer

                found = []
                for seed in range(1, chosen.seeds + 1):
                    result = result_of("gradient", chosen.spp, seed)
                    found.append((result["variance_per_sample"], mean(result["mean_gradient"])))
                checked = result_of("check", chosen.check, 1)["comparison"]
                known = [checked["scale_factor"], checked["scale_factor_error"]]
                factor, error = ("-" if number is None else f"{number:.3f}" for number in known)
                variances, means = zip(*found)
                spread = stdev(means) if len(means) > 1 else math.nan
                print(
                    f"| {scene} | {method} | {median(variances):.3g} | {min(variances):.3g} to {max(variances):.3g} "
                    f"| {mean(means):.5f} ± {spread:.5f} | {factor} ± {error}, {checked['verdict']} |",
                    flush=True,
                )


if __name__ == "__main__":
    main()

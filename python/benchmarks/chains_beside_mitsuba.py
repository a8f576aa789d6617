"""What moves and is seen in a mirror ball or through a glass ball: capwalk's derivative beside
central differences of Mitsuba's images, and beside Mitsuba's own derivative.

    python python/benchmarks/chains_beside_mitsuba.py CAPWALK [--scenes NAME ...] [--runs N]
        [--spp N] [--mitsuba-spp N] [--step H] [--figure FILE.png]

CAPWALK is the program; Mitsuba is the package `mitsuba`, in the variant `llvm_ad_rgb`. Both read the
same files. Prints a table in Markdown, from N runs of each with random numbers of their own: the
factors from capwalk's derivative to differences of Mitsuba's `path` and to the derivative of
`prb_projective`, which gets a quarter of the samples, and the mean z² between derivative and
differences. The steps are those of the scenes, times H. With `--figure`, the scene `FIGURE` is drawn
instead, by the means over all runs, with CPU seconds and errors; differences have four times the runs,
and `prb_projective` has no guiding. This needs the package `matplotlib`."""

from __future__ import annotations

import argparse
import os
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import drjit as dr
import mitsuba as mi
import numpy as np

HEAD = """<scene version="3.0.0">
<default name="move" value="0"/>
<integrator type="path"><integer name="max_depth" value="{depth}"/><integer name="rr_depth" value="100"/></integrator>
<sensor type="perspective" id="sensor">
  <float name="fov" value="{fov}"/>
  <transform name="to_world"><lookat origin="{eye}" target="{target}" up="{up}"/>{move}</transform>
  <film type="hdrfilm">
    <integer name="width" value="{width}"/><integer name="height" value="{height}"/>
    <rfilter type="box"/>
  </film>
  <sampler type="independent"/>
</sensor>
"""
MOVE = '<translate x="$move"/>'
MIRROR = '<bsdf type="conductor"><string name="material" value="none"/></bsdf>'
GLASS = '<bsdf type="dielectric"><float name="int_ior" value="1.5"/></bsdf>'
LIGHT = '<emitter type="area"><rgb name="radiance" value="6, 5.5, 5"/></emitter>'


def diffuse(colour: str) -> str:
    return f'<bsdf type="diffuse"><rgb name="reflectance" value="{colour}"/></bsdf>'


def shape(kind: str, name: str, place: str, rest: str) -> str:
    """A shape of Mitsuba's, or one from a file, placed by what is inside of its transform."""
    file = f'<string name="filename" value="{kind}"/>' if kind.endswith(".ply") else ""
    kind = "ply" if file else kind
    return f'<shape type="{kind}" id="{name}">{file}<transform name="to_world">{place}</transform>{rest}</shape>\n'


def ball(name: str, material: str, radius: float, centre: str, move: str = "") -> str:
    return shape("ball.ply", name, f'<scale value="{radius}"/><translate value="{centre}"/>{move}', material)


def cube(name: str, colour: str, size: float, centre: str, move: str = "") -> str:
    turned = f'<scale value="{size}"/><rotate y="1" angle="25"/><translate value="{centre}"/>{move}'
    return shape("cube", name, turned, diffuse(colour))


def sky(radiance: str) -> str:
    return f'<emitter type="constant"><rgb name="radiance" value="{radiance}"/></emitter>\n'


FLOOR = shape("rectangle", "floor", '<scale value="5"/><rotate x="1" angle="-90"/>', diffuse("0.6, 0.6, 0.55"))
LAMP = shape("rectangle", "lamp", '<rotate x="1" angle="90"/><translate x="-1" y="4" z="1"/>', LIGHT)
LAMPLIGHT = FLOOR + LAMP + sky("0.35, 0.4, 0.5")
DAYLIGHT = FLOOR + sky("0.9, 0.95, 1")
RED, BLUE = "0.75, 0.2, 0.1", "0.15, 0.3, 0.7"


class Scene(NamedTuple):
    """What both renderers read."""

    moves: str
    """What moves along x."""
    step: float
    """Moves nothing in the image by more than a part of a pixel."""
    camera: dict[str, Any]
    content: str
    size: tuple[int, int] = (48, 36)
    depth: int = 4

    def text(self) -> str:
        move = MOVE if self.moves == "sensor" else ""
        width, height = self.size
        head = HEAD.format(width=width, height=height, depth=self.depth, move=move, **self.camera)
        return f"{head}{self.content}</scene>\n"


NEAR = {"fov": 24, "eye": "0, 1.6, 3.3", "target": "0, 1, 0", "up": "0, 1, 0"}
"""A ball of radius 1 fills the image."""
TILTED = NEAR | {"up": "0.3, 1, 0"}
"""No edge is in line with the borders of pixels, where differences blur most."""
MIDDLE = "0, 1.05, 0"
THINGS = cube("cube", RED, 0.5, "-0.6, 0.5, -1.8") + ball("round", diffuse(BLUE), 0.4, "1.3, 0.4, -1.2")
SCENES = {
    "cube before a mirror ball": Scene(
        "cube",
        2e-3,
        NEAR,
        LAMPLIGHT + ball("ball", MIRROR, 1, MIDDLE) + cube("cube", RED, 0.3, "1.1, 1, 1.7", MOVE),
    ),
    "camera before a mirror ball": Scene(
        "sensor",
        5e-4,
        NEAR,
        LAMPLIGHT
        + ball("ball", MIRROR, 1, MIDDLE)
        + cube("cube", RED, 0.3, "1.1, 1, 1.7")
        + ball("round", diffuse(BLUE), 0.4, "-1.2, 0.5, 1.5"),
    ),
    "cube inside a glass ball": Scene(
        "cube",
        1e-4,
        TILTED,
        DAYLIGHT + ball("ball", GLASS, 1, MIDDLE) + cube("cube", RED, 0.25, "0.15, 1, 0.1", MOVE),
    ),
    "glass ball before things": Scene("ball", 1e-4, TILTED, DAYLIGHT + ball("ball", GLASS, 1, MIDDLE, MOVE) + THINGS),
}
FIGURE = Scene(
    "star",
    2e-3,
    {"fov": 31, "eye": "0.2, 2.2, 6.2", "target": "0.15, 0.62, 0", "up": "0, 1, 0"},
    FLOOR
    + LAMP
    + sky("0.5, 0.6, 0.75")
    + shape("rectangle", "wall", '<scale value="6"/><translate z="-3"/>', diffuse("0.75, 0.62, 0.4"))
    + ball("mirror", MIRROR, 0.9, "-0.75, 0.9, -0.4")
    + ball("glass", GLASS, 0.42, "0.85, 0.42, 1.5")
    + shape(
        "star.ply",
        "star",
        f'<scale value="0.55"/><rotate y="1" angle="-35"/><translate value="0.65, 0.6, 0.1"/>{MOVE}',
        f'<bsdf type="twosided">{diffuse(RED)}</bsdf>',
    )
    + cube("other", BLUE, 0.4, "1.75, 0.4, -0.9"),
    (192, 144),
    5,
)
"""What moves is flat, so that `prb_projective` is right where the camera sees it directly. Of a
cube whose faces share vertices it loses the edges between two faces in view."""


def ball_file(rows: int = 64, columns: int = 128) -> str:
    """A ball of radius 1 with normals, in the format PLY."""
    polar = np.pi * np.arange(1, rows)[:, None] / rows
    turn = 2 * np.pi * np.arange(columns)[None] / columns
    inner = np.stack([np.sin(polar) * np.cos(turn), np.cos(polar) + 0 * turn, np.sin(polar) * np.sin(turn)], -1)
    points = np.concatenate([inner.reshape(-1, 3), [[0, 1, 0], [0, -1, 0]]])
    j, k = np.arange(columns), (np.arange(columns) + 1) % columns
    last = (rows - 2) * columns
    top, bottom = np.full(columns, len(points) - 2), np.full(columns, len(points) - 1)
    faces = [np.stack([top, k, j], -1), np.stack([bottom, last + j, last + k], -1)]
    for row in range(0, last, columns):
        a, b, c, d = row + j, row + k, row + columns + j, row + columns + k
        faces += [np.stack([a, b, c], -1), np.stack([b, d, c], -1)]
    return ply(points, points, np.concatenate(faces))


def star_file() -> str:
    """A flat star with five points of radius 1."""
    turn = np.pi / 5 * np.arange(10)
    radius = np.where(np.arange(10) % 2 == 0, 1, 0.5)
    corners = np.stack([radius * np.sin(turn), radius * np.cos(turn), 0 * turn], -1)
    points = np.concatenate([corners, [[0, 0, 0]]])
    normals = np.tile([0, 0, 1], (11, 1))
    return ply(points, normals, np.array([[10, (corner + 1) % 10, corner] for corner in range(10)]))


def ply(points: np.ndarray, normals: np.ndarray, triangles: np.ndarray) -> str:
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}"]
    lines += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    lines += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]
    lines += [" ".join(f"{number:.9g}" for number in row) for row in np.hstack([points, normals])]
    lines += ["3 {} {} {}".format(*face) for face in triangles]
    return "\n".join(lines) + "\n"


def derivative(capwalk: str, file: Path, scene: Scene, spp: int, seed: int) -> np.ndarray:
    """capwalk's."""
    output = file.with_suffix(".npz")
    words = [capwalk, "gradient", file, "-p", f"{scene.moves}.translate.x", "--spp", spp, "--seed", seed]
    done = subprocess.run(
        [str(word) for word in [*words, "--threads", 1, "-o", output]], check=False, capture_output=True, text=True
    )
    if done.returncode != 0:
        raise SystemExit(done.stderr)
    return np.load(output)["gradient"].astype(float)


def difference(file: Path, step: float, spp: int, seed: int) -> np.ndarray:
    """The central difference of Mitsuba's images, with the same random numbers on both sides."""
    sides = [mi.load_file(str(file), move=str(place)) for place in (step, -step)]
    right, left = (np.array(mi.render(side, spp=spp, seed=seed), dtype=float) for side in sides)
    return (right - left) / (2 * step)


def projective(file: Path, scene: Scene, spp: int, seed: int, guiding: str = "octree") -> np.ndarray:
    """The derivative of a shape's motion by `prb_projective`."""
    loaded = mi.load_file(str(file))
    params = mi.traverse(loaded)
    key = f"{scene.moves}.vertex_positions"
    amount = mi.Float(0)
    dr.enable_grad(amount)
    params[key] = dr.ravel(dr.unravel(mi.Point3f, params[key]) + mi.Vector3f(amount, 0, 0))
    params.update()
    integrator = mi.load_dict({"type": "prb_projective", "max_depth": scene.depth, "rr_depth": 100, "guiding": guiding})
    image = mi.render(loaded, params, integrator=integrator, spp=spp, seed=seed, seed_grad=seed + 100_000)
    dr.forward(amount)
    return np.array(dr.grad(image), dtype=float)


def variance(runs: np.ndarray) -> np.ndarray:
    """That of the mean over the runs, of each pixel."""
    return runs.var(axis=0, ddof=1) / len(runs)


def around(noise: np.ndarray) -> np.ndarray:
    """The mean of variances in the 5 × 5 pixels around each: that of a single one depends on what it saw."""
    padded = np.pad(noise, ((2, 2), (2, 2), (0, 0)), mode="edge")
    return np.lib.stride_tricks.sliding_window_view(padded, (5, 5), (0, 1)).mean(axis=(-1, -2))


def weights(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    noise = around(variance(a) + variance(b))
    return 1 / (noise + 1e-3 * noise.mean())


def factor(a: np.ndarray, b: np.ndarray, weight: np.ndarray) -> tuple[float, float]:
    """The factor from one image to another, and its standard error by the jackknife over runs."""

    def of(a: np.ndarray, b: np.ndarray) -> float:
        # Products of a run with itself would count the noise of the derivative as part of it.
        products = np.sum(weight * a.sum(axis=0) ** 2) - np.sum(weight * a**2)
        return float(np.sum(weight * a.mean(axis=0) * b.mean(axis=0)) * len(a) * (len(a) - 1) / products)

    without = [of(np.delete(a, i, axis=0), np.delete(b, i, axis=0)) for i in range(len(a))]
    return of(a, b), float(np.sqrt((len(a) - 1) * np.var(without)))


def written(numbers: tuple[float, float]) -> str:
    return "{:.4f} ± {:.4f}".format(*numbers)


def errors(runs: np.ndarray, differences: np.ndarray) -> tuple[float, float]:
    """The root mean square error of the mean over the runs, less the noise of the differences, and that of noise alone;
    both over the root mean square of the differences."""
    noise = variance(differences).sum()
    squares = (differences.mean(axis=0) ** 2).sum() - noise
    error = ((runs.mean(axis=0) - differences.mean(axis=0)) ** 2).sum() - noise
    return float(np.sqrt(error / squares)), float(np.sqrt(variance(runs).sum() / squares))


def mean_z2(a: np.ndarray, b: np.ndarray) -> str:
    """Squared differences over their variances, both summed over the image before they are divided."""
    weight, expected = weights(a, b), variance(a) + variance(b)
    squares = (a.mean(axis=0) - b.mean(axis=0)) ** 2
    mean = np.sum(weight * squares) / np.sum(weight * expected)
    # Channels come from the same samples.
    off = np.sum(weight * (squares - mean * expected), axis=-1)
    return f"{mean:.2f} ± {np.sqrt(np.sum(off**2)) / np.sum(weight * expected):.2f}"


def cpu_seconds() -> float:
    """Of this process and of those that it waited for."""
    return sum(os.times()[:4])


def timed(run: Callable[[int], np.ndarray], seeds: range) -> tuple[np.ndarray, float]:
    """Means over the channels of all runs, and their CPU seconds, without a first run that compiles kernels."""
    run(0)
    start = cpu_seconds()
    runs = np.array([run(seed).mean(axis=-1, keepdims=True) for seed in seeds])
    return runs, cpu_seconds() - start


def balls(file: Path) -> np.ndarray:
    """The pixels of `FIGURE` whose centres see one of the balls."""
    loaded = mi.load_file(str(file))
    width, height = FIGURE.size
    column, row = np.meshgrid((np.arange(width) + 0.5) / width, (np.arange(height) + 0.5) / height)
    rays, _ = loaded.sensors()[0].sample_ray(0, 0, mi.Point2f(column.ravel(), row.ravel()), mi.Point2f(0.5))
    hit = loaded.ray_intersect(rays).shape
    seen = [hit == mi.ShapePtr(shape) for shape in loaded.shapes() if shape.id() in ("mirror", "glass")]
    return np.array(seen[0] | seen[1]).reshape(height, width)


def figure(capwalk: str, file: Path, runs: int, spp: int, mitsuba_spp: int, step: float, output: Path) -> None:
    """Draws `FIGURE`, and prints the numbers of its labels."""
    file.write_text(FIGURE.text())
    differences, spent = timed(lambda seed: difference(file, step, mitsuba_spp, seed), range(1, 4 * runs + 1))
    differences = differences.reshape(runs, 4, *differences.shape[1:]).mean(axis=1)
    # Weights from the noise of a derivative would favour runs that missed its rare large samples.
    in_balls = balls(file)[..., None] * weights(differences, differences)
    said = ["of Mitsuba's images,", f"{spent:.0f} CPU s: the reference"]
    panels = [("Finite differences", said, differences.mean(axis=0))]
    for name, run in {
        "Mitsuba, prb_projective": lambda seed: projective(file, FIGURE, mitsuba_spp // 4, seed, guiding="none"),
        "capwalk": lambda seed: derivative(capwalk, file, FIGURE, spp, seed),
    }.items():
        found, spent = timed(run, range(1, runs + 1))
        (error, noise), part = errors(found, differences), factor(differences, found, in_balls)
        print(f"{name}: {spent:.0f} CPU s, error {error:.3f}, of noise {noise:.3f}, found in the balls {written(part)}")
        said = [
            f"{spent:.0f} CPU s, error {100 * error:.0f} %",
            f"found in balls: {round(100 * part[0])} ± {round(100 * part[1])} %",
        ]
        panels.append((name, said, found.mean(axis=0)))
    noise = np.sqrt(variance(differences).sum() / (differences.mean(axis=0) ** 2).sum())
    print(f"noise of the differences: {noise:.3f}")
    image = mi.Bitmap(mi.render(mi.load_file(str(file)), spp=mitsuba_spp))
    colours = np.array(image.convert(component_format=mi.Struct.Type.UInt8, srgb_gamma=True))
    draw([("Image", ["The red star moves", "to the right."], colours), *panels], output)


def draw(panels: list[tuple[str, list[str], np.ndarray]], output: Path) -> None:
    """An image, its differences and derivatives side by side, below their names and two lines of text each."""
    from matplotlib import pyplot

    most = float(f"{np.percentile(np.abs(panels[1][2]), 99):.1g}")
    height, width = panels[0][2].shape[:2]
    pad, bar, text, dots = 6, 40, 50, 100
    whole = np.array([len(panels) * (width + pad) + bar, height + text + pad])
    drawn = pyplot.figure(figsize=tuple(whole / dots), dpi=2 * dots)

    def place(left: float, wide: float) -> Any:
        axes = drawn.add_axes((left / whole[0], pad / whole[1], wide / whole[0], height / whole[1]))
        axes.tick_params(labelsize=8, length=2, pad=1, width=0.5)
        return axes

    for number, (name, said, panel) in enumerate(panels):
        axes = place(pad / 2 + number * (width + pad), width)
        axes.set(xticks=[], yticks=[])
        axes.text(0, 1 + 35 / height, name, fontsize=9.5, weight="bold", transform=axes.transAxes)
        for above, line in zip((20, 5), said, strict=True):
            axes.text(0, 1 + above / height, line, fontsize=9, transform=axes.transAxes)
        shown = axes.imshow(panel, cmap=pyplot.get_cmap("RdBu_r", 33), vmin=-most, vmax=most, interpolation="nearest")
    place_of_bar = place(len(panels) * (width + pad) + 1, 7)
    drawn.colorbar(shown, cax=place_of_bar, ticks=[-most, 0, most]).outline.set_linewidth(0.5)
    drawn.savefig(output, pil_kwargs={"optimize": True})


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("capwalk")
    parser.add_argument("--scenes", nargs="*", default=list(SCENES), choices=list(SCENES), metavar="NAME")
    parser.add_argument("--runs", type=int, default=20)
    parser.add_argument("--spp", type=int, default=128)
    parser.add_argument("--mitsuba-spp", type=int, default=2048)
    parser.add_argument("--step", type=float, default=1.0)
    parser.add_argument("--figure", type=Path)
    chosen = parser.parse_args()
    mi.set_variant("llvm_ad_rgb")
    mi.set_log_level(mi.LogLevel.Error)
    dr.set_thread_count(1)
    seeds, spp = range(1, chosen.runs + 1), chosen.mitsuba_spp
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "ball.ply").write_text(ball_file())
        Path(folder, "star.ply").write_text(star_file())
        file = Path(folder, "scene.xml")

        def found(scene: Scene) -> tuple[np.ndarray, np.ndarray]:
            """Runs of capwalk's derivative, and of differences."""
            file.write_text(scene.text())
            ours = [derivative(chosen.capwalk, file, scene, chosen.spp, seed) for seed in seeds]
            differences = [difference(file, chosen.step * scene.step, spp, seed) for seed in seeds]
            return np.array(ours), np.array(differences)

        if chosen.figure:
            figure(chosen.capwalk, file, chosen.runs, chosen.spp, spp, chosen.step * FIGURE.step, chosen.figure)
            return
        print("| scene | moves | to differences | mean z² | to `prb_projective` |\n|---|---|---|---|---|")
        for name in chosen.scenes:
            scene = SCENES[name]
            ours, differences = found(scene)
            last = "-"
            if scene.moves != "sensor":
                theirs = np.array([projective(file, scene, spp // 4, seed) for seed in seeds])
                last = written(factor(ours, theirs, weights(ours, theirs)))
            first = written(factor(ours, differences, weights(ours, differences)))
            row = [name, scene.moves, first, mean_z2(ours, differences), last]
            print(f"| {' | '.join(row)} |", flush=True)


if __name__ == "__main__":
    main()

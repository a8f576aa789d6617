"""A bunny, a cube and a vase that move upwards and are seen in a rough mirror: errors of derivative images
after equal times, in the manner of "Quadric-Based Silhouette Sampling for Differentiable Rendering"
(Soroka, Peters and Marschner, ACM Transactions on Graphics 44, 4, 2025).

    python python/benchmarks/quadric.py CAPWALK [--scenes NAME ...] [--seconds S] [--size WxH] [--alpha A]
        [--mesh FILE] [--seed-spp N] [--without-mitsuba] [--figure FOLDER]

CAPWALK is the program; the package `capwalk` reads and writes meshes. If there is a package `mitsuba`, the
derivatives of its `prb_projective` are measured as well, in the variant `llvm_ad_rgb`. Prints a table in
Markdown; with `--figure` (needs the package `matplotlib`) writes a strip of images for each scene.

What is known of their scenes is from the supplemental page
(mariasoroka.github.io/papers/Data/EdgeSamplingSupplemental/results.html) and from an issue of the first
author's (github.com/mitsuba-renderer/mitsuba3/issues/1648): "a uniformly colored diffuse object is placed in
front of a slightly rough mirror, and the camera observes the object's reflection"; derivatives are "with
respect to vertical translation". Their renderer is a fork of redner, and their table is `THEIRS`. What is a
guess: the meshes (see `MESHES`), the roughness and the place of the mirror, emitters, camera, units, the
number of pixels and the length of paths. Their errors have the unit of an unknown scale, and their times are
those of an unknown machine: neither compares with ours.

Times are seconds of the CPU, with one thread. capwalk's include start, reading, trees and the pilot. A short
run estimates how many samples fit, so its time may differ from S; one column has error times seconds.
Mitsuba's are those of `render_forward` alone; loading, compiling and building the guiding structure are
apart, under "set-up". Its derivatives are means over passes of 2^18 boundary samples and a quarter as many of
the interior, the proportion in the example of its documentation. None are of primary boundaries, because
nothing that moves is seen directly. Each guiding is tried for a sixteenth of the time. The one that would have
the least error after the whole time is used, biased or not; comments in the output have errors and biases.

Errors are mean squared differences, over pixels and channels, from central differences, which take half the
time: of images by Mitsuba's `path` where there is Mitsuba, else by capwalk. So the reference shares no
derivative with either. Its noise is known from its passes and taken off; its step is a small part of what the
mirror blurs. The factor from a derivative to the differences and the mean z² are of the green channel."""

from __future__ import annotations

import argparse
import os
import subprocess
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import capwalk as cw
import numpy as np
from bunny import bunny as round_bunny

THEIRS = {"bunny": (128, 0.04, 32.72, 130), "cube": (128, 0.10, 45.33, 140), "vase": (128, 0.06, 47.60, 126)}
"""Samples, mean squared errors of theirs and of edge sampling of 2019, and about how many seconds."""

HEIGHT = 2.0
"""Of all objects."""

SCENE = """<scene version="3.0.0">
<default name="move" value="0"/>
<integrator type="path"><integer name="max_depth" value="3"/><integer name="rr_depth" value="100"/></integrator>
<sensor type="perspective">
  <float name="fov" value="36"/>
  <transform name="to_world"><lookat origin="2.2, 0.9, 2.2" target="0, 0.4, 0" up="0, 1, 0"/></transform>
  <film type="hdrfilm">
    <integer name="width" value="{width}"/><integer name="height" value="{height}"/><rfilter type="box"/>
  </film>
  <sampler type="independent"/>
</sensor>
<shape type="rectangle" id="mirror">
  <transform name="to_world"><scale x="2.5" y="1.6"/></transform>
  <bsdf type="roughconductor">
    <string name="material" value="none"/><string name="distribution" value="ggx"/>
    <float name="alpha" value="{alpha}"/>
  </bsdf>
</shape>
<shape type="ply" id="thing">
  <string name="filename" value="thing.ply"/>
  <transform name="to_world"><translate x="-1.8" y="$move" z="1.8"/></transform>
  <bsdf type="diffuse"><rgb name="reflectance" value="0.7, 0.4, 0.2"/></bsdf>
</shape>
<shape type="rectangle" id="lamp">
  <transform name="to_world"><rotate x="1" angle="90"/><translate x="-1" y="3.5" z="2.4"/></transform>
  <emitter type="area"><rgb name="radiance" value="6"/></emitter>
</shape>
<emitter type="constant"><rgb name="radiance" value="0.4"/></emitter>
</scene>
"""
"""The camera sees nothing but the mirror, which reflects the object and the sky."""

Triangles = tuple[np.ndarray, np.ndarray]
"""Vertices and faces."""


def grid(rows: int, columns: int, is_ring: bool = False) -> np.ndarray:
    """Two triangles for each square of a grid of vertices; a ring's last column is joined to its first."""
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns if is_ring else columns - 1), indexing="ij")
    right = (j + 1) % columns
    a, b, c, d = i * columns + j, (i + 1) * columns + j, (i + 1) * columns + right, i * columns + right
    return np.concatenate([np.stack(corners, -1).reshape(-1, 3) for corners in [(a, b, c), (a, c, d)]])


def cube(squares: int = 200, bumps: int = 4) -> Triangles:
    """A cube that is turned, with round bumps on its sides: 480,000 triangles."""
    side = np.linspace(0, 1, squares + 1)
    u, v = np.meshgrid(side, side, indexing="ij")
    wave = [np.sin(bumps * np.pi * x) ** 2 for x in (u, v)]
    face = np.stack([2 * u - 1, 2 * v - 1, 1 + 0.12 * wave[0] * wave[1]], -1).reshape(-1, 3)
    sides = [np.roll(face * flip, turn, axis=1) for turn in range(3) for flip in ((1, 1, 1), (-1, 1, -1))]
    squares_of_side = grid(squares + 1, squares + 1)
    faces = np.concatenate([squares_of_side + number * len(face) for number in range(6)])
    # Vertices that sides share become one.
    places = np.round(np.concatenate(sides), 9)
    points, numbers = np.unique(places, axis=0, return_inverse=True)
    a, b = np.radians([35, 20])
    about_y = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
    about_x = np.array([[1, 0, 0], [0, np.cos(b), -np.sin(b)], [0, np.sin(b), np.cos(b)]])
    return points @ (about_x @ about_y).T, numbers.reshape(-1)[faces]


def vase(rows: int = 574, columns: int = 574) -> Triangles:
    """A vase with a wall, closed: a profile turned about the axis, 658,000 triangles."""
    base, outside = rows // 12, rows // 2
    inside = rows - base - outside

    def radius(y: np.ndarray) -> np.ndarray:
        return np.asarray(0.38 + 0.22 * np.cos(3 * (y + 0.4)))

    rising, falling = np.linspace(-1, 1, outside), np.linspace(1, -0.9, inside)
    flat = np.linspace(0, radius(np.array(-1.0)), base + 1)[1:-1]
    inner = np.maximum(radius(falling) - 0.05, 0.02)
    profile = np.concatenate([flat, radius(rising), inner])
    heights = np.concatenate([np.full(len(flat), -1.0), rising, falling])
    turn = np.linspace(0, 2 * np.pi, columns, endpoint=False)[None]
    rings = [profile[:, None] * np.cos(turn), heights[:, None] + 0 * turn, profile[:, None] * np.sin(turn)]
    points = np.concatenate([np.stack(rings, -1).reshape(-1, 3), [[0, -1, 0], [0, -0.9, 0]]])
    j, k, last = np.arange(columns), (np.arange(columns) + 1) % columns, (len(profile) - 1) * columns
    bottom, floor = np.full(columns, len(points) - 2), np.full(columns, len(points) - 1)
    fans = [np.stack([bottom, j, k], -1), np.stack([floor, last + k, last + j], -1)]
    return points, np.concatenate([grid(len(profile), columns, is_ring=True), *fans])


MESHES: dict[str, Callable[[], Triangles]] = {"bunny": round_bunny, "cube": cube, "vase": vase}
"""Made by code. Their table has 0.02, 0.14 and 0.19 s for building the tree of 2019, so cube and vase have
about 7 and 10 times as many triangles as a bunny, of which the usual one has 69,451."""


def read_mesh(file: Path) -> Triangles:
    mesh = cw.load_mesh(file)
    return mesh["positions"], mesh["faces"]


def write_mesh(file: Path, mesh: Triangles) -> None:
    """Writes a mesh, moved to the origin and scaled to its height."""
    points, faces = mesh
    low, high = points.min(axis=0), points.max(axis=0)
    points = (points - (low + high) / 2) * (HEIGHT / (high - low)[1])
    cw.save_mesh(file, {"positions": points, "faces": faces})


class Estimate(NamedTuple):
    """A derivative image, or differences."""

    name: str
    image: np.ndarray
    variance: np.ndarray
    """Of each number of the image, as the program states it or as passes show it."""
    spp: int
    seconds: float
    set_up: float = 0.0
    passes: np.ndarray | None = None


# capwalk.


MOVES = ("-p", "thing.translate.y")
STEP = 0.01
"""Of differences. An object of height 2 is blurred over about a quarter by a roughness of 0.05."""


def gradient(
    capwalk: str, file: Path, method: str, spp: int, seed: int, moves: Sequence[str] = MOVES, step: float = STEP
) -> tuple[float, Any]:
    """Seconds of the CPU, and the file."""
    output = file.with_suffix(".npz")
    words = [capwalk, "gradient", file, *moves, "--method", method, "--spp", spp]
    words += ["--seed", seed, "--threads", 1, "-o", output]
    if method == "fd":
        words += ["--step", step]
    with tempfile.TemporaryFile("w+") as text:
        child = subprocess.Popen([str(word) for word in words], stdout=text, stderr=text)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode != 0:
            text.seek(0)
            raise SystemExit(text.read())
    return usage.ru_utime + usage.ru_stime, np.load(output)


def in_capwalk(
    capwalk: str,
    file: Path,
    method: str,
    seconds: float,
    seed: int,
    moves: Sequence[str] = MOVES,
    step: float = STEP,
) -> tuple[Estimate, np.ndarray]:
    """The derivative after so many seconds, all of the command counted, and the image."""
    few = 2
    start, _ = gradient(capwalk, file, method, few, seed + 1, moves, step)
    spp, spent = few, start
    while spent < start + seconds / 16 and start < seconds:
        spp *= 2
        spent, _ = gradient(capwalk, file, method, spp, seed + 1, moves, step)
    each = max(spent - start, 1e-6) / max(spp - few, 1)
    spp = max(few, round(few + (seconds - start) / each)) if spp > few else few
    spent, found = gradient(capwalk, file, method, spp, seed, moves, step)
    image = found["gradient"].astype(float)
    variance = found["stderr"].astype(float) ** 2
    return Estimate(f"capwalk, `{method}`", image, variance, spp, spent, start), found["value"].astype(float)


# Mitsuba.

GUIDINGS = ["none", "grid", "octree"]
TRIALS = 16
"""The part of the time that each guiding is tried for."""
PASS = 2**18
"""Samples of a whole image."""


class Mitsuba:
    """A scene in Mitsuba, with one thread."""

    key = "thing.vertex_positions"
    """What moves."""

    def __init__(self, file: Path) -> None:
        import drjit as dr
        import mitsuba as mi

        self.dr: Any = dr
        self.mi: Any = mi
        mi.set_variant("llvm_ad_rgb")
        mi.set_log_level(mi.LogLevel.Error)
        dr.set_thread_count(1)
        start = time.process_time()
        self.file = str(file)
        self.scene = mi.load_file(self.file)
        self.params = mi.traverse(self.scene)
        self.sensor = self.scene.sensors()[0]
        self.start = mi.Float(self.params[self.key])
        width, height = self.sensor.film().size()
        self.spp = 4 * max(1, PASS // int(4 * width * height))
        self.loading = time.process_time() - start

    def settings(self) -> dict[str, Any]:
        """Of the integrator."""
        samples = {"sppc": self.spp // 4, "sppp": 0, "sppi": self.spp}
        return {"type": "prb_projective", "max_depth": 3, "rr_depth": 100, **samples}

    def guided(self, guiding: str, seed_spp: int) -> tuple[Any, float]:
        """The integrator with its guiding structure, built once and kept, and the seconds for that."""
        start = time.process_time()
        integrator = self.mi.load_dict({**self.settings(), "guiding": guiding})
        integrator.proj_seed_spp = seed_spp
        self.move()
        integrator.proj_detail.init_indirect_silhouette(self.scene, self.sensor, self.mi.UInt32(77))
        self.dr.eval()
        self.dr.sync_thread()
        integrator.proj_detail.init_indirect_silhouette = lambda *_: None
        self.forward(integrator, 1)
        return integrator, time.process_time() - start

    def move(self) -> Any:
        """The vertices move upwards by a number with a derivative."""
        amount = self.mi.Float(0)
        self.dr.enable_grad(amount)
        moved = self.dr.unravel(self.mi.Point3f, self.start) + self.mi.Vector3f(0, amount, 0)
        self.params[self.key] = self.dr.ravel(moved)
        self.params.update()
        return amount

    def forward(self, integrator: Any, seed: int) -> tuple[float, np.ndarray]:
        """Seconds, and the derivative."""
        amount = self.move()
        self.dr.forward(amount, self.dr.ADFlag.ClearEdges)
        self.dr.eval(self.params[self.key])
        self.dr.sync_thread()
        start = time.process_time()
        found = integrator.render_forward(self.scene, self.params, self.sensor, self.mi.UInt32(seed))
        image = np.array(self.dr.detach(found), dtype=float)
        return time.process_time() - start, image

    def derivative(self, name: str, integrator: Any, set_up: float, seconds: float, seed: int) -> Estimate:
        return repeated(name, lambda seed: self.forward(integrator, seed), self.spp, seconds, seed, set_up)

    def differences(self, seconds: float, seed: int) -> Estimate:
        """Central differences of images, with the same random numbers on both sides."""
        mi = self.mi
        sides = [mi.load_file(self.file, move=str(place)) for place in (STEP, -STEP)]

        def difference(seed: int) -> tuple[float, np.ndarray]:
            start = time.process_time()
            up, down = (np.array(mi.render(side, spp=self.spp, seed=seed), dtype=float) for side in sides)
            return time.process_time() - start, (up - down) / (2 * STEP)

        # Compiles.
        difference(seed - 1)
        return repeated("differences, Mitsuba's `path`", difference, self.spp, seconds, seed)


def repeated(
    name: str,
    one: Callable[[int], tuple[float, np.ndarray]],
    spp: int,
    seconds: float,
    seed: int,
    set_up: float = 0.0,
) -> Estimate:
    """The mean over passes, at least three, until the time is over."""
    times: list[float] = []
    images: list[np.ndarray] = []
    while len(times) < 3 or sum(times) + np.mean(times) / 2 < seconds:
        spent, image = one(seed + len(times))
        times.append(spent)
        images.append(image)
    passes = np.array(images)
    variance = passes.var(axis=0, ddof=1) / len(passes)
    return Estimate(name, passes.mean(axis=0), variance, spp * len(passes), sum(times), set_up, passes)


# Statistics.


def squared_error(found: Estimate, differences: Estimate) -> tuple[float, float]:
    """The mean over the image, without the noise of the differences, and its standard error."""
    squares = np.mean((found.image - differences.image) ** 2 - differences.variance, axis=-1)
    return float(squares.mean()), float(squares.std() / np.sqrt(squares.size))


def bias(found: Estimate, differences: Estimate) -> tuple[float, float]:
    """Relative: the projection on the differences, less one, and its standard error."""
    assert found.passes is not None
    square = np.sum(differences.image**2 - differences.variance)
    sizes = np.sum(found.passes * differences.image, axis=(1, 2, 3)) / square
    own = np.sum(differences.variance * differences.image**2) / square**2
    return float(sizes.mean() - 1), float(np.sqrt(sizes.var(ddof=1) / len(sizes) + own))


def around(noise: np.ndarray) -> np.ndarray:
    """The mean of variances in the 5 × 5 pixels around each: that of a single one depends on what it saw."""
    padded = np.pad(noise, 2, mode="edge")
    return np.asarray(np.lib.stride_tricks.sliding_window_view(padded, (5, 5)).mean(axis=(-1, -2)))


def agreement(found: Estimate, differences: Estimate) -> tuple[str, str]:
    """The best factor from a derivative to differences, without the noise of the derivative, and the mean z²:
    squared differences over their variances, both summed over the image before they are divided."""
    a, b = found.image[..., 1], differences.image[..., 1]
    noise_a, noise_b = found.variance[..., 1], differences.variance[..., 1]
    noise = around(noise_a + noise_b)
    weight = 1 / (noise + 1e-3 * noise.mean())
    size = np.sum(weight * (a**2 - noise_a))
    factor = np.sum(weight * a * b) / size
    error = np.sqrt(np.sum(weight**2 * a**2 * (noise_b + factor**2 * noise_a))) / size
    expected = weight * (noise_a + noise_b)
    mean = np.sum(weight * (a - b) ** 2) / np.sum(expected)
    spread = np.sqrt(np.sum((weight * (a - b) ** 2 - mean * expected) ** 2)) / np.sum(expected)
    return f"{factor:.3f} ± {error:.3f}", f"{mean:.2f} ± {spread:.2f}"


def best(trials: list[tuple[Estimate, Any]], differences: Estimate) -> tuple[Estimate, Any]:
    """The guiding whose error is the least after `TRIALS` times as long: noise shrinks, bias stays."""

    def later(trial: Estimate) -> float:
        error, _ = squared_error(trial, differences)
        noise = float(np.mean(trial.variance))
        return max(error - noise, 0.0) + noise / TRIALS

    return min(trials, key=lambda pair: later(pair[0]))


# A scene.


class Measured(NamedTuple):
    value: np.ndarray
    differences: Estimate
    rows: list[Estimate]


def measure(capwalk: str, file: Path, seconds: float, has_mitsuba: bool, seed_spp: int) -> Measured:
    ours, value = in_capwalk(capwalk, file, "auto", seconds, 1)
    if not has_mitsuba:
        differences, _ = in_capwalk(capwalk, file, "fd", seconds / 2, 2_000_003)
        return Measured(value, differences, [ours])
    mitsuba = Mitsuba(file)
    differences = mitsuba.differences(seconds / 2, 2_000_003)
    trials = []
    for guiding in GUIDINGS:
        integrator, set_up = mitsuba.guided(guiding, seed_spp)
        name = f"`prb_projective`, {guiding}"
        trial = mitsuba.derivative(name, integrator, mitsuba.loading + set_up, seconds / TRIALS, 3_000_003)
        off, error = bias(trial, differences)
        found, _ = squared_error(trial, differences)
        print(f"<!-- {name}, {trial.seconds:.1f} s: error {found:.3g}, bias {off:+.1%} ± {error:.1%} -->", flush=True)
        trials.append((trial, integrator))
    trial, integrator = best(trials, differences)
    theirs = mitsuba.derivative(trial.name, integrator, trial.set_up, seconds, 4_000_003)
    off, error = bias(theirs, differences)
    print(f"<!-- {theirs.name}, {theirs.seconds:.1f} s: bias {off:+.1%} ± {error:.1%} -->", flush=True)
    return Measured(value, differences, [ours, theirs])


def rows_of(name: str, triangles: int, measured: Measured) -> list[str]:
    """Lines of a table."""
    differences = measured.differences
    square = float(np.mean(differences.image**2 - differences.variance))
    lines = []
    for found in [*measured.rows, differences]:
        stated = float(np.mean(found.variance))
        cells = [name, f"{triangles:,}", found.name, f"{found.spp}", f"{found.seconds:.0f}", f"{found.set_up:.1f}"]
        if found is differences:
            # Its own noise, without the bias of the step.
            cells += [f"{stated:.3g}", f"{stated / square:.1%}", f"{stated * found.seconds:.3g}", "-", "-", "-"]
        else:
            error, spread = squared_error(found, differences)
            cells += [f"{error:.3g} ± {spread:.1g}", f"{error / square:.1%}"]
            cells += [f"{error * found.seconds:.3g}", f"{error / stated:.2f}"]
            cells += agreement(found, differences)
        lines.append(f"| {' | '.join(cells)} |")
    return lines


HEAD = """
| scene | triangles | derivative | samples per pixel | CPU s | set-up, s | mean squared error | of the mean square | \
error × s | of what is stated | factor to differences | mean z² |
|---|---|---|---|---|---|---|---|---|---|---|---|"""


def draw(measured: Measured, output: Path) -> None:
    """The image, derivatives with their seconds and errors, and differences, side by side."""
    from matplotlib import pyplot

    linear = np.clip(measured.value, 0, 1)
    colours = np.where(linear < 0.0031308, 12.92 * linear, 1.055 * np.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055)
    names, panels = ["image"], [colours]
    for found in measured.rows:
        error, _ = squared_error(found, measured.differences)
        who = found.name.replace("`", "").replace("prb_projective", "Mitsuba")
        names.append(f"{who}, {found.seconds:.0f} s\nmean squared error {error:.2g}")
        panels.append(found.image.mean(axis=-1))
    differences = measured.differences
    who = "of Mitsuba's images" if differences.passes is not None else "of capwalk's images"
    names.append(f"differences {who},\n{differences.seconds:.0f} s")
    panels.append(differences.image.mean(axis=-1))
    limit = np.percentile(np.abs(measured.differences.image.mean(axis=-1)), 99.5)
    height, width = panels[0].shape[:2]
    rows = (len(panels) + 1) // 2
    figure, all_axes = pyplot.subplots(
        rows, 2, figsize=(8.4, rows * (3.8 * height / width + 0.6)), dpi=110, layout="constrained", squeeze=False
    )
    for axes in all_axes.flat:
        axes.set_axis_off()
    for axes, name, panel in zip(all_axes.flat[: len(panels)], names, panels, strict=True):
        axes.set_axis_on()
        axes.set(xticks=[], yticks=[])
        axes.set_title(name, fontsize=12, loc="left")
        colour_map = pyplot.get_cmap("RdBu_r", 65)
        shown = axes.imshow(panel, cmap=colour_map, vmin=-limit, vmax=limit, interpolation="nearest")
    bar = figure.colorbar(shown, ax=all_axes, aspect=40, pad=0.02)
    bar.ax.tick_params(labelsize=11)
    figure.savefig(output, pil_kwargs={"optimize": True})


def is_installed(name: str) -> bool:
    import importlib.util

    return importlib.util.find_spec(name) is not None


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n\n")[0])
    parser.add_argument("capwalk")
    parser.add_argument("--scenes", nargs="*", default=list(MESHES), choices=list(MESHES), metavar="NAME")
    parser.add_argument("--seconds", type=float, default=130)
    parser.add_argument("--size", default="128x96", help="pixels of the image")
    parser.add_argument("--alpha", type=float, default=0.05, help="roughness of the mirror")
    parser.add_argument("--mesh", type=Path, help="the bunny: a file of any format that capwalk reads")
    parser.add_argument("--seed-spp", type=int, default=512, help="of Mitsuba's guiding")
    parser.add_argument("--without-mitsuba", action="store_true")
    parser.add_argument("--figure", type=Path, help="a folder for images")
    chosen = parser.parse_args()
    width, height = (int(number) for number in chosen.size.split("x"))
    has_mitsuba = not chosen.without_mitsuba and is_installed("mitsuba")
    lines = []
    for name in chosen.scenes:
        mesh = read_mesh(chosen.mesh) if chosen.mesh and name == "bunny" else MESHES[name]()
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "scene.xml")
            file.write_text(SCENE.format(width=width, height=height, alpha=chosen.alpha))
            write_mesh(Path(folder, "thing.ply"), mesh)
            measured = measure(chosen.capwalk, file, chosen.seconds, has_mitsuba, chosen.seed_spp)
        lines += rows_of(name, len(mesh[1]), measured)
        for line in lines[-len(measured.rows) - 1 :]:
            print(line, flush=True)
        if chosen.figure:
            chosen.figure.mkdir(parents=True, exist_ok=True)
            draw(measured, chosen.figure / f"quadric-{name}.png")
    print("\n".join([HEAD, *lines]))
    print("\nTheirs, on scenes and in units that are not published, on another machine: not comparable.\n")
    print("| scene | samples per pixel | seconds | mean squared error | edge sampling of 2019 |\n|---|---|---|---|---|")
    for name, (spp, error, edge_sampling, seconds) in THEIRS.items():
        print(f"| {name} | {spp} | about {seconds} | {error:.2f} | {edge_sampling:.2f} |")


if __name__ == "__main__":
    main()

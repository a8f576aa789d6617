"""The shadows of a ring on two walls, from Mitsuba's tutorial about projective sampling: errors of derivative images
with respect to a turn of the ring about the vertical axis.

    python python/benchmarks/shadow_of_a_curve.py CAPWALK FOLDER [--seconds S] [--figure FILE]

CAPWALK is the program, FOLDER a clone of github.com/mitsuba-renderer/mitsuba-tutorials. Needs the packages `capwalk`
and `mitsuba`, with `--figure` also `matplotlib`. Prints a table in Markdown.

As in the tutorial (inverse_rendering/projective_sampling_integrators.ipynb), two cameras look at the walls with 128 x
128 pixels each and a box filter, neither sees the ring, and Mitsuba renders both at once with its sensor `batch`. Its
derivatives are those of `direct_projective` with 1,024 boundary samples per pixel and pass, none of the interior and
none of primary boundaries. As the tutorial does, they are computed with octree and without guiding, and also with a
grid. The ring is the tutorial's `bsplinecurve`, and then the mesh of triangles that capwalk makes of it. capwalk takes
two commands, one for each camera, and S seconds for both.

Times are seconds of the CPU, with one thread: as in quadric.py, the set-up of Mitsuba is apart, and of guiding too,
which the tutorial repeats in each render. Derivatives of a `bsplinecurve` may end the process or be NaN (see
github.com/mitsuba-renderer/mitsuba3/pull/1928), so each row has a process of its own, which is repeated if it fails.

The curve of the tutorial ends with the four control points with which it begins: its last segment is its first again.
Silhouettes coincide there, so errors are also printed without the pixels that have this seam's shadow.

Angles are in radians. Errors are from central differences of Mitsuba's images, of twice S seconds, without the noise
of the differences. The tutorial's step is 0.001 degrees; here it is 0.002 radians, which moves shadows by
less than a tenth of a pixel, with less noise."""

from __future__ import annotations

import argparse
import re
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import capwalk as cw
import numpy as np
import quadric
from quadric import Estimate, agreement, bias, in_capwalk, repeated, squared_error

SIDE = 128
VIEWS = [("0, 0, -4", "0, 0, -5"), ("-4, 0, 0", "-5, 0, 0")]
"""Where cameras are, and what they look at."""
SENSOR = """<sensor type="perspective" id="camera{number}">
  <float name="fov" value="100"/>
  <transform name="to_world"><lookat origin="{origin}" target="{target}" up="0, 1, 0"/></transform>
  <film type="hdrfilm">
    <integer name="width" value="{side}"/><integer name="height" value="{side}"/><rfilter type="box"/>
  </film>
</sensor>"""
STEP = 0.002
"""Of differences, radians."""
SPP = 1024
"""Boundary samples per pixel in a pass, as in the tutorial, and samples of an image in differences."""
SEAM = np.zeros((2, SIDE, 2 * SIDE, 1), bool)
"""The pixels with the shadow of the seam, on either wall. It is in the left half of a view, and seven pixels high or
less."""
for wall in range(2):
    SEAM[wall, SIDE // 2 - 5 : SIDE // 2 + 5, wall * SIDE : wall * SIDE + SIDE // 2] = True
SEED_SPP = 512
"""Of the guiding: Mitsuba's default."""
TRIES = 12


def write_scenes(scenes: Path, folder: Path) -> tuple[Path, Path, str]:
    """The scene with the curve, the same with its mesh, and capwalk's name for a turn about the origin."""
    text = (scenes / "shadow_art.xml").read_text()
    sensors = [
        SENSOR.format(number=number, origin=origin, target=target, side=SIDE)
        for number, (origin, target) in enumerate(VIEWS)
    ]
    text = re.sub(r"<sensor.*</sensor>", "\n".join(sensors), text, flags=re.DOTALL)
    text = text.replace('"direct_projective"', '"direct"').replace('"meshes/', f'"{scenes.resolve()}/meshes/')
    curve = folder / "curve.xml"
    curve.write_text(text)
    scene = cw.load_file(curve)
    positions = np.array(cw.traverse(scene)["curve.positions"])
    cw.save_mesh(folder / "tube.ply", {"positions": positions, "faces": scene.faces("curve")})
    mesh = folder / "mesh.xml"
    text = text.replace('type="bsplinecurve"', 'type="ply"')
    mesh.write_text(re.sub(r'value="[^"]*bsplinecurve_circle.txt"', 'value="tube.ply"', text))
    # capwalk turns it about the centre of its bounding box, the tutorial about the origin.
    x, _, z = (positions.min(axis=0) + positions.max(axis=0)) / 2
    return curve, mesh, f"curve.rotate.y + {z:.9f}*curve.translate.x + {-x:.9f}*curve.translate.z"


def side_by_side(capwalk: str, file: Path, method: str, seconds: float, seed: int, name: str) -> tuple[Estimate, Any]:
    """The derivative of both views in one image by capwalk, and the image."""
    parts = [
        in_capwalk(capwalk, file, method, seconds / 2, seed, ("-p", name, "--sensor", str(view)), STEP)
        for view in range(len(VIEWS))
    ]
    views = [view for view, _ in parts]
    image, variance = (np.hstack([getattr(view, part) for view in views]) for part in ("image", "variance"))
    title, spp = views[0].name, round(sum(view.spp for view in views) / len(views))
    found = Estimate(title, image, variance, spp, sum(v.seconds for v in views), sum(v.set_up for v in views))
    return found, np.hstack([value for _, value in parts])


class Mitsuba(quadric.Mitsuba):
    """The scene in Mitsuba."""

    def __init__(self, file: Path, key: str) -> None:
        self.key = key
        super().__init__(file)
        self.spp = SPP
        cameras: dict[str, Any] = {}
        for number, view in enumerate(VIEWS):
            origin, target = ([float(x) for x in place.split(",")] for place in view)
            place = self.mi.ScalarTransform4f().look_at(origin=origin, target=target, up=[0, 1, 0])
            cameras[f"camera{number}"] = {"type": "perspective", "fov": 100, "to_world": place}
        film = {"type": "hdrfilm", "width": 2 * SIDE, "height": SIDE, "sample_border": True, "filter": {"type": "box"}}
        self.sensor = self.mi.load_dict({"type": "batch", **cameras, "film": film})

    def settings(self) -> dict[str, Any]:
        return {"type": "direct_projective", "sppc": 0, "sppp": 0, "sppi": self.spp}

    def move(self, angle: float = 0.0) -> Any:
        """The ring turns by an angle with a derivative."""
        dr, mi = self.dr, self.mi
        amount = mi.Float(angle)
        dr.enable_grad(amount)
        turn = mi.Transform4f().rotate([0, 1, 0], amount * (180 / dr.pi))
        if self.key == "curve.control_points":
            points = dr.unravel(mi.Point4f, self.start)
            moved = turn @ mi.Point3f(points.x, points.y, points.z)
            self.params[self.key] = dr.ravel(mi.Point4f(moved.x, moved.y, moved.z, points.w))
        else:
            self.params[self.key] = dr.ravel(turn @ dr.unravel(mi.Point3f, self.start))
        self.params.update()
        return amount

    def differences(self, seconds: float, seed: int) -> Estimate:
        """Central differences of images, with the same random numbers on both sides."""

        def difference(seed: int) -> tuple[float, np.ndarray]:
            sides = []
            start = time.process_time()
            for angle in (STEP, -STEP):
                with self.dr.suspend_grad():
                    self.move(angle)
                    image = self.mi.render(self.scene, sensor=self.sensor, spp=self.spp, seed=seed)
                sides.append(np.array(image, dtype=float))
            return time.process_time() - start, (sides[0] - sides[1]) / (2 * STEP)

        difference(seed - 1)
        return repeated("differences, Mitsuba", difference, self.spp, seconds, seed)


def in_mitsuba(file: Path, key: str, guiding: str, seconds: float) -> Estimate:
    """A derivative, or differences."""
    scene = Mitsuba(file, key)
    if guiding == "differences":
        return scene.differences(seconds, 2_000_003)
    integrator, set_up = scene.guided(guiding, SEED_SPP)
    shape = "mesh" if key == "curve.vertex_positions" else "curve"
    name = f"Mitsuba, {shape}, {guiding}"
    return scene.derivative(name, integrator, scene.loading + set_up, seconds, 4_000_003)


def in_process(*arguments: Any) -> Estimate:
    """The same in a process of its own, until it returns finite numbers."""
    failures = []
    for _ in range(TRIES):
        with ProcessPoolExecutor(1, get_context("spawn")) as pool:
            try:
                found = pool.submit(in_mitsuba, *arguments).result()
            except BrokenProcessPool:
                failures.append("ended")
                continue
        if np.isfinite(found.image).all():
            print(f"<!-- {found.name}: {len(failures)} failures before: {', '.join(failures)} -->", flush=True)
            return found
        failures.append("NaN")
    raise SystemExit(f"{arguments}: {', '.join(failures)}")


HEAD = """
| derivative | samples per pixel | CPU s | set-up, s | relative L2 error | error × s | over ours | \
off by, from Mitsuba's differences | from capwalk's | factor to Mitsuba's | mean z² |
|---|---|---|---|---|---|---|---|---|---|---|"""


def rows_of(rows: list[Estimate], theirs: Estimate, ours: Estimate) -> list[str]:
    """Lines of a table; the first row is what others are compared with."""
    square = float(np.mean(theirs.image**2 - theirs.variance))
    costs, lines = [], []
    for found in [*rows, theirs, ours]:
        cells = [found.name, f"{found.spp:,}", f"{found.seconds:.0f}", f"{found.set_up:.1f}"]
        if found is theirs or found is ours:
            # Its own noise, without the bias of the step.
            error, of_error = float(np.mean(found.variance)), ""
        else:
            error, spread = squared_error(found, theirs)
            of_error = f" ± {spread * found.seconds:.1g}"
        costs.append(error * found.seconds)
        cells += [f"{max(error, 0.0) ** 0.5 / square**0.5:.1%}", f"{costs[-1]:.3g}{of_error}"]
        cells.append(f"{costs[-1] / costs[0]:.3g}")
        cells += ["-" if found is other else off_by(found, other) for other in (theirs, ours)]
        cells += ["-", "-"] if found is theirs else agreement(found, theirs)
        lines.append(f"| {' | '.join(cells)} |")
    return lines


def within(found: Estimate, pixels: Any) -> Estimate:
    """All is zero outside of some pixels."""
    passes = None if found.passes is None else found.passes * pixels
    return found._replace(image=found.image * pixels, variance=found.variance * pixels, passes=passes)


def off_by(found: Estimate, differences: Estimate) -> str:
    """The projection on the differences, less one, of an estimate with passes or with errors of its own. It is that
    of one channel, because all channels are equal."""
    found, differences = (
        one._replace(
            image=one.image[..., :1],
            variance=one.variance[..., :1],
            passes=None if one.passes is None else one.passes[..., :1],
        )
        for one in (found, differences)
    )
    if found.passes is not None:
        off, error = bias(found, differences)
    else:
        square = np.sum(differences.image**2 - differences.variance)
        off = float(np.sum(found.image * differences.image) / square - 1)
        noise = np.sum((found.variance + differences.variance) * differences.image**2)
        error = float(np.sqrt(noise) / square)
    return f"{off:+.2%} ± {error:.2%}"


def draw(value: np.ndarray, rows: list[Estimate], theirs: Estimate, output: Path) -> None:
    """The image, derivatives with the curve, and differences, side by side."""
    from matplotlib import pyplot

    square = float(np.mean(theirs.image**2 - theirs.variance))
    names, panels = ["image: the two walls with the shadows of the ring"], [value.mean(axis=-1)]
    for found in rows[:4]:
        error, _ = squared_error(found, theirs)
        title = found.name.replace("`", "")
        names.append(f"{title}: {found.seconds:.0f} s, relative error {100 * (max(error, 0) / square) ** 0.5:.1f} %")
        panels.append(found.image.mean(axis=-1))
    names.append(f"differences of Mitsuba's images: {theirs.seconds:.0f} s")
    panels.append(theirs.image.mean(axis=-1))
    limit = np.percentile(np.abs(panels[-1]), 99.5)
    figure, all_axes = pyplot.subplots(3, 2, figsize=(10.2, 7.9), dpi=100, layout="constrained")
    for axes, name, panel in zip(all_axes.flat, names, panels, strict=True):
        axes.set(xticks=[], yticks=[])
        axes.set_title(name, fontsize=11.5, loc="left")
        if name.startswith("image"):
            axes.imshow(panel, cmap="gray", vmin=0, interpolation="nearest")
        else:
            colours = pyplot.get_cmap("RdBu_r", 65)
            shown = axes.imshow(panel, cmap=colours, vmin=-limit, vmax=limit, interpolation="nearest")
    bar = figure.colorbar(shown, ax=all_axes, aspect=40, pad=0.02)
    bar.ax.tick_params(labelsize=11)
    figure.savefig(output, pil_kwargs={"optimize": True})


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n\n")[0])
    parser.add_argument("capwalk")
    parser.add_argument("folder", type=Path, help="a clone of mitsuba-tutorials")
    parser.add_argument("--seconds", type=float, default=90)
    parser.add_argument("--figure", type=Path, help="a file for an image")
    chosen = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        curve, mesh, turn = write_scenes(chosen.folder / "scenes", Path(name))
        print(f"<!-- {turn} -->", flush=True)
        seconds = chosen.seconds
        theirs = in_process(curve, "curve.control_points", "differences", 2 * seconds)
        ours, _ = side_by_side(chosen.capwalk, curve, "fd", 2 * seconds, 2_000_003, turn)
        ours = ours._replace(name="differences, capwalk")
        first, value = side_by_side(chosen.capwalk, curve, "auto", seconds, 1, turn)
        rows = [first]
        for file, key in [(curve, "curve.control_points"), (mesh, "curve.vertex_positions")]:
            for guiding in ["octree", "grid", "none"]:
                rows.append(in_process(file, key, guiding, seconds))
                print("<!-- " + rows_of([first, rows[-1]], theirs, ours)[1] + " -->", flush=True)
    print("\n".join([HEAD, *rows_of(rows, theirs, ours)]))
    print("\nWithout the seam:")
    *others, their_others, our_others = (within(one, ~SEAM.any(axis=0)) for one in [*rows, theirs, ours])
    print("\n".join([HEAD, *rows_of(others, their_others, our_others)]))
    print("\nOff by, from Mitsuba's differences, at the seam:")
    print("\n| derivative | left wall | right wall |\n|---|---|---|")
    for row in [*rows, ours]:
        left, right = (off_by(within(row, wall), within(theirs, wall)) for wall in SEAM)
        print(f"| {row.name} | {left} | {right} |")
    if chosen.figure:
        draw(value, rows, theirs, chosen.figure)


if __name__ == "__main__":
    main()

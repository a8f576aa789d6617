"""Random scenes, each with a derivative that is checked against finite differences.

    python python/benchmarks/random_checks.py CAPWALK [--scenes N] [--first SEED]
        [--seconds S | --spp N] [--width PIXELS] [--specular] [--keep FOLDER]

CAPWALK is the program. Each scene has a floor, sometimes walls, one to four shapes with materials of
all kinds, one or two emitters of all kinds, and a camera; something in it moves or changes colour.
`capwalk check` compares the derivative of its image with central differences, with as many samples
as S seconds of the CPU allow, and at least 16, or with N samples within half a minute. With `--specular` each scene has
a curved mirror or smooth glass. What is printed is a line for each scene that is not
right, and a table of the verdicts. Scenes whose check says "wrong" are kept in FOLDER, all with
`--keep-all`."""

from __future__ import annotations

import argparse
import json
import random
import resource
import subprocess
import tempfile
from collections import Counter
from pathlib import Path
from statistics import median
from typing import Any

FIRST_SPP, SECOND_SPP = 16, 48
"""Samples with which the time is measured."""
MOST_TIMES = 8
"""The samples of a run, at most, as a multiple of those of the run before."""
ENOUGH = 0.9
"""The part of the seconds that a run must take."""
TOO_MUCH = 1.25
"""The part of the seconds that a run may take, unless it has the fewest samples."""
TIME_LIMIT = ["--time-limit", "30"]
WIDTH = 40


class Scene:
    """A scene file at random, and a number of it that changes."""

    def __init__(self, seed: int, width: int, specular: bool = False) -> None:
        self.random = random.Random(seed)
        self.specular = specular
        """Whether the first thing is a curved mirror or smooth glass."""
        self.size = width, width * 3 // 4
        """Of the image, pixels."""
        self.moving: list[str] = []
        """Parameters that move geometry, emitters or the camera."""
        self.still: list[str] = []
        """Parameters that move nothing."""
        shapes = [self.floor()] + [self.thing(i) for i in range(self.random.randint(1, 4))]
        emitters = [self.emitter(i) for i in range(self.random.choice([1, 1, 2]))]
        if self.random.random() < 0.2:
            emitters.append(self.sky())
        integrator, sensor = self.integrator(), self.sensor()
        parts = [integrator, sensor, *shapes, *emitters]
        self.text = f'<scene version="3.0.0">\n{"".join(parts)}</scene>\n'
        moves = self.random.random() < 0.8
        self.parameter = self.random.choice(self.moving if moves else self.still)

    def between(self, low: float, high: float) -> float:
        return round(self.random.uniform(low, high), 4)

    def vector(self, low: float, high: float) -> str:
        return ", ".join(str(self.between(low, high)) for _ in range(3))

    def colour(self, name: str, low: float = 0.1, high: float = 0.9) -> str:
        return f'<rgb name="{name}" value="{self.vector(low, high)}"/>'

    def integrator(self) -> str:
        depth = self.random.choice([None, 2, 3, 4])
        if depth is None:
            return '<integrator type="direct"/>\n'
        return f'<integrator type="path"><integer name="max_depth" value="{depth}"/></integrator>\n'

    def sensor(self) -> str:
        at = [self.between(-1.5, 1.5), self.between(-5, -3), self.between(0.8, 2.5)]
        rfilter = self.random.choice(["box", "box", "tent", "gaussian"])
        self.moving += ["sensor.translate.x", "sensor.rotate.z"]
        return f"""<sensor type="perspective">
  <float name="fov" value="{self.between(25, 50)}"/>
  <transform name="to_world">
    <lookat origin="{at[0]}, {at[1]}, {at[2]}" target="0, 0, 0.4" up="0, 0, 1"/>
  </transform>
  <film type="hdrfilm">
    <integer name="width" value="{self.size[0]}"/><integer name="height" value="{self.size[1]}"/>
    <rfilter type="{rfilter}"/>
  </film>
  <sampler type="independent"/>
</sensor>
"""

    def floor(self) -> str:
        material = self.bsdf("floor", self.random.choice(["diffuse", "diffuse", "metal", "plastic"]))
        wall = ""
        if self.random.random() < 0.4:
            wall = f"""<shape type="rectangle" id="wall">
  <transform name="to_world">
    <scale value="4"/><rotate x="1" angle="90"/><translate y="{self.between(1.2, 2.5)}"/>
  </transform>
  {self.bsdf("wall", "diffuse")}
</shape>
"""
        return f"""<shape type="rectangle" id="floor">
  <transform name="to_world"><scale value="4"/></transform>
  {material}
</shape>
{wall}"""

    def thing(self, i: int) -> str:
        plugin = self.random.choice(["cube", "sphere", "rectangle", "disk", "cylinder"])
        kinds = ["diffuse"] * 4 + ["metal", "plastic", "principled", "mirror", "glass", "mask"]
        kind = self.random.choice(kinds)
        if i == 0 and self.specular:
            kind = self.random.choice(["mirror", "glass"])
            if kind == "mirror":
                plugin = self.random.choice(["sphere", "cylinder"])
        sides = [self.between(0.12, 0.45) for _ in range(3)]
        if plugin == "sphere":
            sides = [sides[0]] * 3
        steps = f'<scale x="{sides[0]}" y="{sides[1]}" z="{sides[2]}"/>'
        for axis in "xyz":
            steps += f'<rotate {axis}="1" angle="{self.between(0, 360)}"/>'
        place = [self.between(-1, 1), self.between(-0.8, 0.8), self.between(0.5, 1.2)]
        steps += f'<translate x="{place[0]}" y="{place[1]}" z="{place[2]}"/>'
        name = f"thing_{i}"
        motions = ["translate.x", "translate.y", "translate.z", "rotate.y", "rotate.z", "scale"]
        self.moving += [f"{name}.{self.random.choice(motions)}" for _ in range(2)]
        return f"""<shape type="{plugin}" id="{name}">
  <transform name="to_world">{steps}</transform>
  {self.bsdf(name, kind)}
</shape>
"""

    def bsdf(self, shape: str, kind: str) -> str:
        """A material for both sides of a shape, and the numbers of it that can change."""
        name = f"{shape}_bsdf"
        alpha = f'<float name="alpha" value="{self.between(0.08, 0.5)}"/>'
        if kind == "diffuse":
            self.still += [f"{name}.reflectance.value", f"{name}.reflectance.value.g"]
            inner = f'<bsdf type="diffuse" id="{name}">{self.colour("reflectance")}</bsdf>'
        elif kind == "metal":
            self.still.append(f"{name}.alpha")
            metal = self.random.choice(["Au", "Al", "Cu", "Ag"])
            string = f'<string name="material" value="{metal}"/>'
            inner = f'<bsdf type="roughconductor" id="{name}">{string}{alpha}</bsdf>'
        elif kind == "plastic":
            self.still.append(f"{name}.diffuse_reflectance.value")
            plugin = self.random.choice(["plastic", "roughplastic"])
            rough = alpha if plugin == "roughplastic" else ""
            colour = self.colour("diffuse_reflectance")
            inner = f'<bsdf type="{plugin}" id="{name}">{colour}{rough}</bsdf>'
        elif kind == "principled":
            self.still.append(f"{name}.roughness")
            rough = f'<float name="roughness" value="{self.between(0.2, 0.9)}"/>'
            metallic = f'<float name="metallic" value="{self.between(0, 1)}"/>'
            inner = (
                f'<bsdf type="principled" id="{name}">{self.colour("base_color")}{rough}{metallic}'
                "</bsdf>"
            )
        elif kind == "mirror":
            inner = f'<bsdf type="conductor" id="{name}"/>'
        elif kind == "glass":
            return f'<bsdf type="{self.random.choice(["dielectric", "thindielectric"])}"/>'
        else:
            self.still.append(f"{name}.opacity")
            opacity = f'<float name="opacity" value="{self.between(0.2, 0.8)}"/>'
            colour = f'<bsdf type="twosided"><bsdf type="diffuse">{self.colour("reflectance")}</bsdf></bsdf>'
            return f'<bsdf type="mask" id="{name}">{opacity}{colour}</bsdf>'
        return f'<bsdf type="twosided">{inner}</bsdf>'

    def emitter(self, i: int) -> str:
        name = f"lamp_{i}"
        kind = self.random.choice(["rectangle"] * 3 + ["sphere", "point", "spot", "directional"])
        at = [self.between(-1.5, 1.5), self.between(-1.5, 0.8), self.between(2, 3)]
        aim = f'<lookat origin="{at[0]}, {at[1]}, {at[2]}" target="0, 0, 0" up="0, 1, 0.1"/>'
        if kind in ("rectangle", "sphere"):
            size = self.between(0.1, 0.6)
            light = f'<emitter type="area">{self.colour("radiance", 2, 12)}</emitter>'
            self.moving += [f"{name}.translate.x", f"{name}.translate.z"]
            self.still.append(f"{name}.emitter.radiance.value")
            place = f'<scale value="{size}"/>{aim}'
            return f"""<shape type="{kind}" id="{name}">
  <transform name="to_world">{place}</transform>
  {light}
</shape>
"""
        self.moving.append(f"{name}.rotate.x" if kind == "directional" else f"{name}.translate.x")
        if kind == "directional":
            colour = self.colour("irradiance", 0.5, 3)
        else:
            colour = self.colour("intensity", 4, 15)
        if kind == "spot":
            colour += f'<float name="cutoff_angle" value="{self.between(25, 60)}"/>'
        where = f'<transform name="to_world">{aim}</transform>'
        if kind == "point":
            where = f'<point name="position" value="{at[0]}, {at[1]}, {at[2]}"/>'
        return f'<emitter type="{kind}" id="{name}">{where}{colour}</emitter>\n'

    def sky(self) -> str:
        self.still.append("sky.radiance.value")
        return f'<emitter type="constant" id="sky">{self.colour("radiance", 0.1, 0.6)}</emitter>\n'


def run(command: list[str]) -> tuple[dict[str, Any] | None, str, float]:
    """What a command prints, or why it prints nothing, and its seconds of the CPU."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    if done.stdout:
        return json.loads(done.stdout), done.stderr, seconds
    start = done.stderr.find("error: ")
    return None, done.stderr[max(start, 0) :].removeprefix("error: ").strip(), seconds


def checked(
    capwalk: str, file: str, parameter: str, seconds: float, spp: int | None
) -> tuple[str, str, float]:
    """The verdict, the rest of the line, and the seconds that the check took."""
    command = [capwalk, "check", file, "-p", parameter, "--json", "--threads", "1", "-o"]
    command += [file.replace(".xml", ".npz")]
    command += [*TIME_LIMIT, "--spp"] if spp is not None else ["--spp"]
    result, error, taken = run([*command, str(spp or FIRST_SPP)])
    if result is not None and spp is None:
        first, second = taken, run([*command, str(SECOND_SPP)])[2]
        each = (second - first) / (SECOND_SPP - FIRST_SPP)
        # A pilot, or a second reference, may have taken most of either.
        spp = int(min(seconds / each, MOST_TIMES * SECOND_SPP)) if each > 0 else SECOND_SPP
        spp = max(spp, FIRST_SPP)
        if spp > FIRST_SPP:
            result, error, taken = run([*command, str(spp)])
        while result is not None and taken < ENOUGH * seconds:
            spp = int(spp * min(MOST_TIMES, seconds / taken))
            result, error, taken = run([*command, str(spp)])
        # Too many, perhaps with a second reference: fewer, and some in between if that is without.
        while result is not None and taken > TOO_MUCH * seconds and spp > FIRST_SPP:
            many, spp = spp, max(FIRST_SPP, int(spp * seconds / taken))
            result, error, taken = run([*command, str(spp)])
            if taken < ENOUGH * seconds:
                tried = run([*command, str(int((spp * many) ** 0.5))])
                if tried[2] <= TOO_MUCH * seconds:
                    result, error, taken = tried
    if result is None:
        verdict = "too slow" if "time limit" in error else "refused"
        return verdict, error.splitlines()[0], taken
    found = result["comparison"]
    factor, error_of_it = found["scale_factor"], found["scale_factor_error"]
    return found["verdict"], f"{factor} ± {error_of_it}, {result['spp']} spp, {taken:.2f} s", taken


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("capwalk")
    parser.add_argument("--scenes", type=int, default=200)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=2.0)
    parser.add_argument("--spp", type=int)
    parser.add_argument("--specular", action="store_true")
    parser.add_argument("--width", type=int, default=WIDTH)
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--keep-all", action="store_true")
    chosen = parser.parse_args()
    counts: Counter[str] = Counter()
    times: list[float] = []
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(chosen.first, chosen.first + chosen.scenes):
            scene = Scene(seed, chosen.width, chosen.specular)
            file = Path(folder, f"{seed}.xml")
            file.write_text(scene.text)
            verdict, rest, taken = checked(
                chosen.capwalk, str(file), scene.parameter, chosen.seconds, chosen.spp
            )
            times.append(taken)
            counts[verdict] += 1
            if verdict != "right":
                print(f"{seed} {scene.parameter}: {verdict}: {rest}", flush=True)
            if chosen.keep and (chosen.keep_all or "wrong" in verdict):
                chosen.keep.mkdir(parents=True, exist_ok=True)
                (chosen.keep / f"{seed}.xml").write_text(scene.text)
    print("\n| verdict | scenes |\n|---|---|")
    for verdict, count in counts.most_common():
        print(f"| {verdict} | {count} |")
    print(f"\nMedian {median(times):.2f} s", end="" if chosen.spp is None else "\n")
    if chosen.spp is None:
        above = [taken for taken in times if taken > TOO_MUCH * chosen.seconds]
        print(f"; above {TOO_MUCH * chosen.seconds} s: {len(above)}")


if __name__ == "__main__":
    main()

"""Derivatives of scenes that other people made with respect to something that moves, checked
against finite differences.

    python python/benchmarks/public_gradients.py CAPWALK FOLDER [--only TEXT] [--seconds S] [--side N]

CAPWALK is the program, FOLDER has the repositories `mitsuba-data` and `mitsuba-tutorials`. In each
of the scenes below one shape moves along an axis, and `capwalk check` compares the derivative of
the image, N pixels wide or high, with differences, in S seconds. What is printed is a table in
Markdown."""

from __future__ import annotations

import argparse
import json
import subprocess
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

FIRST_SPP = 32
"""Samples with which the time is measured; fewer would measure how edges are listed."""
DOCS, DATA, TESTS = "mitsuba-data/docs/scenes", "mitsuba-data/scenes", "mitsuba-data/tests/scenes"
SCENES = [
    (f"{DATA}/cbox/cbox.xml", "cbox_smallbox.translate.x"),
    (f"{DATA}/hello.xml", "{most}.translate.x"),
    (f"{DATA}/matpreview/matpreview.xml", "{most}.translate.x"),
    ("mitsuba-tutorials/scenes/cbox.xml", "{most}.translate.x"),
    ("mitsuba-tutorials/scenes/simple.xml", "{most}.translate.x"),
    ("mitsuba-tutorials/scenes/shadow_art.xml", "{most}.translate.x"),
    (f"{DOCS}/bsdf_bumpmap_with.xml", "{most}.translate.x"),
    (f"{DOCS}/bsdf_conductor_gold.xml", "{most}.translate.x"),
    (f"{DOCS}/bsdf_dielectric_glass.xml", "{most}.translate.x"),
    (f"{DOCS}/bsdf_diffuse_textured.xml", "{most}.translate.x"),
    (f"{DOCS}/bsdf_plastic_shiny.xml", "{most}.translate.x"),
    (f"{DOCS}/bsdf_roughdielectric_glass.xml", "{most}.translate.x"),
    (f"{DOCS}/bsdf_roughplastic_beckmann.xml", "{most}.translate.x"),
    (f"{DOCS}/bsdf_thindielectric_glass.xml", "{most}.translate.x"),
    (f"{DOCS}/bsdf_twosided_cbox.xml", "{most}.translate.x"),
    (f"{DOCS}/bsdf_mask_after.xml", "{most}.translate.x"),
    (f"{DOCS}/emitter_spot_no_texture.xml", "{most}.translate.x"),
    (f"{DOCS}/integrator_depth_2.xml", "{most}.translate.x"),
    (f"{DOCS}/integrator_direct_both.xml", "plate2.translate.y"),
    (f"{DOCS}/sampler_independent_16spp.xml", "{most}.translate.x"),
    (f"{DOCS}/shape_disk.xml", "{most}.translate.x"),
    (f"{DOCS}/shape_ply_bunny.xml", "{most}.translate.x"),
    (f"{DOCS}/texture_mesh_attribute_vertex.xml", "{most}.translate.x"),
    (f"{TESTS}/bsdf_spheres/test_envmap_path.xml", "{most}.translate.x"),
    (f"{TESTS}/orthographic_sensor/test_orthographic_path.xml", "{most}.translate.x"),
]
"""Files, and what moves; `{most}` is the shape of the most triangles that does not emit."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("capwalk")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", default="", help="a part of the names of files")
    parser.add_argument("--seconds", type=float, default=20.0)
    parser.add_argument("--side", type=int, default=48)
    chosen = parser.parse_args()
    counts: Counter[str] = Counter()
    print("| scene | what moves | verdict | scale factor | spp |\n|---|---|---|---|---|")
    for file, parameter in SCENES:
        if chosen.only in file:
            path = chosen.folder / file
            kind, row = checked(chosen.capwalk, path, parameter, chosen.side, chosen.seconds)
            counts[kind] += 1
            print(f"| {file} | {row} |", flush=True)
    print("\n" + ", ".join(f"{count} {kind}" for kind, count in counts.most_common()))


def checked(
    capwalk: str, file: Path, parameter: str, longer_side: int, seconds: float
) -> tuple[str, str]:
    """The verdict on the derivative of a scene, and the rest of its row."""
    info, error = run([capwalk, "info", str(file), "--json"])
    if info is None:
        return "not loaded", f"- | not loaded: {error.splitlines()[0]} | - | -"
    shapes = [shape for shape in info["shapes"] if shape["emits"] is None]
    most = max(shapes, key=lambda shape: shape["triangles"])["id"]
    parameter = parameter.format(most=most)
    scale = longer_side / max(info["size"])
    size = "x".join(str(max(1, round(scale * pixels))) for pixels in info["size"])
    with tempfile.TemporaryDirectory() as folder:
        command = [capwalk, "check", str(file), "-p", parameter, "--size", size, "--json"]
        command += ["-o", f"{folder}/check.npz", "--spp"]
        result, error = run([*command, str(FIRST_SPP)])
        if result is not None:
            taken = sum(result[image]["seconds"] for image in ("gradient", "reference"))
            spp = round(FIRST_SPP * seconds / taken)
            if spp > 2 * FIRST_SPP:
                result, error = run([*command, str(spp)])
    if result is None:
        return "refused", f"{parameter} | refused: {error.splitlines()[0]} | - | -"
    found = result["comparison"]
    kind = found["verdict"]
    factor, factor_error = found["scale_factor"], found["scale_factor_error"]
    factor = f"{number(factor)} ± {number(factor_error)}"
    return kind, f"{parameter} | {kind} | {factor} | {result['spp']}"


def number(value: float | None) -> str:
    return "-" if value is None else f"{value:.3f}"


def run(command: list[str]) -> tuple[dict[str, Any] | None, str]:
    """What a command prints, or why it prints nothing."""
    done = subprocess.run(command, capture_output=True, text=True)
    if done.stdout:
        return json.loads(done.stdout), done.stderr
    start = done.stderr.find("error: ")
    return None, done.stderr[max(start, 0) :].removeprefix("error: ").strip()


if __name__ == "__main__":
    main()

"""A ball of 60,500 triangles, smooth or a little rough, among things: variance times processor time of
derivatives, and of central differences.

    python python/benchmarks/chains_beside_rough.py CAPWALK [--spp N]

CAPWALK is the program. Prints a table in Markdown: for glass, plastic and metal, and for what moves, the
processor time of derivatives (method `auto`) times their variance, over the same with roughness 0.05 and
over that of differences (method `fd`, its default step). Below 1, the derivative of the smooth ball is the
better one. Samples with rare large values make the variance itself uncertain."""

from __future__ import annotations

import argparse
import re
import resource
import subprocess
import tempfile
from pathlib import Path

SCENE = """<scene version="3.0.0">
  <integrator type="path"><integer name="max_depth" value="6"/></integrator>
  <sensor type="perspective">
    <float name="fov" value="30"/>
    <transform name="to_world"><lookat origin="0.6, -4, 1.9" target="0, 0, 0.5" up="0, 0, 1"/></transform>
    <film type="hdrfilm">
      <integer name="width" value="64"/><integer name="height" value="48"/><rfilter type="tent"/>
    </film>
    <sampler type="independent"/>
  </sensor>
  <emitter type="constant"><rgb name="radiance" value="0.4"/></emitter>
  <shape type="rectangle" id="lamp">
    <transform name="to_world"><scale value="0.8"/><rotate x="1" angle="180"/><translate z="3"/></transform>
    <emitter type="area"><rgb name="radiance" value="6"/></emitter>
  </shape>
  <shape type="rectangle" id="floor">
    <transform name="to_world"><scale value="4"/></transform>
    <bsdf type="diffuse"><rgb name="reflectance" value="0.5, 0.4, 0.3"/></bsdf>
  </shape>
  <shape type="sphere" id="ball"><point name="center" value="0, 0, 0.6"/><float name="radius" value="0.6"/>{bsdf}</shape>
  <shape type="cube" id="thing">
    <transform name="to_world">
      <scale value="0.25"/><rotate z="1" angle="35"/><translate value="-0.8, -0.9, 0.25"/>
    </transform>
    <bsdf type="diffuse"><rgb name="reflectance" value="0.7, 0.2, 0.1"/></bsdf>
  </shape>
  <shape type="cube" id="behind">
    <transform name="to_world">
      <scale value="0.3"/><rotate z="1" angle="15"/><translate value="0.2, 1.4, 0.3"/>
    </transform>
    <bsdf type="diffuse"><rgb name="reflectance" value="0.1, 0.3, 0.7"/></bsdf>
  </shape>
</scene>
"""
RED = '<rgb name="diffuse_reflectance" value="0.6, 0.1, 0.1"/>'
MATERIALS = {"glass": ("dielectric", ""), "paint": ("plastic", RED), "metal": ("conductor", "")}


def cost(capwalk: str, file: Path, parameter: str, method: str, spp: int) -> float:
    """Variance per sample times processor seconds."""
    words = [capwalk, "gradient", str(file), "-p", parameter, "--method", method, "--spp", str(spp)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([*words, "-o", str(file.with_suffix(".exr"))], check=False, capture_output=True, text=True)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    found = re.search(r"variance per sample: (\S+)", done.stdout + done.stderr)
    if done.returncode != 0 or found is None:
        raise SystemExit(done.stderr)
    return float(found[1]) * seconds


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("capwalk")
    parser.add_argument("--spp", type=int, default=64)
    chosen = parser.parse_args()
    print("| ball | moves | over rough | over differences |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "scene.xml")
        for name, (kind, numbers) in MATERIALS.items():
            smooth = f'<bsdf type="{kind}">{numbers}</bsdf>'
            rough = f'<bsdf type="rough{kind}"><float name="alpha" value="0.05"/>{numbers}</bsdf>'
            for parameter in ("thing.translate.x", "ball.translate.x"):
                costs = []
                for bsdf, method in [(smooth, "auto"), (rough, "auto"), (smooth, "fd")]:
                    file.write_text(SCENE.format(bsdf=bsdf))
                    costs.append(cost(chosen.capwalk, file, parameter, method, chosen.spp))
                ours, over_rough, over_fd = costs
                print(f"| {name} | {parameter} | {ours / over_rough:.2g} | {ours / over_fd:.2g} |", flush=True)


if __name__ == "__main__":
    main()

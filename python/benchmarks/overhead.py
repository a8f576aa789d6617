"""What a call from Python costs: one pixel before a cube, gradients of a moving mesh of 72,000
triangles, and those by the texels of large textures. Prints medians."""

from __future__ import annotations

import statistics
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import capwalk as cw
import numpy as np

PIXEL = Path(__file__).with_name("pixel.xml")


def milliseconds(work: Callable[[], object], times: int) -> float:
    """The median time of a call."""
    taken = []
    for _ in range(times):
        started = time.perf_counter()
        work()
        taken.append(1e3 * (time.perf_counter() - started))
    return statistics.median(taken)


def one_pixel() -> None:
    scene = cw.load_file(PIXEL)
    names, ones = ["box.positions"], np.ones((1, 1, 3))
    for name, work in {
        "render": lambda: cw.render(scene, spp=1),
        "gradient": lambda: cw.gradient(scene, "box.translate.x", spp=1, method="edges"),
        "backward": lambda: cw.backward(scene, ones, names, spp=1, method="edges"),
    }.items():
        print(f"one pixel, {name:10}{milliseconds(work, 2000):8.3f} ms")


def moving_mesh() -> None:
    name = "lattice.positions"
    scene = cw.load_file("lattice-shadow")
    scene.resize(40, 30)
    params, ones = cw.traverse(scene), np.ones((30, 40, 3))

    def gradient(scene: cw.Scene) -> None:
        cw.backward(scene, ones, [name], spp=1, method="edges")

    def update() -> None:
        params[name] += [1e-4, 0.0, 0.0]
        params.update()

    def loaded() -> None:
        anew = cw.load_file("lattice-shadow")
        anew.resize(40, 30)
        gradient(anew)

    def after_update() -> None:
        update()
        gradient(scene)

    for what, work in {
        "loaded anew, backward": loaded,
        "backward again": lambda: gradient(scene),
        "update": update,
        "update, backward": after_update,
    }.items():
        print(f"72,000 triangles, {what:24}{milliseconds(work, 5):8.1f} ms")


ROOM = """<scene version="3.0.0">
<integrator type="path"><integer name="max_depth" value="5"/></integrator>
<sensor type="perspective"><transform name="to_world">
<lookat origin="0.3, -3.6, 2.4" target="0, 0.1, 0.3" up="0, 0, 1"/></transform>
<film type="hdrfilm"><integer name="width" value="160"/><integer name="height" value="90"/>
</film></sensor>
<shape type="rectangle" id="floor"><transform name="to_world"><scale value="1.2"/></transform>
<bsdf type="diffuse"><texture type="bitmap" name="reflectance">
<string name="filename" value="floor.exr"/></texture></bsdf></shape>
<shape type="cube" id="block"><transform name="to_world"><scale value="0.3"/>
<translate z="0.3"/></transform></shape>
<emitter type="envmap" id="sky"><string name="filename" value="sky.exr"/></emitter></scene>"""


def large_textures() -> None:
    random = np.random.default_rng(1)
    with tempfile.TemporaryDirectory() as folder:
        for image in ("floor", "sky"):
            colours = random.uniform(0.2, 0.8, (1024, 2048, 3))
            cw.save_image(Path(folder) / f"{image}.exr", colours)
        started = time.perf_counter()
        scene = cw.load_string(ROOM, folder)
        print(f"textures, load            {1e3 * (time.perf_counter() - started):8.1f} ms")
    params, ones = cw.traverse(scene), np.ones((90, 160, 3))
    colour, texels = "block.bsdf.reflectance.value", "floor.bsdf.reflectance.data"

    def update() -> None:
        params[colour] *= 0.999
        params.update()

    print(f"textures, update of a colour{milliseconds(update, 9):8.2f} ms")
    for spp in (1, 16):
        for what, name in (("a colour", colour), ("texels", texels)):
            taken = milliseconds(lambda: cw.backward(scene, ones, [name], spp=spp), 5)
            print(f"textures, backward, {spp:2} spp, by {what:8}{taken:8.1f} ms")


if __name__ == "__main__":
    one_pixel()
    moving_mesh()
    large_textures()

"""What a call from Python costs: one pixel before a cube, and gradients of a moving mesh of
72,000 triangles. Prints medians."""

from __future__ import annotations

import statistics
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


if __name__ == "__main__":
    one_pixel()
    moving_mesh()

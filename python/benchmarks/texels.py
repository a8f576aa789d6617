"""A texture that is found from one image with few samples, with and without Sobolev gradients.

    python python/benchmarks/texels.py [--texels N] [--spp N] [--steps N] [--seeds N] [--order S] [--lr RATE]

A floor, seen at an angle and half in the shade of a cube, has a texture with soft waves and a disk with
a sharp edge. Adam looks for it from grey, in steps of `spp` samples per pixel for the image and as many for the
gradient, 32 x 24 pixels. Prints a table in Markdown: the error of the texels (root
mean square) after some steps, as the mean over seeds with its standard error; at the end the least of all
steps."""

from __future__ import annotations

import argparse

import numpy as np

import capwalk as cw

NAME = "floor.bsdf.reflectance.data"
SIZE = (32, 24)


def floor(texels: int) -> cw.Scene:
    """The scene with a grey floor."""
    view = cw.Transform().look_at(origin=[0, 1.2, 3], target=[0, 0, 0], up=[0, 1, 0])
    grey = {"type": "bitmap", "data": np.full((texels, texels, 3), 0.5)}
    scene = cw.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "direct"},
            "view": {"type": "perspective", "fov": 45, "to_world": view},
            "sky": {"type": "constant"},
            "floor": {
                "type": "rectangle",
                "to_world": cw.Transform().rotate([1, 0, 0], -90).scale(1.5),
                "bsdf": {"type": "diffuse", "reflectance": grey},
            },
            "box": {
                "type": "cube",
                "to_world": cw.Transform().translate([0.5, 0.3, -0.3]).scale(0.3),
            },
        }
    )
    scene.resize(*SIZE)
    return scene


def waves_and_disk(texels: int) -> np.ndarray:
    """The texture to be found."""
    y, x = np.mgrid[:texels, :texels] / texels
    red = 0.5 + 0.3 * np.sin(5 * x + 3 * y)
    green = 0.5 + 0.3 * np.cos(7 * y)
    blue = 0.4 + 0.2 * np.sin(4 * x - 6 * y)
    texture = np.stack([red, green, blue], axis=2)
    texture[(x - 0.4) ** 2 + (y - 0.6) ** 2 < 0.05] = [0.15, 0.3, 0.7]
    return texture


def errors(texels: int, spp: int, steps: int, seed: int, order: float, lr: float) -> np.ndarray:
    """The error after each step; order 0 for the gradient as it is."""
    scene, truth = floor(texels), waves_and_disk(texels)
    params = cw.traverse(scene)
    start = params[NAME].copy()
    params.update({NAME: truth})
    target = cw.render(scene, spp=1024, seed=1).value
    params.update({NAME: start})
    adam, found = cw.Adam(lr=lr), []
    for step in range(steps):
        first = 2 + 2 * (seed * steps + step)
        image = cw.render(scene, spp=spp, seed=first).value
        adjoint = 2 * (image - target) / image.size
        gradient = cw.backward(scene, adjoint, [NAME], spp=spp, seed=first + 1)[NAME]
        adam.step(params, {NAME: cw.sobolev_gradient(gradient, order) if order else gradient})
        params[NAME] = np.clip(params[NAME], 0, 1)
        params.update()
        found.append(np.sqrt(np.square(params[NAME] - truth).mean()))
    return np.array(found)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--texels", type=int, default=32)
    parser.add_argument("--spp", type=int, default=2)
    parser.add_argument("--steps", type=int, default=100)
    parser.add_argument("--seeds", type=int, default=8)
    parser.add_argument("--order", type=float, default=0.75)
    parser.add_argument("--lr", type=float, default=0.05)
    chosen = parser.parse_args()
    shown = [step for step in (5, 10, 20, 50, 100, 200, 500) if step <= chosen.steps]
    print("| gradient | " + " | ".join(f"{step} steps" for step in shown) + " | least |")
    print("|---" * (len(shown) + 2) + "|")
    for name, order in [("as it is", 0.0), (f"Sobolev, order {chosen.order}", chosen.order)]:
        runs = [
            errors(chosen.texels, chosen.spp, chosen.steps, seed, order, chosen.lr)
            for seed in range(chosen.seeds)
        ]
        of_steps = np.array(runs)[:, [step - 1 for step in shown]]
        columns = np.column_stack([of_steps, np.min(runs, axis=1)])
        mean, error = columns.mean(axis=0), columns.std(axis=0, ddof=1) / np.sqrt(len(runs))
        cells = [f"{m:.4f} ± {e:.4f}" for m, e in zip(mean, error, strict=True)]
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()

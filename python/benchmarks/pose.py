"""The pose, the tint and the roughness of a metal cube, from two views, in a loop of PyTorch.

    python python/benchmarks/pose.py [--width N] [--spp N] [--spp-grad N] [--steps N] [--seeds N]

Six numbers of the pose, three of the tint and the roughness are found by Adam from two images of N x 3/4 N
pixels, at depth 4, under an area emitter and the sky. Prints the processor time of a step (the first one
apart, which also chooses methods), and for each seed how far what was found is from the truth: metres,
degrees, tint and roughness."""

from __future__ import annotations

import argparse
import time

import capwalk as cw
import capwalk.torch
import numpy as np
import torch


def scene_of(width: int) -> cw.Scene:
    place = cw.Transform()
    film = {"type": "hdrfilm", "width": width, "height": width * 3 // 4}
    views = {
        name: {
            "type": "perspective",
            "to_world": place.look_at([x, 1.6, 4.5], [0, 0.5, 0], [0, 1, 0]),
            "film": film,
            "fov": 35,
        }
        for name, x in {"left": -1.5, "right": 1.5}.items()
    }
    metal = {
        "type": "roughconductor",
        "id": "metal",
        "material": "none",
        "alpha": 0.15,
        "specular_reflectance": {"type": "rgb", "value": [0.9, 0.6, 0.3]},
    }
    return cw.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "path", "max_depth": 4},
            **views,
            "floor": {"type": "rectangle", "to_world": place.rotate([1, 0, 0], -90).scale(4)},
            "cube": {
                "type": "cube",
                "to_world": place.translate([0, 0.6, 0]).rotate([0, 1, 0], 30).scale(0.45),
                "bsdf": metal,
            },
            "lamp": {
                "type": "rectangle",
                "to_world": place.translate([0, 4, 0]).rotate([1, 0, 0], 90).scale(0.8),
                "emitter": {"type": "area", "radiance": 12.0},
            },
            "sky": {"type": "constant", "radiance": 0.3},
        }
    )


def found(scene: cw.Scene, steps: int, spp: int, spp_grad: int, seed: int) -> str:
    """A run, as a row of the table."""
    views = ["left", "right"]
    truth = [cw.render(scene, sensor=view, spp=64 * spp, seed=2**20 + seed).value for view in views]

    # The loop: twenty lines.
    target = torch.tensor(np.stack(truth))
    cube = torch.tensor(cw.traverse(scene)["cube.positions"])
    turn = torch.tensor([0.1, 0.2, -0.1], dtype=torch.double, requires_grad=True)
    shift = torch.tensor([0.2, 0.05, -0.15], dtype=torch.double, requires_grad=True)
    tint = torch.full((3,), 0.5, dtype=torch.double, requires_grad=True)
    alpha = torch.tensor(0.3, dtype=torch.double, requires_grad=True)
    adam = torch.optim.Adam([turn, shift, tint, alpha], lr=0.02)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(adam, steps)
    began = []
    for step in range(steps):
        began.append(time.process_time())
        adam.zero_grad()
        axes = torch.linalg.cross(turn.expand(3, 3), torch.eye(3, dtype=torch.double))
        moved = (cube - cube.mean(0)) @ axes.matrix_exp() + cube.mean(0) + shift
        values = {"cube.positions": moved, "metal.specular_reflectance.value": tint, "metal.alpha.value": alpha}
        number = 2 * (seed * steps + step)
        images = capwalk.torch.render(scene, values, views=views, spp=spp, spp_grad=spp_grad, seed=number)
        torch.autograd.backward((images - target).square().mean())
        adam.step()
        schedule.step()

    with torch.no_grad():
        metres, angle = shift.norm().item(), np.degrees(turn.norm().item())
        colour = (tint - torch.tensor([0.9, 0.6, 0.3])).abs().max().item()
        rough = abs(alpha.item() - 0.15)
    cost = (time.process_time() - began[1]) / (steps - 1)
    first = began[1] - began[0]
    return f"{first:.2f} | {cost:.3f} | {metres:.4f} | {angle:.2f} | {colour:.4f} | {rough:.4f}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--width", type=int, default=64)
    parser.add_argument("--spp", type=int, default=32)
    parser.add_argument("--spp-grad", type=int, default=3)
    parser.add_argument("--steps", type=int, default=100)
    parser.add_argument("--seeds", type=int, default=1)
    chosen = parser.parse_args()
    if chosen.steps < 2:
        parser.error("--steps: expected at least 2")
    print("| seed | CPU s, first step | CPU s, others | metres | degrees | tint | roughness |")
    print("|---|---|---|---|---|---|---|")
    for seed in range(chosen.seeds):
        scene = scene_of(chosen.width)
        row = found(scene, chosen.steps, chosen.spp, chosen.spp_grad, seed)
        print(f"| {seed} | {row} |", flush=True)


if __name__ == "__main__":
    main()

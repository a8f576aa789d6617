"""Optimisations that reuse the last gradient, beside plain Adam at equal cost.

    python python/benchmarks/reuse.py [--jobs NAME ...] [--rates X ...] [--seeds N]

With reuse, each of 60 steps computes the gradient at the new and at the last unknowns with the same random
numbers s, and gives Adam G = g(new, s) + a (G_last - g(last, s)). Plain Adam takes 120 steps, or 60 with twice
the samples. Prints for each way the true loss at the end times 10⁶ (the mean over seeds and its standard error)
and the processor time of a run, and then how the noise of g(new, s) and g(last, s) correlates at three
quarters of the plain run of 120 steps (from 50 seeds, pooled over the unknowns)."""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import capwalk as cw
import capwalk.torch
import numpy as np
import pose
import samples_by_noise
import torch


@dataclass
class Job:
    scene: cw.Scene
    start: torch.Tensor
    truth: torch.Tensor
    names: list[str]
    values: Callable[[torch.Tensor], list[torch.Tensor]]
    """From the unknowns, the arrays of these names."""
    least: torch.Tensor
    rate: float
    spp: tuple[int, int]
    """Of images and of gradients."""
    views: list[str] | None = None

    def __post_init__(self) -> None:
        self.targets = [self.images(self.truth, 1024, 2**30 + i) for i in range(2)]

    def images(self, at: torch.Tensor, spp: int, seed: int, spp_grad: int = 1) -> torch.Tensor:
        scene, values, views = self.scene, dict(zip(self.names, self.values(at))), self.views
        return capwalk.torch.render(scene, values, views=views, spp=spp, spp_grad=spp_grad, seed=seed, threads=1)

    def gradient(self, at: torch.Tensor, samples: int, seed: int) -> torch.Tensor:
        """Of the mean square, with so many times the samples."""
        at = at.detach().requires_grad_()
        images = self.images(at, self.spp[0] * samples, seed, self.spp[1] * samples)
        return torch.autograd.grad((images - sum(self.targets) / 2).square().mean(), at)[0]

    def loss(self, at: torch.Tensor) -> float:
        """A product of two images, so that noise does not add to it."""
        one, other = (self.images(at, 256, 2**29 + i) - self.targets[i] for i in range(2))
        return (one * other).mean().item()

    def run(self, rate: float, steps: int, samples: int, a: float, seed: int) -> list[torch.Tensor]:
        """The unknowns after each step."""
        at = self.start.clone().requires_grad_()
        adam = torch.optim.Adam([at], lr=rate, eps=1e-12)
        cosine = torch.optim.lr_scheduler.CosineAnnealingLR(adam, steps, rate / 10)
        passed = [self.start]
        for step in range(steps):
            gradient = self.gradient(at, samples, seed * 2**16 + step)
            if a > 0 and at.grad is not None:
                last = self.gradient(passed[-2], samples, seed * 2**16 + step)
                gradient += min(a, step / (step + 1)) * (at.grad - last)
            at.grad = gradient
            adam.step()
            cosine.step()
            at.data.clamp_(self.least, torch.tensor(0.99))
            passed.append(at.detach().clone())
        return passed

    def correlation(self, points: list[torch.Tensor]) -> float:
        """Of the noise of the gradients at two points with the same random numbers."""
        found = [torch.stack([self.gradient(at, 1, 2**28 + k) for k in range(50)]) for at in points]
        one, other = (each - each.mean(0) for each in found)
        return float((one * other).sum() / ((one**2).sum() * (other**2).sum()).sqrt())


def shadow() -> Job:
    scene = cw.load_file("leaf")
    scene.resize(40, 30)
    leaf, x = torch.tensor(cw.traverse(scene)["leaf.positions"]), torch.tensor([1, 0, 0])
    start, truth = torch.tensor([[0, 0.7, 0.68, 0.64], [0.2, 0.5, 0.6, 0.3]]).double()
    names, least = ["leaf.positions", "floor.bsdf.reflectance.value"], torch.tensor([-0.99, 0, 0, 0])
    return Job(scene, start, truth, names, lambda at: [leaf + at[0] * x, at[1:]], least, 0.1, (4, 2))


def cube() -> Job:
    scene = pose.scene_of(32)
    cube, axes = torch.tensor(cw.traverse(scene)["cube.positions"]), torch.eye(3).double()

    def values(at: torch.Tensor) -> list[torch.Tensor]:
        turn = torch.linalg.cross(at[:3].expand(3, 3), axes).matrix_exp()
        return [(cube - cube.mean(0)) @ turn + cube.mean(0) + at[3:6], at[6:9], at[9:]]

    start = torch.tensor([0.1, 0.2, -0.1, 0.2, 0.05, -0.15, 0.5, 0.5, 0.5, 0.3]).double()
    truth = torch.tensor([0, 0, 0, 0, 0, 0, 0.9, 0.6, 0.3, 0.15]).double()
    names = ["cube.positions", "metal.specular_reflectance.value", "metal.alpha.value"]
    least = torch.tensor([-0.99] * 6 + [0, 0, 0, 0.03])
    return Job(scene, start, truth, names, values, least, 0.02, (8, 1), ["left", "right"])


def texture() -> Job:
    name = "floor_bsdf.reflectance.data"
    with tempfile.TemporaryDirectory() as path:
        samples_by_noise.written("texture", Path(path), Path())
        scenes = [cw.load_file(f"{path}/{file}.xml") for file in ("scene", "wanted")]
    start, truth = (torch.tensor(cw.traverse(scene)[name]) for scene in scenes)
    return Job(scenes[0], start, truth, [name], lambda at: [at], torch.tensor(0), 0.03, (2, 2))


JOBS = {"shadow": shadow, "pose": cube, "texture": texture}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--jobs", nargs="+", default=list(JOBS))
    parser.add_argument("--rates", nargs="+", type=float, default=[0.33, 1, 3], help="times the job's")
    parser.add_argument("--seeds", type=int, default=6)
    chosen = parser.parse_args()
    ways = {"twice the steps": (2, 1, 0.0), "twice the samples": (1, 2, 0.0)}
    ways |= {f"reuse, a = {a}": (1, 1, a) for a in (0.5, 0.8, 0.95)}
    print(f"| job | rate | {' | '.join(ways)} | correlation |")
    print("|---" * (len(ways) + 3) + "|")
    for name in chosen.jobs:
        job = JOBS[name]()
        for rate in np.array(chosen.rates) * job.rate:
            row, late = f"| {name} | {rate:.3g} |", list[torch.Tensor]()
            for more, samples, a in ways.values():
                # The first step chooses a method.
                job.run(rate, 1, samples, a, 0)
                steps, began = more * 60, time.process_time()
                runs = [job.run(rate, steps, samples, a, seed) for seed in range(chosen.seeds)]
                cost = (time.process_time() - began) / chosen.seeds
                late = late or runs[0][3 * steps // 4 :][:2]
                losses = 1e6 * np.array([job.loss(run[-1]) for run in runs])
                error = losses.std(ddof=1) / chosen.seeds**0.5
                row += f" {losses.mean():.2f} ± {error:.2f} ({cost:.2f} s) |"
            print(f"{row} {job.correlation(late):.4f} |", flush=True)


if __name__ == "__main__":
    main()

"""Where a bunny of 70,000 triangles is, how it is turned and what colour it has, found from
three views of 40 x 40 pixels: by capwalk in PyTorch, or by one of Mitsuba's integrators in a
variant with derivatives.

    python python/benchmarks/bunny.py [capwalk | MITSUBA_INTEGRATOR] [IMAGE.png]

Prints the time of the first iteration and of the others, and how far off the bunny is."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

ITERATIONS, SPP, DECAY = 40, 16, 0.93
RATES = {"turn": 0.08, "shift": 0.04, "colour": 0.08}
GREY = {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.6, 0.6, 0.6]}}
MIDDLE = [0.2, 1.05, 0]
VIEWS = {"left": [-3.2, 1.6, 2.4], "front": [0.0, 1.2, 4.0], "right": [3.2, 2.2, 2.0]}
TRUTH = {"turn": [0.2, 0.7, -0.15], "shift": [0.2, 0.95, -0.15], "colour": [0.8, 0.45, 0.25]}
START = {"turn": [0.1, 0.5, 0.0], "shift": [0.0, 0.8, 0.05], "colour": [0.4, 0.4, 0.4]}


def bunny(rings: int = 132, sides: int = 266) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces: a ball with a head, two ears and a tail, seen from its middle."""
    polar = np.linspace(0, np.pi, rings + 1)[1:-1, None]
    around = np.linspace(0, 2 * np.pi, sides, endpoint=False)[None]
    rows = [np.sin(polar) * np.cos(around), np.cos(polar) + 0 * around, np.sin(polar) * np.sin(around)]
    directions = np.concatenate([np.stack(rows, -1).reshape(-1, 3), [[0, 1, 0], [0, -1, 0]]])
    radius = np.full(len(directions), 0.5)
    for towards, height, width in [
        ([0.55, 0.55, 0.0], 0.45, 0.35),  # head
        ([0.42, 0.9, 0.22], 0.75, 0.09),  # ears
        ([0.42, 0.9, -0.22], 0.75, 0.09),
        ([-1.0, 0.0, 0.0], 0.25, 0.2),  # tail
    ]:
        cosine = directions @ (np.array(towards) / np.linalg.norm(towards))
        radius += height * np.exp((cosine - 1) / width**2)
    i, j = np.meshgrid(np.arange(rings - 2), np.arange(sides), indexing="ij")
    right = (j + 1) % sides
    a, b, c, d = i * sides + j, (i + 1) * sides + j, (i + 1) * sides + right, i * sides + right
    top, bottom, last = len(directions) - 2, len(directions) - 1, (rings - 2) * sides
    ring, next_one = np.arange(sides), (np.arange(sides) + 1) % sides
    faces = [
        np.stack([a, c, b], -1).reshape(-1, 3),
        np.stack([a, d, c], -1).reshape(-1, 3),
        np.stack([np.full(sides, top), next_one, ring], -1),
        np.stack([np.full(sides, bottom), last + ring, last + next_one], -1),
    ]
    return 0.8 * radius[:, None] * directions, np.concatenate(faces)


def scene(look_at: Callable[..., Any], place: Callable[..., Any], shape: Any) -> dict[str, Any]:
    """What both renderers load; `place` turns about x by degrees, scales, then moves."""
    film = {"type": "hdrfilm", "width": 40, "height": 40, "rfilter": {"type": "box"}}
    emitter = {"type": "area", "radiance": {"type": "rgb", "value": 14.0}}
    views = {
        name: {"type": "perspective", "fov": 28, "to_world": look_at(origin), "film": film}
        for name, origin in VIEWS.items()
    }
    return {
        "type": "scene",
        **views,
        "integrator": {"type": "direct"},
        "floor": {"type": "rectangle", "to_world": place(-90, 6, [0, 0, 0]), "bsdf": GREY},
        "bunny": shape,
        "lamp": {"type": "rectangle", "to_world": place(90, 0.8, [1, 4, 1]), "emitter": emitter},
        "sky": {"type": "constant", "radiance": {"type": "rgb", "value": 0.25}},
    }


def in_capwalk() -> tuple[list[float], dict[str, np.ndarray], list[np.ndarray]]:
    import capwalk as cw
    import capwalk.torch
    import torch

    vertices, faces = bunny()
    shape = {"type": "mesh", "positions": vertices, "faces": faces, "bsdf": GREY}
    loaded = cw.load_dict(
        scene(
            lambda origin: cw.Transform().look_at(origin=origin, target=MIDDLE, up=[0, 1, 0]),
            lambda turn, size, to: cw.Transform().translate(to).rotate([1, 0, 0], turn).scale(size),
            shape,
        )
    )
    still = torch.from_numpy(vertices)

    method: Any = "auto"

    def render(unknowns: dict[str, torch.Tensor], view: int, seed: int, spp: int) -> torch.Tensor:
        x, y, z = unknowns["turn"]
        zero = torch.zeros_like(x)
        cross = torch.stack([zero, -z, y, z, zero, -x, -y, x, zero]).reshape(3, 3)
        tensors = {
            "bunny.positions": still @ torch.linalg.matrix_exp(cross).T + unknowns["shift"],
            "bunny.bsdf.reflectance.value": unknowns["colour"],
        }
        return capwalk.torch.render(loaded, tensors, sensor=view, spp=spp, seed=seed, method=method)

    truth, found = (
        {name: torch.tensor(value, dtype=torch.float64) for name, value in values.items()}
        for values in (TRUTH, START)
    )
    targets = [render(truth, view, 1000 + view, 64 * SPP) for view in range(len(VIEWS))]
    for value in found.values():
        value.requires_grad_(True)
    groups = [{"params": [found[name]], "lr": rate} for name, rate in RATES.items()]
    optimiser = torch.optim.Adam(groups)
    schedule = torch.optim.lr_scheduler.ExponentialLR(optimiser, gamma=DECAY)
    times = []
    for step in range(ITERATIONS):
        started = time.perf_counter()
        if step == 0:
            names = ["bunny.positions", "bunny.bsdf.reflectance.value"]
            method = cw.backward(loaded, np.ones((40, 40, 3)), names, sensor=1, spp=SPP).method
        optimiser.zero_grad()
        for view, target in enumerate(targets):
            image = render(found, view, len(VIEWS) * step + view, SPP)
            (image - target).square().mean().backward()
        optimiser.step()
        schedule.step()
        with torch.no_grad():
            found["colour"].clamp_(0.01, 0.99)
        times.append(time.perf_counter() - started)
    with torch.no_grad():
        images = [render(found, view, 3000 + view, 64) for view in range(len(VIEWS))]
    images = [image.numpy() for image in [*targets, *images]]
    return times, {name: value.detach().numpy() for name, value in found.items()}, images


def in_mitsuba(integrator: str) -> tuple[list[float], dict[str, np.ndarray], list[np.ndarray]]:
    import drjit as dr
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb")
    vertices, faces = bunny()
    properties = mi.Properties()
    properties["bsdf"] = mi.load_dict(GREY)
    mesh = mi.Mesh("bunny", len(vertices), len(faces), props=properties)
    params = mi.traverse(mesh)
    params["vertex_positions"] = mi.Float(vertices.ravel())
    params["faces"] = mi.UInt32(faces.ravel().astype(np.uint32))
    params.update()
    to_world = mi.ScalarTransform4f
    loaded = mi.load_dict(
        scene(
            lambda origin: to_world().look_at(origin=origin, target=MIDDLE, up=[0, 1, 0]),
            lambda turn, size, to: to_world().translate(to).rotate([1, 0, 0], turn).scale(size),
            mesh,
        )
    )
    how = mi.load_dict({"type": integrator, "max_depth": 2})
    params = mi.traverse(loaded)
    still = mi.Point3f(vertices.T)
    names = {name.rpartition("bunny.")[2]: name for name in params.keys() if "bunny" in name}
    positions = names["vertex_positions"]
    reflectance = names["bsdf.reflectance.value"]

    def render(unknowns: Any, view: int, seed: int, spp: int) -> Any:
        r = unknowns["turn"]
        angle = dr.sqrt(dr.squared_norm(r) + 1e-12)
        turned = mi.Transform4f().rotate(r / angle, angle * (180 / dr.pi)) @ still
        params[positions] = dr.ravel(turned + unknowns["shift"])
        params[reflectance] = mi.Color3f(unknowns["colour"])
        params.update()
        return mi.render(
            loaded, params, sensor=view, integrator=how, spp=spp, seed=seed, seed_grad=10**6 + seed
        )

    truth = {name: mi.Vector3f(value) for name, value in TRUTH.items()}
    start = {name: mi.Vector3f(value) for name, value in START.items()}
    found = mi.ad.Adam(lr=max(RATES.values()), params=start)
    targets = [dr.detach(render(truth, view, 1000 + view, 64 * SPP)) for view in range(len(VIEWS))]
    dr.eval(targets)
    times = []
    for step in range(ITERATIONS):
        started = time.perf_counter()
        found.set_learning_rate({name: rate * DECAY**step for name, rate in RATES.items()})
        for view, target in enumerate(targets):
            image = render(found, view, len(VIEWS) * step + view, SPP)
            dr.backward(dr.mean(dr.square(image - target), axis=None))
        found.step()
        found["colour"] = dr.clip(found["colour"], 0.01, 0.99)
        dr.eval({name: found[name] for name in START})
        dr.sync_thread()
        times.append(time.perf_counter() - started)
    images = [dr.detach(render(found, view, 3000 + view, 64)) for view in range(len(VIEWS))]
    images = [np.array(image) for image in [*targets, *images]]
    return times, {name: np.array(found[name]).ravel() for name in START}, images


def turned(vector: Any) -> np.ndarray:
    """The matrix of a rotation vector (Rodrigues)."""
    x, y, z = vector
    angle = np.linalg.norm(vector)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]) / angle
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def main() -> None:
    which = sys.argv[1] if len(sys.argv) > 1 else "capwalk"
    times, found, images = in_capwalk() if which == "capwalk" else in_mitsuba(which)
    rest = np.mean(times[1:])
    print(f"{which}: first iteration {times[0]:.2f} s, the others {rest:.3f} s each")
    vertices, _ = bunny()
    right = vertices @ turned(TRUTH["turn"]).T + TRUTH["shift"]
    reached = vertices @ turned(found["turn"]).T + found["shift"]
    off = np.sqrt(np.mean(np.sum((reached - right) ** 2, axis=1)))
    size = np.linalg.norm(vertices.max(axis=0) - vertices.min(axis=0))
    colour = np.linalg.norm(found["colour"] - TRUTH["colour"]) / np.linalg.norm(TRUTH["colour"])
    print(f"  vertices off by {off / size:.2%} of the bunny's diagonal, colour by {colour:.2%}")
    if len(sys.argv) > 2:
        import capwalk as cw

        rows = [np.concatenate(row, axis=1) for row in (images[:3], images[3:])]
        image = np.concatenate(rows, axis=0).astype(float)
        cw.Image(image, np.zeros_like(image), {}).save(sys.argv[2])


if __name__ == "__main__":
    main()

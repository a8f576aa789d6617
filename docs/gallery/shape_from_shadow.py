"""A shape from its shadow: python shape_from_shadow.py [WIDTH SPP STEPS] writes shape_from_shadow.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp, steps = map(int, sys.argv[1:] or (72, 8, 60))
angle, faces = np.arange(40) * (np.pi / 20), [[0, (i + 1) % 40 + 1, i + 1] for i in range(40)]
rim = np.stack([np.cos(angle), np.zeros(40), np.sin(angle)], axis=1)
scene = cw.load_dict({
    "type": "scene", "integrator": {"type": "direct"},
    "camera": {"type": "perspective", "fov": 42, "to_world": cw.Transform().look_at([0, 1.5, 2.4], [0, 0, 0], [0, 1, 0])},
    "floor": {"type": "rectangle", "to_world": cw.Transform().rotate([1, 0, 0], -90).scale(4)},
    "sheet": {"type": "mesh", "positions": np.vstack([[0, 2, 0], 0.5 * rim + [0, 2, 0]]), "faces": faces},
    "lamp": {"type": "rectangle", "to_world": cw.Transform().translate([0, 6, 0]).rotate([1, 0, 0], 90).scale(0.3),
             "emitter": {"type": "area", "radiance": 250.0}},
})  # fmt: skip
scene.resize(width, width * 3 // 4)
params, found, adam = cw.traverse(scene), {"radius": np.full(40, 0.5)}, cw.Adam(lr=0.01)


def shadow_of(radius, seed, spp=16 * spp):
    params.update({"sheet.positions": np.vstack([[0, 2, 0], radius[:, None] * rim + [0, 2, 0]])})
    return cw.render(scene, spp=spp, seed=seed).value


target, before = shadow_of(0.5 + 0.15 * np.cos(5 * angle), seed=0), shadow_of(found["radius"], seed=1)
for step in range(1, steps + 1):
    adjoint = 2 * (shadow_of(found["radius"], seed=2 * step, spp=spp) - target) / target.size
    grads = cw.backward(scene, adjoint, ["sheet.positions"], spp=spp, seed=2 * step + 1)
    adam.step(found, {"radius": (grads["sheet.positions"][1:] * rim).sum(axis=1)})
images = {"before": before, "after": shadow_of(found["radius"], seed=1), "target": target}

figure, axes = plt.subplots(1, 3, figsize=(4, 1.25), dpi=96, layout="constrained", subplot_kw={"xticks": [], "yticks": []})
for ax, (title, image) in zip(axes, images.items()):
    ax.imshow(np.clip(image, 0, 1) ** (1 / 2.2))
    ax.set_title(title, fontsize=9)
figure.savefig("shape_from_shadow.png")

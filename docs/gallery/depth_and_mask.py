"""Distances and coverage as a camera moves: python depth_and_mask.py [WIDTH SPP] writes depth_and_mask.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp = map(int, sys.argv[1:] or (128, 64))
place = cw.Transform()
scene = cw.load_dict({
    "type": "scene",
    "integrator": {"type": "direct"},
    "camera": {"type": "perspective", "fov": 38, "to_world": place.look_at([1.5, 1.5, 4.5], [0, 0, 0], [0, 1, 0]),
               "film": {"type": "hdrfilm", "width": width, "height": width * 3 // 4}},
    "cube": {"type": "cube", "to_world": place.translate([-0.5, 0, 0]).rotate([0, 1, 0], 20).scale(0.6)},
    "ball": {"type": "sphere", "center": [0.8, 0.2, -0.6], "radius": 0.7},
    "sky": {"type": "constant"},
})  # fmt: skip
figure, rows = plt.subplots(2, 2, figsize=(4, 3.2), dpi=96, layout="constrained")
for (left, right), aov in zip(rows, ["depth", "mask"]):
    derivative = cw.gradient(scene, "camera.translate.x", aov=aov, spp=spp)
    left.imshow(derivative.value[..., 0], cmap="gray")
    left.set_title(aov, fontsize=9)
    change = derivative.gradient[..., 0]
    limit = np.quantile(np.abs(change), 0.97)
    right.imshow(change, cmap="RdBu_r", vmin=-limit, vmax=limit)
    right.set_title("derivative: camera to the right", fontsize=9)
for ax in rows.flat:
    ax.axis("off")
figure.savefig("depth_and_mask.png")

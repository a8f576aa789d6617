"""A copper floor becomes rougher: python roughness.py [WIDTH SPP] writes roughness.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp = map(int, sys.argv[1:] or (192, 64))
place = cw.Transform()
scene = cw.load_dict({
    "type": "scene",
    "integrator": {"type": "path", "max_depth": 3},
    "camera": {"type": "perspective", "fov": 38, "to_world": place.look_at([0, 1.3, 4], [0, 0.6, 0], [0, 1, 0]),
               "film": {"type": "hdrfilm", "width": width, "height": width * 3 // 4}},
    "floor": {"type": "rectangle", "to_world": place.rotate([1, 0, 0], -90).scale(3),
              "bsdf": {"type": "roughconductor", "material": "Cu", "distribution": "ggx", "alpha": 0.15}},
    "ball": {"type": "sphere", "center": [-0.6, 0.5, 0], "radius": 0.5},
    "panel": {"type": "rectangle", "to_world": place.translate([0.8, 0.9, -1]).scale([0.4, 0.7, 1]),
              "emitter": {"type": "area", "radiance": {"type": "rgb", "value": [1.5, 1.3, 0.9]}}},
    "sky": {"type": "constant", "radiance": 0.15},
})  # fmt: skip
derivative = cw.gradient(scene, "floor.bsdf.alpha", spp=spp)

figure, (left, right) = plt.subplots(1, 2, figsize=(4, 1.6), dpi=96, layout="constrained")
left.imshow(np.clip(derivative.value, 0, 1) ** (1 / 2.2))
left.set_title("image", fontsize=9)
change = derivative.gradient.mean(axis=2)
limit = np.quantile(np.abs(change), 0.99)
right.imshow(change, cmap="RdBu_r", vmin=-limit, vmax=limit)
right.set_title("derivative: roughness of floor", fontsize=9)
for ax in (left, right):
    ax.axis("off")
figure.savefig("roughness.png")

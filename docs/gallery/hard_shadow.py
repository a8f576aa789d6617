"""A hard shadow turns: python hard_shadow.py [WIDTH SPP] writes hard_shadow.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp = map(int, sys.argv[1:] or (192, 64))
place = cw.Transform()
cube = place.translate([0, 0.6, 0]).rotate([0, 1, 0], 25).rotate([1, 0, 0], 35).scale(0.35)
scene = cw.load_dict({
    "type": "scene",
    "integrator": {"type": "direct"},
    "camera": {"type": "perspective", "fov": 36, "to_world": place.look_at([1.5, 2.2, 3.6], [0.25, 0.35, 0], [0, 1, 0]),
               "film": {"type": "hdrfilm", "width": width, "height": width * 3 // 4}},
    "floor": {"type": "rectangle", "to_world": place.rotate([1, 0, 0], -90).scale(5)},
    "cube": {"type": "cube", "to_world": cube,
             "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.7, 0.4, 0.2]}}},
    "bulb": {"type": "point", "position": [-1.2, 3, 1.2], "intensity": 14.0},
})  # fmt: skip
derivative = cw.gradient(scene, "cube.rotate.y", spp=spp)

figure, (left, right) = plt.subplots(1, 2, figsize=(4, 1.6), dpi=96, layout="constrained")
left.imshow(np.clip(derivative.value, 0, 1) ** (1 / 2.2))
left.set_title("image", fontsize=9)
change = derivative.gradient.mean(axis=2)
limit = np.quantile(np.abs(change), 0.99)
right.imshow(change, cmap="RdBu_r", vmin=-limit, vmax=limit)
right.set_title("derivative: cube turns", fontsize=9)
for ax in (left, right):
    ax.axis("off")
figure.savefig("hard_shadow.png")

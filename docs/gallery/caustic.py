"""The light below a ball of glass: python caustic.py [WIDTH SPP] writes caustic.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp = map(int, sys.argv[1:] or (144, 256))
place = cw.Transform()
scene = cw.load_dict({
    "type": "scene",
    "integrator": {"type": "path", "max_depth": 5},
    "camera": {"type": "perspective", "fov": 30, "to_world": place.look_at([0, 2.4, 4.6], [0, 0.55, 0], [0, 1, 0]),
               "film": {"type": "hdrfilm", "width": width, "height": width * 3 // 4}},
    "floor": {"type": "rectangle", "to_world": place.rotate([1, 0, 0], -90).scale(4)},
    "ball": {"type": "sphere", "center": [0, 0.9, 0], "radius": 0.5, "bsdf": {"type": "dielectric", "int_ior": 1.4}},
    "lamp": {"type": "rectangle", "to_world": place.translate([0, 3.2, 0]).rotate([1, 0, 0], 90).scale(0.8),
             "emitter": {"type": "area", "radiance": 9.0}},
})  # fmt: skip
derivative = cw.gradient(scene, "ball.bsdf.int_ior", spp=spp)

figure, (left, right) = plt.subplots(1, 2, figsize=(4, 1.6), dpi=96, layout="constrained")
left.imshow(np.clip(derivative.value, 0, 1) ** (1 / 2.2))
left.set_title("image", fontsize=9)
change = derivative.gradient.mean(axis=2)
limit = np.quantile(np.abs(change), 0.98)
right.imshow(change, cmap="RdBu_r", vmin=-limit, vmax=limit)
right.set_title("derivative: index of refraction", fontsize=9)
for ax in (left, right):
    ax.axis("off")
figure.savefig("caustic.png")

"""A ball of glass refracts more: python glass_lens.py [WIDTH SPP] writes glass_lens.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp = map(int, sys.argv[1:] or (160, 24))
place = cw.Transform()
v, u = np.mgrid[0:128, 0:128] * (np.pi / 4)
waves = np.stack([0.5 + 0.4 * np.cos(u), np.full_like(u, 0.4), 0.5 + 0.4 * np.cos(v)], axis=2)
scene = cw.load_dict({
    "type": "scene",
    "integrator": {"type": "path", "max_depth": 6},
    "camera": {"type": "perspective", "fov": 34, "to_world": place.look_at([0, 0, 5], [0, 0, 0], [0, 1, 0]),
               "film": {"type": "hdrfilm", "width": width, "height": width * 3 // 4}},
    "wall": {"type": "rectangle", "to_world": place.translate([0, 0, -2]).scale(4),
             "emitter": {"type": "area", "radiance": {"type": "bitmap", "data": waves, "raw": True}}},
    "ball": {"type": "sphere", "bsdf": {"type": "dielectric", "int_ior": 1.3}},
    "sky": {"type": "constant", "radiance": 0.3},
})  # fmt: skip
image = cw.render(scene, spp=4 * spp)
derivative = cw.gradient(scene, "ball.bsdf.int_ior", spp=spp)

figure, (left, right) = plt.subplots(1, 2, figsize=(4, 1.6), dpi=96, layout="constrained")
left.imshow(np.clip(image.value, 0, 1) ** (1 / 2.2))
left.set_title("image", fontsize=9)
change = derivative.gradient.mean(axis=2)
limit = np.quantile(np.abs(change), 0.98)
right.imshow(change, cmap="RdBu_r", vmin=-limit, vmax=limit)
right.set_title("derivative: index of refraction", fontsize=9)
for ax in (left, right):
    ax.axis("off")
figure.savefig("glass_lens.png")

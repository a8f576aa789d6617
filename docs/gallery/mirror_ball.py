"""A cube moves before a ball of gold: python mirror_ball.py [WIDTH SPP] writes mirror_ball.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp = map(int, sys.argv[1:] or (192, 32))
place = cw.Transform()
scene = cw.load_dict({
    "type": "scene",
    "integrator": {"type": "path", "max_depth": 3},
    "camera": {"type": "perspective", "fov": 40, "to_world": place.look_at([0, 1.6, 5], [-0.2, 0.8, 0], [0, 1, 0]),
               "film": {"type": "hdrfilm", "width": width, "height": width * 3 // 4}},
    "floor": {"type": "rectangle", "to_world": place.rotate([1, 0, 0], -90).scale(6)},
    "ball": {"type": "sphere", "center": [0.4, 1, 0], "bsdf": {"type": "conductor", "material": "Au"}},
    "cube": {"type": "cube", "to_world": place.translate([-1.2, 0.45, 0.9]).rotate([0, 1, 0], 30).scale(0.35),
             "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.1, 0.3, 0.8]}}},
    "sky": {"type": "constant", "radiance": 0.8},
})  # fmt: skip
image = cw.render(scene, spp=4 * spp)
derivative = cw.gradient(scene, "cube.translate.x", spp=spp)

figure, (left, right) = plt.subplots(1, 2, figsize=(4, 1.6), dpi=96, layout="constrained")
left.imshow(np.clip(image.value, 0, 1) ** (1 / 2.2))
left.set_title("image", fontsize=9)
change = derivative.gradient.mean(axis=2)
limit = np.quantile(np.abs(change), 0.99)
right.imshow(change, cmap="RdBu_r", vmin=-limit, vmax=limit)
right.set_title("derivative: cube to the right", fontsize=9)
for ax in (left, right):
    ax.axis("off")
figure.savefig("mirror_ball.png")

"""A texture from an image of it: python texture_under_sky.py [WIDTH SPP STEPS] writes texture_under_sky.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp, steps = map(int, sys.argv[1:] or (96, 8, 50))
place = cw.Transform()
y, x = np.mgrid[-1:1:32j, -1:1:32j]
rings = 0.5 + 0.4 * np.stack([np.sin(9 * np.hypot(x, y)), np.sin(9 * x), np.cos(9 * y)], axis=2)
sky = np.stack([0.7 + 0.3 * y, 0.9 + 0 * y, 1.1 - 0.3 * y], axis=2)
scene = cw.load_dict({
    "type": "scene",
    "integrator": {"type": "direct"},
    "camera": {"type": "perspective", "fov": 44, "to_world": place.look_at([0, 2, 2.4], [0, 0, 0], [0, 1, 0]),
               "film": {"type": "hdrfilm", "width": width, "height": width * 3 // 4}},
    "rug": {"type": "rectangle", "to_world": place.rotate([1, 0, 0], -90),
            "bsdf": {"type": "diffuse", "reflectance": {"type": "bitmap", "data": rings, "raw": True}}},
    "ball": {"type": "sphere", "center": [0, 0.35, -0.5], "radius": 0.35},
    "sky": {"type": "envmap", "bitmap": sky},
})  # fmt: skip
params, name, adam = cw.traverse(scene), "rug.bsdf.reflectance.data", cw.Adam(lr=0.05)
images = {"target": cw.render(scene, spp=8 * spp, seed=0).value}
params.update({name: np.full_like(rings, 0.5)})
images["before"] = cw.render(scene, spp=8 * spp, seed=1).value
for step in range(1, steps + 1):
    image = cw.render(scene, spp=spp, seed=2 * step)
    adjoint = 2 * (image.value - images["target"]) / image.value.size
    adam.step(params, cw.backward(scene, adjoint, [name], spp=spp, seed=2 * step + 1))
    params.update({name: np.clip(params[name], 0, 1)})
images["after"] = cw.render(scene, spp=8 * spp, seed=1).value

figure, axes = plt.subplots(1, 3, figsize=(4, 1.25), dpi=96, layout="constrained")
for ax, title in zip(axes, ["before", "after", "target"]):
    ax.imshow(np.clip(images[title], 0, 1) ** (1 / 2.2))
    ax.set_title(title, fontsize=9)
    ax.axis("off")
figure.savefig("texture_under_sky.png")

"""One derivative, seen by three cameras: python many_views.py [WIDTH SPP] writes many_views.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp = map(int, sys.argv[1:] or (128, 32))
place = cw.Transform()
film = {"type": "hdrfilm", "width": width, "height": width * 3 // 4}
views = {"left": [-3, 2, 3], "front": [0, 2, 4.2], "above": [0, 5, 0.1]}
cameras = {
    name: {"type": "perspective", "to_world": place.look_at(origin, [0, 0.4, 0], [0, 1, 0]), "film": film, "fov": 40}
    for name, origin in views.items()
}
scene = cw.load_dict({
    "type": "scene",
    "integrator": {"type": "direct"},
    **cameras,
    "floor": {"type": "rectangle", "to_world": place.rotate([1, 0, 0], -90).scale(6)},
    "cube": {"type": "cube", "to_world": place.translate([0, 0.8, 0]).rotate([0, 1, 0], 20).scale(0.4),
             "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.2, 0.5, 0.8]}}},
    "lamp": {"type": "rectangle", "to_world": place.translate([1, 4, 1]).rotate([1, 0, 0], 90).scale(0.4),
             "emitter": {"type": "area", "radiance": 50.0}},
})  # fmt: skip
figure, rows = plt.subplots(2, 3, figsize=(4, 2.4), dpi=96, layout="constrained")
for view, above, below in zip(views, *rows):
    derivative = cw.gradient(scene, "cube.translate.x", sensor=view, spp=spp)
    above.imshow(np.clip(derivative.value, 0, 1) ** (1 / 2.2))
    above.set_title(view, fontsize=9)
    change = derivative.gradient.mean(axis=2)
    below.imshow(change, cmap="RdBu_r", vmin=-0.6, vmax=0.6)
    below.set_title("derivative", fontsize=9)
for ax in rows.flat:
    ax.axis("off")
figure.savefig("many_views.png")

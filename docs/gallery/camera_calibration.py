"""A camera from its image: python camera_calibration.py [WIDTH SPP STEPS] writes camera_calibration.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp, steps = map(int, sys.argv[1:] or (64, 8, 100))
size, K = (width, width * 3 // 4), [[2 * width, 0, width / 2], [0, 2 * width, width * 3 // 4 / 2], [0, 0, 1]]
world_to_camera = [[1, 0, 0, 0], [0, -1, 0, 0.4], [0, 0, -1, 5.0]]
scene = cw.load_dict({
    "type": "scene", "integrator": {"type": "direct"},
    "camera": cw.cameras.from_opencv(K, world_to_camera, size, first_pixel=0.5),
    "cube": {"type": "cube", "to_world": cw.Transform().translate([0.1, 0.5, 0]).rotate([0, 1, 0], 30).scale(0.5),
             "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.7, 0.3, 0.2]}}},
    "lamp": {"type": "point", "position": [1, 3, 4], "intensity": 50.0},
})  # fmt: skip
params, names = cw.traverse(scene), ["camera.translate", "camera.x_fov"]
photograph, true_fov = cw.render(scene, spp=16 * spp, seed=0).value, params["camera.x_fov"].item()
params.update({"camera.x_fov": params["camera.x_fov"] + 6, "camera.translate": np.array([0.3, 0.2, 0.0])})
errors = {"before": cw.render(scene, spp=16 * spp, seed=1).value - photograph}
moved, zoomed, fovs = cw.Adam(lr=0.01), cw.Adam(lr=0.4), []
for step in range(1, steps + 1):
    adjoint = 2 * (cw.render(scene, spp=spp, seed=2 * step).value - photograph) / photograph.size
    grads = cw.backward(scene, adjoint, names, spp=spp, seed=2 * step + 1)
    moved.step(params, {names[0]: grads[names[0]]})
    zoomed.step(params, {names[1]: grads[names[1]]})
    params.update()
    fovs.append(params["camera.x_fov"].item())
errors |= {"after": cw.render(scene, spp=16 * spp, seed=1).value - photograph}

figure, axes = plt.subplots(1, 3, figsize=(4, 1.4), dpi=96, layout="constrained")
for ax, (title, error) in zip(axes, errors.items()):
    ax.imshow(error.mean(axis=2), cmap="RdBu_r", vmin=-0.5, vmax=0.5)
    ax.set_title(f"error {title}", fontsize=9)
    ax.axis("off")
axes[2].plot([true_fov] * steps, "k:", fovs)
axes[2].set_title("field of view (°)", fontsize=9)
figure.savefig("camera_calibration.png")

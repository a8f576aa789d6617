"""What colour is the lamp? python colour_of_light.py [WIDTH SPP STEPS] writes colour_of_light.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp, steps = map(int, sys.argv[1:] or (96, 16, 40))
scene = cw.load_file("box-room")
scene.resize(width, width * 3 // 4)
params = cw.traverse(scene)
name = "lamp.emitter.radiance.value"
white = params[name].copy()
params[name] = white * [1.3, 0.9, 0.4]
params.update()
target = cw.render(scene, spp=4 * spp, seed=0).value
params[name] = white
params.update()
images = {"before": cw.render(scene, spp=4 * spp, seed=1).value}
adam = cw.Adam(lr=0.04 * white.mean())
for step in range(1, steps + 1):
    image = cw.render(scene, spp=spp, seed=2 * step)
    adjoint = 2 * (image.value - target) / target.size
    adam.step(params, cw.backward(scene, adjoint, [name], spp=spp, seed=2 * step + 1))
    params.update()
images |= {"after": cw.render(scene, spp=4 * spp, seed=1).value, "target": target}
print("radiance relative to that of the white lamp:", (params[name] / white).round(3), "target: 1.3 0.9 0.4")

figure, axes = plt.subplots(1, 3, figsize=(4, 1.25), dpi=96, layout="constrained")
for ax, (title, image) in zip(axes, images.items()):
    ax.imshow(np.clip(image, 0, 1) ** (1 / 2.2))
    ax.set_title(title, fontsize=9)
    ax.axis("off")
figure.savefig("colour_of_light.png")

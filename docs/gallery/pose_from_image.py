"""A box is put where a photograph shows it: python pose_from_image.py [WIDTH SPP STEPS] writes pose_from_image.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp, steps = map(int, sys.argv[1:] or (96, 8, 50))
scene = cw.load_file("box-room")
scene.resize(width, width * 3 // 4)
params = cw.traverse(scene)
placed, middle = params["box.to_world"].copy(), params["box.positions"].mean(axis=0)
names = ["box.translate.x", "box.translate.z", "box.rotate.y"]


def image_of(pose, seed, spp=4 * spp):
    moved = cw.Transform().translate(middle + [pose[0], 0, pose[1]]).rotate([0, 1, 0], np.degrees(pose[2]))
    params["box.to_world"] = moved.translate(-middle).matrix @ placed
    params.update()
    return cw.render(scene, spp=spp, seed=seed).value


target = image_of([0, 0, 0], seed=0)
pose = {"box": np.array([-0.4, 0.3, 0.6])}
images = {"before": image_of(pose["box"], seed=1)}
adam = cw.Adam(lr=0.03)
for step in range(1, steps + 1):
    adjoint = 2 * (image_of(pose["box"], seed=2 * step, spp=spp) - target) / target.size
    grads = cw.backward(scene, adjoint, names, spp=spp, seed=2 * step + 1)
    adam.step(pose, {"box": np.array([grads[name].item() for name in names])})
images |= {"after": image_of(pose["box"], seed=1), "target": target}
print("what is left of the displacement and of the angle:", pose["box"].round(3))

figure, axes = plt.subplots(1, 3, figsize=(4, 1.25), dpi=96, layout="constrained")
for ax, (title, image) in zip(axes, images.items()):
    ax.imshow(np.clip(image, 0, 1) ** (1 / 2.2))
    ax.set_title(title, fontsize=9)
    ax.axis("off")
figure.savefig("pose_from_image.png")

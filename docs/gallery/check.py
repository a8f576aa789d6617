"""A derivative and finite differences: python check.py [WIDTH SPP] writes check.png, and prints a verdict."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp = map(int, sys.argv[1:] or (96, 64))
scene = cw.load_file("ball")
scene.resize(width, width * 3 // 4)
check = cw.check(scene, "ball.translate.x", spp=spp)
print(check)

error = np.hypot(check.stderr, check.reference_stderr)
z = np.divide(check.gradient - check.reference, error, out=np.zeros_like(error), where=error > 0)
limit = np.quantile(np.abs(check.reference), 0.99)
figure, axes = plt.subplots(2, 2, figsize=(4, 3.2), dpi=96, layout="constrained")
axes[0, 0].imshow(np.clip(cw.render(scene, spp=spp).value, 0, 1) ** (1 / 2.2))
panels = {"derivative": check.gradient, "finite differences": check.reference, "z of the difference, ±3": z * limit / 3}
for ax, (title, panel) in zip(axes.flat[1:], panels.items()):
    ax.imshow(panel.mean(axis=2), cmap="RdBu_r", vmin=-limit, vmax=limit)
    ax.set_title(title, fontsize=9)
axes[0, 0].set_title("image", fontsize=9)
for ax in axes.flat:
    ax.axis("off")
figure.savefig("check.png")

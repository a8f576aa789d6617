"""A shadow moves: python moving_shadow.py [WIDTH SPP] writes moving_shadow.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp = map(int, sys.argv[1:] or (192, 32))
scene = cw.load_file("lattice-shadow")
scene.resize(width, width * 3 // 4)
derivative = cw.gradient(scene, "lattice.translate.y", spp=spp)

figure, (left, right) = plt.subplots(1, 2, figsize=(4, 1.6), dpi=96, layout="constrained")
left.imshow(np.clip(derivative.value, 0, 1) ** (1 / 2.2))
left.set_title("image", fontsize=9)
change = derivative.gradient.mean(axis=2)
limit = np.quantile(np.abs(change), 0.99)
right.imshow(change, cmap="RdBu_r", vmin=-limit, vmax=limit)
right.set_title("derivative: lattice up", fontsize=9)
for ax in (left, right):
    ax.axis("off")
figure.savefig("moving_shadow.png")

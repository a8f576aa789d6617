"""Distances and coverage as a camera moves: python depth_and_mask.py [WIDTH SPP] writes depth_and_mask.png."""

import sys

import capwalk as cw
import matplotlib.pyplot as plt
import numpy as np

width, spp = map(int, sys.argv[1:] or (144, 32))
scene = cw.load_file("ball")
scene.resize(width, width * 3 // 4)
figure, rows = plt.subplots(2, 2, figsize=(4, 3.2), dpi=96, layout="constrained")
for (left, right), aov in zip(rows, ["depth", "mask"]):
    derivative = cw.gradient(scene, "sensor.translate.x", aov=aov, spp=spp)
    left.imshow(derivative.value[..., 0], cmap="gray")
    left.set_title(aov, fontsize=9)
    change = derivative.gradient[..., 0]
    limit = np.quantile(np.abs(change), 0.99)
    right.imshow(change, cmap="RdBu_r", vmin=-limit, vmax=limit)
    right.set_title(f"derivative of {aov}: camera moves", fontsize=9)
for ax in rows.flat:
    ax.axis("off")
figure.savefig("depth_and_mask.png")

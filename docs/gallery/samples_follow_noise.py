"""Samples that follow the noise: python samples_follow_noise.py [WIDTH SPP STEPS] writes samples_follow_noise.png."""

import sys
import tempfile
from pathlib import Path

import capwalk as cw
import matplotlib.pyplot as plt

width, spp, steps = map(int, sys.argv[1:] or (40, 4, 160))
JOB = f"""
scene = "leaf"
size = [{width}, {width * 3 // 4}]
iterations = {steps}
spp = {spp}
images = 0
[samples]
most = 256
[target]
set = {{ "leaf.translate.x" = 0.2 }}
[[parameter]]
name = "leaf.translate.x"
[optimizer]
lr = 0.02
"""
with tempfile.TemporaryDirectory() as folder:
    (Path(folder) / "job.toml").write_text(JOB)
    record = cw.optimize(Path(folder) / "job.toml").record

figure, (left, right) = plt.subplots(1, 2, figsize=(4, 1.8), dpi=96, layout="constrained")
left.plot(record["leaf.translate.x"])
left.axhline(0.2, color="k", linestyle=":")
left.set_title("position of the leaf", fontsize=9)
right.semilogy(record["spp"], label="image", base=2)
right.semilogy(record["spp_grad"], label="gradient", base=2)
right.set_title("samples per pixel", fontsize=9)
right.legend(fontsize=8, loc="upper left")
for ax in (left, right):
    ax.set_xlabel("step", fontsize=9)
figure.savefig("samples_follow_noise.png")

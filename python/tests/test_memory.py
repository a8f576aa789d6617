"""The memory that work takes does not depend on how much of it there is."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

STATUS = Path("/proc/self/status")

TOLERANCE = 4.0
"""MiB by which peaks may differ. Repeated runs differ by less than one."""

GRADIENT = """
import sys
import capwalk as cw, numpy as np

spp, max_depth = map(int, sys.argv[1:])
T = cw.Transform
scene = cw.load_dict({
    "type": "scene",
    "integrator": {"type": "path", "max_depth": max_depth, "rr_depth": 100},
    "sensor": {
        "type": "perspective",
        "to_world": T().look_at(origin=[0, 1, 5], target=[0, 1, 0], up=[0, 1, 0]),
        "film": {"type": "hdrfilm", "width": 16, "height": 12},
    },
    "floor": {"type": "rectangle", "to_world": T().rotate([1, 0, 0], -90).scale(3)},
    "wall": {"type": "rectangle", "to_world": T().translate([0, 1, -2]).scale(3)},
    "cube": {"type": "cube", "to_world": T().translate([0, 0.7, 0]).scale(0.5)},
    "lamp": {
        "type": "rectangle",
        "to_world": T().translate([0, 3, 0]).rotate([1, 0, 0], 90),
        "emitter": {"type": "area", "radiance": 10.0},
    },
})
cw.backward(scene, np.ones((12, 16, 3)), ["cube.positions"], spp=spp, threads=2)
print(next(line for line in open("/proc/self/status") if line.startswith("VmHWM:")).split()[1])
"""
"""Prints the most memory of the process, KiB. (`ru_maxrss` of `resource` counts what the process that
started this one had.)"""


def peak(spp: int, max_depth: int) -> float:
    """The most memory of a process that computes a gradient, MiB."""
    command = [sys.executable, "-c", GRADIENT, str(spp), str(max_depth)]
    found = subprocess.run(command, capture_output=True, text=True, check=True)
    return int(found.stdout) / 1024


@pytest.mark.skipif(not STATUS.exists(), reason="the peak of a process is read from /proc")
def test_memory_does_not_grow_with_samples_or_depth() -> None:
    """32 times the samples, and paths that are four times as long. Eight bytes kept of each segment of
    these 49,152 paths would be more than the tolerance."""
    least = peak(8, 3)
    assert peak(256, 3) - least < TOLERANCE
    assert peak(8, 12) - least < TOLERANCE
    assert peak(256, 12) - least < TOLERANCE

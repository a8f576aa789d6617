"""True if Mitsuba can render with LLVM here."""

from __future__ import annotations

import functools
import subprocess
import sys

RENDER = """
import mitsuba as mi
mi.set_variant("llvm_ad_rgb")
print(mi.render(mi.load_dict(mi.cornell_box()), spp=1).array[0])
"""


@functools.cache
def has_llvm() -> bool:
    """False where LLVM is not installed, or too old for the kernels of Mitsuba: then it ends the
    process that compiles them, so another one tries."""
    return subprocess.run([sys.executable, "-c", RENDER], capture_output=True).returncode == 0

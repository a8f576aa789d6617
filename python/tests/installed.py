"""Checks an installation by an image, a derivative with its error, and a check:

    python python/tests/installed.py             # the capwalk that this Python imports
    python python/tests/installed.py PACKAGE     # a wheel or an sdist, in a fresh environment
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
import venv
from importlib import metadata
from pathlib import Path

WIDTH, HEIGHT = 64, 48
NAME = "leaf.translate.x"


def check() -> None:
    """Renders, differentiates and checks a built-in scene with the capwalk that is installed."""
    import numpy as np

    import capwalk as cw

    scene = cw.load_file("leaf")
    scene.resize(WIDTH, HEIGHT)
    image = cw.render(scene, spp=16)
    assert image.value.shape == (HEIGHT, WIDTH, 3) and np.all(np.isfinite(image.value))
    derivative = cw.gradient(scene, NAME, spp=16)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "gradient.png")
        derivative.save(file)
        assert file.stat().st_size > 0
    assert derivative.gradient.any() and derivative.stderr.any()
    print(Path(cw.__file__).parent)
    print(derivative)
    verdict = cw.check(scene, NAME, spp=64)
    print(verdict)
    assert verdict.right, "the derivative is not right"
    assert cw.__version__ == metadata.version("capwalk")


def check_fresh(package: Path) -> None:
    """Installs a package in an environment of its own, and checks it there."""
    started = time.monotonic()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        venv.create(folder, with_pip=True)
        python = Path(folder, "Scripts/python.exe" if sys.platform == "win32" else "bin/python")
        subprocess.run([python, "-m", "pip", "install", "--quiet", package], check=True)
        # In isolated mode, in which nothing around is imported.
        subprocess.run([python, "-I", __file__], check=True, cwd=folder)
    print(f"{package.name}: installed and checked in {time.monotonic() - started:.0f} s")


if __name__ == "__main__":
    match sys.argv[1:]:
        case []:
            check()
        case [package]:
            check_fresh(Path(package).resolve())
        case _:
            sys.exit(__doc__)

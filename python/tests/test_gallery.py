"""The scripts of the gallery run with few pixels, samples and steps, and each writes its picture.

``python python/tests/test_gallery.py [NAME...]`` runs them as they are, and stores the pictures in 256 colours.
"""

from __future__ import annotations

import os
import re
import runpy
import sys
import tempfile
from pathlib import Path
from typing import Any

import pytest

DOCS = Path(__file__).parents[2] / "docs"
PICTURES = DOCS / "images" / "gallery"
SCRIPTS = {path.stem: path for path in sorted((DOCS / "gallery").glob("*.py"))}

TINY = ["12", "4", "2"]
"""Width, samples per pixel and steps."""

PNG = b"\x89PNG\r\n\x1a\n"


def run(name: str, arguments: list[str], monkeypatch: pytest.MonkeyPatch) -> bytes:
    """The picture that a script writes into the current folder."""
    monkeypatch.setenv("MPLBACKEND", "agg")
    monkeypatch.setattr(sys, "argv", [name, *arguments])
    runpy.run_path(str(SCRIPTS[name]))
    return Path(f"{name}.png").read_bytes()


@pytest.mark.parametrize("name", SCRIPTS)
def test_script_writes_its_picture(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plt: Any = pytest.importorskip("matplotlib.pyplot")
    monkeypatch.chdir(tmp_path)
    text = SCRIPTS[name].read_text(encoding="utf-8")
    arguments = TINY if "[WIDTH SPP STEPS]" in text else TINY[:2]
    assert run(name, arguments, monkeypatch).startswith(PNG)
    assert [path.name for path in tmp_path.iterdir()] == [f"{name}.png"]
    plt.close("all")


def test_page_shows_each_script_and_picture() -> None:
    page = (DOCS / "gallery.md").read_text(encoding="utf-8")
    assert sorted(re.findall(r"\]\(gallery/(\w+)\.py\)", page)) == list(SCRIPTS)
    assert sorted(re.findall(r"\]\(images/gallery/(\w+)\.png\)", page)) == list(SCRIPTS)


def test_scripts_and_pictures_are_small() -> None:
    for path in SCRIPTS.values():
        assert len(path.read_text(encoding="utf-8").splitlines()) <= 40, path.name
    sizes = {path.stem: path.stat().st_size for path in PICTURES.iterdir()}
    assert sorted(sizes) == list(SCRIPTS)
    assert max(sizes.values()) < 60_000 and sum(sizes.values()) < 600_000


def store(name: str) -> None:
    """Runs a script and stores its picture."""
    from PIL import Image  # type: ignore[import-not-found, unused-ignore]

    with tempfile.TemporaryDirectory() as folder, pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.chdir(folder)
        run(name, [], monkeypatch)
        picture = Image.open(f"{name}.png").convert("RGB").quantize(256)
        picture.save(PICTURES / f"{name}.png", optimize=True)
    print(name, os.path.getsize(PICTURES / f"{name}.png"), "bytes")


if __name__ == "__main__":
    for name in sys.argv[1:] or SCRIPTS:
        store(name)

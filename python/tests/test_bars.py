"""The bar charts of the documentation are drawn from the tables as they are: docs/images/bars.py draws them."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

IMAGES = Path(__file__).parents[2] / "docs" / "images"
BARS = runpy.run_path(str(IMAGES / "bars.py"))
PAGE = BARS["PAGE"].read_text(encoding="utf-8")


def test_charts_show_the_numbers_of_the_page() -> None:
    for name, shown in BARS["numbers"](PAGE).items():
        drawn = BARS["stored"](IMAGES / f"{name}.png")
        assert drawn == BARS["checksum"](shown), f"{name}.png is older than the tables: python docs/images/bars.py"


def test_other_numbers_are_noticed() -> None:
    other = BARS["numbers"](PAGE.replace("1", "2"))
    for name, shown in BARS["numbers"](PAGE).items():
        assert BARS["checksum"](other[name]) != BARS["checksum"](shown)


def test_all_rows_are_read() -> None:
    shown = BARS["numbers"](PAGE)
    assert all(len(scenes) >= 5 for _, scenes in shown["benchmarks"])
    assert len(shown["gpu"]) >= 5


def test_charts_are_small_and_on_their_pages() -> None:
    for name in ("benchmarks", "gpu"):
        page = (IMAGES.parent / f"{name}.md").read_text(encoding="utf-8")
        assert len(re.findall(rf"\]\(images/{name}\.png\)", page)) == 1
        assert (IMAGES / f"{name}.png").stat().st_size < 40_000

"""The bar charts at the top of docs/benchmarks.md and docs/gpu.md, from the tables of docs/benchmarks.md.

    python docs/images/bars.py          # writes benchmarks.png and gpu.png beside this file

Each picture has a checksum of its numbers, so that python/tests/test_bars.py can tell whether it is drawn from the
tables as they are now."""

from __future__ import annotations

import hashlib
import io
import json
import re
from pathlib import Path
from statistics import median
from typing import Any

FOLDER = Path(__file__).parent
PAGE = FOLDER.parent / "benchmarks.md"

JOBS = [
    ("Derivative images,\nshapes move", "derivative images,", 0),
    ("Gradients of a loss,\npose", "gradients of a loss, mean", 0),
    ("Gradients of a loss,\nall vertices", "gradients of a loss, mean", 1),
    ("Gradients of a loss,\ntexels (prb)", "gradients of a loss with respect to texels", 0),
    ("Images\n(llvm_ad_rgb)", "images,", 1),
]
"""What Mitsuba and capwalk do, how the title of its table begins, and which of the columns `ratio` is meant."""

AHEAD, BEHIND, INK = "#0072b2", "#d55e00", "#222222"
"""Blue and vermilion can be told apart by everyone (Okabe and Ito)."""

SIZE = 11.6
"""Of the type, points: 16 pixels if a picture of seven inches is shown 700 pixels wide."""


def beside_mitsuba(page: str) -> list[list[Any]]:
    """For each job its name, and for each scene its name, the ratio, and whether Mitsuba's derivative is biased."""
    found = []
    for job, title, number in JOBS:
        (table,) = re.findall(rf"^{title}.*\n((?:.+\n)+)", page, re.MULTILINE)
        head, *rows = [re.split(r"\s{2,}", line) for line in table.replace("```", "").split("\n") if line]
        column = [at for at, name in enumerate(head) if name == "ratio"][number]
        scenes = [[row[0], float(row[column].removesuffix(" b")), row[column].endswith("b")] for row in rows]
        found.append([job, scenes])
    return found


def on_the_gpu(page: str) -> list[list[Any]]:
    """For each row a scene, a task, and how many times as fast it is as on the CPU, or why that is not known."""
    (table,) = re.findall(r"^(\| scene \| task \|(?:.+\n)+)", page, re.MULTILINE)
    head, _, *rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in table.splitlines()]
    at, (why,) = head.index("x CPU"), [at for at, name in enumerate(head) if name.startswith("kernels")]
    return [[*row[:2], float(row[at]) if row[at] else row[why]] for row in rows]


def numbers(page: str) -> dict[str, list[list[Any]]]:
    """What each picture shows."""
    return {"benchmarks": beside_mitsuba(page), "gpu": on_the_gpu(page)}


def checksum(shown: list[list[Any]]) -> str:
    return hashlib.sha256(json.dumps(shown).encode()).hexdigest()


def stored(picture: Path) -> str:
    """The checksum in a picture."""
    data, at = picture.read_bytes(), 8
    while at < len(data):
        size, kind = int.from_bytes(data[at : at + 4], "big"), data[at + 4 : at + 8]
        if kind == b"tEXt" and data[at + 8 : at + 8 + size].startswith(b"Numbers\0"):
            return data[at + 16 : at + 8 + size].decode()
        at += 12 + size
    return ""


def figure(height: float) -> Any:
    """A figure seven inches wide, and its axes."""
    import matplotlib

    matplotlib.use("agg")
    import matplotlib.pyplot as plt

    plt.rcParams.update({"font.size": SIZE, "text.color": INK, "axes.labelcolor": INK})
    plt.rcParams.update({"xtick.color": INK, "ytick.color": INK, "axes.axisbelow": True})
    chart, axes = plt.subplots(figsize=(7, height), layout="constrained")
    axes.spines[["top", "right", "left"]].set_visible(False)
    axes.tick_params(left=False, labelsize=SIZE)
    axes.grid(axis="x", color="#dddddd")
    return chart, axes


def draw_benchmarks(jobs: list[list[Any]]) -> Any:
    chart, axes = figure(4.6)
    for row, (_, scenes) in enumerate(jobs):
        middle = median(ratio for _, ratio, biased in scenes if not biased)
        axes.barh(row, middle - 1, 0.5, left=1, color=AHEAD if middle > 1 else BEHIND, alpha=0.45)
        # Neighbours are one above the other, so that all can be seen.
        for at, (_, ratio, biased) in enumerate(sorted(scenes, key=lambda scene: scene[1])):
            colour = AHEAD if ratio > 1 else BEHIND
            face = "white" if biased else colour
            axes.scatter(ratio, row + 0.15 * (at % 3 - 1), 38, face, edgecolors=colour, linewidths=1.3, zorder=3)
    axes.set_xscale("log")
    axes.set_xlim(0.07, 250)
    axes.set_xticks([0.1, 1, 10, 100], ["10 times\nas much", "the same\ncost", "10 times\nless", "100 times\nless"])
    axes.minorticks_off()
    axes.axvline(1, color=INK, linewidth=1.2)
    axes.set_yticks(range(len(jobs)), [job for job, _ in jobs])
    axes.set_ylim(len(jobs) - 0.5, -0.95)
    axes.text(0.92, -0.62, "capwalk costs more", ha="right", color=BEHIND)
    axes.text(1.09, -0.62, "capwalk costs less than Mitsuba", color=AHEAD)
    return chart


def draw_gpu(rows: list[list[Any]]) -> Any:
    chart, axes = figure(3.7)
    for row, (_, _, speed) in enumerate(rows):
        known = isinstance(speed, float)
        axes.barh(row, speed if known else 0, 0.55, color=AHEAD)
        axes.text((speed if known else 1) + 0.2, row, f"{speed:.3g}" if known else speed, va="center")
    axes.axvline(1, color=INK, linewidth=1.2)
    axes.set_xlim(0, 17.5)
    axes.set_xticks([1, 5, 10, 15])
    axes.set_xlabel("times as fast as the CPU alone (1: the same)")
    axes.set_yticks(range(len(rows)), [f"{task}\n({scene})" for scene, task, _ in rows])
    axes.invert_yaxis()
    return chart


def main() -> None:
    from PIL import Image, PngImagePlugin

    shown = numbers(PAGE.read_text(encoding="utf-8"))
    for name, draw in {"benchmarks": draw_benchmarks, "gpu": draw_gpu}.items():
        drawn = io.BytesIO()
        draw(shown[name]).savefig(drawn, dpi=200)
        info = PngImagePlugin.PngInfo()
        info.add_text("Numbers", checksum(shown[name]))
        few = Image.open(drawn).convert("RGB").quantize(32, dither=Image.Dither.NONE)
        few.save(FOLDER / f"{name}.png", optimize=True, pnginfo=info)


if __name__ == "__main__":
    main()

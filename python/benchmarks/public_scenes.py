"""Scenes that other people made, in Mitsuba and in capwalk: which of them load, and whether the
images agree.

    python python/benchmarks/public_scenes.py CAPWALK FOLDER... [--only TEXT] [--seconds S]
        [--report FILE.jsonl]

CAPWALK is the program. Every scene file in the folders (but those in folders named `include` or
`fragments`) is loaded by Mitsuba (`scalar_rgb`) and by capwalk as it is. If both load it, both
render its first sensor, 32 pixels wide or high, with as many samples as Mitsuba takes in S seconds.

The test: for the whole image, and for each block of 4 x 4 pixels and each channel, the difference
over its standard error, which is capwalk's own for its image, and that of 16 batches with seeds of
their own for Mitsuba's. By Welch's t, at a level of 0.001 for the image and (Bonferroni) for all
of its blocks. An image that fails is rendered again, with other seeds and four times the samples,
and differs if it fails again. Beside each scene stands the bias that this finds nine times in ten:
of the whole image, and of half of the blocks, relative to the image's mean."""

from __future__ import annotations

import argparse
import json
import multiprocessing
import subprocess
import sys
import tempfile
import time
from collections import Counter
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

LONGER_SIDE, BLOCK, BATCHES = 32, 4, 16
LEVEL = 0.001
LIMIT = 900.0
"""Seconds for one scene."""
ROUNDING = 1e-4
"""How well single precision and Mitsuba's tables agree with themselves, relative."""


@dataclass
class Outcome:
    """What became of one file."""

    file: str
    kind: str
    """`agrees`, `differs`, `refused`, or `not of Mitsuba`, which does not load it either."""
    reason: str = ""
    spp: int = 0
    ratio: float = 0.0
    """Brightness of capwalk's image over Mitsuba's."""
    ratio_error: float = 0.0
    """Its standard error."""
    worst: float = 0.0
    """The largest |t| of a block."""
    p: float = 1.0
    """The smaller of the two tests' probabilities."""
    finds: float = 0.0
    finds_in_blocks: float = 0.0
    """Relative bias that the tests find nine times in ten."""


def judge(ours: tuple[np.ndarray, np.ndarray], theirs: np.ndarray) -> dict[str, float]:
    """Compares an image and its standard errors with batches of images."""
    image, error = ours
    means = blocks(theirs)
    mean = means.mean()
    # Pixels have samples of their own: variances add up.
    own, own_variance = blocks(image), blocks(error**2) / BLOCK**2
    each = welch(own, own_variance, means)
    whole = welch(own.mean(), own_variance.mean() / own.size, means.mean(axis=(1, 2, 3)))
    count = each["p"].size

    def found(test: dict[str, np.ndarray], level: float) -> float:
        """Beyond the limit of the test in nine cases of ten."""
        error, freedom = np.median(test["error"]), np.median(test["freedom"])
        return float(error * (quantile(level, freedom) + 1.2816) / mean)

    return {
        "ratio": float(own.mean() / mean),
        "ratio_error": float(whole["error"] / mean),
        "worst": float(np.abs(each["t"]).max()),
        "p": float(min(whole["p"], each["p"].min() * count, 1.0)),
        "finds": found(whole, LEVEL),
        "finds_in_blocks": found(each, LEVEL / count),
    }


def blocks(images: np.ndarray) -> np.ndarray:
    """Means of blocks; rows and columns that fill none are left out of them."""
    *batches, height, width, channels = images.shape
    rows, columns = height // BLOCK, width // BLOCK
    cut = images[..., : rows * BLOCK, : columns * BLOCK, :].astype(np.float64)
    return cut.reshape(*batches, rows, BLOCK, columns, BLOCK, channels).mean(axis=(-4, -2))


def welch(a: np.ndarray, variance: np.ndarray, batches: np.ndarray) -> dict[str, np.ndarray]:
    """Welch's test of numbers with many degrees of freedom against means of batches;
    differences within rounding are none."""
    b, of_b = batches.mean(axis=0), batches.var(axis=0, ddof=1) / len(batches)
    error = np.sqrt(variance + of_b)
    difference = a - b
    beyond = np.maximum(np.abs(difference) - ROUNDING * np.abs(b) - 1e-9, 0)
    t = np.sign(difference) * beyond / np.maximum(error, 1e-12)
    share = error**4 / np.maximum(of_b**2, np.finfo(float).tiny)
    freedom = np.clip((len(batches) - 1) * share, 1.0, 1000.0)
    p = np.vectorize(tail)(np.abs(t), freedom)
    return {"t": t, "error": error, "freedom": freedom, "p": p}


def tail(t: float, freedom: float) -> float:
    """Probability that |t| of Student's distribution is larger, by Gauss's rule over the angle:
    the density of `t = √freedom tan x` is proportional to `cos(x)^(freedom - 1)`."""
    nodes, weights = np.polynomial.legendre.leggauss(200)

    def integral(start: float) -> float:
        half = (np.pi / 2 - start) / 2
        return float(half * (weights * np.cos(start + half * (1 + nodes)) ** (freedom - 1)).sum())

    return integral(float(np.arctan(t / np.sqrt(freedom)))) / integral(0.0)


def quantile(level: float, freedom: float) -> float:
    """The |t| that is exceeded with this probability."""
    low, high = 0.0, 1e3
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if tail(middle, freedom) > level else (low, middle)
    return low


def in_mitsuba(scene: Any, spp: int, seeds: range) -> np.ndarray:
    """Images of several seeds."""
    import mitsuba as mi

    images = [np.array(mi.render(scene, spp=spp, seed=seed)) for seed in seeds]
    # Behind the first three are opacity, moments, and AOVs.
    return np.stack([image[..., :3] if image.shape[2] > 2 else image[..., :1] for image in images])


def in_capwalk(
    capwalk: str, file: Path, size: list[int], spp: int, seed: int
) -> tuple[np.ndarray, np.ndarray]:
    """An image and its standard errors."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "image.npz"
        options = ["--size", f"{size[0]}x{size[1]}", "--spp", str(spp), "--seed", str(seed)]
        command = [capwalk, "render", str(file), *options, "-o", str(out)]
        subprocess.run(command, check=True, capture_output=True)
        layers = np.load(out)
        return layers["value"], layers["stderr"]


def refusal(capwalk: str, file: Path) -> str | None:
    """What capwalk says if it does not load the file: the message's first line."""
    done = subprocess.run(
        [capwalk, "info", str(file)], capture_output=True, text=True, timeout=LIMIT
    )
    if done.returncode == 0:
        return None
    lines = [line for line in done.stderr.splitlines() if line.startswith("error")]
    return lines[0].removeprefix("error: ") if lines else done.stderr.strip()[:200]


def compared(capwalk: str, file: Path, name: str, seconds: float) -> Outcome:
    """What becomes of one file."""
    import mitsuba as mi

    mi.set_variant("scalar_rgb")
    mi.set_log_level(mi.LogLevel.Error)
    try:
        scene = mi.load_file(str(file))
        if not scene.sensors():
            return Outcome(name, "not of Mitsuba", "no sensor")
        size = shrink(scene)
        start = time.perf_counter()
        in_mitsuba(scene, 4, range(1))
        each = (time.perf_counter() - start) / 4
    except Exception as error:
        return Outcome(name, "not of Mitsuba", str(error).strip().splitlines()[-1][-200:])
    if (reason := refusal(capwalk, file)) is not None:
        return Outcome(name, "refused", reason)
    spp = max(4, round(seconds / each / BATCHES))
    for times, first in [(1, 0), (4, 1000)]:
        theirs = in_mitsuba(scene, times * spp, range(first, first + BATCHES))
        ours = in_capwalk(capwalk, file, size, BATCHES * times * spp, first)
        channels = theirs.shape[3]
        found = judge((ours[0][..., :channels], ours[1][..., :channels]), theirs)
        if found["p"] >= LEVEL:
            break
    kind = "agrees" if found["p"] >= LEVEL else "differs"
    return Outcome(name, kind, "", BATCHES * times * spp, **found)


def shrink(scene: Any) -> list[int]:
    """Gives the film of the first sensor few pixels, about as wide and high."""
    import mitsuba as mi

    width, height = (int(side) for side in scene.sensors()[0].film().size())
    most = max(width, height)
    size = [max(BLOCK, round(LONGER_SIDE * side / most)) for side in (width, height)]
    sensor = mi.traverse(scene.sensors()[0])
    for key, value in [("size", size), ("crop_size", size), ("crop_offset", [0, 0])]:
        sensor[f"film.{key}"] = mi.ScalarVector2u(*value)
    sensor.update()
    return size


def work(arguments: tuple[str, Path, str, float]) -> Outcome:
    try:
        return compared(*arguments)
    except Exception as error:
        return Outcome(arguments[2], "failed", f"{type(error).__name__}: {error}"[:300])


def files(folders: list[Path]) -> list[tuple[Path, str]]:
    """The scene files, and how they are called."""
    found = []
    for folder in folders:
        for file in sorted(folder.rglob("*.xml")):
            inside = file.relative_to(folder).parts[:-1]
            if not {"include", "fragments"} & set(inside):
                found.append((file, str(Path(folder.name, file.relative_to(folder)))))
    return found


def line(it: Outcome) -> str:
    if it.kind not in ("agrees", "differs"):
        return f"{it.kind:15} {it.file}: {it.reason}"
    return (
        f"{it.kind:15} {it.file}: ratio {it.ratio:.5f} ± {it.ratio_error:.5f}, worst block "
        f"{it.worst:.1f} errors, p {it.p:.1e}, finds {it.finds:.2%} of the whole, "
        f"{it.finds_in_blocks:.1%} in blocks, {it.spp} spp"
    )


def summary(outcomes: list[Outcome]) -> str:
    counts = Counter(it.kind for it in outcomes)
    lines = [f"{len(outcomes)} files", *(f"{n:5} {kind}" for kind, n in counts.most_common())]
    if rendered := [it for it in outcomes if it.kind in ("agrees", "differs")]:
        for what, key in [("brightness", "finds"), ("half of the blocks", "finds_in_blocks")]:
            low, middle, high = np.percentile([getattr(it, key) for it in rendered], [10, 50, 90])
            lines.append(
                f"a bias of {what} is found from {middle:.2%} (10th and 90th percentile of the "
                f"scenes: {low:.2%}, {high:.2%})"
            )
        ratios = [it.ratio for it in rendered]
        lines.append(f"median ratio of brightness {np.median(ratios):.5f}")
    reasons = Counter(it.reason.split("\n")[0] for it in outcomes if it.kind == "refused")
    lines += [f"{n:5} refused: {reason}" for reason, n in reasons.most_common()]
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("capwalk")
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--only", default="", help="a part of the names of files")
    parser.add_argument("--seconds", type=float, default=4.0)
    parser.add_argument("--report", type=Path)
    chosen = parser.parse_args()
    outcomes = []
    # A process each: what goes wrong in one file stays there.
    with multiprocessing.get_context("spawn").Pool(1, maxtasksperchild=1) as pool:
        for file, name in files(chosen.folders):
            if chosen.only not in name:
                continue
            job = (chosen.capwalk, file, name, chosen.seconds)
            try:
                outcome = pool.apply_async(work, (job,)).get(LIMIT)
            except multiprocessing.TimeoutError:
                sys.exit(f"{name}: no result after {LIMIT:.0f} s")
            outcomes.append(outcome)
            print(line(outcome), flush=True)
            if chosen.report:
                with chosen.report.open("a") as report:
                    report.write(json.dumps(asdict(outcome)) + "\n")
    print(summary(outcomes))


if __name__ == "__main__":
    main()

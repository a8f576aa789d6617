"""Renders a scene with Mitsuba 3 and compares capwalk's image with it.

usage: parity.py SCENE.xml CAPWALK.npz SPP SEEDS FAILURE_FOLDER

Mitsuba renders the scene SEEDS times with SPP samples per pixel; its standard
error comes from the spread of these images. Prints one JSON object. If the
images differ, writes both, their difference and z as EXR.

Tests, all at one channel per pixel (a fixed mosaic, since channels of a pixel
share their samples):

* z of each pixel, two-sided, at a level of 0.01 for the whole image after
  Sidak's correction; 99.75 % of the pixels must pass, as in Mitsuba's own
  test_renders.py. The variance is the larger of the pixel's own and that around
  it: a pixel that no sample of a rare event met states an error of zero.
* the sum of squared differences over the sum of variances, both weighted by
  the noise around the pixel, within 0.8 to 1.25 or four of its standard errors.
* the weighted sum of differences, within four standard errors.
"""

import json
import math
import pathlib
import sys

import mitsuba as mi
import numpy as np

SIGNIFICANT = 4.0
PASSING_PIXELS = 0.9975
IMAGE_LEVEL = 0.01


def mitsuba_images(scene_file, spp, seeds):
    """Independent renderings of a scene, as (seed, height, width, channel)."""
    mi.set_variant("scalar_rgb")
    mi.set_log_level(mi.LogLevel.Error)
    scene = mi.load_file(scene_file)
    render = lambda seed: np.array(mi.render(scene, spp=spp, seed=1000 + seed))
    images = np.stack([render(seed)[..., :3] for seed in range(seeds)])
    return images.astype(np.float64)


def mean_and_error(images):
    """Mean and standard error of independent renderings."""
    seeds = len(images)
    return images.mean(axis=0), images.std(axis=0, ddof=1) / math.sqrt(seeds)


def mosaic(image):
    """Channel (x + y) mod 3 of each pixel."""
    y, x = np.indices(image.shape[:2])
    return np.take_along_axis(image, ((x + y) % 3)[..., None], axis=2)[..., 0]


def around(variance):
    """Mean variance of the 24 pixels around each, and a little of all others:
    a weight that does not know the pixel's own noise."""
    h, w = variance.shape
    padded = np.pad(variance, 2, mode="symmetric")
    shifts = [(i, j) for i in range(5) for j in range(5) if (i, j) != (2, 2)]
    local = sum(padded[i : i + h, j : j + w] for i, j in shifts) / len(shifts)
    return 0.99 * local + 0.01 * variance.mean()


def compare(ours, ours_error, theirs, theirs_error):
    """The statistics, and whether they are as those of equal images."""
    difference = mosaic(ours - theirs)
    variance = mosaic(ours_error**2 + theirs_error**2)
    # The emitters themselves have no noise, but single precision there.
    noisy = np.sqrt(variance) > 1e-5 * np.abs(mosaic(theirs))
    exact = np.abs(difference[~noisy]) <= 1e-4 * np.abs(mosaic(theirs)[~noisy]) + 1e-12
    local = around(variance)[noisy]
    weight = 1.0 / local
    d, v = difference[noisy], variance[noisy]
    z = np.zeros_like(difference)
    z[noisy] = d / np.sqrt(np.maximum(v, local))
    level = 1.0 - (1.0 - IMAGE_LEVEL) ** (1.0 / max(d.size, 1))
    tails = np.array([math.erfc(abs(x) / math.sqrt(2.0)) for x in z[noisy]])
    passing = float(np.mean(tails > level)) if d.size else 1.0
    mean_z_squared = float((weight * d**2).sum() / (weight * v).sum())
    excess = weight * (d**2 - v)
    error = float(np.sqrt((excess**2).sum()) / (weight * v).sum())
    sign = float((np.sqrt(weight) * d).sum() / math.sqrt((weight * v).sum()))
    off = abs(mean_z_squared - 1.0)
    right = (
        passing >= PASSING_PIXELS
        and (0.8 <= mean_z_squared <= 1.25 or off < SIGNIFICANT * error)
        and abs(sign) < SIGNIFICANT
        and bool(exact.all())
    )
    return {
        "pixels": int(d.size),
        "passing": passing,
        "mean_z_squared": mean_z_squared,
        "mean_z_squared_error": error,
        "sign": sign,
        "differing_without_noise": int((~exact).sum()),
        "relative_mean_difference": float((ours.mean() - theirs.mean()) / theirs.mean()),
        "right": right,
    }, z


def main():
    scene_file, capwalk_file, spp, seeds, folder = sys.argv[1:]
    ours = np.load(capwalk_file)
    theirs, theirs_error = mean_and_error(mitsuba_images(scene_file, int(spp), int(seeds)))
    if ours["value"].shape != theirs.shape:
        sys.exit(f"sizes differ: {ours['value'].shape} and {theirs.shape}")
    result, z = compare(
        ours["value"].astype(np.float64),
        ours["stderr"].astype(np.float64),
        theirs,
        theirs_error,
    )
    result["mitsuba"] = mi.__version__
    if not result["right"]:
        folder = pathlib.Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        images = {"capwalk": ours["value"], "mitsuba": theirs, "z": z}
        images["difference"] = ours["value"] - theirs
        for name, image in images.items():
            mi.Bitmap(image.astype(np.float32)).write(str(folder / f"{name}.exr"))
    print(json.dumps(result))


if __name__ == "__main__":
    main()

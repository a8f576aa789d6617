"""Renders a scene with Mitsuba 3 into a golden image: what capwalk's own
images are tested against where there is no Mitsuba.

usage: golden.py SCENE.xml GOLDEN.npz SPP SEEDS

Mitsuba renders the scene SEEDS times with SPP samples per pixel. The file has,
at one channel per pixel (the mosaic of parity.py):

* `mean`, rounded to twelve bits, which deflate then finds short;
* `variance` of that mean: from the spread of the images, and from rounding;
* in `metadata`: the sample count, Mitsuba's version, and `correlation`: how many
  times larger the variance of a sum over a block of pixels is than the sum of
  their variances. A sample counts in several pixels under a wide filter.
"""

import sys

import mitsuba as mi
import numpy as np

from parity import around, mitsuba_images, mosaic

MEAN_BITS = 12
VARIANCE_BITS = 7
BLOCK = 8


def rounded(numbers, bits):
    """Single precision with so many significant bits, to the nearest."""
    fraction, exponent = np.frexp(numbers)
    return np.ldexp(np.round(np.ldexp(fraction, bits)), exponent - bits).astype(np.float32)


def block_sums(image):
    """Sums over blocks of BLOCK by BLOCK pixels; what is left at the borders is
    left out."""
    h, w = (side // BLOCK for side in image.shape)
    whole = image[: h * BLOCK, : w * BLOCK]
    return whole.reshape(h, BLOCK, w, BLOCK).sum(axis=(1, 3))


def correlation(images, variance):
    """The mean over blocks; each pixel in units of the noise around it."""
    scale = np.sqrt(around(variance) + 1e-30)
    weighted = (images - images.mean(axis=0)) / scale
    of_sums = np.stack([block_sums(image) for image in weighted]).var(axis=0, ddof=1)
    sums = block_sums(weighted.var(axis=0, ddof=1))
    return max(1.0, float(of_sums.sum() / (sums.sum() + 1e-30)))


def main():
    scene_file, golden_file, spp, seeds = sys.argv[1:]
    images = mitsuba_images(scene_file, int(spp), int(seeds))
    images = np.stack([mosaic(image) for image in images])
    mean = images.mean(axis=0)
    variance = images.var(axis=0, ddof=1) / len(images)
    metadata = {
        "spp": int(spp) * int(seeds),
        "mitsuba": mi.__version__,
        "correlation": f"{correlation(images, variance):.2f}",
    }
    # A number of n bits is off by up to 2^-n of itself, evenly.
    variance = variance + (mean * 2.0**-MEAN_BITS) ** 2 / 3.0
    np.savez_compressed(
        golden_file,
        mean=rounded(mean, MEAN_BITS),
        variance=rounded(variance, VARIANCE_BITS),
        metadata=np.array([[key, str(value)] for key, value in metadata.items()]),
    )


main()

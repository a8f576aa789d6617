"""Images in colours that a screen shows."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ._numbers import Array

Colours = NDArray[np.uint8]
"""(height, width, 3)."""

NON_FINITE = (255, 0, 255)
"""Of a pixel that is infinite or NaN: nothing else is magenta."""

DIVERGING = np.array(
    [
        [5, 48, 97],
        [33, 102, 172],
        [67, 147, 195],
        [146, 197, 222],
        [209, 229, 240],
        [247, 247, 247],
        [253, 219, 199],
        [244, 165, 130],
        [214, 96, 77],
        [178, 24, 43],
        [103, 0, 31],
    ]
)
"""ColorBrewer's ``RdBu`` (Harrower and Brewer 2003), from blue to red: as in images that are saved."""


def photographic(image: Array) -> Colours:
    """Linear colours, (height, width, 3), as sRGB (IEC 61966-2-1), clamped to [0, 1] before."""
    x = np.clip(image, 0.0, 1.0)
    encoded = np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)
    return _as_bytes(255.0 * encoded, image)


def false_colours(places: Array) -> Colours:
    """From blue at -1 and below through white to red at 1 and above, of numbers, (height, width)."""
    x = (0.5 + 0.5 * np.clip(places, -1.0, 1.0)) * (len(DIVERGING) - 1)
    stops = np.arange(len(DIVERGING))
    colours = np.stack([np.interp(x, stops, channel) for channel in DIVERGING.T], axis=2)
    return _as_bytes(colours, places[:, :, None])


def _as_bytes(colours: Array, values: Array) -> Colours:
    """Colours that stand for values, (height, width, channels)."""
    is_finite = np.isfinite(values).all(axis=2, keepdims=True)
    return np.where(is_finite, np.round(colours), NON_FINITE).astype(np.uint8)

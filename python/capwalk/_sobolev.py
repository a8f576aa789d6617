"""A preconditioner for gradients with respect to textures."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ._numbers import Array, numbers
from .errors import ArgumentError


def sobolev_gradient(gradient: ArrayLike, order: float = 0.75) -> Array:
    """The Sobolev gradient of a loss with respect to a texture, in the shape of ``gradient``: coarse
    scales count more than single texels, in which noise is large. For :class:`Adam` and other
    optimisers, in place of the gradient.

    It is ``P g`` with ``P = (1 - Δ)^(-order)``, for the Laplacian ``Δ`` without flow across the borders
    and with the longer side of the texture as π. A cosine with ``k`` half periods along this side is
    multiplied by ``(1 + k²)^(-order)``, a constant by 1. So ``P`` is linear, symmetric and positive
    definite, the same in each step: what is unbiased stays so, up to ``P``, and a gradient is zero
    where its Sobolev gradient is.

    Texels without samples follow their neighbours.

    >>> import numpy as np
    >>> import capwalk as cw
    >>> gradient = np.zeros((32, 32, 3))
    >>> gradient[10, 12] = 1.0
    >>> smooth = cw.sobolev_gradient(gradient)
    >>> bool(np.isclose(smooth.sum(), 3)), bool((smooth > 0).sum() > 500)
    (True, True)

    :param gradient: (height, width) or (height, width, channels), such as :func:`backward` returns it
        for ``<material>.reflectance.data``.
    :param order: above 0; larger orders smooth more. Order 1 is a step of implicit diffusion; the large
        steps of Nicolet et al. (2021), for texels, are two of them.
    :raises ArgumentError: another number of dimensions, NaN or infinite numbers, or a wrong order.
    """
    array = numbers("the gradient", gradient)
    if array.ndim not in (2, 3) or array.size == 0:
        text = f"the gradient has the shape {array.shape}"
        raise ArgumentError(f"{text}; expected (height, width) or (height, width, channels)")
    if not np.isfinite(array).all():
        raise ArgumentError("the gradient has infinite numbers or NaN")
    if not (np.isfinite(order) and order > 0.0):
        raise ArgumentError(f"order is {order}; expected a finite number above 0")
    # Beside its mirror image a texture is periodic, and its cosines are those of a Fourier transform.
    height, width = array.shape[:2]
    rows = np.abs(np.fft.fftfreq(2 * height)) * 2 * max(height, width)
    columns = np.fft.rfftfreq(2 * width) * 2 * max(height, width)
    weights = (1.0 + rows[:, None] ** 2 + columns**2) ** -order
    result = np.empty_like(array)
    for channel in np.ndindex(array.shape[2:]):
        texels = array[(..., *channel)]
        mirrored = np.block([[texels, texels[:, ::-1]], [texels[::-1], texels[::-1, ::-1]]])
        smooth = np.fft.irfft2(weights * np.fft.rfft2(mirrored), mirrored.shape)
        result[(..., *channel)] = smooth[:height, :width]
    return result

"""Optimisers that need no framework."""

from __future__ import annotations

from collections.abc import Callable, Mapping, MutableMapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _capwalk
from ._numbers import Array, numbers
from .errors import ArgumentError


@dataclass
class Adam:
    """Adam (Kingma and Ba 2015), with PyTorch's conventions, over arrays by their names.

    >>> import capwalk as cw
    >>> adam = cw.Adam(lr=0.1)
    >>> values = {"x": np.array([3.0])}
    >>> for _ in range(100):
    ...     adam.step(values, {"x": 2 * values["x"]})
    >>> bool(abs(values["x"][0]) < 0.1)
    True
    """

    lr: float
    """Length of the first step in each number."""
    betas: tuple[float, float] = (0.9, 0.999)
    """How much of the means of the gradient and of its square is kept."""
    eps: float = 1e-8
    """Added to the root of the mean square."""
    uniform: bool = False
    """True if all numbers of an array take steps by the same rate, so that the direction of the
    gradient is kept (Nicolet et al. 2021, section 4): for :class:`LargeSteps`."""
    _means: dict[str, tuple[int, Array, Array]] = field(default_factory=dict, init=False)

    def __post_init__(self) -> None:
        if not (np.isfinite(self.lr) and self.lr > 0.0):
            raise ArgumentError(f"lr is {self.lr}; expected a finite number above 0")
        if not all(0.0 <= beta < 1.0 for beta in self.betas):
            raise ArgumentError(f"betas are {self.betas}; expected two numbers from 0 to below 1")
        if not (np.isfinite(self.eps) and self.eps > 0.0):
            raise ArgumentError(f"eps is {self.eps}; expected a finite number above 0")

    def step(
        self, values: MutableMapping[str, Array], gradients: Mapping[str, ArrayLike]
    ) -> None:
        """Takes a step in each array that has a gradient. ``values`` may be a dict, or
        :func:`capwalk.traverse` of a scene, which must be updated afterwards.

        :raises ArgumentError: a gradient of another shape, or with NaN or infinite numbers.
        """
        new: dict[str, Array] = {}
        means = dict(self._means)
        for name, given in gradients.items():
            value, gradient = numbers(name, values[name]), numbers(name, given)
            if value.shape != gradient.shape:
                text = f"the gradient of {name} has the shape {gradient.shape}"
                raise ArgumentError(f"{text}; expected {value.shape}")
            if not np.isfinite(gradient).all():
                raise ArgumentError(f"the gradient of {name} has infinite numbers or NaN")
            zero = np.zeros_like(value)
            step, first, second = means.get(name, (0, zero, zero))
            if first.shape != value.shape:
                text = f"{name} had the shape {first.shape} in the step before"
                text += f", and has {value.shape}; take another Adam for it"
                raise ArgumentError(f"{text}, or, after remeshing, call transfer")
            new[name], first, second = _capwalk.adam(
                self, step + 1, value, gradient, [first, second]
            )
            means[name] = (step + 1, first, second)
        # All of them or none.
        self._means = means
        for name, array in new.items():
            values[name] = array

    def transfer(self, name: str, transfer: Callable[[Array], Array]) -> None:
        """Goes on with an array that has other rows than before: replaces the means of its gradient and
        of its square by ``transfer`` of them, which :func:`capwalk.remesh` returns, and keeps the
        number of steps. Before the first step there is nothing to do.

        For :class:`LargeSteps` the array is ``u``. It is not interpolated itself: make new large steps
        of the new mesh, and ``u`` by :meth:`LargeSteps.to_differential`.
        """
        if name in self._means:
            step, first, second = self._means[name]
            self._means[name] = (step, transfer(first), transfer(second))


class LargeSteps:
    """Large steps (Nicolet, Jacobson and Jakob 2021): a reparameterization of a mesh in which a
    step moves whole regions, so that noise in the gradient does not wrinkle the surface. Instead of
    the positions ``x`` of the vertices, the unknowns are ``u = (I + λL) x`` with the Laplacian
    ``L`` of the mesh. Vertices at the same position are one node.

    >>> import capwalk as cw
    >>> scene = cw.load_file("ball")
    >>> x = cw.traverse(scene)["ball.positions"]
    >>> large = cw.LargeSteps(x, scene.faces("ball"), lambda_=19.0)
    >>> u = large.to_differential(x)
    >>> bool(np.allclose(large.from_differential(u), x))
    True

    :param positions: (V, 3), world units.
    :param faces: (F, 3), numbers of vertices.
    :param lambda_: the weight of the Laplacian, at least 0: larger weights move larger regions
        together; with 0, ``u`` is ``x``.
    """

    def __init__(self, positions: ArrayLike, faces: ArrayLike, lambda_: float = 19.0) -> None:
        vertices = vertices_of("positions", positions)
        triangles = triangles_of(faces, len(vertices))
        if not (np.isfinite(lambda_) and lambda_ >= 0.0):
            raise ArgumentError(f"lambda_ is {lambda_}; expected a finite number of at least 0")
        self._smooth = _capwalk.Smooth(vertices, triangles.tolist(), float(lambda_))

    def to_differential(self, positions: ArrayLike) -> Array:
        """``u``, (N, 3), for positions, (V, 3)."""
        return self._smooth.multiply(self._checked("positions", positions, 1))

    def from_differential(self, u: ArrayLike) -> Array:
        """Positions, (V, 3), for ``u``, (N, 3)."""
        return self._smooth.solve(self._checked("u", u, 0))

    def gradient(self, by_positions: ArrayLike) -> Array:
        """The gradient of a loss with respect to ``u``, (N, 3), from the gradient with respect to
        the positions, (V, 3)."""
        return self._smooth.pull(self._checked("the gradient", by_positions, 1))

    def _checked(self, what: str, value: ArrayLike, side: int) -> Array:
        array, expected = vertices_of(what, value), self._smooth.sizes[side]
        if len(array) != expected:
            raise ArgumentError(f"{what} has {len(array)} rows; expected {expected}")
        return array


def vertices_of(what: str, value: ArrayLike) -> Array:
    """Rows of three finite numbers."""
    array = numbers(what, value)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ArgumentError(f"{what} has the shape {array.shape}; expected rows of three numbers")
    if not np.isfinite(array).all():
        raise ArgumentError(f"{what} has infinite numbers or NaN")
    return array


def triangles_of(faces: ArrayLike, count: int) -> NDArray[np.int64]:
    """Rows of three numbers of vertices, of so many that there are."""
    triangles = np.asarray(faces)
    if triangles.dtype.kind not in "iu" or triangles.ndim != 2 or triangles.shape[1] != 3:
        text = f"faces are {triangles.dtype} of the shape {triangles.shape}"
        raise ArgumentError(f"{text}; expected integers of the shape (F, 3)")
    if triangles.size and not 0 <= triangles.min() <= triangles.max() < count:
        raise ArgumentError(f"faces name vertices beyond the {count} there are")
    return triangles.astype(np.int64)

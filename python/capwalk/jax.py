"""Differentiable images for JAX, 0.4.38 or newer.

>>> import capwalk as cw, capwalk.jax
>>> import jax
>>> scene = cw.load_file("leaf")
>>> scene.resize(32, 24)
>>> @jax.jit
... def loss(shift, seed):
...     positions = cw.traverse(scene)["leaf.positions"] + shift
...     image = capwalk.jax.render(scene, {"leaf.positions": positions}, spp=2, seed=seed)
...     return (image**2).mean()
>>> jax.grad(loss)(jax.numpy.zeros(3), 1).shape
(3,)
"""

# mypy: allow-untyped-calls

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import jax  # type: ignore[import-not-found, unused-ignore]
import jax.numpy as jnp  # type: ignore[import-not-found, unused-ignore]
import numpy as np
from jax.extend.core import Primitive  # type: ignore[import-not-found, unused-ignore]
from jax.interpreters import ad, batching, mlir  # type: ignore[import-not-found, unused-ignore]
from numpy.typing import ArrayLike, NDArray

from . import _capwalk
from ._functional import Work, check_seeds, second_derivative, seeds
from ._options import LARGEST_SEED, integer
from .errors import ArgumentError
from .options import FunctionOptions, Unpack

__all__ = ["render"]


def render(
    scene: _capwalk.Scene,
    params: Mapping[str, jax.Array | ArrayLike],
    *,
    seed: int | jax.Array | None = None,
    seed_grad: int | jax.Array | None = None,
    **options: Unpack[FunctionOptions],
) -> jax.Array:
    """The image of a scene, (height, width, 3), with arrays of JAX in place of some of its own; with
    ``views`` the images of several sensors, (views, height, width, 3). It is differentiable with
    respect to them, once, in forward and in reverse mode. ``jax.jit`` and ``jax.vmap`` may be
    combined with that in any order. Views, and images under ``jax.vmap``, are rendered one after
    the other.

    The scene is not changed. Image and derivatives use its state at the time of the call or, in a
    compiled function, at the time of tracing, like everything that such a function captures. Calls
    refit its trees, which all sensors share, and build none, and may be made in several threads.

    **Seeds.** The image and its derivatives have different random numbers. Otherwise the gradient
    of a loss, which is a product of both, would be biased. For the same reason all images that
    occur in one loss, such as an image and its rendered target, need different seeds. Use other
    seeds in each step of an optimisation: as an argument of a compiled function, such as the number
    of the step or ``jax.random.bits(key)``, they cause no new compilation.

    :param params: arrays of float32 or float64 by the names of the arrays that
        :func:`capwalk.traverse` lists, in their shapes or flat, in their units. The image is of
        the widest of their types.
    :param seed: of the random numbers of the image, 0 to 2**64 - 1; by default the scene's. Of
        several views it is that of the first.
    :param seed_grad: of the random numbers of the derivatives; by default the complement of
        ``seed``.
    :param options: how, see :class:`capwalk.options.FunctionOptions`: ``sensor``, ``views``, ``aov``,
        ``spp``, ``spp_grad``, ``threads``, ``progress``, and what is said of methods by
        :class:`capwalk.options.MethodOptions`.

    In compiled functions, errors that depend on values are raised by JAX as an error of its own
    with the same message. So is Ctrl-C, after the image if JAX waits for it on another thread.

    :raises ArgumentError: an array of another shape or type, or ``seed_grad`` equals ``seed``.
    :raises ParameterError: a name is not an array, or an array has numbers that the scene cannot
        have, NaN for one.
    :raises Refused: a derivative could only be estimated with a bias, or is a second derivative;
        with ``reason`` and ``instead``. Raised when the derivative is computed.
    """
    values = {name: _array(name, value) for name, value in params.items()}
    work = Work(
        scene,
        {name: value.shape for name, value in values.items()},
        **options,
    )
    call = _Call(work, np.dtype(jnp.result_type(*values.values() or [float])))
    images: list[jax.Array] = _IMAGE.bind(
        _words(work.seed, seed, seed_grad), *values.values(), call=call
    )
    return images[0]


@dataclass(frozen=True, eq=False)
class _Call:
    """What the primitives of a call have in common."""

    work: Work
    dtype: np.dtype[Any]
    moving: tuple[bool, ...] = ()
    """Which of the values derivatives are with respect to."""

    def check_first(self, tangents: Sequence[Any]) -> None:
        """An error if the values move once more."""
        pairs = zip(self.work.names, tangents)
        names = [name for name, tangent in pairs if type(tangent) is not ad.Zero]
        if names:
            raise second_derivative(names)


# Three primitives: each of the last two is linear in what the other returns, and the other's
# transpose. `jax.custom_derivatives.linear_call` would be that, but knows no `vmap`.

_Arrays = Sequence[NDArray[Any]]


def _image(call: _Call, words: NDArray[Any], *values: NDArray[Any]) -> _Arrays:
    """The image, from all values."""
    seed, seed_grad = map(_number, words)
    check_seeds(seed, seed_grad)
    return [call.work.image(seed, _doubles(values)).astype(call.dtype)]


def _push(call: _Call, words: NDArray[Any], *arrays: NDArray[Any]) -> _Arrays:
    """The derivative of the image, from all values and the velocities of those that move."""
    doubles, count = _doubles(arrays), len(call.moving)
    seed = _number(words[1])
    image = call.work.push(seed, doubles[:count], call.moving, doubles[count:])
    return [image.astype(call.dtype)]


def _pull(call: _Call, words: NDArray[Any], *arrays: NDArray[Any]) -> _Arrays:
    """The gradients with respect to the values that move, from all values and the adjoint."""
    *values, adjoint = _doubles(arrays)
    gradients = call.work.pull(_number(words[1]), values, call.moving, adjoint)
    types = [array.dtype for array, moves in zip(arrays, call.moving) if moves]
    return [gradient.astype(dtype) for gradient, dtype in zip(gradients, types)]


def _image_shape(call: _Call, *_: Any) -> list[Any]:
    return [jax.core.ShapedArray(call.work.image_shape, call.dtype)]


def _pull_shape(call: _Call, _: Any, *arrays: Any) -> list[Any]:
    moving = [value for value, moves in zip(arrays, call.moving) if moves]
    return [jax.core.ShapedArray(value.shape, value.dtype) for value in moving]


def _image_jvp(primals: Sequence[Any], tangents: Sequence[Any], *, call: _Call) -> Any:
    moving = tuple(type(tangent) is not ad.Zero for tangent in tangents[1:])
    velocities = [tangent for tangent, moves in zip(tangents[1:], moving) if moves]
    image = _IMAGE.bind(*primals, call=call)
    return image, _PUSH.bind(*primals, *velocities, call=replace(call, moving=moving))


def _push_jvp(primals: Sequence[Any], tangents: Sequence[Any], *, call: _Call) -> Any:
    return _linear_jvp(_PUSH, primals, tangents, call)


def _pull_jvp(primals: Sequence[Any], tangents: Sequence[Any], *, call: _Call) -> Any:
    return _linear_jvp(_PULL, primals, tangents, call)


def _linear_jvp(
    primitive: Primitive, primals: Sequence[Any], tangents: Sequence[Any], call: _Call
) -> Any:
    """Linear in what follows the seeds and the values."""
    count = 1 + len(call.moving)
    call.check_first(tangents[1:count])
    velocities = map(ad.instantiate_zeros, tangents[count:])
    answers = primitive.bind(*primals, call=call)
    return answers, primitive.bind(*primals[:count], *velocities, call=call)


def _transposed(primitive: Primitive, cotangents: Sequence[Any], *arrays: Any, call: _Call) -> Any:
    """The other primitive's answer to what is linear in an input that is not known."""
    count = 1 + len(call.moving)
    vectors = map(ad.instantiate_zeros, cotangents)
    answers = primitive.bind(*arrays[:count], *vectors, call=call)
    # None for what is known.
    pairs = zip(answers, arrays[count:])
    asked = [answer if ad.is_undefined_primal(array) else None for answer, array in pairs]
    return [None] * count + asked


def _one_by_one(
    primitive: Primitive, arrays: Sequence[Any], dims: Sequence[int | None], **params: Any
) -> tuple[Any, Any]:
    """The results for each index of a batch. Each takes all cores already."""
    batches = [jnp.moveaxis(a, dim, 0) for a, dim in zip(arrays, dims) if dim is not None]

    def one(rows: Iterable[Any]) -> Any:
        rest = iter(rows)
        chosen = [a if dim is None else next(rest) for a, dim in zip(arrays, dims)]
        return primitive.bind(*chosen, **params)

    if any(isinstance(array, jax.core.Tracer) for array in arrays):
        results = jax.lax.map(one, batches)
    else:
        # Not compiled, so that exceptions keep their types.
        results = [jnp.stack(column) for column in zip(*map(one, zip(*batches)))]
    return results, [0] * len(results)


def _primitive(
    host: Callable[..., _Arrays], shapes: Callable[..., list[Any]], jvp: Callable[..., Any]
) -> Primitive:
    """A primitive that is computed by a function of NumPy arrays, in compiled functions by a
    callback."""
    primitive = Primitive(f"capwalk{host.__name__}")
    primitive.multiple_results = True

    def run(*arrays: Any, call: _Call) -> list[Any]:
        return [jnp.asarray(result) for result in host(call, *map(np.asarray, arrays))]

    def compiled(ctx: Any, *operands: Any, call: _Call) -> Any:
        # Not `jax.pure_callback`: it copies large operands on a thread that the callbacks which
        # wait for them may occupy.
        results, _, _ = mlir.emit_python_callback(
            ctx,
            lambda *arrays: tuple(host(call, *arrays)),
            None,
            operands,
            ctx.avals_in,
            ctx.avals_out,
            has_side_effect=False,
        )
        return results

    primitive.def_impl(run)
    primitive.def_abstract_eval(lambda *arrays, call: shapes(call, *arrays))
    mlir.register_lowering(primitive, compiled)
    batching.primitive_batchers[primitive] = partial(_one_by_one, primitive)
    ad.primitive_jvps[primitive] = jvp
    return primitive


_IMAGE = _primitive(_image, _image_shape, _image_jvp)
_PUSH = _primitive(_push, _image_shape, _push_jvp)
_PULL = _primitive(_pull, _pull_shape, _pull_jvp)
ad.primitive_transposes[_PUSH] = partial(_transposed, _PULL)
ad.primitive_transposes[_PULL] = partial(_transposed, _PUSH)


def _array(name: str, value: jax.Array | ArrayLike) -> jax.Array:
    try:
        array = jnp.asarray(value)
    except TypeError:
        raise TypeError(f"{name} is a {type(value).__name__}; expected an array") from None
    if array.dtype not in (jnp.float32, jnp.float64):
        raise ArgumentError(
            f"{name} is an array of {array.dtype}; expected float32 or float64: convert it, for "
            "instance by .astype(float)"
        )
    return array


def _words(own: int, seed: Any, seed_grad: Any) -> Any:
    """Both seeds, as (2, 2) words of 32 bits, which is all that JAX has by default."""
    if not any(isinstance(number, jax.core.Tracer) for number in (seed, seed_grad)):
        pair = seeds(own, seed, seed_grad)
        return np.array([divmod(number, 2**32) for number in pair], dtype=np.uint32)
    first = _words_of("seed", own if seed is None else seed)
    second = ~first if seed_grad is None else _words_of("seed_grad", seed_grad)
    return jnp.stack([first, second])


def _words_of(name: str, seed: Any) -> jax.Array:
    if not isinstance(seed, jax.core.Tracer):
        return jnp.array(divmod(integer(name, seed, 0, LARGEST_SEED), 2**32), dtype=jnp.uint32)
    if not jnp.issubdtype(seed.dtype, jnp.integer) or seed.shape != ():
        raise TypeError(f"{name} is an array {seed.dtype}{list(seed.shape)}; expected one integer")
    # In two steps, because no number can be shifted by all of its bits.
    high = (seed >> 16) >> 16
    return jnp.stack([high.astype(jnp.uint32), seed.astype(jnp.uint32)])


def _number(words: NDArray[Any]) -> int:
    high, low = (int(word) for word in words)
    return high << 32 | low


def _doubles(arrays: Iterable[Any]) -> list[NDArray[np.float64]]:
    return [np.asarray(array, dtype=np.float64) for array in arrays]

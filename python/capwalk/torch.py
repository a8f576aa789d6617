"""Differentiable images for PyTorch, 2.0 or newer.

>>> import capwalk as cw, capwalk.torch
>>> import torch
>>> scene = cw.load_file("leaf")
>>> scene.resize(32, 24)
>>> positions = torch.from_numpy(cw.traverse(scene)["leaf.positions"])
>>> shift = torch.zeros(3, dtype=torch.float64, requires_grad=True)
>>> image = capwalk.torch.render(scene, {"leaf.positions": positions + shift}, spp=2, seed=1)
>>> image.square().mean().backward()
>>> shift.grad.shape
torch.Size([3])
"""

# mypy: allow-subclassing-any

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import torch  # type: ignore[import-not-found, unused-ignore]

from . import _capwalk
from ._functional import Work, second_derivative, seeds
from ._numbers import Array
from ._sample_scheduler import SampleScheduler
from .errors import ArgumentError
from .options import FunctionOptions, Unpack

__all__ = ["SampleScheduler", "render"]


def render(
    scene: _capwalk.Scene,
    params: Mapping[str, torch.Tensor],
    *,
    seed: int | None = None,
    seed_grad: int | None = None,
    **options: Unpack[FunctionOptions],
) -> torch.Tensor:
    """The image of a scene, (height, width, 3), with tensors in place of some of its arrays; with
    ``views`` the images of several sensors, (views, height, width, 3). It is differentiable with
    respect to them, once: in reverse mode (``backward``, ``torch.func.grad``) and in forward mode
    (``torch.func.jvp``, ``torch.autograd.forward_ad``).

    The scene is not changed. Image and derivatives use its state at the time of the call. Calls
    refit its trees, which all sensors share, and build none, and may be made in several threads.
    Views, and images under ``torch.func.vmap``, are rendered one after the other.

    **Seeds.** The image and its derivatives have different random numbers. Otherwise the gradient
    of a loss, which is a product of both, would be biased. For the same reason all images that
    occur in one loss, such as an image and its rendered target, need different seeds. Use other
    seeds in each step of an optimisation.

    :param params: tensors of float32 or float64 by the names of the arrays that
        :func:`capwalk.traverse` lists, in their shapes or flat, in their units. All of them are
        on one device, the image comes back there, in the widest of their types.
    :param seed: of the random numbers of the image, 0 to 2**64 - 1; by default the scene's. Of
        several views it is that of the first.
    :param seed_grad: of the random numbers of the derivatives; by default the complement of
        ``seed``.
    :param options: how, see :class:`capwalk.options.FunctionOptions`: ``sensor``, ``views``, ``aov``,
        ``spp``, ``spp_grad``, ``threads``, ``progress``, and what is said of methods by
        :class:`capwalk.options.MethodOptions`.

    :raises ArgumentError: a tensor of another shape, type or device, or ``seed_grad`` equals
        ``seed``.
    :raises ParameterError: a name is not an array, or a tensor has numbers that the scene cannot
        have, NaN for one.
    :raises Refused: a derivative could only be estimated with a bias, or is a second derivative;
        with ``reason`` and ``instead``. Raised when the derivative is computed.
    """
    params = dict(params)
    for name, tensor in params.items():
        _check(name, tensor)
    work = Work(
        scene,
        {name: tuple(tensor.shape) for name, tensor in params.items()},
        **options,
    )
    call = _Call(work, *seeds(work.seed, seed, seed_grad), *_common(params))
    image: torch.Tensor = _Image.apply(call, *params.values())
    return image


@dataclass(frozen=True, eq=False)
class _Call:
    """What the functions of a call have in common."""

    work: Work
    seed: int
    seed_grad: int
    dtype: torch.dtype
    device: torch.device
    moving: tuple[bool, ...] = ()
    """Which of the values derivatives are with respect to."""

    def tensor(self, image: Array) -> torch.Tensor:
        return torch.from_numpy(image).to(self.dtype).to(self.device)

    def moving_of(self, values: Iterable[Any]) -> list[Any]:
        return [value for value, moves in zip(values, self.moving) if moves]

    def check_first(self, needed: Iterable[bool]) -> None:
        """An error if a derivative with respect to the values is needed once more."""
        names = [name for name, again in zip(self.work.names, needed) if again]
        if names:
            raise second_derivative(names)


# The transforms of torch.func go through functions only, so that derivatives are such, too.
# Each of the last two is linear in what the other returns, and the other's transpose.


class _Image(torch.autograd.Function):
    """The image, from all values."""

    @staticmethod
    def forward(call: _Call, *values: torch.Tensor) -> torch.Tensor:
        return call.tensor(call.work.image(call.seed, _arrays(values)))

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Any) -> None:
        ctx.call, *values = inputs
        _save(ctx, values)

    @staticmethod
    def backward(ctx: Any, adjoint: torch.Tensor) -> Any:
        moving = tuple(ctx.needs_input_grad[1:])
        gradients = iter(_Pull.apply(replace(ctx.call, moving=moving), adjoint, *ctx.saved_tensors))
        return (None, *(next(gradients) if moves else None for moves in moving))

    @staticmethod
    def jvp(ctx: Any, _: None, *velocities: torch.Tensor | None) -> Any:
        moving = tuple(velocity is not None for velocity in velocities)
        call = replace(ctx.call, moving=moving)
        return _Push.apply(call, *ctx.saved_tensors, *call.moving_of(velocities))

    @staticmethod
    def vmap(info: Any, in_dims: tuple[int | None, ...], *inputs: Any) -> tuple[Any, int]:
        return torch.stack(_one_by_one(_Image, info, in_dims, inputs)), 0


class _Push(torch.autograd.Function):
    """The derivative of the image, from all values and the velocities of those that move."""

    @staticmethod
    def forward(call: _Call, *inputs: torch.Tensor) -> torch.Tensor:
        arrays, count = _arrays(inputs), len(call.moving)
        image = call.work.push(call.seed_grad, arrays[:count], call.moving, arrays[count:])
        return call.tensor(image)

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Any) -> None:
        ctx.call, *tensors = inputs
        _save(ctx, tensors[: len(ctx.call.moving)])

    @staticmethod
    def backward(ctx: Any, adjoint: torch.Tensor) -> Any:
        ctx.call.check_first(ctx.needs_input_grad[1:])
        gradients = _Pull.apply(ctx.call, adjoint, *ctx.saved_tensors)
        return (None, *(None for _ in ctx.call.moving), *gradients)

    @staticmethod
    def jvp(ctx: Any, _: None, *tangents: torch.Tensor | None) -> Any:
        ctx.call.check_first(tangent is not None for tangent in tangents)
        values = ctx.saved_tensors
        velocities = _filled(tangents[len(values) :], ctx.call.moving_of(values))
        return _Push.apply(ctx.call, *values, *velocities)

    @staticmethod
    def vmap(info: Any, in_dims: tuple[int | None, ...], *inputs: Any) -> tuple[Any, int]:
        return torch.stack(_one_by_one(_Push, info, in_dims, inputs)), 0


class _Pull(torch.autograd.Function):
    """The gradients with respect to the values that move, from the adjoint and all values."""

    @staticmethod
    def forward(
        call: _Call, adjoint: torch.Tensor, *values: torch.Tensor
    ) -> tuple[torch.Tensor, ...]:
        image, *arrays = _arrays((adjoint, *values))
        gradients = call.work.pull(call.seed_grad, arrays, call.moving, image)
        return tuple(
            torch.from_numpy(gradient).to(value.dtype).to(value.device)
            for gradient, value in zip(gradients, call.moving_of(values))
        )

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Any) -> None:
        ctx.call, _, *values = inputs
        _save(ctx, values)

    @staticmethod
    def backward(ctx: Any, *velocities: torch.Tensor | None) -> Any:
        ctx.call.check_first(ctx.needs_input_grad[2:])
        values = ctx.saved_tensors
        given = _filled(velocities, ctx.call.moving_of(values))
        return (None, _Push.apply(ctx.call, *values, *given), *(None for _ in values))

    @staticmethod
    def jvp(ctx: Any, _: None, *tangents: torch.Tensor | None) -> Any:
        adjoint, *velocities = tangents
        ctx.call.check_first(velocity is not None for velocity in velocities)
        return _Pull.apply(ctx.call, adjoint, *ctx.saved_tensors)

    @staticmethod
    def vmap(info: Any, in_dims: tuple[int | None, ...], *inputs: Any) -> tuple[Any, Any]:
        rows = _one_by_one(_Pull, info, in_dims, inputs)
        columns = tuple(torch.stack(column) for column in zip(*rows))
        return columns, (0,) * len(columns)


def _save(ctx: Any, values: Iterable[torch.Tensor]) -> None:
    ctx.save_for_backward(*values)
    ctx.save_for_forward(*values)
    # What does not move is not a motion by zero.
    ctx.set_materialize_grads(False)


def _one_by_one(
    function: Any, info: Any, in_dims: tuple[int | None, ...], inputs: tuple[Any, ...]
) -> list[Any]:
    """The results for each index of a batch. Each takes all cores already."""

    def taken(index: int) -> list[Any]:
        pairs = zip(inputs, in_dims)
        return [value if dim is None else value.select(dim, index) for value, dim in pairs]

    return [function.apply(*taken(index)) for index in range(info.batch_size)]


def _filled(
    tensors: Iterable[torch.Tensor | None], like: Iterable[torch.Tensor]
) -> list[torch.Tensor]:
    pairs = zip(tensors, like)
    return [torch.zeros_like(other) if tensor is None else tensor for tensor, other in pairs]


def _arrays(tensors: Iterable[torch.Tensor]) -> list[Array]:
    return [np.asarray(tensor.numpy(force=True), dtype=np.float64) for tensor in tensors]


def _check(name: str, tensor: torch.Tensor) -> None:
    if not isinstance(tensor, torch.Tensor):
        raise TypeError(
            f"{name} is a {type(tensor).__name__}; expected a tensor, such as torch.as_tensor "
            "makes"
        )
    if tensor.dtype not in (torch.float32, torch.float64) or tensor.layout != torch.strided:
        kind = f"{tensor.dtype}, {tensor.layout}"
        raise ArgumentError(
            f"{name} is a tensor of {kind}; expected a dense one of torch.float32 or "
            "torch.float64: convert it, for instance by .float()"
        )
    if tensor.device.type == "meta":
        raise ArgumentError(f"{name} is on the device meta, where tensors have no numbers")


def _common(params: Mapping[str, torch.Tensor]) -> tuple[torch.dtype, torch.device]:
    """The widest type of all tensors, and their device."""
    if not params:
        return torch.get_default_dtype(), torch.device("cpu")
    devices = {name: tensor.device for name, tensor in params.items()}
    if len(set(devices.values())) > 1:
        places = ", ".join(f"{name} on {device}" for name, device in devices.items())
        raise ArgumentError(f"tensors are on several devices ({places}); move them to one")
    is_double = any(tensor.dtype == torch.float64 for tensor in params.values())
    return torch.float64 if is_double else torch.float32, next(iter(devices.values()))

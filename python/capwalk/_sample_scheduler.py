"""Sample counts that follow the noise, in loops of PyTorch."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import torch  # type: ignore[import-not-found, unused-ignore]

from ._capwalk import NoDescent, SampleCounts
from ._options import LARGEST_COUNT, LARGEST_SEED, integer
from .errors import ArgumentError

LEAST_OF_BATCH = 2
"""The fewest samples per pixel of a batch."""


class SampleScheduler:
    """Takes the steps of an optimiser with as many samples as the noise of the gradient requires, and
    says when further steps would bring little: the rule of ``[samples]`` of :func:`capwalk.optimize`.

    >>> import capwalk as cw, capwalk.torch
    >>> import torch
    >>> scene = cw.load_file("leaf")
    >>> scene.resize(16, 12)
    >>> target = torch.from_numpy(cw.render(scene, spp=64, seed=1).value)
    >>> positions = torch.from_numpy(cw.traverse(scene)["leaf.positions"])
    >>> shift = torch.tensor([0.1, 0.0, 0.0], dtype=torch.float64, requires_grad=True)
    >>> def loss_of(spp, seed):
    ...     params = {"leaf.positions": positions + shift}
    ...     image = capwalk.torch.render(scene, params, spp=spp, seed=seed)
    ...     return (image - target).square().mean()
    >>> optimizer = torch.optim.Adam([shift], lr=0.01)
    >>> scheduler = capwalk.torch.SampleScheduler(optimizer, spp=4, seed=2)
    >>> for _ in range(3):
    ...     loss = scheduler.step(loss_of)
    ...     if scheduler.no_descent:
    ...         break

    A step has several batches of samples with seeds of their own. Its gradient is their mean, and what
    they differ by is its noise, of image and derivative together. The *descent* is how much the loss
    would fall if the step before were repeated, at its full learning rate: the product of the gradient
    and that step. After each 20 steps their mean descent is compared with its standard error. If the
    error is larger than ``theta`` times the descent, the next 20 steps have twice the samples, unless the
    descents vary by more than their noise, because steps are too long. If half the samples would be
    enough, the next 20 steps have half of them. If 40 steps had ``most`` samples, and neither the mean
    descent of the first 20 nor that of all is more than its standard error, :attr:`no_descent` says so.

    Noise must not bias the gradient of the loss, as is so for squared differences. It does for absolute
    differences, for instance, and more so with few samples: do not use it there.

    :param optimizer: any that steps without a closure. Parameters may also be changed after a step, to
        keep them within bounds. Rates of ``torch.optim.lr_scheduler`` are steps at a part of the full
        rate, the first one (of ``OneCycleLR`` and ``ReduceLROnPlateau`` the present one).
    :param spp: samples per pixel of the first step, all batches together; rounded up to a multiple of
        ``batches``. All counts are such multiples.
    :param theta: the relative standard error that the mean descent of 20 steps may have, above 0.
    :param most: the most samples per pixel of a step; by default 16 times ``spp``.
    :param batches: how many, at least 2. More of them know the noise better, and are more calls.
    :param seed: of the first batch, 0 to 2**64 - 1. Each batch of each step has the next one. A target
        that is rendered needs another one.
    :raises ArgumentError: a wrong number.
    """

    no_descent: NoDescent | None
    """That the descent cannot be told from zero, with its ``mean`` over the last ``steps``, at the full learning rate,
    and the standard ``error`` of that; None otherwise."""
    descent: float
    """The descent of the last step; NaN if there was none before it."""
    descent_stderr: float
    """Its standard error."""

    def __init__(
        self,
        optimizer: torch.optim.Optimizer,
        spp: int,
        *,
        theta: float = 0.9,
        most: int | None = None,
        batches: int = 2,
        seed: int = 0,
    ) -> None:
        self._optimizer = optimizer
        self._batches = integer("batches", batches, 2, 1024)
        spp = integer("spp", spp, LEAST_OF_BATCH * self._batches, LARGEST_COUNT)
        most = 16 * spp if most is None else integer("most", most, spp, LARGEST_COUNT)
        if not (math.isfinite(theta) and theta > 0.0):
            raise ArgumentError(f"theta is {theta}; expected a finite number above 0")
        first, most = (math.ceil(count / self._batches) for count in (spp, most))
        self._counts = SampleCounts((1.0, first), theta, (1, LEAST_OF_BATCH), most, 1.0)
        """Of the samples per pixel of a batch. Its noise, of image and gradient together, counts as that of
        gradients, as if images had none and cost as much."""
        self._seed = integer("seed", seed, 0, LARGEST_SEED)
        self._before: list[tuple[Any, Any, float]] = []
        """Parameters with their values before the last step, and the part of the full rate it had."""
        self.no_descent, self.descent, self.descent_stderr = None, math.nan, math.nan

    @property
    def spp(self) -> int:
        """Samples per pixel of the next step, all batches together."""
        return self._counts.spp()[1] * self._batches

    def step(self, loss_of: Callable[[int, int], torch.Tensor]) -> torch.Tensor:
        """Takes a step.

        :param loss_of: a function of samples per pixel and a seed, which renders and returns the loss
            with its graph. It is called for each batch.
        :return: the mean loss of the batches, without a graph.
        :raises ArgumentError: the gradient has NaN or infinite numbers. No step was taken then.
        """
        parameters = [p for group in self._optimizer.param_groups for p in group["params"]]
        last = [
            (parameter, (parameter.detach() - before).double() / factor)
            for parameter, before, factor in self._before
        ]
        _, spp_of_batch = self._counts.spp()
        losses: list[torch.Tensor] = []
        descents: list[float] = []
        sums: list[torch.Tensor | None] = [None] * len(parameters)
        for _ in range(self._batches):
            self._optimizer.zero_grad()
            loss = loss_of(spp_of_batch, self._seed)
            self._seed = (self._seed + 1) % (LARGEST_SEED + 1)
            torch.autograd.backward(loss)
            losses.append(loss.detach())
            along = [(p.grad.double() * d).sum().item() for p, d in last if p.grad is not None]
            descents.append(-sum(along))
            for i, parameter in enumerate(parameters):
                if parameter.grad is not None:
                    total = sums[i]
                    sums[i] = parameter.grad.clone() if total is None else total + parameter.grad
        for parameter, total in zip(parameters, sums):
            parameter.grad = None if total is None else total / self._batches
            if total is not None and not total.isfinite().all():
                raise ArgumentError("the gradient of the loss has infinite numbers or NaN")
        if any(direction.any() for _, direction in last):
            self._learn(descents)
        self._before = [
            (parameter, parameter.detach().clone(), _factor(group))
            for group in self._optimizer.param_groups
            for parameter in group["params"]
            if _factor(group) > 0.0
        ]
        self._optimizer.step()
        return torch.stack(losses).mean()

    def _learn(self, descents: list[float]) -> None:
        """Chooses the next count by the descents that the batches say."""
        count = len(descents)
        self.descent = sum(descents) / count
        squares = sum((descent - self.descent) ** 2 for descent in descents)
        variance = squares / (count - 1) / count
        self.descent_stderr = math.sqrt(variance)
        self._counts.learn(self.descent, (0.0, variance))
        self.no_descent = self._counts.no_descent()


def _factor(group: dict[str, Any]) -> float:
    """The learning rate of a group, relative to its first one, which schedulers note."""
    first = float(group.get("initial_lr", group["lr"]))
    return float(group["lr"]) / first if first > 0.0 else 0.0

"""How many samples the next step takes: the rule of ``[samples]``, ``crates/inverse/src/samples.rs``."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

KEPT = 0.8
"""How much of the means over steps is kept in each."""
FASTEST = 2.0
"""Counts change by this factor at most in a step."""
FAR_BELOW = 2.0
"""Counts get smaller if this times as many would be enough."""
BLOCK = 20
"""The steps in a row with the most samples that decide whether there is still a descent."""
CLEARLY = 1.0
"""There is if its mean over them is so many standard errors."""


@dataclass(frozen=True)
class NoDescent:
    """A descent that cannot be told from zero."""

    mean: float
    """Its mean over some steps: by how much the loss falls per step at the full learning rate."""
    error: float
    """The standard error of that."""
    steps: int
    """How many steps."""


@dataclass
class SampleCounts:
    """As many samples as the noise of the descent requires (the inner-product test of Bollapragada, Byrd
    and Nocedal 2018). With the variance ``V`` that one sample gives it, and its cost ``c``, for each
    kind of sample, the counts that reach a standard error ``e`` at the least cost are ::

        n = √(V / c) S / e² ,   S = Σ √(V c)

    """

    counts: list[float]
    """Of each kind of sample, for the next step, before they are rounded."""
    theta: float
    """The standard error of the descent, relative to it, that a step may have."""
    least: Sequence[int]
    most: int
    costs: Sequence[float] = (1.0,)
    """Of a sample of each kind, relative to each other."""
    _weight: float = 0.0
    """The sum of the weights of steps, which fall."""
    _squared: float = 0.0
    """The weighted sum of squared descents, less what noise adds to them."""
    _variances: list[float] = field(default_factory=list)
    """That of the variances for one sample."""
    _block: list[float] = field(default_factory=list)
    """Descents of the last steps in a row with the most samples, and too much noise; up to 20."""

    def spp(self) -> list[int]:
        """The samples of each kind that the next step takes."""
        # Halves up, as in Rust.
        return [math.floor(count + 0.5) for count in self.counts]

    def learn(self, descent: float, variances: Sequence[float]) -> None:
        """Learns from a step with these counts: its descent along the step before, and the variances
        that each kind of sample gives it."""
        spp = self.spp()
        # Means over some steps: a single one is noisy.
        squared = descent * descent
        for variance in variances:
            squared -= variance
        self._weight = KEPT * self._weight + (1.0 - KEPT)
        self._squared = KEPT * self._squared + (1.0 - KEPT) * squared
        self._variances = [
            KEPT * old + (1.0 - KEPT) * (variance * n)
            for old, variance, n in zip(self._variances or [0.0] * len(spp), variances, spp)
        ]
        # If there is no descent, the error is to be 0: as many as possible.
        squared_error = self.theta * self.theta * max(0.0, self._squared / self._weight)
        means = [max(0.0, variance / self._weight) for variance in self._variances]
        both = sum(math.sqrt(v * cost) for v, cost in zip(means, self.costs))
        is_short = False
        for i, (variance, cost) in enumerate(zip(means, self.costs)):
            enough = _over(math.sqrt(variance / cost) * both, squared_error)
            is_short |= spp[i] >= self.most and enough > self.most
            more = enough / self.counts[i]
            change = 1.0
            if more > 1.0:
                change = min(more, FASTEST)
            elif more * FAR_BELOW < 1.0:
                change = max(more, 1.0 / FASTEST)
            most = max(self.most, self.least[i])
            self.counts[i] = min(max(self.counts[i] * change, self.least[i]), most)
        if len(self._block) >= BLOCK:
            self._block = []
        self._block = [*self._block, descent] if is_short else []

    def no_descent(self) -> NoDescent | None:
        """That the last steps had the most samples, too much noise, and no descent that is clearly above
        zero; None otherwise."""
        count = len(self._block)
        if count < BLOCK:
            return None
        mean = sum(self._block) / count
        squares = sum(descent * descent for descent in self._block)
        error = math.sqrt(max((squares / count - mean * mean) / (count - 1), 0.0))
        return NoDescent(mean, error, count) if mean <= CLEARLY * error else None


def _over(a: float, b: float) -> float:
    """The quotient, of 0 and 0 NaN, which changes nothing."""
    if b == 0.0:
        return math.inf if a > 0.0 else math.nan
    return a / b

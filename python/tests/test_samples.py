"""The rule by which sample counts follow the noise."""

from __future__ import annotations

from pathlib import Path

import capwalk as cw
import numpy as np
import pytest
from capwalk._capwalk import NoDescent, SampleCounts
from test_jobs import JOB


@pytest.mark.parametrize(("theta", "most"), [(0.9, 32), (0.2, 64), (3.0, 64)])
def test_counts_are_those_of_jobs(tmp_path: Path, theta: float, most: int) -> None:
    """Two kinds of samples, as the job's own rule chose them in each step."""
    job = tmp_path / "job.toml"
    text = JOB.replace("most = 32", f"theta = {theta}, most = {most}")
    job.write_text(text.replace("iterations = 4", "iterations = 60"))
    found = cw.optimize(job)
    record = found.record
    of_jobs = np.stack([record["spp"], record["spp_grad"]], axis=1)
    counts = SampleCounts((4.0, 4.0), theta, (2, 4), most)
    columns = ("descent", "descent_variance_by_image", "descent_variance_by_gradient")
    steps = np.stack([record[column] for column in columns], axis=1)
    chosen = []
    # Before the first step there is no direction; after the last there is no step.
    for i, (descent, of_image, of_gradient) in enumerate(steps[:-1].tolist()):
        chosen.append(counts.spp())
        if i > 0:
            counts.learn(descent, (of_image, of_gradient))
    np.testing.assert_array_equal(chosen, of_jobs[:-1])
    assert len(np.unique(of_jobs[:, 0])) > 2
    assert (counts.no_descent() is not None) == ("descent" in found.stopped)


def test_a_descent_that_is_not_there_is_the_end() -> None:
    """With either sign at the most samples: after 20 steps. A small but steady one goes on."""

    def after(steps: int, *descents: float) -> tuple[SampleCounts, NoDescent | None]:
        counts = SampleCounts((1.0, 8.0), 0.5, (1, 2), 256)
        for step in range(steps):
            value, variance = descents[step % len(descents)], 9e3 / counts.spp()[1]
            size = (value * value + variance) ** 0.5
            counts.learn(float(np.copysign(size, value)), (0.0, variance))
            if counts.no_descent():
                break
        return counts, counts.no_descent()

    counts, found = after(100, 1.0, -0.9)
    assert found is not None and found.steps == 20 and abs(found.mean) < 2 * found.error
    assert counts.spp()[1] == 256
    counts, found = after(100, 2.0, 1.0, 0.0)
    assert found is None

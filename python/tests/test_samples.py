"""The rule by which sample counts follow the noise."""

from __future__ import annotations

from pathlib import Path

import capwalk as cw
import numpy as np
import pytest
from capwalk._capwalk import SampleCounts
from test_jobs import JOB


@pytest.mark.parametrize(("theta", "most", "ends"), [(0.9, 8, True), (0.2, 64, True), (3.0, 64, False)])
def test_counts_are_those_of_jobs(tmp_path: Path, theta: float, most: int, ends: bool) -> None:
    """Two kinds of samples, as the job's own rule chose them in each step."""
    job = tmp_path / "job.toml"
    text = JOB.replace("most = 32", f"theta = {theta}, most = {most}")
    job.write_text(text.replace("iterations = 4", "iterations = 200"))
    found = cw.optimize(job)
    record = found.record
    of_jobs = np.stack([record["spp"], record["spp_grad"]], axis=1)
    counts = SampleCounts((4.0, 4.0), theta, (2, 4), most, 50.0)
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
    assert (counts.no_descent() is not None) == ("descent" in found.stopped) == ends


def test_a_descent_that_is_not_there_is_the_end() -> None:
    """With either sign: after 40 steps with the most samples."""
    counts, steps = SampleCounts((1.0, 8.0), 0.5, (1, 2), 256, 1.0), 0
    while not (found := counts.no_descent()):
        variance = 9e3 / counts.spp()[1]
        counts.learn((-1) ** steps * variance**0.5, (0.0, variance))
        steps += 1
    # 8, 16, 32, 64, 128, and twice 256.
    assert steps == 140 and counts.spp()[1] == 256
    assert found.steps == 40
    assert repr(found) == "NoDescent(mean=0, error=0.9375, steps=40)"


def test_gradients_without_errors_are_refused(tmp_path: Path) -> None:
    job = tmp_path / "job.toml"
    job.write_text(JOB.replace("spp = 4", "spp_grad = 2", 1))
    with pytest.raises(cw.LoadError, match="at least 4 beside `\\[samples\\]`"):
        cw.optimize(job)

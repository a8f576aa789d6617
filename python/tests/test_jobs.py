"""Jobs of inverse rendering, as the command line runs them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import capwalk as cw

JOB = """scene = "leaf"
size = [8, 6]
iterations = 4
spp = 4
images = 0
parameter = [{ name = "leaf.translate.x", bounds = [-1, 1] }]
optimizer = { lr = 0.02 }
samples = { most = 32 }
[target]
spp = 64
[target.set]
"leaf.translate.x" = 0.2
"""


def test_jobs_are_run_and_resumed(tmp_path: Path) -> None:
    """In pieces, and with any number of threads, the same numbers come out."""
    job = tmp_path / "job.toml"
    job.write_text(JOB.replace("iterations = 4", "iterations = 9"))
    told: list[tuple[int, int]] = []
    whole = cw.optimize(job, threads=1, progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (9, 9)
    assert whole.folder == tmp_path / "job.out"
    assert whole.stopped == "all iterations are done"
    # The last row has no step.
    assert len(whole.record["loss"]) == 10 and np.isnan(whole.record["step_norm"][-1])
    assert whole.record["spp"][0] == 4
    x = whole.parameters["leaf.translate.x"]
    assert x.shape == () or x.shape == (1,)
    assert 0 < float(x.item()) < 0.25
    moved = cw.render(whole.scene(), spp=4).value
    assert np.abs(moved - cw.render(cw.load_file("leaf"), spp=4).value.mean()).max() > 0

    job.write_text(JOB)
    piece = cw.optimize(job, tmp_path / "pieces", threads=2)
    assert len(piece.record["loss"]) == 5
    job.write_text(JOB.replace("iterations = 4", "iterations = 9"))
    rest = cw.optimize(job, tmp_path / "pieces", resume=True)
    for name, column in whole.record.items():
        np.testing.assert_array_equal(rest.record[name], column, name)


def test_mistakes_have_their_place(tmp_path: Path) -> None:
    job = tmp_path / "job.toml"
    job.write_text(JOB.replace("most = 32", "most = 3"))
    with pytest.raises(cw.LoadError, match="job.toml") as error:
        cw.optimize(job)
    assert error.value.line == 8
    job.write_text(JOB)
    cw.optimize(job)
    with pytest.raises(cw.Error, match="resume"):
        cw.optimize(job)


def test_reports_are_one_page(tmp_path: Path) -> None:
    """With all pictures and curves in it, and nothing that is not finite."""
    job = tmp_path / "a <job>.toml"
    job.write_text(JOB.replace("images = 0", "images = 2"))
    found = cw.optimize(job)
    text = found.report().read_text(encoding="utf-8")
    assert found.report(tmp_path / "other.html").read_text(encoding="utf-8") == text
    # Iterations 0, 2 and 4; loss, samples, gradient and the parameter.
    assert text.count("data:image/png;base64") == 3 and text.count("<svg") == 4
    assert "a &lt;job&gt;" in text and "leaf.translate.x" in text
    assert not any(word in text for word in ("http", "src=\"/", "nan", "inf "))


def test_runs_without_an_iteration_are_results(tmp_path: Path) -> None:
    job = tmp_path / "job.toml"
    job.write_text(JOB.replace("size = [8, 6]", "size = [400, 300]").replace("spp = 4", "spp = 99999", 1))
    job.write_text(job.read_text().replace("most = 32", "most = 99999") + "\n")
    text = job.read_text().replace("iterations = 4", 'iterations = 4\ntime_limit = "3s"')
    job.write_text(text.replace("spp = 64", "spp = 2"))
    found = cw.optimize(job)
    assert found.stopped == "the time limit is over"
    assert all(len(column) == 0 for column in found.record.values()) and "spp" in found.record
    assert "the time limit is over" in found.report().read_text(encoding="utf-8")


def test_bad_ends_are_warnings(tmp_path: Path) -> None:
    """A rate that throws the floor out of what can be rendered."""
    job = tmp_path / "job.toml"
    text = JOB.replace('"leaf.translate.x", bounds = [-1, 1]', '"floor.bsdf.reflectance.value"')
    text = text.replace('"leaf.translate.x" = 0.2', '"floor.bsdf.reflectance.value" = 0.01')
    job.write_text(text.replace("lr = 0.02", "lr = 10"))
    with pytest.warns(cw.UnreliableWarning, match="bounds"):
        assert "bounds" in cw.optimize(job).stopped

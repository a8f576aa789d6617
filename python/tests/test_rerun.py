"""Optimisations in recordings of Rerun, read back."""

from __future__ import annotations

import io
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import capwalk as cw
import numpy as np
import pytest
from conftest import SCENE
from test_jobs import JOB

rr = pytest.importorskip("rerun")
pillow: Any = pytest.importorskip("PIL.Image")
chunk = pytest.importorskip("rerun.chunk", reason="this rerun-sdk reads no recordings")

from capwalk import _run_folder  # noqa: E402
from capwalk._rerun_command import main  # noqa: E402
from capwalk.rerun import Log  # noqa: E402

NAME = "box.positions"
IMAGE = "/world/cameras/sensor/image"


def read(file: Path) -> dict[str, dict[str, list[tuple[int | None, Any]]]]:
    """What a recording has: by entity and component the iterations, None of what is static, and values."""
    found: dict[str, dict[str, list[tuple[int | None, Any]]]] = {}
    for one in chunk.RrdReader(file).stream().to_chunks():
        batch = one.to_record_batch()
        times = [None] * batch.num_rows if one.is_static else batch.column("iteration").to_pylist()
        components = [name for name in batch.schema.names if ":" in name]
        for name in components:
            rows = found.setdefault(one.entity_path, {}).setdefault(name, [])
            rows += zip(times, batch.column(name).to_pylist(), strict=True)
    for components_of in found.values():
        for rows in components_of.values():
            rows.sort(key=lambda row: -1 if row[0] is None else row[0])
    return found


def curve(recording: Any, entity: str) -> Any:
    """Iterations with the points of curves."""
    return recording[entity]["Scalars:scalars"]


def pixels(recording: Any, entity: str, row: int = 0) -> Any:
    """An image, (height, width, 3)."""
    [blob] = recording[entity]["EncodedImage:blob"][row][1]
    with pillow.open(io.BytesIO(bytes(blob))) as image:
        return np.array(image)


def test_loops_are_recorded(tmp_path: Path, scene: cw.Scene) -> None:
    """Each iteration with its loss, images, arrows and curves; what does not change once."""
    file, target = tmp_path / "run.rrd", np.full((18, 24, 3), 0.2)
    params, adam, losses = cw.traverse(scene), cw.Adam(lr=0.01), []
    before = params[NAME].copy()
    with Log.save(file) as log:
        for step in range(3):
            image = cw.render(scene, spp=4, seed=2 * step)
            difference = image.value - target
            adjoint = 2 * difference / difference.size
            grads = cw.backward(scene, adjoint, [NAME], spp=4, seed=2 * step + 1)
            losses.append(float(np.square(difference).mean()))
            log.iteration(step)
            log.loss(losses[-1], 0.5)
            log.image(image, target)
            log.scene(scene, grads)
            log.parameters({NAME: params[NAME], "x": [step, 2.0]}, grads)
            adam.step(params, grads)
            params.update()
    found = read(file)
    assert curve(found, "/loss/loss") == [(i, [loss]) for i, loss in enumerate(losses)]
    band = [(i, [loss - 0.5, loss + 0.5]) for i, loss in enumerate(losses)]
    assert curve(found, "/loss/loss\\ stderr") == band
    assert curve(found, "/parameters/x") == [(0, [0, 2]), (1, [1, 2]), (2, [2, 2])]
    # Adam's first steps are as long as the rate in every number.
    changes = [change for _, [change] in curve(found, f"/parameters/{NAME}")]
    assert changes[0] == 0 and changes[1] == pytest.approx(0.01, rel=0.2)
    length, noise = curve(found, f"/gradients/{NAME}")[2][1]
    assert length == np.linalg.norm(grads[NAME]) and noise == np.linalg.norm(grads.stderr[NAME])
    # The box moves; floor and camera stay, as does the target.
    counts = {entity: len(next(iter(of.values()))) for entity, of in found.items()}
    assert counts["/world/shapes/box"] == counts[IMAGE] == counts["/images/sensor/difference"] == 3
    assert counts["/world/shapes/floor"] == counts["/images/sensor/target"] == 1
    assert len(found["/world/cameras/sensor"]["Pinhole:image_from_camera"]) == 1
    corners = np.array(found["/world/shapes/box"]["Mesh3D:vertex_positions"][0][1])
    np.testing.assert_allclose(corners, before[scene.faces("box")].reshape(-1, 3), atol=1e-6)
    arrows = found["/world/shapes/box/gradient\\ of\\ positions"]["Arrows3D:vectors"][2][1]
    seen = np.linalg.norm(grads[NAME], axis=1) > 0
    cosines = np.sum(arrows * grads[NAME][seen], axis=1)
    cosines /= np.linalg.norm(arrows, axis=1) * np.linalg.norm(grads[NAME][seen], axis=1)
    np.testing.assert_allclose(cosines, -1, atol=1e-6)
    # Images have the colours of files.
    image.save(tmp_path / "image.png")
    saved = np.round(cw.load_image(tmp_path / "image.png", raw=True) * 255)
    assert np.abs(pixels(found, IMAGE, 2) - saved).max() <= 1
    assert len(chunk.RrdReader(file).blueprints()) == 1


def test_cameras_see_what_sensors_see(tmp_path: Path) -> None:
    """Points of the scene have the pixels in which they are rendered."""
    scene = cw.load_string(SCENE.replace('"width" value="24"', '"width" value="48"'))
    with Log.save(tmp_path / "run.rrd") as log:
        log.scene(scene)
    camera = read(tmp_path / "run.rrd")["/world/cameras/sensor"]
    value = {name: rows[0][1] for name, rows in camera.items()}
    rotation = np.reshape(value["Transform3D:mat3x3"], (3, 3)).T
    intrinsics = np.reshape(value["Pinhole:image_from_camera"], (3, 3)).T
    assert value["Pinhole:camera_xyz"] == [[way.value for way in rr.ViewCoordinates.LUF.coordinates]]
    points = cw.render(scene, aov="position", spp=16).value
    place = (points - value["Transform3D:translation"]) @ rotation
    # From x to the left and y up to x to the right and y down.
    column, row = np.moveaxis((place * [-1, -1, 1]) @ intrinsics.T, 2, 0)[:2] / place[..., 2]
    # In the last rows there is only the floor, whose mean point in a pixel is about at its centre.
    assert np.abs(points[-4:, :, 1]).max() < 1e-9
    expected_row, expected_column = np.mgrid[:18, :48] + 0.5
    assert np.abs(row - expected_row)[-4:].max() < 0.4
    assert np.abs(column - expected_column)[-4:].max() < 0.4


def test_derivatives_and_nan_are_shown(tmp_path: Path, scene: cw.Scene) -> None:
    derivative = cw.gradient(scene, "box.translate.x", spp=4)
    derivative.value[3, 5, 1] = np.nan
    with Log.save(tmp_path / "run.rrd") as log:
        log.image(derivative)
        log.loss(np.nan, name="depth")
        log.scene(scene, {"box.translate": [np.nan, 0.0, 0.0], "floor.translate": [0.0, 2.0, 0.0]})
    # The error is shown by the scale of the derivative.
    titles = [title.partition(", ") for title in log._layout.images["sensor"].values()]
    assert [title for title, _, _ in titles] == ["image", "derivative", "standard error"]
    assert titles[1][2] == titles[2][2] and titles[1][2].startswith("±")
    found = read(tmp_path / "run.rrd")
    image = pixels(found, IMAGE)
    assert tuple(image[3, 5]) == (255, 0, 255) and (image == (255, 0, 255)).all(axis=2).sum() == 1
    # Its derivative is red or blue where its mean is; its error is never blue.
    shown = pixels(found, "/images/sensor/derivative").astype(int)
    means = derivative.gradient.mean(axis=2)
    assert np.isfinite(means).all() and means.max() > 0 > means.min()
    row, column = np.unravel_index(means.argmax(), means.shape)
    assert shown[row, column, 0] > shown[row, column, 2]
    row, column = np.unravel_index(means.argmin(), means.shape)
    assert shown[row, column, 0] < shown[row, column, 2]
    error = pixels(found, "/images/sensor/standard\\ error").astype(int)
    assert (error[..., 0] >= error[..., 2]).all()
    notes = [text for _, [text] in found["/notes"]["TextLog:text"]]
    assert notes == [
        "image of sensor: 1 of 1,296 numbers are NaN or infinite",
        "depth: 1 of 1 numbers are NaN or infinite",
        "the gradient of box.translate: 1 of 3 numbers are NaN or infinite",
    ]
    [vector] = found["/world/shapes/floor/gradient\\ of\\ translate"]["Arrows3D:vectors"][0][1]
    assert vector[0] == vector[2] == 0 and vector[1] < 0
    assert found["/world/shapes/box/gradient\\ of\\ translate"]["Arrows3D:vectors"][0][1] == []


def test_values_of_other_frameworks_are_taken(tmp_path: Path, scene: cw.Scene) -> None:
    torch: Any = pytest.importorskip("torch")
    moved = torch.tensor(cw.traverse(scene)[NAME] + [0.5, 0, 0], requires_grad=True)
    before = cw.traverse(scene)[NAME].copy()
    with Log.save(tmp_path / "run.rrd") as log:
        log.loss(moved.square().mean())
        log.image(torch.zeros(18, 24, 3, requires_grad=True), torch.ones(18, 24, 3))
        log.scene(scene, {NAME: torch.ones_like(moved)}, params={NAME: moved})
        log.parameters({NAME: moved}, {NAME: moved})
    mesh = read(tmp_path / "run.rrd")["/world/shapes/box"]["Mesh3D:vertex_positions"][0][1]
    expected = moved.detach().numpy()[scene.faces("box")].reshape(-1, 3)
    np.testing.assert_allclose(mesh, expected, atol=1e-6)
    np.testing.assert_array_equal(cw.traverse(scene)[NAME], before)


def test_other_sensors_have_an_arrow(tmp_path: Path) -> None:
    scene = cw.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "direct"},
            "a/b": {"type": "orthographic"},
            "lamp": {"type": "constant"},
        }
    )
    with Log.save(tmp_path / "run.rrd") as log:
        log.scene(scene)
    assert "Arrows3D:vectors" in read(tmp_path / "run.rrd")["/world/cameras/a\\/b"]


def test_jobs_are_followed(tmp_path: Path) -> None:
    """While they run, and afterwards with the scene that was found; nothing twice."""
    job, folder = tmp_path / "job.toml", tmp_path / "results"
    job.write_text(JOB.replace("images = 0", "images = 2"))
    with Log.save(tmp_path / "run.rrd") as log:
        with pytest.raises(FileNotFoundError, match="record.csv"):
            log.run(folder)
        found = cw.optimize(job, folder, progress=log.follow(folder))
        log.run(found.folder)
    with Log.save(tmp_path / "later.rrd") as log:
        log.run(folder)
    recording, later = read(tmp_path / "run.rrd"), read(tmp_path / "later.rrd")
    assert curve(recording, "/loss/loss") == [(i, [x]) for i, x in enumerate(found.record["loss"])]
    # The last row has no step.
    lengths = np.stack([found.record["gradient_norm"], found.record["gradient_noise"]], axis=1)
    assert curve(recording, "/gradients/all") == [(i, list(lengths[i])) for i in range(4)]
    x = curve(recording, "/parameters/leaf.translate.x")
    assert len(x) == 5 and x[-1][1] == [found.parameters["leaf.translate.x"].item()]
    pictures = recording["/images/run/image\\,\\ target\\,\\ difference"]["EncodedImage:blob"]
    assert [iteration for iteration, _ in pictures] == [0, 2, 4]
    # Those of a video have one size, whatever the numbers at the colour bar are.
    entity = "/images/run/image\\,\\ target\\,\\ difference"
    shown = [pixels(recording, entity, row) for row in range(3)]
    assert len({picture.shape for picture in shown}) == 1
    with pillow.open(folder / "images/000004.png") as picture:
        width, height = picture.size
        np.testing.assert_array_equal(shown[2][:height, :width], np.array(picture))
    assert (shown[2][:, width:] == 255).all()
    assert recording["/world/shapes/leaf"]["Mesh3D:vertex_positions"][0][0] == 4
    assert recording.keys() == later.keys()
    assert all(curve(later, path) == curve(recording, path) for path in recording if "/loss" in path)


def test_runs_that_go_on_are_logged_once_more(tmp_path: Path) -> None:
    """What is new, and the row that was the last one, which has a step now."""
    job, folder = tmp_path / "job.toml", tmp_path / "results"
    job.write_text(JOB)
    with Log.save(tmp_path / "run.rrd") as log:
        cw.optimize(job, folder)
        log.run(folder)
        job.write_text(JOB.replace("iterations = 4", "iterations = 6"))
        cw.optimize(job, folder, resume=True)
        log.run(folder)
    recording = read(tmp_path / "run.rrd")
    assert [i for i, _ in curve(recording, "/loss/loss")] == [0, 1, 2, 3, 4, 4, 5, 6]
    assert [i for i, _ in curve(recording, "/gradients/all")] == list(range(6))


def followed(folder: Path, work: Callable[[], Any], monkeypatch: pytest.MonkeyPatch) -> Any:
    """The recording of what the command shows while something is done."""
    monkeypatch.setattr(_run_folder, "OFTEN", 0.01)
    # Should it begin and end before the folder is read first.
    monkeypatch.setattr(_run_folder, "BEGINS_WITHIN", 5.0)
    file = folder.with_suffix(".rrd")
    with ThreadPoolExecutor(1) as thread:
        status = thread.submit(main, [str(folder), "--follow", "--save", str(file)])
        work()
        assert status.result(60) == 0
    return read(file)


def test_the_command_follows_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """From before the folder is there until the run has ended, with its result; a run that goes on as
    well. Afterwards it shows the same."""
    job, folder = tmp_path / "job.toml", tmp_path / "results"
    job.write_text(JOB.replace("images = 0", "images = 2"))
    recording = followed(folder, lambda: cw.optimize(job, folder), monkeypatch)
    assert main([str(folder), "--save", str(tmp_path / "later.rrd")]) == 0
    later = read(tmp_path / "later.rrd")
    assert recording.keys() == later.keys() and "/world/shapes/leaf" in recording
    assert [i for i, _ in curve(recording, "/loss/loss")] == list(range(5))
    assert all(curve(later, path) == curve(recording, path) for path in recording if "/loss" in path)
    # It has begun, and nobody writes: it is over, and is not waited for.
    monkeypatch.setattr(_run_folder, "BEGINS_WITHIN", 1e9)
    arguments = [str(folder), "--follow", "--begun", "--save", str(tmp_path / "over.rrd")]
    assert main(arguments) == 0
    # Begun again; a result is there meanwhile, but of the run before.
    job.write_text(job.read_text().replace("iterations = 4", "iterations = 6"))
    recording = followed(folder, lambda: cw.optimize(job, folder, resume=True), monkeypatch)
    # The last row that was there before has no step, and may have been read before it gets one.
    assert sorted({i for i, _ in curve(recording, "/loss/loss")}) == list(range(7))
    assert [i for i, _ in curve(recording, "/gradients/all")] == list(range(6))
    [(iteration, _)] = recording["/world/shapes/leaf"]["Mesh3D:vertex_positions"]
    assert iteration == 6


def test_the_command_ends_with_a_killed_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With all that was written, and without a result."""
    job, folder = tmp_path / "job.toml", tmp_path / "results"
    job.write_text(JOB.replace("iterations = 4", "iterations = 1000000"))
    is_written = _run_folder.RunFolder(folder).is_written
    assert not is_written()

    def run_and_kill() -> None:
        code = "import sys, capwalk as cw; cw.optimize(*sys.argv[1:])"
        run = subprocess.Popen([sys.executable, "-c", code, str(job), str(folder)])
        try:
            while run.poll() is None and not rows():
                pass
            assert is_written()
        finally:
            run.kill()
            run.wait()
        assert not is_written()

    def rows() -> list[str]:
        record = folder / "record.csv"
        return record.read_text().splitlines()[1:] if record.exists() else []

    recording = followed(folder, run_and_kill, monkeypatch)
    assert len(curve(recording, "/loss/loss")) in (len(rows()), len(rows()) - 1) and rows()
    assert not any(path.startswith("/world") for path in recording)


def test_the_command_names_mistakes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """In one line."""
    monkeypatch.setattr(_run_folder, "BEGINS_WITHIN", 0.0)
    (tmp_path / "file").touch()
    run = tmp_path / "run"
    run.mkdir()
    (run / "record.csv").touch()
    missing, place = tmp_path / "missing", tmp_path / "a" / "b.rrd"
    for arguments, expected in [
        ([missing, "--save", tmp_path / "a.rrd"], "record.csv"),
        ([missing, "--follow", "--save", tmp_path / "a.rrd"], "record.csv"),
        ([tmp_path / "file", "--follow"], "is no folder"),
        ([run, "--save", place], "b.rrd"),
        ([run, "--connect", "nowhere"], "nowhere"),
    ]:
        assert main([str(argument) for argument in arguments]) == 1
        error = capsys.readouterr().err
        assert error.count("\n") == 1 and expected in error


def test_mistakes_are_errors(tmp_path: Path, scene: cw.Scene) -> None:
    with Log.save(tmp_path / "run.rrd") as log:
        with pytest.raises(cw.ArgumentError, match="the shape .18, 24.; expected"):
            log.image(np.zeros((18, 24)))
        with pytest.raises(cw.ArgumentError, match="that of the image"):
            log.image(np.zeros((18, 24, 3)), np.zeros((24, 18, 3)))
        with pytest.raises(cw.ArgumentError, match="expected one number"):
            log.loss([1.0, 2.0])
        with pytest.raises(cw.ArgumentError, match="expected 8 x 3"):
            log.scene(scene, {NAME: np.zeros((7, 3))})
        log.parameters({"x": np.zeros(3)})
        with pytest.raises(cw.ArgumentError, match="as many as before"):
            log.parameters({"x": np.zeros(4)})
        with pytest.raises(cw.ArgumentError, match="the iteration"):
            log.iteration(-1)


def test_the_extra_is_named_where_rerun_is_missing() -> None:
    code = "import sys; sys.modules['rerun'] = None; import capwalk.rerun"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert ran.returncode != 0 and "pip install 'capwalk[rerun]'" in ran.stderr
    code = """import runpy, sys; sys.modules['rerun'] = None; sys.argv = ['', 'results']
runpy.run_module('capwalk.rerun', run_name='__main__')"""
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert ran.returncode == 1
    assert ran.stderr == "capwalk.rerun needs Rerun: pip install 'capwalk[rerun]'\n"


def test_viewers_hold_no_pipe() -> None:
    """What ``--view`` starts outlives it: a pipe on its output ends all the same."""
    program = """
import subprocess, sys
from capwalk._rerun_command import _files_closed
with _files_closed():
    viewer = subprocess.Popen([sys.executable, "-c", "import time; print('here'); time.sleep(60)"])
print(viewer.pid)
"""
    command = [sys.executable, "-c", program]
    done = subprocess.run(command, capture_output=True, text=True, timeout=30, check=True)
    os.kill(int(done.stdout), signal.SIGTERM)

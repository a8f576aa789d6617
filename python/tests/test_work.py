"""Long work: progress, interruption, threads and processes."""

from __future__ import annotations

import _thread
import multiprocessing
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import capwalk as cw
import numpy as np
import pytest


def test_progress_is_told(scene: cw.Scene, capsys: pytest.CaptureFixture[str]) -> None:
    told: list[tuple[int, int]] = []
    cw.render(scene, spp=256, progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (256 * 18 * 24, 256 * 18 * 24)
    assert told == sorted(told)
    cw.render(scene, progress=True)
    assert "render" in capsys.readouterr().err


def test_an_exception_of_the_callback_stops(scene: cw.Scene) -> None:
    def stop(done: int, total: int) -> None:
        raise ValueError("enough")

    started = time.monotonic()
    with pytest.raises(ValueError, match="enough"):
        cw.render(scene, spp=10**7, progress=stop)
    assert time.monotonic() - started < 5


def test_interruption(scene: cw.Scene) -> None:
    """Ctrl-C while a long image is rendered."""
    sent = []

    def interrupt() -> None:
        sent.append(time.monotonic())
        _thread.interrupt_main()

    timer = threading.Timer(0.3, interrupt)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        cw.render(scene, spp=10**7)
    # 0.2 s on an idle machine.
    assert time.monotonic() - sent[0] < 2


def test_the_interpreter_goes_on(scene: cw.Scene) -> None:
    """Another thread of Python counts while an image is rendered."""
    counted = 0
    done = threading.Event()

    def count() -> None:
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    cw.render(scene, spp=1500)
    done.set()
    counter.join()
    assert counted > 10


def test_several_threads_render_at_once(scene: cw.Scene) -> None:
    alone = [cw.render(scene, seed=seed).value for seed in range(4)]
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda seed: cw.render(scene, seed=seed).value, range(4)))
    assert all(np.array_equal(a, b) for a, b in zip(alone, together))


def test_a_scene_is_not_changed_while_it_is_rendered(scene: cw.Scene) -> None:
    stop = threading.Event()
    running = threading.Event()

    def watch(done: int, total: int) -> None:
        running.set()
        if stop.is_set():
            raise StopIteration

    def render() -> None:
        with pytest.raises(StopIteration):
            # On a thread of its own, which leaves those of the process to the others.
            cw.render(scene, spp=10**7, threads=1, progress=watch)

    worker = threading.Thread(target=render, daemon=True)
    worker.start()
    assert running.wait(10)
    params = cw.traverse(scene)
    params["floor.bsdf.reflectance.value"] = [0.1, 0.1, 0.1]
    with pytest.raises(cw.BusyError, match="rendered: by another thread"):
        params.update()
    # A copy can be changed meanwhile.
    cw.traverse(scene.copy()).update({"floor.bsdf.reflectance.value": [0.1, 0.1, 0.1]})
    stop.set()
    worker.join(20)
    assert not worker.is_alive()


def _child(scene: cw.Scene, seed: int, answers: multiprocessing.SimpleQueue) -> None:  # type: ignore[type-arg]
    answers.put(cw.render(scene, seed=seed).value)


@pytest.mark.skipif(
    "fork" not in multiprocessing.get_all_start_methods(), reason="the system has no fork"
)
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_forked_child_renders(scene: cw.Scene) -> None:
    expected = cw.render(scene, seed=3).value
    context = multiprocessing.get_context("fork")
    answers = context.SimpleQueue()
    child = context.Process(target=_child, args=(scene, 3, answers))
    child.start()
    assert np.array_equal(answers.get(), expected)
    child.join(20)
    assert child.exitcode == 0

"""Work in parts by executors: the bits of the whole, whoever does it."""

from __future__ import annotations

import _thread
import multiprocessing
import os
import pickle
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import capwalk as cw
import capwalk.parallel
import numpy as np
import pytest
from capwalk import _capwalk, _parts
from capwalk._options import checked
from capwalk.parallel import Pool, Workers, view_seed
from conftest import SCENE

NAMES = ["leaf.positions", "lamp.emitter.radiance.value"]
LEFT = """<sensor type="perspective" id="left">
<transform name="to_world"><lookat origin="-3, 3, 6" target="0, 0.5, 0" up="0, 1, 0"/></transform>
<film type="hdrfilm"><integer name="width" value="12"/><integer name="height" value="8"/></film>
<sampler type="independent"><integer name="sample_count" value="4"/></sampler></sensor></scene>"""

forks = pytest.mark.skipif(
    "fork" not in multiprocessing.get_all_start_methods(), reason="the system has no fork"
)
pytestmark = pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")


@pytest.fixture
def leaf() -> cw.Scene:
    scene = cw.load_file("leaf")
    scene.resize(16, 12)
    return scene


@pytest.fixture(scope="module")
def processes() -> Iterator[Executor]:
    """Two processes, as all systems have them."""
    with ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as executor:
        yield executor


def everything(with_what: Any, scene: cw.Scene, spp: int = 5) -> list[np.ndarray[Any, Any]]:
    """An image, a derivative and gradients, by the functions of capwalk or by workers."""
    width, height = scene.size
    adjoint = np.linspace(-1, 2, 3 * width * height).reshape(height, width, 3)
    image = with_what.render(scene, spp=spp, seed=3)
    derivative = with_what.gradient(scene, "leaf.translate.x - leaf.rotate.y", spp=spp)
    gradients = with_what.backward(scene, adjoint, NAMES, spp=spp)
    arrays = [image.value, image.stderr, derivative.gradient, derivative.stderr, derivative.value]
    arrays += [gradients[name] for name in NAMES] + [gradients.stderr[name] for name in NAMES]
    return arrays


def are_same(some: Sequence[Any], others: Sequence[Any]) -> bool:
    pairs = zip(some, others, strict=True)
    return all(np.array_equal(a, b, equal_nan=True) for a, b in pairs)


@pytest.mark.parametrize("workers", [1, 2, 3])
@pytest.mark.parametrize("parts", [1, 5, 16, 64])
def test_threads_have_the_bits_of_the_whole(leaf: cw.Scene, workers: int, parts: int) -> None:
    with ThreadPoolExecutor(workers) as executor:
        pool = Pool(executor, parts=parts)
        assert are_same(everything(pool, leaf), everything(cw, leaf))


@pytest.mark.parametrize(
    ("workers", "parts", "method"),
    [
        (1, 5, "spawn"),
        pytest.param(2, 16, "fork", marks=forks),
        pytest.param(3, 7, "forkserver", marks=forks),
    ],
)
def test_processes_have_the_bits_of_the_whole(
    leaf: cw.Scene, workers: int, parts: int, method: str
) -> None:
    with ProcessPoolExecutor(workers, multiprocessing.get_context(method)) as executor:
        assert are_same(everything(Pool(executor, parts=parts), leaf), everything(cw, leaf))


def test_methods_are_chosen_alike(leaf: cw.Scene, processes: Executor) -> None:
    derivative = Pool(processes).gradient(leaf, {"leaf.positions": np.ones((3, 3))}, spp=6)
    alone = cw.gradient(leaf, {"leaf.positions": np.ones((3, 3))}, spp=6)
    assert derivative.method == alone.method
    assert derivative.statistics == alone.statistics
    assert np.array_equal(derivative.gradient, alone.gradient)


def test_changes_are_sent(leaf: cw.Scene, processes: Executor) -> None:
    """Of shapes, colours, sensors and sizes, back and forth."""
    pool = Pool(processes, parts=5)
    before = cw.render(leaf, spp=2).value
    first = leaf._values("leaf.positions")
    turned = leaf._values("leaf.to_world") @ np.diag([1.5, 0.5, 1, 1])
    changes: list[Callable[[], None]] = [
        lambda: leaf._update({"leaf.positions": first + 0.1}),
        lambda: leaf._update({"floor.bsdf.reflectance.value": np.array([0.1, 0.2, 0.7])}),
        lambda: leaf._update({"leaf.to_world": turned}),
        lambda: leaf._update({"sensor.translate": np.array([0.1, 0.0, 0.0])}),
        lambda: leaf.resize(8, 9),
        lambda: leaf.resize(16, 12),
        lambda: leaf._update({"leaf.positions": first}),
    ]
    for change in changes:
        change()
        now = cw.render(leaf, spp=2).value
        assert not np.array_equal(now, before)
        assert np.array_equal(pool.render(leaf, spp=2).value, now)
        before = now
    assert are_same(everything(pool, leaf), everything(cw, leaf))


def test_scenes_in_turn(leaf: cw.Scene, processes: Executor) -> None:
    """More of them than a worker keeps, each with changes of its own."""
    pool = Pool(processes, parts=4)
    scenes = [leaf.copy() for _ in range(_parts.SCENES + 2)]
    for turn in range(2):
        for number, scene in enumerate(scenes):
            colour = np.array([0.1 * number, 0.3 * turn, 0.5])
            scene._update({"floor.bsdf.reflectance.value": colour})
            image = pool.render(scene, spp=2)
            assert np.array_equal(image.value, cw.render(scene, spp=2).value)


@forks
def test_scenes_are_sent_once(
    leaf: cw.Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    read = capwalk.parallel._File._read

    def counted(file: capwalk.parallel._File) -> bytes:
        content = read(file)
        with (tmp_path / "read").open("a") as log:
            log.write(f"{os.getpid()} {file.key} {len(content)}\n")
        return content

    monkeypatch.setattr(capwalk.parallel._File, "_read", counted)
    with ProcessPoolExecutor(2, multiprocessing.get_context("fork")) as executor:
        pool = Pool(executor)
        for step in range(3):
            leaf._update({"leaf.positions": leaf._values("leaf.positions") + 0.1})
            pool.backward(leaf, np.ones((12, 16, 3)), NAMES, spp=2)
    lines = [line.split() for line in (tmp_path / "read").read_text().splitlines()]
    # By each process: the scene, two changes, and what is asked for three times.
    assert len(lines) <= 2 * 6
    assert len({tuple(line) for line in lines}) == len(lines)
    sizes = sorted({int(size) for _, _, size in lines})
    assert sizes[0] < len(pickle.dumps(leaf)) < sizes[-1]


def test_changes_are_small(leaf: cw.Scene) -> None:
    sizes: list[int] = []

    def put(content: object) -> Any:
        sizes.append(len(pickle.dumps(content)))
        return capwalk.parallel._put(content)

    scene = cw.load_file("ball")
    sender = _parts.Sender(put)
    for red in (0.1, 0.2, 0.3):
        scene._update({"floor.bsdf.reflectance.value": np.array([red, 0.5, 0.5])})
        how = checked(scene, {"spp": 1, "seed": 0})
        sender.sent(_parts.Job(scene, None, how, scene.revision))
    # The scene and what is asked for, then a number and the checksum.
    assert sizes[0] > 10**6
    assert max(sizes[1:]) < 2000


def _have_no_files() -> None:
    def missing(file: capwalk.parallel._File) -> bytes:
        raise capwalk.parallel._MissingError(file.key)

    setattr(capwalk.parallel._File, "_read", missing)


def test_other_machines_have_no_files(leaf: cw.Scene) -> None:
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(2, context, initializer=_have_no_files) as executor:
        pool = Pool(executor)
        for _ in range(2):
            assert are_same(everything(pool, leaf), everything(cw, leaf))
            leaf._update({"leaf.positions": leaf._values("leaf.positions") + 0.1})


def test_files_are_removed(
    leaf: cw.Scene, processes: Executor, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    pool, scene = Pool(processes), leaf.copy()
    pool.render(scene, spp=1)
    assert len(list(tmp_path.iterdir())) == 1
    scene._update({"leaf.positions": scene._values("leaf.positions") + 0.1})
    pool.render(scene, spp=1)
    assert len(list(tmp_path.iterdir())) == 2
    del scene
    assert not list(tmp_path.iterdir())


def test_progress_is_told(leaf: cw.Scene, processes: Executor) -> None:
    for executor in (processes, ThreadPoolExecutor(2)):
        told: list[tuple[int, int]] = []
        Pool(executor, parts=5).render(leaf, spp=5, progress=lambda *now: told.append(now))
        samples = 5 * 16 * 12
        assert told == [(samples * (i + 1) // 5, samples) for i in range(5)]


def _enough(done: int, total: int) -> None:
    raise ValueError("enough")


def test_an_exception_of_the_callback_stops(leaf: cw.Scene, processes: Executor) -> None:
    for executor in (processes, ThreadPoolExecutor(2)):
        pool = Pool(executor)
        with pytest.raises(ValueError, match="enough"):
            pool.render(leaf, spp=16, progress=_enough)
        # The executor goes on.
        assert np.array_equal(pool.render(leaf, spp=2), cw.render(leaf, spp=2))


def test_interruption(leaf: cw.Scene) -> None:
    """Ctrl-C while threads work, also on what they have begun."""
    with ThreadPoolExecutor(2) as executor:
        with pytest.raises(KeyboardInterrupt):
            threading.Timer(0.3, _thread.interrupt_main).start()
            Pool(executor, parts=2).render(leaf, spp=10**5)
        started = time.monotonic()
    # It would take minutes.
    assert time.monotonic() - started < 20


def _refuse(*arguments: object) -> bytes:
    raise cw.Refused("a. b", "a", "b")


def _refuse_parts() -> None:
    setattr(_capwalk, "part", _refuse)


def test_exceptions_come_through(leaf: cw.Scene, processes: Executor) -> None:
    pool = Pool(processes)
    with pytest.raises(cw.ParameterError, match="did you mean"):
        pool.gradient(leaf, "leaf.tranlate.x")
    with pytest.raises(cw.ArgumentError, match="spp is 0"):
        pool.render(leaf, spp=0)
    with pytest.raises(cw.ArgumentError, match="expected 16 x 12"):
        pool.backward(leaf, np.ones((3, 3, 3)), NAMES)
    with pytest.raises(cw.ArgumentError, match="parts is 65; expected 1 to 64"):
        Pool(processes, parts=65)
    # What is found by a worker.
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(1, context, initializer=_refuse_parts) as executor:
        with pytest.raises(cw.Refused) as caught:
            Pool(executor).render(leaf, spp=2)
    assert (caught.value.reason, caught.value.instead) == ("a", "b")


def _die(*arguments: object) -> bytes:
    os._exit(9)


def _die_of_parts() -> None:
    setattr(_capwalk, "part", _die)


def test_lost_workers_are_reported(leaf: cw.Scene) -> None:
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(1, context, initializer=_die_of_parts) as executor:
        with pytest.raises(cw.WorkerError, match="make another one"):
            Pool(executor).render(leaf, spp=2)


def test_a_scene_is_not_changed_while_it_is_rendered(leaf: cw.Scene, processes: Executor) -> None:
    def change(done: int, total: int) -> None:
        leaf._update({"floor.bsdf.reflectance.value": np.array([0.1, 0.1, 0.1])})

    with pytest.raises(cw.BusyError, match="change a copy"):
        Pool(processes).render(leaf, spp=4, progress=change)
    assert np.array_equal(Pool(processes).render(leaf, spp=4), cw.render(leaf, spp=4))


def views_are_right(workers: Workers, spp: int = 3) -> None:
    """Several sensors at once give what each of them gives alone."""
    scene = cw.load_string(SCENE.replace("</scene>", LEFT))
    images = workers.render_views(scene, spp=spp, seed=4)
    for view, image in enumerate(images):
        alone = cw.render(scene, sensor=view, spp=spp, seed=view_seed(4, view))
        assert np.array_equal(image.value, alone.value)
    assert not are_same(workers.render_views(scene, [1, 1], spp=spp), [images[1]] * 2)

    adjoints = [image.value - 0.5 for image in images]
    box, left = "box.positions", "left.to_world"
    total = workers.backward_views(scene, adjoints, [box, left], spp=spp, seed=5, method="walk")
    how: dict[str, Any] = {"spp": spp, "method": "walk"}
    first = cw.backward(scene, adjoints[0], [box], seed=5, **how)
    second = cw.backward(scene, adjoints[1], [box, left], sensor=1, seed=view_seed(5, 1), **how)
    assert list(total) == [box, left]
    assert np.array_equal(total[box], first[box] + second[box])
    assert np.array_equal(total.stderr[box], np.hypot(first.stderr[box], second.stderr[box]))
    assert np.array_equal(total[left], second[left])
    assert total.statistics["samples"] == spp * (24 * 18 + 12 * 8)

    for_left = workers.backward_views(scene, adjoints, [left], spp=spp, seed=5, method="walk")
    assert np.array_equal(for_left[left], total[left])
    assert for_left.statistics["samples"] == spp * 12 * 8
    names = [box, left, "left.translate.x"]
    other = workers.backward_views(scene, adjoints[:1], names, sensors=[0], spp=spp)
    assert not other[left].any() and other[left].shape == total[left].shape
    assert other["left.translate.x"] == 0 and other[box].any()
    with pytest.raises(cw.ParameterError, match="did you mean"):
        workers.backward_views(scene, adjoints[:1], [box, "left.to_wrld"], sensors=[0], spp=spp)
    with pytest.raises(cw.ParameterError, match="is of another sensor"):
        workers.backward_views(scene, adjoints, ["left.translate.x + box.scale"], spp=spp)
    again = workers.backward_views(
        scene, adjoints, (name for name in [box, left]), spp=spp, seed=5, method="walk"  # type: ignore[arg-type]
    )
    assert np.array_equal(again[box], total[box])
    with pytest.raises(cw.ArgumentError, match="none of these images"):
        workers.backward_views(scene, adjoints[:1], [left], sensors=[0], spp=spp)
    with pytest.raises(cw.ParameterError, match="is of another sensor"):
        cw.backward(scene, adjoints[0], [left], spp=spp)

    everything = workers.backward_views(scene, adjoints, spp=spp, method="walk")
    assert {"sensor_0.to_world", "left.to_world", "box.positions"} <= set(everything)
    with pytest.raises(cw.ArgumentError, match="there are 1 adjoints for 2 sensors"):
        workers.backward_views(scene, adjoints[:1])
    with pytest.raises(cw.ArgumentError, match='no sensor "right"'):
        workers.render_views(scene, ["right"])


def test_views(processes: Executor) -> None:
    views_are_right(Pool(processes, parts=3))

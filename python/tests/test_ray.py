"""Work by a Ray cluster of three nodes on this machine, some of which are lost."""

from __future__ import annotations

import _thread
import os
import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import capwalk as cw
import numpy as np
import pytest
from test_parallel import are_same, everything, views_are_right

ray: Any = pytest.importorskip("ray")
ray_nodes: Any = pytest.importorskip("ray.cluster_utils")

if not Path("/proc/self/stat").exists():
    pytest.skip("processes are found in /proc", allow_module_level=True)

from capwalk.ray import Cluster  # noqa: E402

STORE = 80 * 2**20
NAMES = ["leaf.positions", "floor.bsdf.reflectance.value"]


@pytest.fixture(scope="module")
def nodes() -> Iterator[Any]:
    """Three nodes of one core."""
    head = {"num_cpus": 1, "object_store_memory": STORE, "include_dashboard": False}
    nodes = ray_nodes.Cluster(initialize_head=True, head_node_args=head)
    for _ in range(2):
        nodes.add_node(wait=False, num_cpus=1, object_store_memory=STORE)
    nodes.wait_for_nodes()
    ray.init(address=nodes.address, log_to_driver=False)
    yield nodes
    ray.shutdown()
    nodes.shutdown()


@pytest.fixture
def leaf() -> cw.Scene:
    scene = cw.load_file("leaf")
    scene.resize(16, 12)
    return scene


def gradients(with_what: Any, scene: cw.Scene, **how: Any) -> list[Any]:
    """What takes some seconds: it is to be interrupted in its middle."""
    found = with_what.backward(scene, np.ones((12, 16, 3)), NAMES, spp=256, method="walk", **how)
    return [found[name] for name in NAMES] + [found.stderr[name] for name in NAMES]


def busy() -> list[int]:
    """Ray's processes which work on parts, of those that this test has started."""
    parents: dict[int, int] = {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            parents[int(stat.parent.name)] = int(stat.read_text().rpartition(")")[2].split()[1])
    ours = {os.getpid()}
    while more := {child for child, parent in parents.items() if parent in ours} - ours:
        ours |= more
    return [pid for pid in ours if name(pid).startswith(b"ray::capwalk")]


def name(pid: int) -> bytes:
    try:
        return Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:
        return b""


def once(share: float, what: Callable[[], object]) -> tuple[Callable[[int, int], None], list[int]]:
    """A progress callback that does something in the middle of the work, and when it did."""
    when: list[int] = []

    def told(done: int, total: int) -> None:
        if not when and done >= share * total:
            when.append(done)
            what()

    return told, when


def kill() -> None:
    started = time.monotonic()
    while not (found := busy()):
        assert time.monotonic() - started < 60, "no worker has anything to do"
        time.sleep(0.01)
    os.kill(found[0], signal.SIGKILL)


@pytest.mark.parametrize("workers", [1, 2, 3])
def test_workers_have_the_bits_of_the_whole(nodes: Any, leaf: cw.Scene, workers: int) -> None:
    with Cluster(workers) as cluster:
        assert are_same(everything(cluster, leaf), everything(cw, leaf))
        leaf._update({"leaf.positions": leaf._values("leaf.positions") + 0.1})
        leaf._update({"floor.bsdf.reflectance.value": np.array([0.9, 0.1, 0.4])})
        assert are_same(everything(cluster, leaf), everything(cw, leaf))
    assert ray.is_initialized()
    with pytest.raises(cw.Error, match="was closed"):
        cluster.render(leaf)


def test_views(nodes: Any) -> None:
    with Cluster() as cluster:
        views_are_right(cluster)


def test_a_lost_worker(nodes: Any, leaf: cw.Scene) -> None:
    """One that is killed in the middle, when the scene is not any more what was sent first."""
    with Cluster(2) as cluster:
        cluster.render(leaf, spp=1)
        leaf._update({"leaf.positions": leaf._values("leaf.positions") + 0.1})
        told, when = once(0.25, kill)
        assert are_same(gradients(cluster, leaf, progress=told), gradients(cw, leaf))
        assert when
        # The one in its place goes on.
        leaf._update({"leaf.positions": leaf._values("leaf.positions") - 0.05})
        assert are_same(gradients(cluster, leaf), gradients(cw, leaf))


def test_workers_that_are_lost_again_and_again(nodes: Any, leaf: cw.Scene) -> None:
    with Cluster(1, retries=0) as cluster:
        told, when = once(0.1, kill)
        with pytest.raises(cw.WorkerError, match="workers were lost"):
            gradients(cluster, leaf, progress=told)
        assert are_same(gradients(cluster, leaf), gradients(cw, leaf))


def test_interruption(nodes: Any, leaf: cw.Scene) -> None:
    """Ctrl-C stops the workers, too."""
    with Cluster(2, parts=2) as cluster:
        cluster.render(leaf, spp=1)
        threading.Timer(1, _thread.interrupt_main).start()
        with pytest.raises(KeyboardInterrupt):
            cluster.render(leaf, spp=10**5)
        started = time.monotonic()
        while busy():
            # Machines may be slow; without cancelling it takes minutes.
            assert time.monotonic() - started < 60
            time.sleep(0.1)
        assert np.array_equal(cluster.render(leaf, spp=2), cw.render(leaf, spp=2))


def test_exceptions_come_through(nodes: Any, leaf: cw.Scene) -> None:
    with Cluster(1) as cluster:
        with pytest.raises(cw.ParameterError, match="did you mean"):
            cluster.gradient(leaf, "leaf.tranlate.x")
        with pytest.raises(cw.ArgumentError, match="is connected already"):
            Cluster(address="auto")
        # What is found by a worker.
        def refuse(*arguments: object) -> bytes:
            raise cw.Refused("a. b", "a", "b")

        cluster._part = ray.remote(refuse)
        with pytest.raises(cw.Refused) as caught:
            cluster.render(leaf, spp=2)
    assert (caught.value.reason, caught.value.instead) == ("a", "b")


def test_a_lost_machine(nodes: Any, leaf: cw.Scene) -> None:
    """The last one here: a node less."""
    lost = nodes.add_node(num_cpus=2, object_store_memory=STORE)
    with Cluster() as cluster:
        cluster.render(leaf, spp=1)
        leaf._update({"leaf.positions": leaf._values("leaf.positions") + 0.1})
        told, when = once(0.4, lambda: nodes.remove_node(lost, allow_graceful=False))
        assert are_same(gradients(cluster, leaf, progress=told), gradients(cw, leaf))
        assert when

"""What workers cost: one gradient by two threads of this process, by two processes and by two
workers of Ray, of one thread each, in turn. Prints seconds for each round, and medians as ratios
to that of the threads. All have the same bits."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import capwalk as cw
import numpy as np
from capwalk.parallel import Pool
from capwalk.ray import Cluster

ROUNDS = 3
SECONDS = 20
NAMES = ["ball.positions", "lamp.emitter.radiance.value"]


def seconds(work: Callable[[], cw.Gradients]) -> tuple[float, cw.Gradients]:
    started = time.perf_counter()
    gradients = work()
    return time.perf_counter() - started, gradients


def main() -> None:
    scene = cw.load_file("ball")
    scene.resize(128, 96)
    adjoint = np.ones((96, 128, 3))
    method = cw.backward(scene, adjoint, NAMES, spp=8, threads=2).method
    short, _ = seconds(lambda: cw.backward(scene, adjoint, NAMES, spp=64, threads=2, method=method))
    spp = round(64 * SECONDS / short)
    with ProcessPoolExecutor(2, get_context("spawn")) as executor, Cluster(2) as cluster:
        pool = Pool(executor)
        ways: dict[str, Callable[[int], cw.Gradients]] = {
            "two threads": lambda spp: cw.backward(
                scene, adjoint, NAMES, spp=spp, threads=2, method=method
            ),
            "two processes": lambda spp: pool.backward(
                scene, adjoint, NAMES, spp=spp, method=method
            ),
            "two workers of Ray": lambda spp: cluster.backward(
                scene, adjoint, NAMES, spp=spp, method=method
            ),
        }
        for work in ways.values():
            work(4)  # Processes start, and the scene is sent.
        times: dict[str, list[float]] = {way: [] for way in ways}
        for _ in range(ROUNDS):
            found = {}
            for way, work in ways.items():
                taken, found[way] = seconds(lambda: work(spp))
                times[way].append(taken)
            first, *others = found.values()
            assert all(np.array_equal(first[name], other[name]) for other in others for name in NAMES)
    whole = statistics.median(times["two threads"])
    for way, taken in times.items():
        rounds = " ".join(f"{t:6.2f}" for t in taken)
        print(f"{way:20}{rounds} s   {statistics.median(taken) / whole:.3f}")


if __name__ == "__main__":
    main()

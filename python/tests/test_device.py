"""Images on a GPU, or on software Vulkan. Without either, most of this is skipped;
``CAPWALK_GPU_TESTS=require`` has it fail instead."""

from __future__ import annotations

import _thread
import multiprocessing
import os
import subprocess
import sys
import threading
import time
import warnings
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import capwalk as cw
import numpy as np
import pytest
from conftest import SCENE

GLASS = SCENE.replace(
    '<bsdf type="diffuse"><rgb name="reflectance" value="0.2, 0.5, 0.8"/></bsdf>',
    '<bsdf type="dielectric"/>',
)

WITHOUT_DRIVERS = {
    # Files of drivers that are not there, by the loader's names for them, old and new.
    "VK_DRIVER_FILES": "/nonexistent",
    "VK_ICD_FILENAMES": "/nonexistent",
    # NVIDIA's devices, which need no Vulkan.
    "CUDA_VISIBLE_DEVICES": "",
}


NOT_BUILT = "this build of capwalk has no GPU support"


@pytest.fixture(scope="session")
def found() -> str | cw.DeviceError:
    """The name of what there is to run on, or why there is nothing."""
    try:
        image = cw.render(cw.load_file("leaf"), spp=1, device="gpu")
    except cw.DeviceError as error:
        return error
    return image.device


@pytest.fixture
def built(found: str | cw.DeviceError) -> None:
    """Skips what a package without the GPU does otherwise."""
    if NOT_BUILT in str(found):
        pytest.skip(str(found))


@pytest.fixture
def adapter(found: str | cw.DeviceError) -> str:
    """The name of what there is to run on."""
    if isinstance(found, str):
        return found
    if os.environ.get("CAPWALK_GPU_TESTS") == "require":
        raise found
    pytest.skip(str(found))


def test_a_gpu_takes_the_samples_of_the_cpu(
    scene: cw.Scene, adapter: str, tmp_path: Path
) -> None:
    cpu = cw.render(scene, seed=3)
    gpu = cw.render(scene, seed=3, device="gpu")
    assert (cpu.device, gpu.device) == ("cpu", adapter)
    assert gpu.statistics["samples"] == cpu.statistics["samples"] == 16 * 18 * 24
    assert gpu.statistics["complete"] and gpu.value.dtype == np.float64
    # A ray that passes an edge on its other side is a pixel that differs.
    for of_gpu, of_cpu in [(gpu.value, cpu.value), (gpu.stderr, cpu.stderr)]:
        assert np.isclose(of_gpu, of_cpu, rtol=1e-3, atol=1e-4).mean() > 0.99
    assert not np.array_equal(gpu.value, cpu.value)
    # Other seeds are other samples.
    other = cw.render(scene, seed=4, device="gpu")
    assert np.isclose(other.value, cpu.value, rtol=1e-3).mean() < 0.5
    gpu.save(tmp_path / "gpu.exr")
    assert adapter.encode() in (tmp_path / "gpu.exr").read_bytes()


def test_same_bits_again_and_from_any_thread(scene: cw.Scene, adapter: str) -> None:
    once = cw.render(scene, device="gpu", threads=1).value
    with ThreadPoolExecutor(4) as pool:
        again = list(pool.map(lambda _: cw.render(scene, device="gpu").value, range(4)))
    assert all(np.array_equal(once, value) for value in again)


def test_auto_says_why_it_was_the_cpu(scene: cw.Scene, adapter: str) -> None:
    # Where there is software only, the CPU is what is meant: nothing to warn of.
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        image = cw.render(scene, seed=3, device="auto")
        glass = cw.render(cw.load_string(GLASS), spp=1, device="auto")
    assert image.device in ("cpu", adapter)
    assert glass.device == "cpu"
    if image.device == "cpu":
        assert np.array_equal(image.value, cw.render(scene, seed=3).value)
    else:
        assert [warning.category for warning in caught] == [cw.DeviceWarning]
        assert "a dielectric" in str(caught[0].message) and caught[0].filename == __file__


def test_derivatives_by_colours_are_those_of_the_cpu(scene: cw.Scene, adapter: str) -> None:
    name = "floor.bsdf.reflectance.value"
    adjoint = np.random.default_rng(1).random((*cw.render(scene, spp=1).value.shape,))
    images = [cw.gradient(scene, f"1*{name}", seed=3, device=device) for device in ("cpu", "gpu")]
    assert [image.device for image in images] == ["cpu", adapter]
    for cpu, gpu in [[image.gradient for image in images], [image.stderr for image in images]]:
        assert np.isclose(gpu, cpu, rtol=1e-3, atol=1e-4).mean() > 0.99
    found = [
        cw.backward(scene, adjoint, [name], seed=3, device=device) for device in ("cpu", "gpu")
    ]
    assert [gradients.device for gradients in found] == ["cpu", adapter]
    cpu, gpu = (gradients[name] for gradients in found)
    assert np.allclose(gpu, cpu, rtol=1e-3) and not np.array_equal(gpu, cpu)
    # The same samples, backwards and forwards.
    assert np.isclose(gpu.sum(), (adjoint * images[1].gradient).sum(), rtol=1e-4)


def test_derivatives_by_what_moves_agree_with_the_cpu(scene: cw.Scene, adapter: str) -> None:
    cpu, gpu = (
        cw.gradient(scene, "box.translate.x", spp=64, method="edges", device=device)
        for device in ("cpu", "gpu")
    )
    assert (cpu.device, gpu.device) == ("cpu", adapter)
    errors = np.hypot(cpu.stderr, gpu.stderr)
    z = (gpu.gradient - cpu.gradient)[errors > 0] / errors[errors > 0]
    assert len(z) > 0 and abs(z.mean()) * np.sqrt(len(z)) < 5 and z.std() < 1.3
    # In reverse mode, all vertices at once.
    adjoint = np.random.default_rng(1).random((*gpu.gradient.shape,))
    found = cw.backward(scene, adjoint, ["box.positions"], spp=64, method="edges", device="gpu")
    by_pixels = (adjoint * gpu.gradient).sum()
    error = np.sqrt(((adjoint * gpu.stderr) ** 2).sum())
    by_vertices = found["box.positions"][:, 0].sum()
    assert found.device == adapter and abs(by_vertices - by_pixels) < 6 * error
    with pytest.raises(cw.ArgumentError, match="walk"):
        cw.gradient(scene, "box.translate.x", method="walk", device="gpu")


def test_what_a_gpu_does_not_have_is_refused_by_name(scene: cw.Scene, built: None) -> None:
    # Whether there is one or not.
    with pytest.raises(cw.ArgumentError, match='"box" is of the type dielectric: not on the GPU yet') as error:
        cw.render(cw.load_string(GLASS), device="gpu")
    assert isinstance(error.value, ValueError) and 'device="cpu"' in str(error.value)
    with pytest.raises(cw.ArgumentError, match="renders depth, not light: not on the GPU"):
        cw.render(scene, aov="depth", device="gpu")
    with pytest.raises(cw.ArgumentError, match="Sobol"):
        sobol = SCENE.replace('sampler type="independent"', 'sampler type="ldsampler"')
        cw.render(cw.load_string(sobol), device="gpu")


def test_names_of_devices(scene: cw.Scene) -> None:
    with pytest.raises(ValueError, match='no device "cuda"; there are auto, cpu, gpu'):
        cw.render(scene, device="cuda")
    with pytest.raises(TypeError, match="device is 0; expected a name"):
        cw.render(scene, device=0)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match='no device "cuda"'):
        cw.gradient(scene, "box.translate.x", device="cuda")
    with pytest.raises(TypeError, match="device"):
        cw.check(scene, "box.translate.x", device="gpu")  # type: ignore[call-arg]


def test_a_package_without_the_gpu_says_so(scene: cw.Scene, found: str | cw.DeviceError) -> None:
    if NOT_BUILT not in str(found):
        pytest.skip("the package has it")
    with pytest.raises(RuntimeError, match="build it with the feature `gpu`"):
        cw.render(cw.load_string(GLASS), spp=1, device="gpu")
    assert cw.render(scene, device="auto").device == "cpu"


@pytest.mark.skipif(sys.platform != "linux", reason="Metal and DX12 are part of the system")
def test_without_drivers_the_package_works(built: None) -> None:
    script = """
import warnings
import capwalk as cw
warnings.simplefilter("error")
scene = cw.load_file("leaf")
scene.resize(8, 6)
image = cw.render(scene, spp=2, device="auto")
assert image.device == "cpu"
assert (image.value == cw.render(scene, spp=2).value).all()
for attempt in range(2):
    try:
        cw.render(scene, spp=2, device="gpu")
    except cw.DeviceError as error:
        assert isinstance(error, RuntimeError)
        print(error)
"""
    environment = {**os.environ, **WITHOUT_DRIVERS}
    done = subprocess.run(
        [sys.executable, "-c", script], env=environment, capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 0, done.stderr
    first, second = done.stdout.splitlines()
    assert first == second and first.startswith("no GPU: ") and "use the CPU" in first


def test_interruption_and_progress(scene: cw.Scene, adapter: str) -> None:
    told: list[tuple[int, int]] = []
    cw.render(scene, device="gpu", progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (16 * 18 * 24, 16 * 18 * 24)

    def stop(done: int, total: int) -> None:
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        cw.render(scene, spp=10**6, device="gpu", progress=stop)
    sent = []

    def interrupt() -> None:
        sent.append(time.monotonic())
        _thread.interrupt_main()

    threading.Timer(0.3, interrupt).start()
    with pytest.raises(KeyboardInterrupt):
        cw.render(scene, spp=10**6, device="gpu")
    # It is seen after a kernel.
    assert time.monotonic() - sent[0] < 10
    # The device is what it was.
    assert cw.render(scene, device="gpu").device == adapter


def _child(scene: cw.Scene, answers: multiprocessing.SimpleQueue) -> None:  # type: ignore[type-arg]
    answers.put(cw.render(scene, device="gpu").value)


@pytest.mark.skipif(
    "fork" not in multiprocessing.get_all_start_methods(), reason="the system has no fork"
)
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_forked_child_opens_its_own(scene: cw.Scene, adapter: str) -> None:
    if "llvmpipe" not in adapter:
        pytest.skip("drivers of GPUs do not work in what was forked after they were used")
    expected = cw.render(scene, device="gpu").value
    context = multiprocessing.get_context("fork")
    answers = context.SimpleQueue()
    child = context.Process(target=_child, args=(scene, answers))
    child.start()
    child.join(120)
    assert child.exitcode == 0
    assert np.array_equal(answers.get(), expected)

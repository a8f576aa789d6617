"""Samples per second of Mitsuba 3 in images, derivative images and gradients, as a table.

usage: gpu_peer.py VARIANT [SCENE.xml PARAMETER ...]

The variant is cuda_ad_rgb, or llvm_ad_rgb to try this without a GPU. Without scenes
it only says whether that runs here. A parameter is SHAPE.translate.AXIS. Scene files
are changed as in peers.py, so they should be copies.

Tasks, sizes and the loss are those of crates/gpu-render/examples/image_table.rs, so
that rows can be read beside its rows. Everything is counted in seconds of the clock,
with the result's way to the CPU, after a run that compiles; the fastest of some
runs counts, and their spread is the error. Guiding structures are built before, once,
as if they were amortised. A sample of `direct_projective` and `prb_projective` is one
of each of their three kinds.
"""

import math
import pathlib
import sys
import time
import xml.etree.ElementTree as xml

try:
    import drjit as dr
    import mitsuba as mi
    import numpy as np

    import peers
except ImportError as error:
    sys.exit(f"Mitsuba cannot be imported ({error}); install it with `pip install mitsuba numpy`")

GUIDINGS = ["none", "octree"]
# What the names of colours have in them, and how they end.
COLOURS = {"reflectance", "diffuse_reflectance"}
NUMBERS = ("value", "data")

# Samples of a pixel at least, and of an image at most, for which memory is needed.
FEWEST = 16
MOST = 2**24
# Seconds that a run takes at least.
LEAST = 0.25
# Runs whose spread is the error.
ROUNDS = 12


def use(variant):
    """Chooses a variant, or says why it cannot be."""
    if variant not in mi.variants():
        sys.exit(f"this Mitsuba has no {variant}, but {', '.join(mi.variants())}")
    try:
        mi.set_variant(variant)
        dr.eval(dr.arange(mi.Float, 2))
        dr.sync_thread()
    except (ImportError, RuntimeError) as error:
        sys.exit(f"{variant} does not run here: {error}")
    mi.set_log_level(mi.LogLevel.Error)


class Image:
    """The image, by the integrator of the file."""

    def __init__(self, file, weights):
        self.scene = mi.load_file(str(file))
        self.weights = weights

    def run(self, spp, seed):
        work = lambda: mi.render(self.scene, spp=spp, seed=seed)
        seconds, image = peers.timed(work, time.perf_counter)
        return seconds, (image * self.weights).sum()


class Colours:
    """The gradient of the loss with respect to all colours, by path replay."""

    def __init__(self, file, weights, depth):
        self.scene = mi.load_file(str(file))
        self.params = mi.traverse(self.scene)
        words = {key: key.split(".") for key in self.params.keys()}
        keys = [key for key, word in words.items() if word[-1] in NUMBERS and COLOURS & {*word}]
        self.start = {key: type(self.params[key])(self.params[key]) for key in keys}
        self.integrator = mi.load_dict({"type": "prb", "max_depth": depth})
        self.weights = weights

    def run(self, spp, seed):
        for key, start in self.start.items():
            colour = type(start)(start)
            dr.enable_grad(colour)
            self.params[key] = colour
        self.params.update()
        colours = [self.params[key] for key in self.start]
        weights = mi.TensorXf(self.weights)
        dr.eval(colours, weights)
        dr.sync_thread()

        def work():
            sensor = self.scene.sensors()[0]
            arguments = (self.scene, self.params, weights, sensor, mi.UInt32(seed), spp)
            self.integrator.render_backward(*arguments)
            return sum(np.array(dr.grad(colour), dtype=np.float64).sum() for colour in colours)

        return peers.timed(work, time.perf_counter)


def fastest(run, pixels):
    """Million samples per second, the mean of what runs give, its standard error, and
    that after a second."""
    spp = FEWEST
    run(spp, 0)
    while run(spp, 0)[0] < LEAST and 2 * spp * pixels <= MOST:
        spp *= 2
    runs = [run(spp, 1 + seed) for seed in range(ROUNDS)]
    seconds = min(time for time, _ in runs)
    losses = [float(loss) for _, loss in runs]
    spread = float(np.std(losses, ddof=1))
    rate = spp * pixels / seconds * 1e-6
    return rate, np.mean(losses), spread / math.sqrt(ROUNDS), spread * math.sqrt(seconds)


def tasks(file, shape, axis, variant):
    """Each task with its method and its function of samples and seed; and the pixels."""
    root = xml.parse(file).getroot()
    film = root.find("sensor/film")
    height, width = (
        int(film.find(f"integer[@name='{side}']").get("value")) for side in ("height", "width")
    )
    weights = peers.smooth_weights(height, width) / (3 * height * width)
    plan = {"file": str(file), "shape": shape}
    derivatives = peers.Derivatives(plan, variant, time.perf_counter)
    moves = "xyz".index(axis)
    velocities = peers.poses(derivatives.vertices)[moves]
    name = derivatives.integrator["type"]

    def forward(integrator, spp, seed):
        seconds, image = derivatives.forward(integrator, velocities, spp, seed)
        return seconds, (image * weights).sum()

    def reverse(integrator, spp, seed):
        seconds, gradient = derivatives.reverse(integrator, weights, spp, seed)
        return seconds, gradient[moves]

    yield "image", root.find("integrator").get("type"), Image(file, weights).run, width * height
    for task, function in [("derivative image", forward), ("gradient, all vertices", reverse)]:
        for guiding in GUIDINGS:
            integrator, _ = derivatives.guided(guiding, peers.Budget(quick=False))
            run = lambda spp, seed, f=function, i=integrator: f(i, spp, seed)
            yield task, f"{name}, {guiding}", run, width * height
    # Light that is reflected once is what `direct` has.
    depth = derivatives.integrator.get("max_depth", 2)
    yield "gradient, all colours", "prb", Colours(file, weights, depth).run, width * height


def main():
    variant, *scenes = sys.argv[1:] or sys.exit(__doc__)
    use(variant)
    if not scenes:
        return
    print(f"Mitsuba {mi.__version__}, {variant}")
    if not variant.startswith("cuda"):
        print("This is the CPU: no figure is from a GPU")
    print(
        "\n| scene | task | method | million samples per second | loss, or its derivative | "
        "its error after a second |\n|---|---|---|---|---|---|"
    )
    for file, parameter in zip(map(pathlib.Path, scenes[::2]), scenes[1::2], strict=True):
        shape, _, axis = parameter.split(".")
        peers.prepare(file, shape)
        for task, method, run, pixels in tasks(file, shape, axis, variant):
            try:
                rate, loss, error, after = fastest(run, pixels)
                found = f"{rate:.4f} | {loss:.4e} ± {error:.1e} | {after:.1e}"
            except RuntimeError as problem:
                found = f"left out: {problem}"
            print(f"| {file.stem} | {task} | {method} | {found} |", flush=True)


if __name__ == "__main__":
    main()

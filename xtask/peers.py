"""Measures Mitsuba 3 and capwalk on one scene, in turn, with one thread each.

usage: peers.py PLAN.json RESULT.json

The plan is written by peers.rs. Everything is counted in seconds of the CPU
(user and system). A contestant is one program with one method and one number of
samples; all of them run in turn in each of several rounds, each run with another
seed. Times are minima, errors are means over all runs.

* capwalk runs as a child process. What does not depend on samples (start, reading,
  trees) is found from a run with few samples, taken off, and reported apart.
* Mitsuba runs in this process, `llvm_ad_rgb` after a run to warm up, so that
  kernels are compiled. Loading, this first run and building the guiding structure
  are reported apart, although Mitsuba builds the structure anew for every
  derivative: here it is built once and kept, as if it were amortised. Forward and
  reverse mode are called directly, without the image that `mi.render` adds.
"""

import json
import math
import os
import pathlib
import sys
import time
import xml.etree.ElementTree as xml

import drjit as dr
import mitsuba as mi
import numpy as np

from peer_contestants import Capwalk, Mitsuba, in_turn, timed
from peer_scenes import integrator_of, prepare

VARIANT = "llvm_ad_rgb"
GUIDINGS = ["none", "grid", "octree"]
# Seeds: a run has its own number; the reference shares none of them.
REFERENCE_SEED = 1_000_003


class Budget:
    """How much is measured."""

    def __init__(self, quick):
        self.rounds = 1 if quick else 3
        # Runs per round of an image, of a derivative image, of a vector of few numbers.
        self.render_runs = 2 if quick else 4
        self.image_runs = 2
        self.vector_runs = 2 if quick else 15
        # Seconds that a run of capwalk takes at least.
        self.image_seconds = 0.1 if quick else 0.6
        self.vector_seconds = 0.1 if quick else 0.3
        # The reference has so many times the samples of its method's own runs.
        self.reference = 4 if quick else 16
        # Samples of a whole image, of each of Mitsuba's budgets.
        self.forward = [2**14] if quick else [2**16, 2**18, 2**19]
        self.reverse = [2**14] if quick else [2**16, 2**18]
        self.texels = [2**14] if quick else [2**16, 2**18, 2**20]
        self.image = [2**16] if quick else [2**18, 2**20]
        # Mitsuba's own defaults, and less.
        self.guiding_spp = 16 if quick else 512
        self.guiding_grid = [100, 100, 100] if quick else [10000, 100, 100]


def log(text):
    print(f"    {text}", file=sys.stderr, flush=True)


# Mitsuba's derivatives.


def load(file):
    """A scene. With one thread alone Mitsuba would wait forever for the one that reads textures."""
    dr.set_thread_count(2)
    scene = mi.load_file(file)
    dr.set_thread_count(1)
    return scene


class Derivatives:
    """Derivatives of a scene in Mitsuba when the vertices of one shape move."""

    def __init__(self, plan, variant=VARIANT, clock=time.process_time):
        self.variant, self.clock = variant, clock
        mi.set_variant(variant)
        start = clock()
        self.scene = mi.load_file(plan["file"])
        self.params = mi.traverse(self.scene)
        self.loading = clock() - start
        self.sensor = self.scene.sensors()[0]
        self.key = plan["shape"] + ".vertex_positions"
        if self.key not in self.params:
            sys.exit(f"{plan['file']}: Mitsuba has no \"{self.key}\"; choose a shape that is a mesh")
        self.vertices = np.array(self.params[self.key], dtype=np.float64).reshape(-1, 3)
        self.start = mi.Float(self.vertices.ravel())
        self.integrator = integrator_of(plan["file"])

    def guided(self, guiding, budget):
        """The integrator with its guiding structure, built here and kept."""
        mi.set_variant(self.variant)
        integrator = mi.load_dict({**self.integrator, "guiding": guiding})
        integrator.proj_seed_spp = budget.guiding_spp
        integrator.guiding_grid_reso = budget.guiding_grid
        self.attach_vertices()
        start = self.clock()
        integrator.proj_detail.init_indirect_silhouette(self.scene, self.sensor, mi.UInt32(77))
        dr.eval()
        dr.sync_thread()
        seconds = self.clock() - start
        integrator.proj_detail.init_indirect_silhouette = lambda *_: None
        return integrator, seconds

    def attach_vertices(self):
        vertices = mi.Float(self.start)
        dr.enable_grad(vertices)
        self.params[self.key] = vertices
        self.params.update()
        return vertices

    def forward(self, integrator, velocities, spp, seed):
        """The derivative of the image."""
        mi.set_variant(self.variant)
        amount = mi.Float(0.0)
        dr.enable_grad(amount)
        self.params[self.key] = self.start + amount * mi.Float(velocities.ravel())
        self.params.update()
        dr.forward(amount, dr.ADFlag.ClearEdges)
        dr.eval(self.params[self.key])
        dr.sync_thread()
        arguments = (self.scene, self.params, self.sensor, mi.UInt32(seed), spp)
        return timed(lambda: dr.detach(integrator.render_forward(*arguments)), self.clock)

    def reverse(self, integrator, weights, spp, seed):
        """The gradient of a loss: of the pose, then of all vertices."""
        mi.set_variant(self.variant)
        vertices = self.attach_vertices()
        weights = mi.TensorXf(weights)
        dr.eval(vertices, weights)
        dr.sync_thread()

        def work():
            integrator.render_backward(
                self.scene, self.params, weights, self.sensor, mi.UInt32(seed), spp
            )
            return dr.grad(vertices)

        seconds, gradient = timed(work, self.clock)
        pose = [(motion.ravel() * gradient).sum() for motion in poses(self.vertices)]
        return seconds, np.concatenate([pose, gradient])


# What moves, and the loss.

POSE = [f"{kind}.{axis}" for kind in ("translate", "rotate") for axis in "xyz"] + ["scale"]


def poses(vertices):
    """Velocities of the vertices for each number of the pose, as capwalk defines
    them: about the centre of the bounding box."""
    arms = vertices - (vertices.min(axis=0) + vertices.max(axis=0)) / 2
    axes = np.eye(3)
    moves = [np.broadcast_to(axis, arms.shape) for axis in axes]
    return moves + [np.cross(axis, arms) for axis in axes] + [arms]


def smooth_weights(height, width):
    """The derivative of the loss by each pixel and channel."""
    y, x, channel = np.meshgrid(
        np.arange(height) / height, np.arange(width) / width, np.arange(3), indexing="ij"
    )
    return 1.0 + 0.5 * np.sin(7.0 * x + 2.0 * channel) * np.cos(5.0 * y + 1.0)


# Statistics.


def variances(results):
    return np.var(np.stack(results), axis=0, ddof=1)


class Reference:
    """A long derivative image, with the variance of its own."""

    def __init__(self, image, error):
        self.image = image.astype(np.float64)
        self.variance = error.astype(np.float64) ** 2
        self.square = (self.image**2 - self.variance).sum()

    def mean_squared_error(self, results):
        """Over runs, pixels and channels, without what the reference adds."""
        squares = [((result - self.image) ** 2).mean() for result in results]
        return float(np.mean(squares) - self.variance.mean())

    def bias(self, results):
        """Relative: the projection on the reference, less one, and its error."""
        sizes = [(result * self.image).sum() / self.square for result in results]
        own = (self.variance * self.image**2).sum() / self.square**2
        error = math.sqrt(np.var(sizes, ddof=1) / len(sizes) + own)
        return {"bias": float(np.mean(sizes) - 1.0), "bias_error": float(error)}


# The parts.


def forward(plan, budget, mitsuba, guided):
    """Derivative images, against a reference."""
    motion = f"{plan['shape']}.translate.{plan['axis']}"
    gradient = lambda method: ["gradient", "-p", motion, "--method", method]
    image = lambda file: file["gradient"].astype(np.float64)
    ours = [
        Capwalk(plan, gradient(method), image, budget.image_seconds, method=method)
        for method in plan["methods"]
    ]
    velocities = poses(mitsuba.vertices)["xyz".index(plan["axis"])]
    theirs = []
    for guiding, integrator in guided.items():
        call = lambda spp, seed, i=integrator: mitsuba.forward(i, velocities, spp, seed)
        theirs += [
            Mitsuba(call, samples, plan["pixels"], guiding=guiding) for samples in budget.forward
        ]
    in_turn(ours + theirs, budget, budget.image_runs)

    log("reference")
    both = lambda file: (file["gradient"], file["stderr"])
    method = plan["reference_method"]
    long = Capwalk(plan, gradient(method), both, budget.image_seconds)
    spp = long.long(budget)
    _, estimate = long.call(spp, REFERENCE_SEED, os.cpu_count())
    reference = Reference(*estimate)
    rows = []
    for contestant in ours + theirs:
        error = reference.mean_squared_error(contestant.results)
        cost = error * contestant.seconds()
        found = reference.bias(contestant.results)
        rows.append(contestant.row(mean_squared_error=error, cost=cost, **found))
    return {"motion": motion, "reference": {"method": method, "spp": spp}, "rows": rows}


def reverse(plan, budget, mitsuba, guided):
    """The gradient of a weighted sum of pixels."""
    weights, adjoint = write_weights(plan)
    names = [f"{plan['shape']}.{name}" for name in [*POSE, "positions"]]
    read = lambda file: np.concatenate([file[name].ravel() for name in names])
    backward = lambda method: ["backward", "--adjoint", adjoint, "--method", method, "-p", *names]
    contestants = [
        Capwalk(plan, backward(method), read, budget.vector_seconds, method=method)
        for method in plan["methods"]
    ]
    for guiding, integrator in guided.items():
        call = lambda spp, seed, i=integrator: mitsuba.reverse(i, weights, spp, seed)
        contestants += [
            Mitsuba(call, samples, plan["pixels"], guiding=guiding) for samples in budget.reverse
        ]
    in_turn(contestants, budget, budget.vector_runs)

    log("reference")
    method = plan["reference_method"]
    errors = lambda file: np.concatenate([file[f"{name}.stderr"].ravel() for name in names])
    both = lambda file: (read(file), errors(file))
    long = Capwalk(plan, [*backward(method), "--errors"], both, budget.vector_seconds)
    spp = long.long(budget)
    _, (reference, error) = long.call(spp, REFERENCE_SEED, os.cpu_count())
    if reference.size != len(POSE) + mitsuba.vertices.size:
        sys.exit(
            f"{plan['file']}: capwalk and Mitsuba count the vertices of \"{plan['shape']}\" "
            "differently; expected a mesh file without seams"
        )
    rows = []
    for contestant in contestants:
        runs = len(contestant.results)
        variance = variances(contestant.results)
        means = np.mean(np.stack(contestant.results), axis=0)
        # What is left of the squared distance of the means when their noise is
        # taken off is bias, if anything.
        noise = variance / runs + error**2
        squares = variance + np.maximum((means - reference) ** 2 - noise, 0.0)
        pose, vertices = squares[: len(POSE)], squares[len(POSE) :]
        seconds = contestant.seconds()
        # The numbers have different units: their geometric mean has no favourite.
        typical = math.exp(np.log(np.maximum(pose, 1e-300)).mean())
        rows.append(
            contestant.row(
                pose_means=means[: len(POSE)].tolist(),
                pose_variances=variance[: len(POSE)].tolist(),
                pose_squared_errors=pose.tolist(),
                pose_cost=typical * seconds,
                vertices=vertices.size // 3,
                vertex_variance=float(variance[len(POSE) :].sum()),
                vertex_squared_error=float(vertices.sum()),
                vertex_cost=float(vertices.sum() * seconds),
            )
        )
    about = {
        "method": method,
        "spp": spp,
        "pose": reference[: len(POSE)].tolist(),
        "pose_errors": error[: len(POSE)].tolist(),
    }
    return {"pose": POSE, "reference": about, "rows": rows}


def write_weights(plan):
    """The derivative of the loss by each pixel, and the file that capwalk reads it from."""
    weights = smooth_weights(plan["height"], plan["width"])
    file = os.path.join(plan["folder"], "weights.npz")
    np.savez(file, adjoint=weights)
    return weights, file


class Texels:
    """The gradient of a loss by an array of texels in Mitsuba."""

    def __init__(self, plan, weights):
        mi.set_variant(VARIANT)
        self.scene = load(plan["file"])
        self.params = mi.traverse(self.scene)
        self.key = plan["array"]
        if self.key not in self.params:
            sys.exit(f"{plan['file']}: Mitsuba has no \"{self.key}\"; correct the list in subjects.rs")
        self.start = mi.TensorXf(self.params[self.key])
        self.channels = self.start.shape[-1]
        self.weights = mi.TensorXf(weights)
        self.sensor = self.scene.sensors()[0]
        self.integrator = mi.load_dict({**integrator_of(plan["file"]), "type": "prb"})

    def reverse(self, spp, seed):
        mi.set_variant(VARIANT)
        texels = mi.TensorXf(self.start)
        dr.enable_grad(texels)
        self.params[self.key] = texels
        self.params.update()
        dr.eval(texels, self.weights)
        dr.sync_thread()

        def work():
            self.integrator.render_backward(
                self.scene, self.params, self.weights, self.sensor, mi.UInt32(seed), spp
            )
            return dr.grad(texels)

        return timed(work)


def texels(plan, budget):
    """The gradient of a weighted sum of pixels by the texels of a material or an emitter."""
    weights, adjoint = write_weights(plan)
    array = plan["array"]
    mitsuba = Texels(plan, weights)

    def of_file(numbers):
        # A grey texture has one channel in Mitsuba, three in capwalk, whose derivatives (and
        # whose standard errors, because they are multiples of one number) add up.
        numbers = numbers.astype(np.float64)
        return numbers.sum(axis=-1, keepdims=True) if mitsuba.channels == 1 else numbers

    read = lambda file: of_file(file[array])
    command = ["backward", "--adjoint", adjoint, "-p", array]
    ours = Capwalk(plan, command, read, budget.image_seconds)
    theirs = [Mitsuba(mitsuba.reverse, samples, plan["pixels"]) for samples in budget.texels]
    in_turn([ours, *theirs], budget, budget.image_runs)

    log("reference")
    both = lambda file: (read(file), of_file(file[f"{array}.stderr"]))
    long = Capwalk(plan, [*command, "--errors"], both, budget.image_seconds)
    spp = long.long(budget)
    _, estimate = long.call(spp, REFERENCE_SEED, os.cpu_count())
    reference = Reference(*estimate)
    rows = []
    for contestant in [ours, *theirs]:
        contestant.results = [
            without_seam(result, reference.image.shape[1]) for result in contestant.results
        ]
        error = reference.mean_squared_error(contestant.results) * reference.image.size
        cost = error * contestant.seconds()
        found = reference.bias(contestant.results)
        rows.append(contestant.row(squared_error=error, cost=cost, **found))
    return {
        "array": array,
        "entries": reference.image.size,
        "reference": {"spp": spp},
        "rows": rows,
    }


def without_seam(gradient, columns):
    """Mitsuba repeats the first and last column of an environment map on the other side."""
    if gradient.shape[1] == columns:
        return gradient
    inner = gradient[:, 1:-1].copy()
    inner[:, -1] += gradient[:, 0]
    inner[:, 0] += gradient[:, -1]
    return inner


def squares_of_samples(contestant):
    """For each run an estimate of the variance of one sample, as a mean over pixels."""
    results = np.stack(contestant.results)
    squares = ((results - results.mean(axis=0)) ** 2).reshape(len(results), -1).mean(axis=1)
    return squares * contestant.about["spp"] * len(results) / (len(results) - 1)


def image(plan, budget):
    """The image itself."""
    read = lambda file: file["value"].astype(np.float64)
    contestants = [Capwalk(plan, ["render"], read, budget.image_seconds, method="render")]
    for variant in plan["variants"]:
        mi.set_variant(variant)
        start = time.process_time()
        scene = load(plan["file"])
        loading = time.process_time() - start

        def call(spp, seed, variant=variant, scene=scene):
            mi.set_variant(variant)
            return timed(lambda: mi.render(scene, spp=spp, seed=seed))

        contestants += [
            Mitsuba(call, samples, plan["pixels"], variant=variant, loading=loading)
            for samples in budget.image
        ]
    in_turn(contestants, budget, budget.render_runs)
    # How much one sample varies does not depend on how many there are, nor on the variant.
    samples = {}
    for program in ("capwalk", "mitsuba"):
        of_program = [c for c in contestants if c.about["program"] == program]
        runs = np.concatenate([squares_of_samples(c) for c in of_program])
        samples[program] = runs.mean(), runs.std(ddof=1) / math.sqrt(len(runs)) / runs.mean()
    rows = []
    for contestant in contestants:
        of_one_sample, relative_error = samples[contestant.about["program"]]
        variance = float(of_one_sample / contestant.about["spp"])
        rows.append(
            contestant.row(
                mean=float(np.mean(contestant.results)),
                variance=variance,
                cost=variance * contestant.seconds(),
                relative_error=float(relative_error),
            )
        )
    return {"rows": rows}


def derivatives(plan, budget):
    """Both modes of differentiation."""
    mitsuba = Derivatives(plan)
    guided, guiding_seconds = {}, {}
    for guiding in GUIDINGS:
        log(f"guiding: {guiding}")
        guided[guiding], guiding_seconds[guiding] = mitsuba.guided(guiding, budget)
    log("derivative images")
    images = forward(plan, budget, mitsuba, guided)
    log("gradients of a loss")
    return {
        "mitsuba_set_up": {"loading": mitsuba.loading, "guiding": guiding_seconds},
        "forward": images,
        "reverse": reverse(plan, budget, mitsuba, guided),
    }


def main():
    plan_file, result_file = sys.argv[1:]
    plan = json.loads(pathlib.Path(plan_file).read_text())
    budget = Budget(plan["quick"])
    plan["variants"] = ["scalar_rgb", VARIANT] if plan["llvm"] else ["scalar_rgb"]
    for variant in plan["variants"]:
        mi.set_variant(variant)
        mi.set_log_level(mi.LogLevel.Error)
    source = plan["source"] and pathlib.Path(plan["source"])
    prepare(pathlib.Path(plan["file"]), plan["shape"], plan["size"], source)
    # Not before: textures are written by a second thread.
    dr.set_thread_count(1)
    film = xml.parse(plan["file"]).getroot().find("sensor/film")
    for side in ("width", "height"):
        plan[side] = int(film.find(f"integer[@name='{side}']").get("value"))
    plan["pixels"] = plan["width"] * plan["height"]
    result = {
        "scene": plan["name"],
        "size": [plan["width"], plan["height"]],
        "mitsuba": mi.__version__,
    }
    if "motion" in plan["parts"]:
        result.update(derivatives(plan, budget))
    if "texels" in plan["parts"]:
        log("gradient of texels")
        result["texels"] = texels(plan, budget)
    if "image" in plan["parts"]:
        log("images")
        result["image"] = image(plan, budget)
    pathlib.Path(result_file).write_text(json.dumps(result, indent=1))


if __name__ == "__main__":
    main()

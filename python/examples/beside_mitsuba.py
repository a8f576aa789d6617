"""How does a weighted sum of the image change when an object moves? By Mitsuba 3's prb_projective,
by capwalk inside Mitsuba, and by central differences of Mitsuba's own images, which are right."""

import sys

import drjit as dr
import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
import capwalk.mitsuba  # noqa: E402, F401  Makes the integrator known.

mi.set_log_level(mi.LogLevel.Error)
SEEDS = 8
T = mi.ScalarTransform4f


def scene(filter="box", border=False, **parts):
    film = {"type": "hdrfilm", "width": 12, "height": 9, "sample_border": border}
    return {
        "type": "scene",
        "sensor": {
            "type": "perspective",
            "fov": 35,
            "to_world": T().look_at(origin=[0, 1.5, 6], target=[0, 0.7, 0], up=[0, 1, 0]),
            "film": {**film, "rfilter": {"type": filter}},
        },
        "floor": {"type": "rectangle", "to_world": T().rotate([1, 0, 0], -90).scale(5)},
        "lamp": {
            "type": "rectangle",
            "to_world": T().translate([0.5, 4, 0.5]).rotate([1, 0, 0], 90).scale(0.5),
            "emitter": {"type": "area", "radiance": {"type": "rgb", "value": 20.0}},
        },
        **parts,
    }


CUBE = {"type": "cube", "to_world": T().translate([0.2, 1, 0]).rotate([0, 1, 0], 30).scale(0.5)}
# Without seams.
SQUARE = {"type": "rectangle", "to_world": T().translate([0.3, 1.6, 0]).rotate([1, 0, 0], 80)}
GLOWING = {**CUBE, "type": "rectangle", "emitter": {"type": "area"}}
SKY = {"sky": {"type": "constant", "radiance": 0.2}}

# A mirror that hides everything behind it from the camera.
MIRROR = {
    "type": "rectangle",
    "to_world": T().translate([0, 1, 3]).scale([3, 2, 1]),
    "bsdf": {"type": "conductor"},
}
# Behind the camera: floor, occluder and emitter, and the shadow, are seen in the mirror alone.
BEHIND = {
    "occluder": {
        "type": "cube",
        "to_world": T().translate([0.2, 4.2, 8]).rotate([0, 1, 0], 30).scale(0.5),
    },
    "lamp": {
        "type": "rectangle",
        "to_world": T().translate([0.5, 7, 8.5]).rotate([1, 0, 0], 90).scale(0.5),
        "emitter": {"type": "area", "radiance": {"type": "rgb", "value": 40.0}},
    },
    "floor": {"type": "rectangle", "to_world": T().rotate([1, 0, 0], -90).scale(14)},
}

SCENES = {
    "a shadow on the floor": scene(occluder=SQUARE),
    "a shadow in a mirror": scene(mirror=MIRROR, **BEHIND),
    "a cube, with its seams": scene(occluder=CUBE, **SKY),
    "a Gaussian filter": scene(filter="gaussian", occluder=GLOWING),
    "the same with sample_border": scene(filter="gaussian", border=True, occluder=GLOWING),
}


def moved(params, x):
    """Moves the occluder sideways."""
    shift = mi.Vector3f(x, 0, 0)
    if "occluder.to_world" in params:
        start = mi.Transform4f(dr.detach(params["occluder.to_world"]))
        params["occluder.to_world"] = mi.Transform4f().translate(shift) @ start
    else:
        start = dr.unravel(mi.Point3f, dr.detach(params["occluder.vertex_positions"]))
        params["occluder.vertex_positions"] = dr.ravel(start + shift)
    params.update()


def weights(shape):
    """Of the pixels: from -1 at the left to 1 at the right."""
    columns = np.broadcast_to(np.linspace(-1, 1, shape[1])[:, None], shape)
    return mi.TensorXf(np.ascontiguousarray(columns, dtype=np.float32))


def derivatives(description, kind, spp):
    """By an integrator, one for each seed."""
    loaded = mi.load_dict(description)
    params = mi.traverse(loaded)
    integrator = mi.load_dict({"type": kind, "max_depth": 3})
    found = []
    for seed in range(1, SEEDS + 1):
        x = mi.Float(0)
        dr.enable_grad(x)
        moved(params, x)
        image = mi.render(loaded, params, integrator=integrator, spp=spp, seed=seed)
        dr.backward(dr.sum(image * weights(image.shape)))
        found.append(dr.grad(x)[0])
    return np.array(found)


def differences(description, spp, step=0.02):
    """Of Mitsuba's images, one for each seed."""
    integrator = mi.load_dict({"type": "path", "max_depth": 3})
    found = []
    for seed in range(1, SEEDS + 1):
        sums = []
        for x in (step, -step):
            loaded = mi.load_dict(description)
            moved(mi.traverse(loaded), mi.Float(x))
            image = mi.render(loaded, integrator=integrator, spp=spp, seed=seed)
            sums.append(float(np.asarray(image * weights(image.shape), dtype=np.float64).sum()))
        found.append((sums[0] - sums[1]) / (2 * step))
    return np.array(found)


def main(spp=32):
    print(f"{'':38}{'prb_projective':>20}{'capwalk':>20}{'differences':>20}")
    for name, description in SCENES.items():
        columns = [derivatives(description, kind, spp) for kind in ("prb_projective", "capwalk")]
        columns.append(differences(description, 64 * spp))
        texts = [f"{c.mean():.3f} ± {c.std(ddof=1) / len(c) ** 0.5:.3f}" for c in columns]
        print(f"{name:38}" + "".join(f"{text:>20}" for text in texts), flush=True)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))

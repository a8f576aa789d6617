"""Scenes for Mitsuba 3, with everything that capwalk can convert."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mitsuba as mi
import numpy as np

SCALAR, VECTORIZED = "scalar_rgb", "llvm_ad_rgb"
Description = dict[str, Any]


def turned(*steps: Any) -> Any:
    transform = mi.ScalarTransform4f()
    for step, *arguments in steps:
        transform = getattr(transform, step)(*arguments)
    return transform


def sensor(**parts: Any) -> Description:
    film = {"type": "hdrfilm", "width": 24, "height": 18, "rfilter": {"type": "box"}}
    view = turned(("look_at", [0, 3, 6], [0, 0.5, 0], [0, 1, 0]))
    own = {} if parts.get("type") == "orthographic" else {"fov": 40}
    sampler = {"type": "independent", "sample_count": 16}
    return {
        "type": "perspective",
        "to_world": view,
        "film": film,
        "sampler": sampler,
        **own,
        **parts,
    }


def scene(**parts: Any) -> Description:
    """A ball over a floor under an emitter, with these parts in place of others or beside them."""
    whole = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 4},
        "sensor": sensor(),
        "floor": {
            "type": "rectangle",
            "to_world": turned(("rotate", [1, 0, 0], -90), ("scale", 4)),
            "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.7, 0.5, 0.3]}},
        },
        "ball": {"type": "sphere", "center": [0.3, 1, 0], "radius": 0.8},
        "lamp": {
            "type": "rectangle",
            "to_world": turned(("translate", [0, 5, 0]), ("rotate", [1, 0, 0], 90)),
            "emitter": {"type": "area", "radiance": {"type": "rgb", "value": [10, 9, 8]}},
        },
        **parts,
    }
    return {key: part for key, part in whole.items() if part is not None}


SKY = {"sky": {"type": "constant", "radiance": {"type": "rgb", "value": [0.3, 0.4, 0.5]}}}


def of(**bsdf: Any) -> Description:
    """The scene with a ball of a material, under a sky."""
    return scene(ball={"type": "sphere", "center": [0.3, 1, 0], "radius": 0.8, "bsdf": bsdf}, **SKY)


def on_square(bsdf: Any, **shape: Any) -> Description:
    """The scene with a tilted square of a material."""
    tilted = turned(("translate", [0, 1, 0]), ("rotate", [1, 0, 0], -30), ("scale", 1.5))
    return scene(ball={"type": "rectangle", "to_world": tilted, "bsdf": bsdf, **shape}, **SKY)


def texture(**image: Any) -> Description:
    return on_square({"type": "diffuse", "reflectance": {"type": "bitmap", **image}})


def random(*shape: int) -> Any:
    return np.random.default_rng(7).random(shape).astype(np.float32)


def tilted_normals() -> Any:
    return random(4, 4, 3) * np.float32([0.8, 0.8, 0.0]) + np.float32([0.1, 0.1, 0.75])


TWO_SIDES = {
    "type": "twosided",
    "front": {"type": "diffuse", "reflectance": 0.8},
    "back": {"type": "diffuse", "reflectance": 0.1},
}


def smooth_mesh() -> Any:
    """A mesh with normals of its own, and attributes."""
    angles = np.meshgrid(np.linspace(0.1, 3.0, 9), np.linspace(0, 2 * np.pi, 13))
    theta, phi = (angle.ravel() for angle in angles)
    normals = np.stack([np.sin(theta) * np.cos(phi), np.cos(theta), np.sin(theta) * np.sin(phi)], 1)
    corner = (np.arange(12)[:, None] * 9 + np.arange(8)).ravel()
    faces = np.stack([corner, corner + 9, corner + 1, corner + 1, corner + 9, corner + 10], 1)
    props = mi.Properties()
    props["bsdf"] = mi.load_dict(
        {"type": "diffuse", "reflectance": {"type": "mesh_attribute", "name": "vertex_color"}}
    )
    mesh = mi.Mesh("mesh", len(normals), faces.size // 3, props, has_vertex_normals=True)
    params = mi.traverse(mesh)
    params["vertex_positions"] = (0.8 * normals + [0.3, 1, 0]).ravel()
    params["faces"] = faces.ravel().astype(np.uint32)
    params.update()
    params["vertex_normals"] = normals.ravel()
    params.update()
    mesh.add_attribute("vertex_color", 3, random(len(normals) * 3))
    return scene(ball=mesh)


def flat_mesh() -> Any:
    """A sheet of eight triangles with normals that they share."""
    x, z = (side.ravel() for side in np.meshgrid([-1.2, 0, 1.2], [-1.0, 0, 1]))
    corner = np.array([0, 1, 3, 4])
    faces = np.stack([corner, corner + 3, corner + 1, corner + 1, corner + 3, corner + 4], 1)
    mesh = mi.Mesh("mesh", 9, 8, has_vertex_normals=True)
    params = mi.traverse(mesh)
    params["vertex_positions"] = np.stack([x, 1 + 0.5 * x, z], 1).ravel()
    params["faces"] = faces.ravel().astype(np.uint32)
    params.update()
    return scene(ball=mesh)


SCENES: dict[str, Callable[[], Description]] = {
    "sphere": scene,
    "cube": lambda: scene(
        ball={
            "type": "cube",
            "to_world": turned(("translate", [0, 1, 0]), ("rotate", [0, 1, 0], 30)),
        }
    ),
    "disk from behind": lambda: scene(
        ball={
            "type": "disk",
            "to_world": turned(("translate", [0, 1, 0]), ("rotate", [1, 0, 0], -40)),
            "flip_normals": True,
            "bsdf": TWO_SIDES,
        }
    ),
    "rectangle from behind": lambda: on_square(TWO_SIDES, flip_normals=True),
    "sphere from inside": lambda: scene(
        ball={"type": "sphere", "center": [0, 1, 0], "flip_normals": True, "bsdf": TWO_SIDES}
    ),
    "mirrored sphere": lambda: scene(
        ball={
            "type": "sphere",
            "to_world": turned(("translate", [0, 1, 0]), ("scale", [-1, 1, 1])),
            "bsdf": TWO_SIDES,
        }
    ),
    "mesh with normals": smooth_mesh,
    "gold": lambda: of(type="conductor", material="Au"),
    "rough metal": lambda: of(
        type="roughconductor",
        alpha_u=0.2,
        alpha_v=0.5,
        distribution="ggx",
        specular_reflectance=0.8,
    ),
    "glass": lambda: of(type="dielectric", int_ior=1.6),
    "rough glass": lambda: of(type="roughdielectric", alpha=0.3, distribution="ggx"),
    "thin glass": lambda: of(type="thindielectric"),
    "plastic": lambda: of(type="plastic", nonlinear=True, diffuse_reflectance=0.7),
    "rough plastic": lambda: of(type="roughplastic", alpha=0.2, diffuse_reflectance=0.7),
    "principled": lambda: of(
        type="principled",
        base_color={"type": "rgb", "value": [0.1, 0.4, 0.8]},
        metallic=0.4,
        roughness=0.4,
        clearcoat=0.5,
        sheen=0.3,
        eta=1.7,
    ),
    "mask": lambda: of(type="mask", opacity=0.4, inner={"type": "diffuse"}),
    "blend": lambda: of(
        type="blendbsdf",
        weight=0.3,
        first={"type": "diffuse"},
        second={"type": "roughconductor", "alpha": 0.3},
    ),
    "normal map": lambda: on_square(
        {
            "type": "normalmap",
            "normalmap": {
                "type": "bitmap",
                "raw": True,
                "bitmap": mi.Bitmap(tilted_normals()),
            },
            "use_shadowing_function": False,
            "inner": {"type": "diffuse"},
        }
    ),
    "bitmap, mirrored": lambda: texture(
        bitmap=mi.Bitmap(random(4, 5, 3)),
        to_uv=turned(("scale", [2, 3, 1]), ("translate", [0.1, 0.2, 0])),
        filter_type="nearest",
        wrap_mode="mirror",
    ),
    "bitmap, clamped": lambda: texture(
        bitmap=mi.Bitmap(random(4, 5, 3)),
        to_uv=turned(("scale", [2, 3, 1]), ("translate", [-0.1, -0.2, 0])),
        wrap_mode="clamp",
    ),
    "bitmap of bytes": lambda: texture(bitmap=mi.Bitmap((random(4, 5, 3) * 255).astype(np.uint8))),
    "checkerboard": lambda: on_square(
        {
            "type": "diffuse",
            "reflectance": {
                "type": "checkerboard",
                "to_uv": turned(("scale", [3, 2, 1])),
                "color0": {"type": "rgb", "value": [0.9, 0.1, 0.1]},
            },
        }
    ),
    "environment": lambda: scene(
        lamp=None,
        sky={
            "type": "envmap",
            "bitmap": mi.Bitmap(random(8, 16, 3)),
            "scale": 2.0,
            "to_world": turned(("rotate", [0, 1, 0], 70)),
        },
    ),
    "point": lambda: scene(
        lamp=None, point={"type": "point", "position": [1, 3, 1], "intensity": 20.0}
    ),
    "spot": lambda: scene(
        lamp=None,
        spot={
            "type": "spot",
            "to_world": turned(("look_at", [1, 4, 1], [0, 0, 0], [1, 0, 0])),
            "intensity": 60.0,
            "cutoff_angle": 30,
        },
    ),
    "directional": lambda: scene(
        lamp=None, sun={"type": "directional", "direction": [1, -3, 1], "irradiance": 2.0}
    ),
    "lens": lambda: scene(
        sensor=sensor(type="thinlens", aperture_radius=0.4, focus_distance=6.0, fov_axis="y")
    ),
    "orthographic": lambda: scene(
        sensor=sensor(
            type="orthographic",
            to_world=turned(("look_at", [0, 3, 6], [0, 0.5, 0], [0, 1, 0]), ("scale", 3)),
        )
    ),
    "film": lambda: scene(
        sensor=sensor(
            fov_axis="diagonal",
            principal_point_offset_x=0.1,
            film={
                "type": "hdrfilm",
                "width": 30,
                "height": 24,
                "crop_offset_x": 3,
                "crop_offset_y": 4,
                "crop_width": 24,
                "crop_height": 18,
                "sample_border": True,
                "pixel_format": "luminance",
                "rfilter": {"type": "gaussian", "stddev": 0.6},
            },
        )
    ),
}

"""The add-on for Blender, where the module of Blender is installed (``pip install bpy``)."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import capwalk as cw

bpy: Any = pytest.importorskip("bpy", reason="no Blender: pip install bpy")

ROOT = Path(__file__).parents[2]


def test_objects_move_as_in_blender() -> None:
    """The derivative of a cube of two materials and a name with a blank and a dot, turned about its
    origin, is the difference of images of scenes that Blender turned."""
    sys.path.insert(0, str(ROOT / "python/blender"))
    addon: Any = __import__("capwalk_blender")
    addon.register()
    try:
        scene = bpy.context.scene
        for thing in [thing for thing in scene.objects if thing.type == "MESH"]:
            bpy.data.objects.remove(thing)
        bpy.ops.mesh.primitive_plane_add(size=8)
        bpy.ops.mesh.primitive_cube_add(size=1, location=(0.3, 0.2, 0.9))
        cube = bpy.context.object
        cube.name = "My.Cube 1"
        for name in ("first", "second"):
            cube.data.materials.append(bpy.data.materials.new(name))
        cube.data.polygons[0].material_index = 1
        scene.render.resolution_x, scene.render.resolution_y = 24, 16
        scene.render.resolution_percentage, scene.capwalk.spp = 100, 16
        assert bpy.ops.capwalk.render() == {"FINISHED"}
        assert tuple(bpy.data.images["capwalk image"].size) == (24, 16)
        for motion in ("Y", "TURN_X", "SCALE"):
            scene.capwalk.motion = motion
            assert bpy.ops.capwalk.gradient() == {"FINISHED"}
            now = addon.loaded(bpy.context)
            along = addon.direction(now, cube, motion)
            assert len(along) == 2, "two materials"
            derivative = cw.gradient(now, along, spp=512)
            step = 0.004
            sides = [_moved(addon, cube, motion, sign * step) for sign in (1, -1)]
            difference = (sides[0].value - sides[1].value) / (2 * step)
            error = np.hypot(sides[0].stderr, sides[1].stderr).sum() / (2 * step)
            found, sizes = derivative.gradient, np.abs(derivative.gradient)
            # The noise of both sides is the same but where something moved.
            factor = (found * difference).sum() / (found * found).sum()
            assert abs(factor - 1) < 0.2, (motion, factor, error / sizes.sum())
    finally:
        addon.unregister()


def _moved(addon: Any, cube: Any, motion: str, by: float) -> cw.Image:
    place, turn, size = cube.location.copy(), cube.rotation_euler.copy(), cube.scale.copy()
    if motion == "SCALE":
        cube.scale = size * (1 + by)
    elif motion.startswith("TURN_"):
        cube.rotation_euler["XYZ".index(motion[-1])] += by
    else:
        cube.location["XYZ".index(motion)] += by
    bpy.context.view_layer.update()
    image = cw.render(addon.loaded(bpy.context), spp=4096, seed=5)
    cube.location, cube.rotation_euler, cube.scale = place, turn, size
    bpy.context.view_layer.update()
    return image

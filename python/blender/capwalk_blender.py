"""capwalk in Blender: images, and derivatives of them with respect to the motion of an object.

One file. In Blender 4.2 or later: Edit > Preferences > Add-ons > Install from Disk. capwalk must be
installed in Blender's Python (`python -m pip install capwalk`, or the path of a wheel, with the Python
in Blender's folder). The panel is in the properties of the render: images appear in the image editor.

The scene goes to capwalk as glTF, so what glTF does not have is not seen: the world's background,
volumes, most nodes of materials.
"""

from __future__ import annotations

import os
import re
import tempfile
from typing import Any

import bpy

bl_info = {
    "name": "capwalk",
    "description": "Unbiased derivatives of rendered images",
    "version": (0, 1, 0),
    "blender": (4, 2, 0),
    "location": "Properties > Render > capwalk",
    "category": "Render",
}

MOTIONS = [
    ("X", "Move along X", "Per unit of length along the world's X axis"),
    ("Y", "Move along Y", "Per unit of length along the world's Y axis"),
    ("Z", "Move along Z", "Per unit of length along the world's Z axis"),
    ("TURN_X", "Turn about X", "Per radian about the world's X axis"),
    ("TURN_Y", "Turn about Y", "Per radian about the world's Y axis"),
    ("TURN_Z", "Turn about Z", "Per radian about the world's Z axis"),
    ("SCALE", "Scale", "Per factor of its size, about its centre"),
]

AXES = {"X": (1, 0, 0), "Y": (0, 0, -1), "Z": (0, 1, 0)}
"""Blender's axes in glTF, whose Y axis points up."""


def velocities(positions: Any, motion: str, origin: Any) -> Any:
    """How vertices move, (V, 3), both in glTF's axes; turns and scales are about the origin of the
    object."""
    import numpy as np

    from_origin = positions - np.asarray(origin)
    if motion == "SCALE":
        return from_origin
    axis = np.array(AXES[motion[-1]], float)
    if motion.startswith("TURN_"):
        return np.cross(axis, from_origin)
    return np.broadcast_to(axis, positions.shape)


def direction(scene: Any, thing: bpy.types.Object, motion: str) -> dict[str, Any]:
    """The motion of an object, which is one shape for each of its materials."""
    import capwalk as cw

    x, y, z = thing.matrix_world.translation
    mine = re.compile(re.escape(thing.name) + r"(_\d+)?\.positions")
    arrays = {name: array for name, array in cw.traverse(scene).items() if mine.fullmatch(name)}
    if not arrays:
        raise cw.ParameterError(f'"{thing.name}" has no faces that can be rendered')
    return {name: velocities(array, motion, (x, z, -y)) for name, array in arrays.items()}


def loaded(context: bpy.types.Context) -> Any:
    """The scene as capwalk sees it, at the size of the render."""
    import capwalk as cw

    render = context.scene.render
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.glb")
        bpy.ops.export_scene.gltf(
            filepath=path,
            export_format="GLB",
            export_cameras=True,
            export_lights=True,
            export_apply=True,
            # Watts, as Blender renders them.
            export_import_convert_lighting_mode="COMPAT",
            use_visible=True,
            use_active_scene=True,
        )
        scene = cw.load_file(path)
    share = render.resolution_percentage / 100
    width, height = (
        max(1, round(side * share)) for side in (render.resolution_x, render.resolution_y)
    )
    scene.resize(width, height)
    return scene


def shown(name: str, result: Any) -> bpy.types.Image:
    """A result of capwalk as an image of Blender, packed into the file."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, f"{name}.png")
        result.save(path)
        if (old := bpy.data.images.get(name)) is not None:
            bpy.data.images.remove(old)
        image = bpy.data.images.load(path)
        image.name = name
        image.pack()
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "IMAGE_EDITOR":
                area.spaces.active.image = image
    return image


class CapwalkSettings(bpy.types.PropertyGroup):
    spp: bpy.props.IntProperty(name="Samples", default=64, min=1, description="Per pixel")  # type: ignore[valid-type]
    motion: bpy.props.EnumProperty(name="Motion", items=MOTIONS, default="X")  # type: ignore[valid-type]


class _Operator:
    """What happens to errors: they are reported as capwalk words them."""

    def execute(self, context: bpy.types.Context) -> set[str]:
        try:
            import capwalk as cw
        except ImportError:
            self.report(
                {"ERROR"},
                "capwalk is not installed in Blender's Python: python -m pip install capwalk",
            )
            return {"CANCELLED"}
        try:
            self.report({"INFO"}, self.done(context))
        except cw.Error as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class CAPWALK_OT_render(_Operator, bpy.types.Operator):
    bl_idname = "capwalk.render"
    bl_label = "Render"
    bl_description = "Render the scene's camera with capwalk"

    def done(self, context: bpy.types.Context) -> str:
        import capwalk as cw

        image = cw.render(loaded(context), spp=context.scene.capwalk.spp)
        return f"{shown('capwalk image', image).name} is in the image editor"


class CAPWALK_OT_gradient(_Operator, bpy.types.Operator):
    bl_idname = "capwalk.gradient"
    bl_label = "Derivative of Motion"
    bl_description = "How the image changes as the active object moves"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return context.object is not None and context.object.type == "MESH"

    def done(self, context: bpy.types.Context) -> str:
        import capwalk as cw

        settings, scene = context.scene.capwalk, loaded(context)
        along = direction(scene, context.object, settings.motion)
        derivative = cw.gradient(scene, along, spp=settings.spp)
        size, noise = (abs(part).mean() for part in (derivative.gradient, derivative.stderr))
        name = shown("capwalk derivative", derivative).name
        return f"{name} is in the image editor; mean size {size:.3g}, standard error {noise:.3g}"


class CAPWALK_PT_panel(bpy.types.Panel):
    bl_label = "capwalk"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"

    def draw(self, context: bpy.types.Context) -> None:
        layout, settings = self.layout, context.scene.capwalk
        layout.prop(settings, "spp")
        layout.operator(CAPWALK_OT_render.bl_idname)
        layout.prop(settings, "motion")
        layout.operator(CAPWALK_OT_gradient.bl_idname)


CLASSES = (CapwalkSettings, CAPWALK_OT_render, CAPWALK_OT_gradient, CAPWALK_PT_panel)


def register() -> None:
    for each in CLASSES:
        bpy.utils.register_class(each)
    bpy.types.Scene.capwalk = bpy.props.PointerProperty(type=CapwalkSettings)


def unregister() -> None:
    del bpy.types.Scene.capwalk
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)


if __name__ == "__main__":
    register()

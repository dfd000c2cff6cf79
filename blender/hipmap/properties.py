# SPDX-License-Identifier: GPL-3.0-or-later
"""The settings of a scene, and the add-on's preferences."""

import math

import bpy

from .run import ToolError, find_tool


class HipmapSettings(bpy.types.PropertyGroup):
    """Settings of hipmap in a scene."""

    stop_at: bpy.props.EnumProperty(
        name="Stop at", default="ERROR",
        description="What ends a render",
        items=(("ERROR", "Error", "End when the estimated error is small enough"),
               ("TIME", "Time", "End after a time"),
               ("PASSES", "Passes", "End after a number of passes")))
    error: bpy.props.FloatProperty(
        name="Error", default=5, min=0.01, max=100, soft_min=0.5, precision=2,
        subtype="PERCENTAGE",
        description="Estimated relative error, root mean square over the pixels")
    seconds: bpy.props.FloatProperty(
        name="Time", default=60, min=1, max=1e6, subtype="TIME", unit="TIME_ABSOLUTE",
        description="Seconds of rendering")
    passes: bpy.props.IntProperty(
        name="Passes", default=16, min=1, max=1_000_000,
        description="Independent passes, whose images are averaged")
    proceed: bpy.props.BoolProperty(
        name="Continue", default=False,
        description="Add to the passes of the last render of this frame, if nothing but the stop "
                    "has changed since")
    integrator: bpy.props.EnumProperty(
        name="Integrator", default="progressive",
        items=(("progressive", "Photon Maps", "Photon maps and final gathering, with radii that "
                                              "shrink from pass to pass"),
               ("direct", "Direct Estimate", "Photon maps seen directly: fast and blurred"),
               ("path", "Path Tracing", "Path tracing without photons, for comparison")))
    samples: bpy.props.IntProperty(
        name="Samples", default=4, min=1, max=65536,
        description="Mean samples of a pixel in a pass; noisy pixels get more")
    photons: bpy.props.IntProperty(
        name="Photons", default=0, min=0, max=2_000_000_000,
        description="Light paths of a pass; 0: as many as the pass has samples")
    seed: bpy.props.IntProperty(
        name="Seed", default=0, min=0, description="The same seed gives the same image")
    remove_fireflies: bpy.props.BoolProperty(
        name="Remove Fireflies", default=True,
        description="Take rare bright samples out of the image; its error counts the "
                    "light removed")
    angle: bpy.props.FloatProperty(
        name="Angle Threshold", default=math.radians(30), min=0, max=math.pi, subtype="ANGLE",
        description="Neighbouring faces whose normals differ by less share photons")
    threads: bpy.props.IntProperty(
        name="Threads", default=0, min=0, max=4096, description="0: all cores")
    keep_passes: bpy.props.BoolProperty(
        name="Keep Passes", default=True,
        description="Keep the passes of a render on disk, so that Continue can add to them; some "
                    "hundred megabytes for a large image")
    preview_passes: bpy.props.IntProperty(
        name="Passes", default=32, min=1, max=65536,
        description="Passes of a preview in the viewport, whose images are averaged")
    bake: bpy.props.BoolProperty(
        name="Bake Nodes", default=False,
        description="Have Cycles bake the nodes that hipmap cannot express to images before a "
                    "render; they are kept until nodes or meshes change")
    bake_size: bpy.props.EnumProperty(
        name="Image Size", default="1024",
        description="Width and height of the image of each mesh and material",
        items=tuple((size, size, f"{size} x {size} pixels")
                    for size in ("256", "512", "1024", "2048", "4096")))
    folder: bpy.props.StringProperty(
        name="Folder", subtype="DIR_PATH",
        description="Where the exported scene, the partition and the passes are kept; empty: "
                    "Blender's temporary folder, which is emptied when Blender ends")


class HipmapPreferences(bpy.types.AddonPreferences):
    """The add-on's preferences."""

    bl_idname = __package__

    programs: bpy.props.StringProperty(
        name="Programs", subtype="DIR_PATH",
        description="Folder of hipmap's programs preprocess and render; empty: those in the "
                    "add-on, or hipmap-preprocess and hipmap-render on the PATH")

    def draw(self, _context):
        """Shows the preferences, and the programs that they lead to."""
        self.layout.prop(self, "programs")
        try:
            folder = bpy.path.abspath(self.programs)
            for name in ("preprocess", "render"):
                self.layout.label(text=find_tool(name, folder), icon="CHECKMARK")
        except ToolError as error:
            self.layout.label(text=str(error), icon="ERROR")


def programs_folder(context):
    """Returns the folder of the programs that the user chose; empty: none."""
    addon = context.preferences.addons.get(__package__)
    return bpy.path.abspath(addon.preferences.programs) if addon else ""


def find_program(name):
    """Returns the path of a program, as find_tool, by the user's preferences.  Throws ToolError."""
    return find_tool(name, programs_folder(bpy.context))


def register():
    """Adds the settings to every scene."""
    bpy.utils.register_class(HipmapSettings)
    bpy.utils.register_class(HipmapPreferences)
    bpy.types.Scene.hipmap = bpy.props.PointerProperty(type=HipmapSettings)


def unregister():
    """Removes the settings."""
    del bpy.types.Scene.hipmap
    bpy.utils.unregister_class(HipmapPreferences)
    bpy.utils.unregister_class(HipmapSettings)

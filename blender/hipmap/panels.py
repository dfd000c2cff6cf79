# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels of the render properties, and Blender's own panels that also apply to hipmap."""

import bpy

from .engine import HipmapEngine
from .losses import draw_losses
from .motion import position_owner
from .quote import draw_costs

_EEVEE = {"EEVEE_MATERIAL_PT_context_material", "EEVEE_MATERIAL_PT_surface",
          "EEVEE_MATERIAL_PT_volume", "EEVEE_WORLD_PT_surface", "EEVEE_WORLD_PT_volume",
          "DATA_PT_EEVEE_light", "EEVEE_NEXT_MATERIAL_PT_surface",
          "EEVEE_NEXT_MATERIAL_PT_volume"}
_NOT_RENDERED = {"RENDER_PT_freestyle", "RENDER_PT_gpencil", "RENDER_PT_stereoscopy"}


class HipmapPanel:
    """A panel of the render properties that is there while hipmap is the engine.  It shows the
    settings named in `shown`."""

    shown = ()
    bl_options = {"DEFAULT_CLOSED"}
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"
    COMPAT_ENGINES = {HipmapEngine.bl_idname}

    @classmethod
    def poll(cls, context):
        """Whether the panel is shown."""
        return context.engine in cls.COMPAT_ENGINES

    def draw(self, context):
        """Shows the panel."""
        self.column(context, *self.shown)

    def column(self, context, *names):
        """A column of settings in Blender's style."""
        self.layout.use_property_split = True
        self.layout.use_property_decorate = False
        column = self.layout.column()
        for name in names:
            column.prop(context.scene.hipmap, name)
        return column


class RENDER_PT_hipmap_stop(HipmapPanel, bpy.types.Panel):
    """When a render ends"""

    bl_label = "Render"
    bl_options = set()

    def draw(self, context):
        """Shows the panel."""
        settings = context.scene.hipmap
        column = self.column(context, "stop_at", {"ERROR": "error", "TIME": "seconds",
                                                  "PASSES": "passes"}[settings.stop_at])
        row = column.row()
        row.enabled = settings.keep_passes
        row.prop(settings, "proceed")
        self.layout.operator("render.hipmap_quote")
        draw_costs(self.layout, context.scene)


class RENDER_PT_hipmap_method(HipmapPanel, bpy.types.Panel):
    """How light is found"""

    bl_label = "Light Transport"

    def draw(self, context):
        """Shows the panel."""
        column = self.column(context, "integrator", "samples", "photons", "seed",
                             "remove_fireflies")
        column.operator("render.hipmap_effects")


class RENDER_PT_hipmap_partition(HipmapPanel, bpy.types.Panel):
    """Which faces share photons"""

    bl_label = "Photon Maps"

    def draw(self, context):
        """Shows the panel."""
        column = self.column(context, "angle")
        column.operator("object.hipmap_show_maps")
        column.operator("object.hipmap_remove_maps")


class RENDER_PT_hipmap_nodes(HipmapPanel, bpy.types.Panel):
    """What hipmap does not render, and what it can bake"""

    bl_label = "Not Rendered"

    def draw(self, context):
        """Shows the panel."""
        column = self.column(context, "bake")
        row = column.row()
        row.active = context.scene.hipmap.bake
        row.prop(context.scene.hipmap, "bake_size")
        draw_losses(self.layout, context)


class RENDER_PT_hipmap_motion_blur(HipmapPanel, bpy.types.Panel):
    """Blender's settings of motion blur"""

    bl_label = "Motion Blur"

    def draw_header(self, context):
        """Shows the switch."""
        self.layout.prop(context.scene.render, "use_motion_blur", text="")

    def draw(self, context):
        """Shows the panel."""
        scene = context.scene
        column = self.column(context)
        column.active = scene.render.use_motion_blur
        if position_owner(scene):
            column.prop(position_owner(scene), "motion_blur_position", text="Position")
        column.prop(scene.render, "motion_blur_shutter", text="Shutter")


class RENDER_PT_hipmap_viewport(HipmapPanel, bpy.types.Panel):
    """The preview in 3D viewports"""

    bl_label = "Viewport"

    def draw(self, context):
        """Shows the panel."""
        column = self.column(context, "preview_passes")
        column.prop(context.scene.render, "preview_pixel_size", text="Pixel Size")


class RENDER_PT_hipmap_running(HipmapPanel, bpy.types.Panel):
    """How the programs run"""

    bl_label = "Running"
    shown = ("threads", "keep_passes", "folder")


_CLASSES = (RENDER_PT_hipmap_stop, RENDER_PT_hipmap_method, RENDER_PT_hipmap_partition,
            RENDER_PT_hipmap_nodes, RENDER_PT_hipmap_motion_blur, RENDER_PT_hipmap_viewport,
            RENDER_PT_hipmap_running)


def _shared_panels():
    """Blender's panels that apply to hipmap too."""
    for panel in bpy.types.Panel.__subclasses__():
        engines = getattr(panel, "COMPAT_ENGINES", None)
        applies = engines and ("BLENDER_RENDER" in engines or panel.__name__ in _EEVEE)
        if applies and panel.__name__ not in _NOT_RENDERED:
            yield engines


def register():
    """Adds the panels."""
    for panel in _CLASSES:
        bpy.utils.register_class(panel)
    for engines in _shared_panels():
        engines.add(HipmapEngine.bl_idname)


def unregister():
    """Removes the panels."""
    for engines in _shared_panels():
        engines.discard(HipmapEngine.bl_idname)
    for panel in reversed(_CLASSES):
        bpy.utils.unregister_class(panel)

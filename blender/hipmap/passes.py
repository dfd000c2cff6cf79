# SPDX-License-Identifier: GPL-3.0-or-later
"""Render passes of a view layer: the layers that `render --layers` writes."""

import copy
from dataclasses import dataclass

import bpy
import numpy


@dataclass(frozen=True)
class Pass:
    """A render pass."""

    layer: str     # its name for `render --layer-names`
    name: str      # its name in Blender
    channels: str  # a letter each
    kind: str      # of a socket: "VALUE", "VECTOR" or "COLOR"
    switch: str    # the view layer's setting that asks for it, or hipmap's own
    own: tuple = ()  # label and description of a setting that Blender lacks


# A new layer of `render` gets a row here.
PASSES = (
    Pass("depth", "Depth", "Z", "VALUE", "use_pass_z"),
    Pass("position", "Position", "XYZ", "VECTOR", "use_pass_position"),
    Pass("normal", "Normal", "XYZ", "VECTOR", "use_pass_normal"),
    Pass("object-index", "IndexOB", "X", "VALUE", "use_pass_object_index"),
    Pass("material-index", "IndexMA", "X", "VALUE", "use_pass_material_index"),
    Pass("diffuse-color", "DiffCol", "RGB", "COLOR", "use_pass_diffuse_color"),
    Pass("denoising-albedo", "Denoising Albedo", "RGB", "COLOR", "denoising_albedo",
         ("Denoising Albedo", "Deliver the share of light that surfaces scatter, for the compositor's "
                              "Denoise node")),
    Pass("map", "Map ID", "X", "VALUE", "map_id",
         ("Map ID", "Deliver the number of the shared photon map")),
    Pass("noise", "Noise", "RGB", "COLOR", "noise",
         ("Noise", "Deliver the standard error of each pixel")),
    Pass("error", "Error", "RGB", "COLOR", "error",
         ("Error", "Deliver the estimated error of each pixel: noise and bias")),
)


def _owner(view_layer, one):
    return view_layer.hipmap if one.own else view_layer


def asked_passes(view_layer):
    """Returns the passes that a view layer asks for, besides Combined."""
    return [one for one in PASSES if getattr(_owner(view_layer, one), one.switch, False)]


def register_passes(engine, scene, view_layer):
    """Tells Blender's compositor which passes a view layer will have."""
    engine.register_pass(scene, view_layer, "Combined", 4, "RGBA", "COLOR")
    for one in asked_passes(view_layer):
        engine.register_pass(scene, view_layer, one.name, len(one.channels), one.channels,
                             one.kind)


class Rects:
    """The pixels of every pass of a result, rows from the bottom left.  One array, because Blender
    takes the pixels of several passes quickly only all together."""

    def __init__(self, passes, pixels):
        self._passes = passes
        self._all = numpy.zeros(sum(one.channels for one in passes) * pixels, numpy.float32)
        self._starts, at = {}, 0
        for one in passes:
            self._starts[one.name] = at, at + one.channels * pixels
            at += one.channels * pixels

    def again(self, passes):
        """Returns these values for the passes of another result of the same size."""
        out = copy.copy(self)
        out._passes = passes
        return out

    def of(self, name):
        """Returns the values of a pass, a view that may be written."""
        begin, end = self._starts[name]
        return self._all[begin:end]

    def read(self):
        """Takes the values from the result."""
        self._passes.foreach_get("rect", self._all)

    def write(self):
        """Puts the values into the result."""
        self._passes.foreach_set("rect", self._all)


def renumber(rects, numbers):
    """Replaces numbers of the file by Blender's pass indices.  numbers: by pass, those of number 1
    and on."""
    for name, indices in numbers.items():
        values = rects.of(name)
        values[:] = numpy.array([0, *indices], numpy.float32)[values.astype(numpy.int64)]


def _changed(_settings, context):
    context.view_layer.update_render_passes()


def _settings_class():
    """The settings of the passes that Blender does not know."""
    switches = {one.switch: bpy.props.BoolProperty(name=one.own[0], description=one.own[1],
                                                   default=False, update=_changed)
                for one in PASSES if one.own}
    return type("HipmapViewLayer", (bpy.types.PropertyGroup,),
                {"__doc__": "Settings of hipmap in a view layer.", "__annotations__": switches})


HipmapViewLayer = _settings_class()


class VIEWLAYER_PT_hipmap_passes(bpy.types.Panel):
    """Which render passes are delivered"""

    bl_label = "Passes"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "view_layer"
    COMPAT_ENGINES = {"HIPMAP"}

    @classmethod
    def poll(cls, context):
        """Whether the panel is shown."""
        return context.engine in cls.COMPAT_ENGINES

    def draw(self, context):
        """Shows a switch for each pass that this Blender has."""
        self.layout.use_property_split = True
        self.layout.use_property_decorate = False
        column = self.layout.column(heading="Include", align=True)
        for one in PASSES:
            owner = _owner(context.view_layer, one)
            if hasattr(owner, one.switch):
                column.prop(owner, one.switch)


def register():
    """Adds the settings to every view layer, and the panel."""
    bpy.utils.register_class(HipmapViewLayer)
    bpy.types.ViewLayer.hipmap = bpy.props.PointerProperty(type=HipmapViewLayer)
    bpy.utils.register_class(VIEWLAYER_PT_hipmap_passes)


def unregister():
    """Removes the settings and the panel."""
    bpy.utils.unregister_class(VIEWLAYER_PT_hipmap_passes)
    del bpy.types.ViewLayer.hipmap
    bpy.utils.unregister_class(HipmapViewLayer)

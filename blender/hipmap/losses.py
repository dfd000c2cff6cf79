# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that say what is not rendered, and how nodes are named in them."""

import textwrap

_MOST_LINES = 20
_WIDTH_OF_LETTER = 7  # pixels, at a user interface of normal size
_MARGIN = 60

_NOT_RENDERED = {"CURVES": "hair curves are not rendered", "POINTCLOUD": "points are not rendered",
                 "GPENCIL": "grease pencil is not rendered",
                 "GREASEPENCIL": "grease pencil is not rendered"}
_TREATED_ALIKE = {"is_holdout": "a holdout", "is_shadow_catcher": "a shadow catcher"}
_RAYS = ("camera", "diffuse", "glossy", "transmission", "volume_scatter", "shadow")


def label(node):
    """Returns the name of a node as an artist knows it: 'Noise Texture'."""
    return f"'{node.label or node.bl_label}'"


def without_repeats(lines):
    """Returns the lines in order, each once."""
    return list(dict.fromkeys(lines))


def type_losses(item):
    """Yields a line if hipmap renders no objects of this type."""
    if item.type in _NOT_RENDERED:
        yield f"object '{item.name}': {_NOT_RENDERED[item.type]}"


def mesh_losses(item):
    """Yields what hipmap does not render of an object with a mesh, one line each."""
    if any(modifier.type == "FLUID" and modifier.fluid_type == "DOMAIN" and
           modifier.domain_settings.domain_type == "GAS" for modifier in item.modifiers):
        yield f"object '{item.name}': its smoke is not rendered: its volume fills the whole domain"
    for system in item.particle_systems:
        if system.settings.render_type == "PATH":
            yield f"object '{item.name}': its hair '{system.name}' is not rendered"
    for name, what in _TREATED_ALIKE.items():
        if getattr(item, name, False):
            yield f"object '{item.name}': it is rendered like any other, although it is {what}"
    if not all(getattr(item, "visible_" + kind, True) for kind in _RAYS):
        yield f"object '{item.name}': its ray visibility is not rendered: all rays see it"


_told = {}  # by the name of a scene: what its last render lost


def keep_losses(scene, lines):
    """Keeps what a render does not show, for the panel.  scene: its name."""
    _told[scene] = lines


def draw_losses(layout, context):
    """Lists in a panel what the last render of the scene does not show."""
    lines = _told.get(context.scene.name, [])
    if not lines:
        return
    room = context.region.width / context.preferences.system.ui_scale - _MARGIN
    letters = max(int(room / _WIDTH_OF_LETTER), 20)
    box = layout.column()
    for line in lines[:_MOST_LINES]:
        column = box.box().column(align=True)
        for part in textwrap.wrap(line, letters):
            column.label(text=part)
    if len(lines) > _MOST_LINES:
        box.label(text=f"and {len(lines) - _MOST_LINES} more, in the Info editor")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that say what is not rendered, and how nodes are named in them."""

_MOST_LINES = 20


def label(node):
    """Returns the name of a node as an artist knows it: 'Noise Texture'."""
    return f"'{node.label or node.bl_label}'"


def without_repeats(lines):
    """Returns the lines in order, each once."""
    return list(dict.fromkeys(lines))


_told = {}  # by the name of a scene: what its last render lost


def keep_losses(scene, lines):
    """Keeps what a render does not show, for the panel.  scene: its name."""
    _told[scene] = lines


def draw_losses(layout, scene):
    """Lists in a panel what the last render of a scene does not show."""
    lines = _told.get(scene.name, [])
    column = layout.box().column(align=True) if lines else None
    for line in lines[:_MOST_LINES]:
        column.label(text=line)
    if len(lines) > _MOST_LINES:
        column.label(text=f"and {len(lines) - _MOST_LINES} more, in the Info editor")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that say what is not rendered, and how nodes are named in them."""

import textwrap

_MOST_LINES = 20
_WIDTH_OF_LETTER = 7  # pixels, at a user interface of normal size
_MARGIN = 60


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

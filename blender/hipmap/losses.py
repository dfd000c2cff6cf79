# SPDX-License-Identifier: GPL-3.0-or-later
"""How nodes are named in lines that say what is not rendered."""


def label(node):
    """Returns the name of a node as an artist knows it: 'Noise Texture'."""
    return f"'{node.label or node.bl_label}'"


def without_repeats(lines):
    """Returns the lines in order, each once."""
    return list(dict.fromkeys(lines))

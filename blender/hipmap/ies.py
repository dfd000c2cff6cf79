# SPDX-License-Identifier: GPL-3.0-or-later
"""IES Texture nodes of lights: photometric files beside the scene."""

import hashlib
import os

import bpy

from .sockets import Unknown, follow, origin


def ies_node(emission):
    """Returns the IES Texture at the strength of an Emission node; None: there is none."""
    output, _ = origin(emission.inputs["Strength"], ())
    return output.node if output and output.node.bl_idname == "ShaderNodeTexIES" else None


def ies_problem(node):
    """Returns why an IES Texture is not rendered; None: it is."""
    if node.inputs["Vector"].is_linked:
        return "its Vector is linked"
    try:
        strength = follow(node.inputs["Strength"])
    except Unknown as unknown:
        return f"node {unknown} at its Strength"
    if not strength.is_plain:
        return "an image at its Strength"
    return None if _content(node) else "its file is missing"


def _content(node):
    """The bytes of the photometric file; None: there are none."""
    if node.mode == "INTERNAL":
        return node.ies.as_string().encode() if node.ies else None
    path = bpy.path.abspath(node.filepath, library=node.id_data.library)
    if not os.path.isfile(path):
        return None
    with open(path, "rb") as file:
        return file.read()


def write_ies(node, folder):
    """Writes the file of an IES Texture whole.  Returns its name, which tells its content."""
    content = _content(node)
    name = f"light_{hashlib.sha256(content).hexdigest()[:16]}.ies"
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        with open(path + ".part", "wb") as file:
            file.write(content)
        os.replace(path + ".part", path)
    return name

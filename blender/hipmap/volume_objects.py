# SPDX-License-Identifier: GPL-3.0-or-later
"""Volume objects: a grid of an OpenVDB file as the density of a medium in a box."""

import hashlib
import os
import re
import struct
import subprocess
from dataclasses import dataclass

import bpy
import numpy
from mathutils import Matrix, Vector

from .geometry import in_gltf_axes
from .run import ToolError
from .sockets import origin
from .surfaces import material_output
from .volumes import medium_of

_NUMBER = r"(-?[\d.]+(?:e[-+]?\d+)?)"
_BOX = re.compile(r"^box: \({0}, {0}, {0}\) to \({0}, {0}, {0}\)".format(_NUMBER), re.MULTILINE)
_LEAST_TURN = 1e-4
_HEADER = 48  # bytes of a .vol file before its values, with the counts of values from byte 8 on

_boxes = {}  # by the names of .vol files

# Cycles' material of a volume without one: a Principled Volume as it is added.
_DEFAULT = {"scattering": [0.5] * 3, "absorption": [0.5] * 3}

# Corners of a box, x fastest, and its triangles, counter-clockwise from outside.
_TRIANGLES = numpy.array([0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                          2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5], numpy.uint32)


@dataclass(frozen=True)
class WrittenVolume:
    """A volume in the file."""

    mesh: int  # its number
    matrix: Matrix  # to glTF's world
    geometry: bytes  # what tells its faces from others
    losses: list  # lines on what is not rendered


def remove_other_volumes(folder, gltf):
    """Removes the .vol files of a folder that the JSON of a scene does not name, such as those of
    other frames."""
    used = {material.get("extras", {}).get("hipmap", {}).get("medium", {}).get("density")
            for material in gltf.get("materials", [])}
    for name in os.listdir(folder):
        if name.startswith("volume_") and name.endswith(".vol") and name not in used:
            os.remove(os.path.join(folder, name))


class NotRendered(Exception):
    """A volume object that hipmap does not render.  Its text says why."""


def _grid_and_medium(material):
    """The name of the grid, the medium for density 1, and what is lost."""
    if material is None:
        return "density", _DEFAULT, []
    output = material_output(material)
    socket = output.inputs["Volume"] if output else None
    node = origin(socket, ())[0] if socket else None
    if node is None or node.node.bl_idname != "ShaderNodeVolumePrincipled":
        raise NotRendered("its material is no Principled Volume")
    medium, losses = medium_of(socket)
    grid = node.node.inputs["Density Attribute"].default_value
    if not medium or not grid:
        raise NotRendered(losses[0] if losses else "its material takes no grid")
    if medium.pop("emission", None):
        losses.append("its emission is not rendered")
    return grid, medium, losses


def _placed(matrix):
    """(up, matrix): the axis of the file that points upwards, and the matrix to glTF's world of the
    box that vdb_to_vol prints."""
    for up, to_box in (("z", in_gltf_axes(Matrix()).inverted()), ("y", Matrix())):
        placed = in_gltf_axes(matrix) @ to_box
        size = max(abs(x) for row in placed.to_3x3() for x in row)
        if all(placed[i][i] > 0 for i in range(3)) and all(
                abs(placed[i][j]) <= _LEAST_TURN * size for i in range(3) for j in range(3)
                if i != j):
            return up, placed
    raise NotRendered("it is turned: only turns of Blender's import, 0 or 90 degrees about X, are "
                      "rendered")


def _converted(tool, volume, grid, up, folder):
    """The name of the .vol file of a grid, and the box that it fills, two corners."""
    if not volume.grids.load():
        raise NotRendered(volume.grids.error_message or "its file cannot be read")
    path = bpy.path.abspath(volume.grids.frame_filepath)
    if grid not in volume.grids:
        raise NotRendered(f"its file has no grid '{grid}'")
    if not os.path.isfile(path):
        raise NotRendered("it is in no file")
    told = repr((path, os.path.getmtime(path), grid, up))
    name = f"volume_{hashlib.sha256(told.encode()).hexdigest()[:16]}.vol"
    if name not in _boxes or not os.path.isfile(os.path.join(folder, name)):
        _boxes[name] = _convert(tool, path, os.path.join(folder, name), grid, up)
    return name, _boxes[name]


def _convert(tool, vdb, path, grid, up):
    """Writes the .vol file of a grid.  Returns the box that it fills, two corners."""
    done = subprocess.run([tool, vdb, "-o", path, "--grid", grid, "--up", up],
                          stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True, check=False)
    box = _BOX.search(done.stderr)
    if done.returncode != 0 or box is None:
        raise NotRendered((done.stderr.strip().splitlines() or ["no message"])[-1])
    corners = numpy.array([float(x) for x in box.groups()]).reshape(2, 3)
    return _with_border(path, *corners)


def _with_border(path, low, high):
    """Puts a border of zeros around the values of a .vol file, down to which Cycles interpolates.
    Returns the box that it then fills, two corners."""
    with open(path, "rb") as file:
        header, values = bytearray(file.read(_HEADER)), numpy.frombuffer(file.read(), "<f4")
    counts = numpy.frombuffer(header, "<i4", 3, 8).copy()
    step = (high - low) / (counts - 1)
    struct.pack_into("<3i", header, 8, *(counts + 2))
    with open(path, "wb") as file:
        file.write(header)
        file.write(numpy.pad(values.reshape(counts[::-1]), 1).tobytes())
    return low - step, high + step


def _density_scale(volume, matrix):
    """What a density of the object's space is in the world's, as Cycles takes it."""
    if volume.render.space == "WORLD":
        return 1.0
    return 1 / (matrix.to_3x3() @ Vector((1, 1, 1)).normalized()).length


def write_volume(glb, item, matrix, folder, find):
    """Adds a volume object as a box with a medium.  Returns the WrittenVolume.  find: returns the
    path of a program by its name.  Throws NotRendered."""
    materials = [slot.material for slot in item.material_slots] or list(item.data.materials)
    grid, medium, losses = _grid_and_medium(materials[0] if materials else None)
    up, placed = _placed(matrix)
    try:
        tool = find("vdb_to_vol")
    except ToolError as error:
        raise NotRendered(str(error)) from error
    name, (low, high) = _converted(tool, item.data, grid, up, folder)
    scale = _density_scale(item.data, matrix)
    scaled = {key: [scale * c for c in medium[key]] if key in ("scattering", "absorption")
              else medium[key] for key in medium}
    material = glb.add("materials", {
        "name": item.name, "pbrMetallicRoughness": {"metallicFactor": 0.0},
        "extras": {"hipmap": {"boundary": False, "medium": {**scaled, "density": name}}}})
    corners = numpy.array([[(low, high)[i >> axis & 1][axis] for axis in range(3)]
                           for i in range(8)], numpy.float32)
    primitive = {"attributes": {"POSITION": glb.add_array(corners, bounds=True)},
                 "indices": glb.add_array(_TRIANGLES), "material": material}
    mesh = glb.add("meshes", {"name": item.data.name, "primitives": [primitive]})
    return WrittenVolume(mesh, placed, corners.tobytes(), losses)

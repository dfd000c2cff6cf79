# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads and writes .glb files: JSON and one buffer (glTF 2.0, chapter "GLB File Format")."""

import json
import os
import struct

import numpy

_HEADER = struct.Struct("<4sII")
_CHUNK = struct.Struct("<I4s")

_COMPONENT_TYPES = {"float32": 5126, "uint32": 5125, "uint16": 5123}
_ELEMENT_TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}


def read_glb(path):
    """Returns the JSON of a .glb as a dictionary, and its buffer as bytes (empty: none)."""
    with open(path, "rb") as file:
        magic, version, _ = _HEADER.unpack(file.read(_HEADER.size))
        if magic != b"glTF" or version != 2:
            raise ValueError(f"{path}: not a .glb file of version 2")
        chunks = {}
        while head := file.read(_CHUNK.size):
            length, kind = _CHUNK.unpack(head)
            chunks[kind] = file.read(length)
    return json.loads(chunks[b"JSON"]), chunks.get(b"BIN\0", b"")


def write_glb(path, gltf, buffer):
    """Writes a .glb whole: to a temporary name, then renamed."""
    text = json.dumps(gltf, separators=(",", ":"), ensure_ascii=False).encode()
    text += b" " * (-len(text) % 4)
    rest = bytes(-len(buffer) % 4)
    length = _HEADER.size + _CHUNK.size + len(text)
    if buffer:
        length += _CHUNK.size + len(buffer) + len(rest)
    with open(path + ".part", "wb") as file:
        file.write(_HEADER.pack(b"glTF", 2, length))
        file.write(_CHUNK.pack(len(text), b"JSON") + text)
        if buffer:
            file.write(_CHUNK.pack(len(buffer) + len(rest), b"BIN\0"))
            file.write(buffer)
            file.write(rest)
    os.replace(path + ".part", path)


class GlbBuilder:
    """Collects the arrays and the JSON of a .glb."""

    def __init__(self, generator):
        self.json = {"asset": {"version": "2.0", "generator": generator}, "scene": 0,
                     "scenes": [{"nodes": []}]}
        self._parts = []
        self._length = 0

    def add(self, kind, thing):
        """Appends a thing to a list of the JSON, such as "meshes".  Returns its index."""
        things = self.json.setdefault(kind, [])
        things.append(thing)
        return len(things) - 1

    def add_root(self, node):
        """Appends a node that has no parent.  Returns its index."""
        index = self.add("nodes", node)
        self.json["scenes"][0]["nodes"].append(index)
        return index

    def add_bytes(self, data):
        """Appends bytes to the buffer.  Returns the index of their buffer view."""
        rest = bytes(-self._length % 4)
        self._parts += [rest, data]
        view = {"buffer": 0, "byteOffset": self._length + len(rest), "byteLength": len(data)}
        self._length += len(rest) + len(data)
        return self.add("bufferViews", view)

    def add_array(self, array, bounds=False):
        """Appends an array [n] or [n, 2 to 4] of float32, uint32 or uint16.  Returns the index of
        its accessor.  bounds: write the least and the greatest value, as positions need."""
        array = numpy.ascontiguousarray(array)
        width = 1 if array.ndim == 1 else array.shape[1]
        accessor = {"bufferView": self.add_bytes(array.tobytes()),
                    "componentType": _COMPONENT_TYPES[array.dtype.name],
                    "count": len(array), "type": _ELEMENT_TYPES[width]}
        if bounds:
            accessor["min"] = array.min(axis=0).tolist()
            accessor["max"] = array.max(axis=0).tolist()
        return self.add("accessors", accessor)

    def use_extension(self, name):
        """Names an extension in extensionsUsed."""
        used = self.json.setdefault("extensionsUsed", [])
        if name not in used:
            used.append(name)

    def finish(self):
        """Returns the JSON and the buffer of what was added."""
        buffer = b"".join(self._parts)
        if buffer:
            self.json["buffers"] = [{"byteLength": len(buffer)}]
        return self.json, buffer

    def write(self, path):
        """Writes the file whole."""
        write_glb(path, *self.finish())

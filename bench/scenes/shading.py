"""Turns solids into vertices as Blender's exporter writes them: split at hard edges and UV seams."""

import math
from array import array

from solids import face_normal


def triangulate(points, face, normal):
    """Corner numbers of triangles that fill a polygon, by cutting ears."""
    if len(face) == 3:
        return ((0, 1, 2),)
    if len(face) == 4 and _is_convex(points, face, normal):
        return ((0, 1, 2), (0, 2, 3))
    axis = max(range(3), key=lambda k: abs(normal[k]))
    u, v = ((axis + 1) % 3, (axis + 2) % 3)[::1 if normal[axis] > 0 else -1]
    flat = [(points[i][u], points[i][v]) for i in face]
    return _cut_ears(flat)


def _turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _is_convex(points, face, normal):
    corners = [points[i] for i in face]
    for k in range(4):
        a, b, c = corners[k - 2], corners[k - 1], corners[k]
        if sum(n * m for n, m in zip(face_normal((a, b, c), (0, 1, 2)), normal)) < 0:
            return False
    return True


def _cut_ears(flat):
    left, triangles, misses = list(range(len(flat))), [], 0
    while len(left) > 3 and misses <= len(left):
        a, b, c = left[0], left[1], left[2]
        corners = flat[a], flat[b], flat[c]
        ear = _turn(*corners) > 1e-6 * math.dist(flat[a], flat[c]) ** 2 and not any(
            _turn(corners[0], corners[1], flat[p]) >= 0 and
            _turn(corners[1], corners[2], flat[p]) >= 0 and
            _turn(corners[2], corners[0], flat[p]) >= 0 for p in left[3:])
        if ear:
            triangles.append((a, b, c))
            left.pop(1)
            left.append(left.pop(0))
            misses = 0
        else:
            left.append(left.pop(0))
            misses += 1
    if len(left) > 3:
        raise ValueError("a polygon crosses itself: no ear is left to cut")
    return triangles + [tuple(left)]


def _box_projection(points, face, normal):
    """Texture coordinates in metres along the two axes that the polygon faces least."""
    x, y, z = map(abs, normal)
    if y >= x and y >= z:
        return tuple((points[i][0], points[i][2]) for i in face)
    if x >= z:
        return tuple((points[i][2], points[i][1]) for i in face)
    return tuple((points[i][0], points[i][1]) for i in face)


def _smooth_corners(solid, normals, lengths, least_cosine):
    """For each corner the number of the group of corners at its point that share one normal."""
    first, total = [], 0
    for face in solid.faces:
        first.append(total)
        total += len(face)
    group = list(range(total))

    def root(c):
        while group[c] != c:
            group[c] = group[group[c]]
            c = group[c]
        return c

    open_edges = {}
    for f, face in enumerate(solid.faces):
        count = len(face)
        for k in range(count):
            a, b = face[k], face[(k + 1) % count]
            key = (a, b) if a < b else (b, a)
            here = (f, first[f] + k, first[f] + (k + 1) % count, a)
            other = open_edges.pop(key, None)
            if other is None:
                open_edges[key] = here
                continue
            g = other[0]
            n, m = normals[f], normals[g]
            if n[0] * m[0] + n[1] * m[1] + n[2] * m[2] > least_cosine * lengths[f] * lengths[g]:
                same = other[3] == a
                group[root(here[1])] = root(other[1] if same else other[2])
                group[root(here[2])] = root(other[2] if same else other[1])
    return [root(c) for c in range(total)]


class Vertices:
    """Arrays of positions, normals, texture coordinates and triangle indices."""

    def __init__(self):
        self.positions, self.normals, self.uvs = array("f"), array("f"), array("f")
        self.indices = array("I")

    def count(self):
        return len(self.positions) // 3


def shade(solid, smooth_deg=30.0):
    """Vertices of a solid; edges sharper than smooth_deg are hard, as with Blender's auto smooth."""
    normals = [face_normal(solid.points, face) for face in solid.faces]
    lengths = [math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) for n in normals]
    groups = _smooth_corners(solid, normals, lengths, math.cos(math.radians(smooth_deg)))
    sums, corner = {}, 0
    for face, n in zip(solid.faces, normals):
        for _ in face:
            total = sums.setdefault(groups[corner], [0.0, 0.0, 0.0])
            total[0] += n[0]
            total[1] += n[1]
            total[2] += n[2]
            corner += 1
    result, known, corner = Vertices(), {}, 0
    for face, n, uv in zip(solid.faces, normals, solid.uvs):
        uv = uv or _box_projection(solid.points, face, n)
        numbers = []
        for k, point in enumerate(face):
            key = (groups[corner], uv[k])
            if key not in known:
                known[key] = len(known)
                _add_vertex(result, solid.points[point], sums[groups[corner]], uv[k])
            numbers.append(known[key])
            corner += 1
        for triangle in triangulate(solid.points, face, n):
            result.indices.extend(numbers[c] for c in triangle)
    return result


def _add_vertex(result, position, normal, uv):
    length = math.sqrt(sum(n * n for n in normal)) or 1.0
    result.positions.extend(position)
    result.normals.extend((normal[0] / length, normal[1] / length, normal[2] / length))
    result.uvs.extend((uv[0], 1 - uv[1]))  # glTF counts v downwards

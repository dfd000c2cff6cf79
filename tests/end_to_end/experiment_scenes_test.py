"""The scenes of the experiment are what experiments/README.md says.

    experiment_scenes_test.py FOLDER
"""

import itertools
import math
import os
import sys
import unittest

from glb_file import GlbFile

FOLDER = sys.argv[1]
ANGLE = 1e-4  # rad; positions are float
DISTANCE = 1e-4  # metres; a tenth of the gap under glass
SMOOTH = math.cos(math.radians(30))
SCENES = {"axis_aligned": 149, "hexagonal_room": 240, "egg_room": 2916, "egg_chair": 2916,
          "hexagonal": 308}


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normal(triangle):
    a, b, c = triangle
    direction = cross(subtract(b, a), subtract(c, a))
    return tuple(x / math.sqrt(dot(direction, direction)) for x in direction)


def place(node, point):
    """Rotation by a unit quaternion, then translation."""
    assert not {"scale", "matrix", "children"} & node.keys(), f"{node['name']}: not expected here"
    *axis, real = node.get("rotation", (0, 0, 0, 1))
    twice = tuple(2 * x for x in cross(axis, point))
    turned = (p + real * t + c for p, t, c in zip(point, twice, cross(axis, twice)))
    return tuple(p + t for p, t in zip(turned, node.get("translation", (0, 0, 0))))


def triangles(name, of=None):
    """World triangles of a scene, or of one of its objects."""
    scene = GlbFile(os.path.join(FOLDER, name + ".glb"))
    found = []
    for node in scene.json["nodes"]:
        if "mesh" not in node or of not in (None, node["name"]):
            continue
        for primitive in scene.json["meshes"][node["mesh"]]["primitives"]:
            flat = scene.values(primitive["attributes"]["POSITION"])
            points = [place(node, flat[i:i + 3]) for i in range(0, len(flat), 3)]
            corners = [points[i] for i in scene.values(primitive["indices"])]
            found += [tuple(corners[i:i + 3]) for i in range(0, len(corners), 3)]
    return found


def by_plane(faces):
    """Lists of faces in one plane, whichever way they face."""
    planes = {}
    for face in faces:
        n = normal(face)
        front = max(n, tuple(-x for x in n), key=lambda v: [round(x, 3) for x in v])
        key = tuple(round(x, 3) for x in front) + (round(dot(front, face[0]), 4),)
        planes.setdefault(tuple(x + 0.0 for x in key), []).append(face)
    return planes.values()


def overlap(a, b):
    """Whether two triangles of one plane share more than a border: no edge separates them."""
    n = normal(a)
    for face in (a, b):
        for i in range(3):
            edge = subtract(face[(i + 1) % 3], face[i])
            across = cross(edge, n)
            length = math.sqrt(dot(across, across))
            spans = [[dot(across, p) / length for p in other] for other in (a, b)]
            if min(spans[0]) > max(spans[1]) - DISTANCE or min(spans[1]) > max(spans[0]) - DISTANCE:
                return False
    return True


class ExperimentScenes(unittest.TestCase):
    def test_triangles_are_as_many_as_in_the_dissertation_where_that_says(self):
        self.assertEqual({name: len(triangles(name)) for name in SCENES}, SCENES)

    def test_faces_of_scene_1_are_parallel_or_perpendicular(self):
        normals = [normal(face) for face in triangles("axis_aligned")]
        for a, b in itertools.combinations(normals, 2):
            cosine = abs(dot(a, b))
            self.assertTrue(cosine < ANGLE or cosine > 1 - ANGLE, (a, b))

    def test_prisms_of_scene_2_are_hexagonal(self):
        for scene in ("hexagonal", "hexagonal_room"):
            sides = {tuple(round(x, 3) for x in normal(face))
                     for face in triangles(scene, "Table column")}
            self.assertEqual(len(sides), 6)
            for a in sides:
                nearest = max(dot(a, b) for b in sides if b != a)
                self.assertAlmostEqual(nearest, math.cos(math.radians(60)), places=2)

    def test_the_walls_of_scene_3_are_whole(self):
        self.assertEqual(len(triangles("egg_room", "Room")), 12)

    def test_the_chairs_of_scene_3_are_closed_smooth_surfaces_with_their_front_outside(self):
        for scene, count in (("egg_chair", 1344), ("egg_room", 1624)):
            edges, volume = {}, 0
            for face in triangles(scene, "Shell"):
                volume += dot(face[0], cross(face[1], face[2])) / 6
                for i in range(3):
                    edges[face[i], face[(i + 1) % 3]] = normal(face)
            self.assertEqual(len(edges), 3 * count)
            self.assertGreater(volume, 0)
            for (a, b), front in edges.items():
                self.assertIn((b, a), edges)
                self.assertGreater(dot(front, edges[b, a]), SMOOTH, (a, b))

    def test_no_two_faces_cover_each_other(self):
        for scene in SCENES:
            for faces in by_plane(triangles(scene)):
                for a, b in itertools.combinations(faces, 2):
                    self.assertFalse(overlap(a, b), f"{scene}: {a} and {b}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)

"""What the bundled scenes are built of: materials, simple solids, lamps and a camera.

Metres; Blender's axes (z up).  A solid is made without the faces that would lie in the plane of
what it stands on or hangs on, so that no two faces of a scene cover each other.
"""

import itertools
import math
import sys

import bpy
import mathutils

GLASS_GAP = 0.001  # m; real glass touches what carries it in a few points only, with air between


def principled(name, color, **inputs):
    """A Principled BSDF; inputs are named as Blender names them, with _ for a space."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*color, 1.0)
    for key, value in inputs.items():
        shader.inputs[key.replace("_", " ")].default_value = value
    return material


def matte(name, color):
    """Purely diffuse: no dielectric coat."""
    return principled(name, color, Specular=0.0, Roughness=1.0)


def mirror(name="Mirror", color=(0.92, 0.92, 0.92)):
    return principled(name, color, Metallic=1.0, Roughness=0.0)


def glass(name="Glass", color=(1.0, 1.0, 1.0)):
    return principled(name, color, Transmission=1.0, Roughness=0.0, IOR=1.5)


def glowing(name, color, radiance):
    """Shines from the front of its faces, radiance x color, W/(m2 sr)."""
    emission = {"Emission": (*color, 1.0), "Emission_Strength": radiance}
    material = principled(name, (0, 0, 0), Specular=0.0, Roughness=1.0, **emission)
    material.use_backface_culling = True
    return material


def add_mesh(name, vertices, polygons, materials, smooth=False):
    """polygons: (material index, corners), counter-clockwise from the front."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], [corners for _, corners in polygons])
    for material in materials:
        mesh.materials.append(material)
    mesh.polygons.foreach_set("material_index", [material for material, _ in polygons])
    mesh.polygons.foreach_set("use_smooth", [smooth] * len(polygons))
    placed = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(placed)
    return placed


def add_faces(name, vertices, corners_of, material, without=(), other=None):
    """corners_of: {face name: corners}.  other: {face name: its material} where it differs."""
    materials, polygons = [material], []
    for face, corners in corners_of.items():
        if face in without:
            continue
        worn = (other or {}).get(face, material)
        if worn not in materials:
            materials.append(worn)
        polygons.append((materials.index(worn), corners))
    return add_mesh(name, vertices, polygons, materials)


def add_box(name, low, high, material, without=(), other=None):
    """Faces: left, right (-x, +x), front, back (-y, +y), bottom, top (-z, +z)."""
    vertices = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1])
                for x in (low[0], high[0])]
    corners_of = {"bottom": (0, 2, 3, 1), "top": (4, 5, 7, 6), "front": (0, 1, 5, 4),
                  "right": (1, 3, 7, 5), "back": (3, 2, 6, 7), "left": (2, 0, 4, 6)}
    return add_faces(name, vertices, corners_of, material, without, other)


def add_room(low, high, wall, other, cell=math.inf):
    """A box seen from inside, faces named as the box's, divided into cells about so many m wide."""
    counts = [max(1, round((h - l) / cell)) for l, h in zip(low, high)]
    steps = [[l + (h - l) * i / n for i in range(n + 1)] for l, h, n in zip(low, high, counts)]
    materials, polygons, numbers = [wall, *other.values()], [], {}
    for place, name in enumerate(("left", "right", "front", "back", "bottom", "top")):
        axis, far = divmod(place, 2)
        u, v = (axis + 1) % 3, (axis + 2) % 3
        material = materials.index(other.get(name, wall))
        for i, j in itertools.product(range(counts[u]), range(counts[v])):
            corners = []
            for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                at = {axis: far * counts[axis], u: i + du, v: j + dv}
                corner = tuple(steps[k][at[k]] for k in range(3))
                corners.append(numbers.setdefault(corner, len(numbers)))
            polygons.append((material, corners[::-1] if far else corners))
    return add_mesh("Room", list(numbers), polygons, materials)


def add_prism(name, base, radius, height, material, without=(), other=None, turn_deg=0.0):
    """Upright hexagonal prism; radius: to a corner.  Faces: side0 to side5, bottom, top."""
    angles = [math.radians(60 * i + turn_deg) for i in range(6)]
    vertices = [(base[0] + radius * math.cos(a), base[1] + radius * math.sin(a), base[2] + z)
                for z in (0, height) for a in angles]
    corners_of = {f"side{i}": (i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i) for i in range(6)}
    corners_of["bottom"] = (5, 4, 3, 2, 1, 0)
    corners_of["top"] = (6, 7, 8, 9, 10, 11)
    return add_faces(name, vertices, corners_of, material, without, other)


def add_rings(name, rings, material, start=None, end=None):
    """A smooth surface through rings of equally many points each, counter-clockwise as seen from
    the end.  start, end: the points that close it; open without them."""
    count = len(rings[0])
    vertices = [point for ring in rings for point in ring]
    polygons = []
    for ring in range(len(rings) - 1):
        for i in range(count):
            a, b = ring * count + i, ring * count + (i + 1) % count
            polygons.append((0, (a, b, b + count, a + count)))
    last = (len(rings) - 1) * count
    if start is not None:
        polygons += [(0, (len(vertices), (i + 1) % count, i)) for i in range(count)]
        vertices.append(start)
    if end is not None:
        polygons += [(0, (len(vertices), last + i, last + (i + 1) % count)) for i in range(count)]
        vertices.append(end)
    return add_mesh(name, vertices, polygons, [material], smooth=True)


def add_turned(name, centre, profile, segments, material):
    """A surface of revolution about the upright axis through centre.  profile: (radius, height)
    from one end to the other; a radius of 0 at an end closes it.  Upwards: front outside."""
    def point(radius, height, i):
        angle = 2 * math.pi * i / segments
        return (centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle),
                centre[2] + height)

    closed = [profile[0][0] == 0, profile[-1][0] == 0]
    inner = profile[closed[0]:len(profile) - closed[1]]
    rings = [[point(radius, height, i) for i in range(segments)] for radius, height in inner]
    ends = [point(*profile[at], 0) if closed[at] else None for at in (0, -1)]
    return add_rings(name, rings, material, *ends)


def icosphere(radius, divisions):
    """(vertices, triangles) of a geodesic sphere of 20 * 4^divisions triangles, fronts outside."""
    golden = (1 + math.sqrt(5)) / 2
    vertices = []
    for a, b in itertools.product((-1, 1), (-golden, golden)):
        vertices += [(0, a, b), (a, b, 0), (b, 0, a)]
    vertices = [mathutils.Vector(v).normalized() for v in vertices]
    edge = min((vertices[0] - v).length for v in vertices[1:]) * 1.1
    triangles = []
    for corners in itertools.combinations(range(12), 3):
        a, b, c = (vertices[i] for i in corners)
        if max((a - b).length, (b - c).length, (c - a).length) < edge:
            front = (b - a).cross(c - a).dot(a) > 0
            triangles.append(corners if front else corners[::-1])
    for _ in range(divisions):
        triangles = divided(vertices, triangles)
    return [tuple(radius * v) for v in vertices], triangles


def divided(vertices, triangles):
    """Each triangle as four, the new corners pushed out to the unit sphere."""
    middles = {}

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in middles:
            middles[key] = len(vertices)
            vertices.append((vertices[a] + vertices[b]).normalized())
        return middles[key]

    out = []
    for a, b, c in triangles:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        out += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return out


def add_icosphere(name, centre, radius, divisions, material, inward=False):
    """Of flat triangles.  inward: fronts face the centre."""
    vertices, triangles = icosphere(radius, divisions)
    polygons = [(0, corners[::-1] if inward else corners) for corners in triangles]
    sphere = add_mesh(name, vertices, polygons, [material])
    sphere.location = centre
    return sphere


def add_point_lamp(name, location, watts, color):
    lamp = bpy.data.objects.new(name, bpy.data.lights.new(name, "POINT"))
    lamp.data.energy = watts
    lamp.data.color = color
    lamp.location = location
    bpy.context.collection.objects.link(lamp)


def add_camera(location, target, lens, aspect=4 / 3):
    """lens: mm on a sensor 36 mm wide."""
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.lens = lens
    camera.location = location
    view = mathutils.Vector(target) - mathutils.Vector(location)
    camera.rotation_euler = view.to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(camera)
    scene = bpy.context.scene
    scene.camera = camera
    scene.render.resolution_x, scene.render.resolution_y = round(768 * aspect), 768


def build(add_scene, normals=True):
    """Runs add_scene in an empty Blender and exports to the file named after `--`.  normals: else
    none are written, and all faces are flat."""
    output = sys.argv[sys.argv.index("--") + 1]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    add_scene()
    bpy.ops.export_scene.gltf(
        filepath=output, export_format="GLB", export_cameras=True, export_lights=True,
        export_normals=normals)

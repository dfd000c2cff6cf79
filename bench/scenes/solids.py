"""Builds polygon meshes: boxes with bevels, lofts, turned profiles, tubes, sheets.

Lengths are metres, +Y is up. A polygon's front is where its corners run counter-clockwise.
"""

import math

import vectors as v3


class Solid:
    """Points and polygons. A polygon may carry texture coordinates, in metres, for its corners."""

    def __init__(self, points=(), faces=(), uvs=None):
        self.points = list(points)
        self.faces = list(faces)
        self.uvs = list(uvs) if uvs is not None else [None] * len(self.faces)

    def mapped(self, function):
        """A copy with every point replaced by function(point)."""
        return Solid([function(p) for p in self.points], self.faces, self.uvs)

    def moved(self, x=0.0, y=0.0, z=0.0):
        return self.mapped(lambda p: (p[0] + x, p[1] + y, p[2] + z))

    def scaled(self, x, y=None, z=None):
        y, z = (x if y is None else y), (x if z is None else z)
        return self.mapped(lambda p: (p[0] * x, p[1] * y, p[2] * z))

    def turned(self, axis, degrees):
        """A copy turned about the axis "x", "y" or "z" by the right-hand rule."""
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        rules = {"x": lambda p: (p[0], c * p[1] - s * p[2], s * p[1] + c * p[2]),
                 "y": lambda p: (c * p[0] + s * p[2], p[1], c * p[2] - s * p[0]),
                 "z": lambda p: (c * p[0] - s * p[1], s * p[0] + c * p[1], p[2])}
        return self.mapped(rules[axis])

    def flipped(self):
        """A copy whose polygons face the other way."""
        return Solid(self.points, [face[::-1] for face in self.faces],
                     [uv[::-1] if uv else None for uv in self.uvs])

    def displaced(self, distance):
        """A copy with each point moved along its normal by distance(point)."""
        normals = point_normals(self)
        return Solid([v3.along(p, n, distance(p)) for p, n in zip(self.points, normals)],
                     self.faces, self.uvs)


def joined(solids):
    """One solid of several; their points stay apart."""
    points, faces, uvs = [], [], []
    for solid in solids:
        first = len(points)
        points += solid.points
        faces += [tuple(first + i for i in face) for face in solid.faces]
        uvs += solid.uvs
    return Solid(points, faces, uvs)


def face_normal(points, face):
    """The normal of a polygon by Newell's method, twice its area long."""
    x = y = z = 0.0
    a = points[face[-1]]
    for index in face:
        b = points[index]
        x += (a[1] - b[1]) * (a[2] + b[2])
        y += (a[2] - b[2]) * (a[0] + b[0])
        z += (a[0] - b[0]) * (a[1] + b[1])
        a = b
    return x, y, z


def point_normals(solid):
    """Unit normals of the points, averaged over their polygons by area."""
    sums = [[0.0, 0.0, 0.0] for _ in solid.points]
    for face in solid.faces:
        normal = face_normal(solid.points, face)
        for index in face:
            total = sums[index]
            total[0] += normal[0]
            total[1] += normal[1]
            total[2] += normal[2]
    return [v3.unit(total) for total in sums]


def _lengths(points, closed):
    """Distances along a line of points, from 0; of a closed line also back to its start."""
    total, result = 0.0, [0.0]
    ends = points[1:] + points[:1] if closed else points[1:]
    for a, b in zip(points, ends):
        total += math.dist(a, b)
        result.append(total)
    return result


def loft(rings, wrap=False, caps=True, open_rings=False):
    """Joins rings of points, counter-clockwise as seen from the last one, by quads.

    A ring of one point is a pole. `wrap` also joins the last ring to the first, as in a torus;
    `open_rings` leaves out the quads from the last point of a ring to its first.
    """
    widest = max(rings, key=lambda ring: _lengths(ring, True)[-1])
    across = _lengths(widest, not open_rings)
    ups = [0.0]
    for a, b in zip(rings, rings[1:] + rings[:1]):
        ups.append(ups[-1] + math.dist(a[0], b[0]))
    first, points = [], []
    for ring in rings:
        first.append(len(points))
        points += ring
    solid, count = Solid(points), len(widest)
    for k in range(len(rings) if wrap else len(rings) - 1):
        after = (k + 1) % len(rings)
        _add_band(solid, (first[k], len(rings[k])), (first[after], len(rings[after])),
                  count if not open_rings else count - 1, (across, ups[k], ups[k + 1]))
    if caps and not wrap:
        if len(rings[0]) > 2:
            solid.faces.append(tuple(reversed(range(len(rings[0])))))
        if len(rings[-1]) > 2:
            solid.faces.append(tuple(first[-1] + i for i in range(len(rings[-1]))))
        solid.uvs += [None] * (len(solid.faces) - len(solid.uvs))
    return solid


def _add_band(solid, low, high, quads, texture):
    """Quads between two rings, or triangles where one of them is a pole."""
    (a, na), (b, nb), (across, v0, v1) = low, high, texture
    for i in range(quads):
        j = i + 1
        u0, u1 = across[i], across[j]
        if na == 1:
            solid.faces.append((a, b + j % nb, b + i))
            solid.uvs.append((((u0 + u1) / 2, v0), (u1, v1), (u0, v1)))
        elif nb == 1:
            solid.faces.append((a + i, a + j % na, b))
            solid.uvs.append(((u0, v0), (u1, v0), ((u0 + u1) / 2, v1)))
        else:
            solid.faces.append((a + i, a + j % na, b + j % nb, b + i))
            solid.uvs.append(((u0, v0), (u1, v0), (u1, v1), (u0, v1)))


def circle(radius, count, y=0.0, phase=0.0):
    """Points around the Y axis, counter-clockwise from above."""
    return [(radius * math.cos(phase + 2 * math.pi * i / count), y,
             -radius * math.sin(phase + 2 * math.pi * i / count)) for i in range(count)]


def lathe(profile, segments, wrap=False, caps=False):
    """A turned shape about the Y axis: profile is (radius, y), upwards along the outside."""
    rings = [circle(r, segments, y) if r > 0 else [(0.0, y, 0.0)] for r, y in profile]
    return loft(rings, wrap, caps)


def smooth_line(corners, steps):
    """Points of a Catmull-Rom spline through corners of any dimension, `steps` for each span."""
    result = []
    last = len(corners) - 1
    for k in range(last):
        p = [corners[max(0, min(last, k + d))] for d in (-1, 0, 1, 2)]
        for step in range(steps):
            t = step / steps
            result.append(tuple(
                b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)))
                for a, b, c, d in zip(*p)))
    return result + [tuple(corners[-1])]


def tube(path, radius, sides, closed=False, caps=True):
    """A pipe along a path; radius is a number or one for each point of the path."""
    count = len(path)
    radii = radius if isinstance(radius, (list, tuple)) else [radius] * count
    rings, normal = [], None
    for i, point in enumerate(path):
        before = path[i - 1] if i or closed else point
        after = path[(i + 1) % count] if i + 1 < count or closed else point
        tangent = v3.unit(v3.sub(after, before))
        if normal is None:
            normal = v3.perpendicular(tangent)
        normal = v3.unit(v3.along(normal, tangent, -v3.dot(normal, tangent)))
        side = v3.cross(tangent, normal)
        rings.append([v3.along(v3.along(point, normal, radii[i] * math.cos(angle)), side,
                               radii[i] * math.sin(angle))
                      for angle in (2 * math.pi * k / sides for k in range(sides))])
    return loft(rings, closed, caps)


def extrude(outline, depth, chamfer=0.0):
    """A prism from z = 0 to depth; outline is (x, y), counter-clockwise from +z.

    A chamfer cuts both rims at 45 degrees; it must be smaller than half of every edge.
    """
    if chamfer == 0:
        return loft([[(x, y, z) for x, y in outline] for z in (0.0, depth)])
    small = inset(outline, chamfer)
    rings = ((small, 0.0), (outline, chamfer), (outline, depth - chamfer), (small, depth))
    return loft([[(x, y, z) for x, y in line] for line, z in rings])


def extrude_ring(outer, inner, depth):
    """A prism with a hole, from z = 0 to depth; both outlines have as many points."""
    rings = ((inner, 0.0), (outer, 0.0), (outer, depth), (inner, depth))
    return loft([[(x, y, z) for x, y in line] for line, z in rings], wrap=True)


def inset(outline, distance):
    """A counter-clockwise outline moved inwards by a distance."""
    result = []
    for i, (x, y) in enumerate(outline):
        (px, py), (nx, ny) = outline[i - 1], outline[(i + 1) % len(outline)]
        a = v3.unit((y - py, px - x, 0))  # normals to the right: outwards
        b = v3.unit((ny - y, x - nx, 0))
        share = distance / (1 + a[0] * b[0] + a[1] * b[1])
        result.append((x - share * (a[0] + b[0]), y - share * (a[1] + b[1])))
    return result


def disc_outline(radius, count, phase=0.0):
    """Corners (x, y) of a regular polygon."""
    return [(radius * math.cos(phase + 2 * math.pi * i / count),
             radius * math.sin(phase + 2 * math.pi * i / count)) for i in range(count)]


def sheet(columns, rows, place, wrap=False):
    """An open grid of quads: place(u, v) is the point at u, v from 0 to 1; front is du x dv."""
    across = columns if wrap else columns + 1
    points = [place(i / columns, j / rows) for j in range(rows + 1) for i in range(across)]
    wide = _lengths(points[:across], wrap)
    high = _lengths(points[::across], False)
    faces, uvs = [], []
    for j in range(rows):
        for i in range(columns):
            a, b = j * across + i, j * across + (i + 1) % across
            faces.append((a, b, b + across, a + across))
            uvs.append(tuple((wide[i + p], high[j + q]) for p, q in ((0, 0), (1, 0), (1, 1), (0, 1))))
    return Solid(points, faces, uvs)


def rectangle(corner, right, up):
    """One quad from its lower left corner; the front is where right and up run counter-clockwise."""
    points = [tuple(c + i * r + j * u for c, r, u in zip(corner, right, up))
              for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    wide, high = math.hypot(*right), math.hypot(*up)
    return Solid(points, [(0, 1, 2, 3)], [((0, 0), (wide, 0), (wide, high), (0, high))])


BOX_FACES = {"bottom": (0, 3, 2, 1), "top": (4, 5, 6, 7), "front": (0, 1, 5, 4),
             "right": (1, 2, 6, 5), "back": (2, 3, 7, 6), "left": (3, 0, 4, 7)}


def box(x, y, z, without=()):
    """A sharp box on y = 0, centred on the Y axis; `without` names the sides to leave out."""
    points = [(sx * x / 2, h, sz * z / 2) for h in (0.0, y)
              for sx, sz in ((-1, 1), (1, 1), (1, -1), (-1, -1))]
    return Solid(points, [face for name, face in BOX_FACES.items() if name not in without])


def bevelled_box(x, y, z, bevel, segments=3):
    """A box on y = 0 with round edges; one segment gives chamfers of 45 degrees.

    The octants of a sphere of latitudes and longitudes, moved apart.
    """
    steps = segments + 1
    half = (x / 2 - bevel, y / 2 - bevel, z / 2 - bevel)
    rings = []
    for row in range(2 * steps):
        hemisphere, step = divmod(row, steps)
        latitude = (step / segments + hemisphere - 1) * math.pi / 2
        ring = []
        for column in range(4 * steps):
            quadrant, step = divmod(column, steps)
            a = (quadrant + step / segments) * math.pi / 2
            sx, sz = (1, -1, -1, 1)[quadrant], (-1, -1, 1, 1)[quadrant]
            ring.append((sx * half[0] + bevel * math.cos(latitude) * math.cos(a),
                         y / 2 + (2 * hemisphere - 1) * half[1] + bevel * math.sin(latitude),
                         sz * half[2] - bevel * math.cos(latitude) * math.sin(a)))
        rings.append(ring)
    return merged(loft(rings))


def merged(solid, distance=1e-7):
    """A copy without double points, and without polygons that collapse to a line."""
    index, points, new = {}, [], []
    for p in solid.points:
        key = tuple(round(c / distance) for c in p)
        if key not in index:
            index[key] = len(points)
            points.append(p)
        new.append(index[key])
    faces, uvs = [], []
    for face, uv in zip(solid.faces, solid.uvs):
        corners = [new[i] for i in face]
        keep = [k for k, c in enumerate(corners) if c != corners[k - 1]]
        if len(keep) >= 3:
            faces.append(tuple(corners[k] for k in keep))
            uvs.append(tuple(uv[k] for k in keep) if uv else None)
    return Solid(points, faces, uvs)


def soft_box(size, radius, cells, puff=0.0):
    """A box of grids of quads about the origin with round edges; `puff` swells its sides."""
    half = [s / 2 for s in size]
    counts = [max(4, round(cells * s / max(size))) for s in size]

    def place(lattice):
        p = [h * (2 * i / n - 1) for h, i, n in zip(half, lattice, counts)]
        inner = [max(radius - h, min(h - radius, c)) for h, c in zip(half, p)]
        out = v3.unit([a - b for a, b in zip(p, inner)])
        swell = [math.cos(math.pi / 2 * c / h) for c, h in zip(p, half)]
        bulge = [puff * swell[(k + 1) % 3] * swell[(k + 2) % 3] for k in range(3)]
        return tuple(i + (radius + b) * o for i, o, b in zip(inner, out, bulge))

    solids = []
    for axis in range(3):
        u, w = (axis + 1) % 3, (axis + 2) % 3
        for end in (0, counts[axis]):
            def corner(i, j, axis=axis, u=u, w=w, end=end):
                lattice = [0, 0, 0]
                lattice[axis], lattice[u], lattice[w] = end, round(i * counts[u]), round(j * counts[w])
                return place(lattice)
            side = sheet(counts[u], counts[w], corner)
            solids.append(side if end else side.flipped())
    return merged(joined(solids), 1e-6)


def ball(radius, segments, squash=1.0):
    """A sphere of latitudes and longitudes about the origin."""
    rows = max(4, segments // 2)
    profile = [(radius * math.sin(math.pi * k / rows) if 0 < k < rows else 0.0,
                -squash * radius * math.cos(math.pi * k / rows)) for k in range(rows + 1)]
    return lathe(profile, segments)


def vessel(outside, inside, segments):
    """A closed thick vessel: profiles (radius, y) of both sides, each from the axis up to the rim."""
    return lathe(list(outside) + list(reversed(inside)), segments)


def rounded_outline(width, height, radius, steps):
    """Corners (x, y) of a rectangle about the origin with round corners, counter-clockwise."""
    centres = ((1, 1), (-1, 1), (-1, -1), (1, -1))
    return [(sx * (width / 2 - radius) + radius * math.cos(a),
             sy * (height / 2 - radius) + radius * math.sin(a))
            for k, (sx, sy) in enumerate(centres)
            for a in ((k + i / steps) * math.pi / 2 for i in range(steps + 1))]


def level(outline, y, x=0.0, z=0.0):
    """An outline laid flat at a height, as a ring for loft() from below to above."""
    return [(x + a, y, z - b) for a, b in outline]

"""Rooms with nasty glass, mirrors and metals; adds them to rooms.ROOMS."""

from room import WALLS, Room, box, quad, triangles_of, turned
from rooms import family, nasty

SLAB = ((-0.7, 0, -0.7), (0.7, 0.1, 0.5))


def ball_of(ior):
    room = Room()
    room.add_ball(room.glass(ior), (0, 0.7, -0.2), 0.5)
    return room


family("glass_ball_of_index", ball_of, (1, 1.0001, 1.33, 2.4, 10, 100),
       "a glass ball of facets, of index")


@nasty
def slab_on_floor():
    """a glass slab that lies exactly on the floor"""
    room = Room()
    room.add_box(room.glass(), *SLAB)
    return room


@nasty
def pane_on_floor():
    """an open pane of glass that lies exactly on the floor"""
    room = Room()
    room.add("Pane", room.glass(), triangles_of(quad((-0.7, 0, 0.5), (1.4, 0, 0), (0, 0, -1.2))))
    return room


@nasty
def see_through_decal_on_wall():
    """a poster that covers half of the light, in the plane of the back wall"""
    room = Room()
    decal = room.material("Decal", (0.1, 0.1, 0.3), alphaMode="BLEND",
                          base={"baseColorFactor": [0.1, 0.1, 0.3, 0.5]})
    room.add("Decal", decal, triangles_of(quad((-0.63, 0.31, -1), (1.1, 0, 0), (0, 0.97, 0))))
    return room


@nasty
def leaf_on_floor():
    """a sheet that transmits diffusely and lies exactly on the floor"""
    room = Room()
    leaf = room.material("Leaf", (0.4, 0.6, 0.3), extensions={
        "KHR_materials_diffuse_transmission": {"diffuseTransmissionFactor": 0.5}})
    room.add("Leaf", leaf, triangles_of(quad((-0.7, 0, 0.5), (1.4, 0, 0), (0, 0, -1.2))))
    return room


@nasty
def fog_flush_with_walls():
    """fog whose bounds are the walls"""
    room = Room()
    fog = room.material("Fog", (1, 1, 1), extras={"hipmap": {
        "boundary": False, "medium": {"scattering": [0.2, 0.2, 0.2]}}})
    room.add_box(fog, (-1, 0, -1), (1, 2, 1))
    return room


@nasty
def slab_before_floor():
    """the same, the slab's faces before the floor's in the file"""
    room = Room(without=("floor",))
    room.add_box(room.glass(), *SLAB)
    room.add("Floor", room.grey, triangles_of(quad((-1, 0, 1), (2, 0, 0), (0, 0, -2))))
    return room


@nasty
def slab_on_slanted_floor():
    """a glass slab on a floor that rounding keeps from being exactly where the slab is"""
    room = Room()
    up, right, deep = (0.1, 0.95, -0.1), (1.3, -0.1370, -0.0015), (-0.0115, -0.1264, -1.2126)
    corner = (-0.6, 0.3, 0.5)
    room.add("Slanted", room.grey, triangles_of(quad(
        tuple(c - 0.1 * r - 0.1 * d for c, r, d in zip(corner, right, deep)),
        tuple(1.2 * x for x in right), tuple(1.2 * x for x in deep))))
    sides = slab_sides(corner, right, deep, tuple(0.1 * x for x in up))
    room.add("Slab", room.glass(), sides)
    return room


def slab_sides(corner, right, deep, up):
    """A slanted box from outside, its bottom spanned by right and deep."""
    def at(i, j, k):
        return tuple(c + i * r + j * d + k * u for c, r, d, u in zip(corner, right, deep, up))
    round_it = (((0, 0), (1, 0)), ((1, 0), (1, 1)), ((1, 1), (0, 1)), ((0, 1), (0, 0)))
    quads = [(at(*a, 0), at(*b, 0), at(*b, 1), at(*a, 1)) for a, b in round_it]
    quads += [tuple(at(*ij, 1) for ij in ((0, 0), (1, 0), (1, 1), (0, 1))),
              tuple(at(*ij, 0) for ij in ((0, 1), (1, 1), (1, 0), (0, 0)))]
    return [part for a, b, c, d in quads for part in ((a, b, c), (a, c, d))]


@nasty
def glass_sunk_into_floor():
    """a glass box of which the lower third is below the floor"""
    room = Room()
    room.add_box(room.glass(), (-0.5, -0.3, -0.6), (0.4, 0.6, 0.2))
    return room


@nasty
def glass_ball_on_floor():
    """a glass ball that touches the floor in a point"""
    room = Room()
    room.add_ball(room.glass(), (0, 0.5, -0.2), 0.5)
    return room


@nasty
def water_in_glass():
    """water whose faces are those of the glass around it"""
    room = Room()
    outer, inner = ((-0.5, 0.3, -0.6), (0.5, 1.1, 0.3)), ((-0.4, 0.4, -0.5), (0.4, 1.0, 0.2))
    room.add("Glass", room.glass(1.5),
             triangles_of(box(*outer)) + turned(triangles_of(box(*inner))))
    room.add_box(room.glass(1.33), *inner, name="Water")
    return room


@nasty
def glass_boxes_touching():
    """two glass boxes that share a side"""
    room = Room()
    room.add_box(room.glass(1.5), (-0.6, 0.3, -0.5), (0, 1.1, 0.2))
    room.add_box(room.glass(1.8), (0, 0.3, -0.5), (0.6, 1.1, 0.2))
    return room


@nasty
def glass_box_twice():
    """a glass box that is there twice, in the same place"""
    room = Room()
    glass = room.glass()
    for _ in range(2):
        room.add_box(glass, (-0.5, 0.3, -0.5), (0.5, 1.1, 0.2))
    return room


@nasty
def open_glass():
    """a glass box without its front and lid"""
    room = Room()
    sides = triangles_of(box((-0.5, 0.2, -0.6), (0.5, 1.1, 0.2)))
    room.add("Open", room.glass(), sides[2:8] + sides[10:])
    return room


@nasty
def camera_in_glass():
    """a camera inside a glass box"""
    room = Room()
    room.add_box(room.glass(), (-0.4, 0.7, 0.5), (0.4, 1.3, 0.98))
    return room


@nasty
def room_full_of_water():
    """a camera in water that fills the room up to the light, its faces those of the walls"""
    room = Room()
    room.add_box(room.glass(1.2), (-1, 0, -1), (1, 1.8, 1))
    return room


@nasty
def camera_on_glass():
    """a camera exactly on the side of a glass box"""
    room = Room()
    room.add_box(room.glass(), (-0.5, 0.6, 0.2), (0.5, 1.4, 0.95))
    return room


@nasty
def camera_on_wall():
    """a camera exactly on the front wall"""
    room = Room()
    room.camera = (0, 1, 1)
    return room


@nasty
def camera_on_corner():
    """a camera exactly on a vertex of the room"""
    room = Room()
    room.camera = (1, 0, 1)
    return room


@nasty
def mirror_corridor():
    """two mirrors, 2 cm apart, that the camera looks into and the light does not"""
    room = Room()
    mirror = room.metal(0)
    for x, faces in ((-0.01, 1), (0.01, -1)):
        sheet = triangles_of(quad((x, 0.2, 0.9), (0, 0, -1.6), (0, 1.5, 0)))
        room.add("Mirror", mirror, sheet if faces > 0 else turned(sheet))
    return room


@nasty
def mirror_room():
    """all walls but the floor are mirrors"""
    room = Room(without=("ceiling", "back", "front", "left", "right"))
    mirror = room.metal(0, (0.8, 0.8, 0.8))
    for name, corners in WALLS.items():
        if name != "floor":
            room.add(name, mirror, triangles_of(quad(*corners)))
    return room


def metal_of(roughness):
    room = Room()
    room.add_box(room.metal(roughness), (-0.5, 0, -0.6), (0.3, 0.9, 0.1))
    return room


family("metal_of_roughness", metal_of, (0, 1e-4, 0.02, 0.3, 0.300001, 1), "a metal of roughness")


def plastic_of(roughness):
    room = Room()
    plastic = room.material("Plastic", (0.5, 0.2, 0.2), base={"roughnessFactor": roughness},
                            extensions={"KHR_materials_ior": {"ior": 1.5}})
    room.add_box(plastic, (-0.5, 0, -0.6), (0.3, 0.9, 0.1))
    return room


family("plastic_of_roughness", plastic_of, (0, 0.3, 1), "a plastic of roughness")


@nasty
def light_on_glass():
    """a light that lies exactly on a glass slab"""
    room = Room(light=None)
    room.add_box(room.glass(), (-0.5, 1.3, -0.5), (0.5, 1.5, 0.3))
    room.add("Light", room.glowing(5), triangles_of(quad((-0.4, 1.3, -0.4), (0.8, 0, 0),
                                                         (0, 0, 0.6))))
    return room


@nasty
def light_in_glass():
    """a light inside a glass box"""
    room = Room(light=None)
    room.add_box(room.glass(), (-0.5, 1.1, -0.6), (0.5, 1.7, 0.3))
    room.add("Light", room.glowing(5), triangles_of(quad((-0.4, 1.4, -0.4), (0.8, 0, 0),
                                                         (0, 0, 0.6))))
    return room


@nasty
def glowing_glass():
    """a glass box whose faces emit"""
    room = Room(light=None)
    glow = room.material("Glow", (1, 1, 1), base={"roughnessFactor": 0}, emissiveFactor=[1, 1, 1],
                         extensions={"KHR_materials_transmission": {"transmissionFactor": 1},
                                     "KHR_materials_ior": {"ior": 1.5}})
    room.add_box(glow, (-0.4, 0.8, -0.6), (0.4, 1.5, 0.1))
    return room

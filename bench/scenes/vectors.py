"""Vectors of three numbers as tuples, and value noise."""

import functools
import math


def sub(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def along(p, direction, distance):
    return (p[0] + distance * direction[0], p[1] + distance * direction[1],
            p[2] + distance * direction[2])


def unit(a):
    """A vector of length 1; (0, 1, 0) for the zero vector."""
    length = math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])
    return (a[0] / length, a[1] / length, a[2] / length) if length > 0 else (0.0, 1.0, 0.0)


def perpendicular(a):
    """A unit vector at right angles to a."""
    other = (1.0, 0.0, 0.0) if abs(a[0]) < 0.6 else (0.0, 1.0, 0.0)
    return unit(cross(a, other))


def axis_turn(axis, degrees):
    """The quaternion (x, y, z, w) of a turn about a unit axis by the right-hand rule."""
    s = math.sin(math.radians(degrees) / 2)
    return axis[0] * s, axis[1] * s, axis[2] * s, math.cos(math.radians(degrees) / 2)


def turn_onto(direction):
    """The quaternion that turns -Z onto a direction and keeps X level, as a light or camera needs."""
    d = unit(direction)
    x = unit(cross(d, (0.0, 1.0, 0.0))) if abs(d[1]) < 0.9999 else (1.0, 0.0, 0.0)
    z = (-d[0], -d[1], -d[2])
    y = cross(z, x)
    trace = x[0] + y[1] + z[2]
    if trace > 0:
        s = 2 * math.sqrt(trace + 1)
        return (y[2] - z[1]) / s, (z[0] - x[2]) / s, (x[1] - y[0]) / s, s / 4
    if x[0] >= y[1] and x[0] >= z[2]:
        s = 2 * math.sqrt(1 + x[0] - y[1] - z[2])
        return s / 4, (x[1] + y[0]) / s, (z[0] + x[2]) / s, (y[2] - z[1]) / s
    if y[1] >= z[2]:
        s = 2 * math.sqrt(1 + y[1] - x[0] - z[2])
        return (x[1] + y[0]) / s, s / 4, (y[2] + z[1]) / s, (z[0] - x[2]) / s
    s = 2 * math.sqrt(1 + z[2] - x[0] - y[1])
    return (z[0] + x[2]) / s, (y[2] + z[1]) / s, s / 4, (x[1] - y[0]) / s


@functools.lru_cache(1 << 16)  # neighbouring points share corners
def _lattice(x, y, z):
    h = (x * 374761393 + y * 668265263 + z * 2147483647 + 1013904223) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
    return ((h ^ (h >> 16)) & 0xFFFF) / 32767.5 - 1


def noise(x, y, z=0.0, period=0):
    """Smooth value noise from -1 to 1 on the integer lattice; repeats after `period` if above 0."""
    ix, iy, iz = math.floor(x), math.floor(y), math.floor(z)
    fx, fy, fz = x - ix, y - iy, z - iz
    fx, fy, fz = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy), fz * fz * (3 - 2 * fz)
    jx, jy = ix + 1, iy + 1
    if period:
        ix, iy, jx, jy = ix % period, iy % period, jx % period, jy % period

    def plane(k):
        a, b = _lattice(ix, iy, k), _lattice(jx, iy, k)
        c, d = _lattice(ix, jy, k), _lattice(jx, jy, k)
        low, high = a + fx * (b - a), c + fx * (d - c)
        return low + fy * (high - low)

    near = plane(iz)
    return near if fz == 0 else near + fz * (plane(iz + 1) - near)


def layers(x, y, z=0.0, octaves=3, period=0):
    """A sum of octaves of noise, each of half the size and strength of the one before."""
    total, strength = 0.0, 0.5
    for octave in range(octaves):
        scale = 1 << octave
        total += strength * noise(x * scale, y * scale, z * scale, period * scale)
        strength /= 2
    return total

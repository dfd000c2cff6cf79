# SPDX-License-Identifier: GPL-3.0-or-later
"""Cameras: glTF's, and the custom properties for what glTF lacks."""

import math

from mathutils import Vector

_MILLIMETRE = 1e-3


def _is_wide(camera, aspect):
    """Whether the sensor's width is what the picture's width sees."""
    return camera.sensor_fit == "HORIZONTAL" or (camera.sensor_fit == "AUTO" and aspect >= 1)


def _sensor(camera):
    """The size that the angle of view belongs to, mm."""
    return camera.sensor_height if camera.sensor_fit == "VERTICAL" else camera.sensor_width


def gltf_camera(camera, aspect):
    """Returns the entry of a perspective or orthographic camera; None: glTF has no such camera.
    aspect: width / height of the picture, with the pixels' own."""
    clip = {"znear": camera.clip_start, "zfar": camera.clip_end}
    wide = _is_wide(camera, aspect)
    if camera.type == "PERSP":
        half = 0.5 * _sensor(camera) / camera.lens
        yfov = 2 * math.atan(half / aspect if wide else half)
        return {"name": camera.name, "type": "perspective",
                "perspective": {"yfov": yfov, "aspectRatio": aspect, **clip}}
    if camera.type == "ORTHO":
        half_height = 0.5 * camera.ortho_scale / (aspect if wide else 1)
        return {"name": camera.name, "type": "orthographic",
                "orthographic": {"xmag": half_height * aspect, "ymag": half_height, **clip}}
    return None


def _focus_distance(item, matrix):
    dof = item.data.dof
    if dof.focus_object is None:
        return dof.focus_distance
    to_focus = dof.focus_object.matrix_world.translation - matrix.translation
    forward = (matrix.to_3x3() @ Vector((0, 0, -1))).normalized()
    return abs(to_focus.dot(forward))


def camera_extras(item, matrix):
    """Returns the custom property `hipmap` of a camera's object: its lens, if depth of field is
    on.  matrix: to the world."""
    camera = item.data
    if camera.type != "PERSP" or not camera.dof.use_dof or camera.dof.aperture_fstop <= 0:
        return {}
    return {"aperture_radius": 0.5 * camera.lens * _MILLIMETRE / camera.dof.aperture_fstop,
            "focus_distance": _focus_distance(item, matrix)}


def camera_losses(item):
    """Yields what hipmap does not render of a camera, one line each."""
    camera = item.data
    name = f"camera '{item.name}': "
    if camera.type == "PANO":
        yield name + "it is panoramic, which hipmap does not render"
    if (camera.shift_x, camera.shift_y) != (0, 0):
        yield name + "its shift is not rendered"
    if camera.dof.use_dof:
        if camera.type == "ORTHO":
            yield name + "an orthographic camera has no depth of field here"
        if camera.dof.aperture_blades > 2:
            yield name + "its aperture is round: its blades are not rendered"
        if camera.dof.aperture_ratio != 1:
            yield name + "its aperture is round: its ratio is not rendered"

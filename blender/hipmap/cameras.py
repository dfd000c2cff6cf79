# SPDX-License-Identifier: GPL-3.0-or-later
"""Cameras: glTF's, and the custom properties for what glTF lacks."""

import math

from mathutils import Vector

from .frame import middle_of_part

_MILLIMETRE = 1e-3


def _is_wide(camera, aspect):
    """Whether the sensor's width is what the picture's width sees."""
    return camera.sensor_fit == "HORIZONTAL" or (camera.sensor_fit == "AUTO" and aspect >= 1)


def _sensor(camera):
    """The size that the angle of view belongs to, mm."""
    return camera.sensor_height if camera.sensor_fit == "VERTICAL" else camera.sensor_width


def _half_height(camera, picture):
    """Half the height that the whole picture shows: at distance 1, or orthographic in metres."""
    aspect = _aspect(picture)
    wide = _is_wide(camera, aspect)
    half = 0.5 * (camera.ortho_scale if camera.type == "ORTHO" else _sensor(camera) / camera.lens)
    return half / aspect if wide else half


def _aspect(picture):
    return picture.width * picture.pixel_aspect / picture.height


def gltf_camera(camera, picture):
    """Returns the entry of a perspective or orthographic camera for the part of a Picture; None:
    glTF has no such camera."""
    clip = {"znear": camera.clip_start, "zfar": camera.clip_end}
    part = picture.part_height / picture.height
    half_height = _half_height(camera, picture) * part
    aspect = picture.part_width * picture.pixel_aspect / picture.part_height
    if camera.type == "PERSP":
        return {"name": camera.name, "type": "perspective",
                "perspective": {"yfov": 2 * math.atan(half_height), "aspectRatio": aspect, **clip}}
    if camera.type == "ORTHO":
        return {"name": camera.name, "type": "orthographic",
                "orthographic": {"xmag": half_height * aspect, "ymag": half_height, **clip}}
    return None


def shift_extras(camera, picture):
    """Returns the custom properties for the camera's shift, and for the place of the part in the
    Picture, in heights of the part."""
    right, up = middle_of_part(picture)
    aspect = _aspect(picture)
    # Blender's shift is a share of the side that the sensor's size belongs to.
    side = picture.width if _is_wide(camera, aspect) else picture.height / picture.pixel_aspect
    right += camera.shift_x * side
    up += camera.shift_y * side * picture.pixel_aspect
    if right == 0 and up == 0:
        return {}
    return {"shift_right": right * picture.pixel_aspect / picture.part_height,
            "shift_up": up / picture.part_height}


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
    if camera.dof.use_dof:
        if camera.type == "ORTHO":
            yield name + "an orthographic camera has no depth of field here"
        if camera.dof.aperture_blades > 2:
            yield name + "its aperture is round: its blades are not rendered"
        if camera.dof.aperture_ratio != 1:
            yield name + "its aperture is round: its ratio is not rendered"

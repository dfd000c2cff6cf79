# SPDX-License-Identifier: GPL-3.0-or-later
"""Volume nodes as hipmap's medium: absorption, scattering and emission by metre."""

from .losses import label
from .sockets import Unknown, follow, origin

_NOTHING = {"absorption": (0, 0, 0), "scattering": (0, 0, 0), "emission": (0, 0, 0), "g": 0.0}


def _plain(node, name, path):
    source = follow(node.inputs[name], path)
    if not source.is_plain:
        raise Unknown(f"an image at {name} of {label(node)}")
    return source


def _number(node, name, path):
    return _plain(node, name, path).value[0]


def _absorption(node, path):
    density = max(_number(node, "Density", path), 0)
    return {**_NOTHING, "absorption": tuple(max(1 - c, 0) * density for c in
                                            _plain(node, "Color", path).numbers())}


def _scattering(node, path):
    density = max(_number(node, "Density", path), 0)
    return {**_NOTHING, "g": _number(node, "Anisotropy", path),
            "scattering": tuple(c * density for c in _plain(node, "Color", path).numbers())}


def _principled(node, path):
    """Cycles takes the square root of the absorption colour."""
    density = max(_number(node, "Density", path), 0)
    colour = _plain(node, "Color", path).numbers()
    passed = _plain(node, "Absorption Color", path).numbers()
    strength = _number(node, "Emission Strength", path)
    if _number(node, "Blackbody Intensity", path) > 0:
        raise Unknown(f"the blackbody emission of {label(node)}")
    return {"scattering": tuple(c * density for c in colour),
            "absorption": tuple(max(1 - c, 0) * max(1 - a ** 0.5, 0) * density
                                for c, a in zip(colour, passed)),
            "emission": tuple(c * strength for c in
                              _plain(node, "Emission Color", path).numbers()),
            "g": _number(node, "Anisotropy", path)}


def _emission(node, path):
    strength = _number(node, "Strength", path)
    return {**_NOTHING, "emission": tuple(c * strength for c in
                                          _plain(node, "Color", path).numbers())}


def _sum(node, path):
    a, b = (_read(socket, path) for socket in node.inputs[:2])
    out = {key: tuple(x + y for x, y in zip(a[key], b[key]))
           for key in ("absorption", "scattering", "emission")}
    weights = [sum(part["scattering"]) for part in (a, b)]
    total = sum(weights)
    out["g"] = (a["g"] * weights[0] + b["g"] * weights[1]) / total if total > 0 else 0.0
    return out


_READERS = {"ShaderNodeVolumeAbsorption": _absorption, "ShaderNodeVolumeScatter": _scattering,
            "ShaderNodeVolumePrincipled": _principled, "ShaderNodeEmission": _emission,
            "ShaderNodeAddShader": _sum}


def _read(socket, path):
    output, outer = origin(socket, path)
    if output is None:
        return _NOTHING
    reader = _READERS.get(output.node.bl_idname)
    if reader is None:
        raise Unknown(label(output.node))
    return reader(output.node, outer)


def medium_of(socket):
    """Returns (medium, losses): hipmap's custom property `medium` for what is linked to a Volume
    output, None without one, and lines on what is not rendered."""
    if not socket.is_linked:
        return None, []
    try:
        found = _read(socket, ())
    except Unknown as unknown:
        return None, [f"node {unknown} at Volume cannot be expressed: rendered without the volume"]
    medium = {key: list(found[key]) for key in ("absorption", "scattering", "emission")
              if any(found[key])}
    if found["g"] and "scattering" in medium:
        medium.update(phase="henyey-greenstein", g=max(-0.99, min(found["g"], 0.99)))
    return medium or None, []

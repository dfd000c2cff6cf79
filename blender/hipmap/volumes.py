# SPDX-License-Identifier: GPL-3.0-or-later
"""Volume nodes as hipmap's medium: absorption, scattering and emission by metre."""

import math

from .adjust import blackbody
from .losses import label
from .sockets import Unknown, follow, origin

_NOTHING = {"absorption": (0, 0, 0), "scattering": (0, 0, 0), "emission": (0, 0, 0), "g": 0.0,
            "losses": ()}
_SAME_G = 1e-3

# W / (m2 K4) by steradian, and by 1e6: the scale of Cycles' Principled Volume.
_STEFAN_BOLTZMANN = 5.670373e-8 * 1e-6 / math.pi


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
    if getattr(node, "phase", "HENYEY_GREENSTEIN") != "HENYEY_GREENSTEIN":  # Blender 4.3 and later
        raise Unknown(f"{label(node)} with another phase function than Henyey and Greenstein's")
    return {**_NOTHING, "g": _number(node, "Anisotropy", path),
            "scattering": tuple(c * density for c in _plain(node, "Color", path).numbers())}


def _principled(node, path):
    """Cycles takes the square root of the absorption colour."""
    density = max(_number(node, "Density", path), 0)
    colour = _plain(node, "Color", path).numbers()
    passed = _plain(node, "Absorption Color", path).numbers()
    strength = _number(node, "Emission Strength", path)
    heat = _blackbody(node, path)
    return {**_NOTHING, "scattering": tuple(c * density for c in colour),
            "absorption": tuple(max(1 - c, 0) * max(1 - a ** 0.5, 0) * density
                                for c, a in zip(colour, passed)),
            "emission": tuple(c * strength + h for c, h in
                              zip(_plain(node, "Emission Color", path).numbers(), heat)),
            "g": _number(node, "Anisotropy", path)}


def _blackbody(node, path):
    """The emission of a Principled Volume that is hot."""
    share = _number(node, "Blackbody Intensity", path)
    if share <= 1e-3:  # as in Cycles
        return 0.0, 0.0, 0.0
    kelvin = max(_number(node, "Temperature", path), 0)
    power = _STEFAN_BOLTZMANN * (1 - share + share * kelvin ** 4)
    tint = _plain(node, "Blackbody Tint", path).numbers()
    return tuple(power * t * c for t, c in zip(tint, blackbody(max(kelvin, 1))))


def _emission(node, path):
    strength = _number(node, "Strength", path)
    return {**_NOTHING, "emission": tuple(c * strength for c in
                                          _plain(node, "Color", path).numbers())}


def _added(node, a, b, weights=(1, 1)):
    """Two media in the same place."""
    out = {key: tuple(weights[0] * x + weights[1] * y for x, y in zip(a[key], b[key]))
           for key in ("absorption", "scattering", "emission")}
    shares = [weight * sum(part["scattering"]) for weight, part in zip(weights, (a, b))]
    total = sum(shares)
    out["g"] = (a["g"] * shares[0] + b["g"] * shares[1]) / total if total > 0 else 0.0
    out["losses"] = a["losses"] + b["losses"]
    if min(shares) > 0 and abs(a["g"] - b["g"]) > _SAME_G:
        out["losses"] += (f"node {label(node)} at Volume: both anisotropies are rendered as their "
                          "mean",)
    return out


def _sum(node, path):
    return _added(node, *(_read(socket, path) for socket in node.inputs[:2]))


def _mixture(node, path):
    factor = min(max(_number(node, "Fac", path), 0), 1)
    return _added(node, *(_read(socket, path) for socket in node.inputs[1:3]),
                  (1 - factor, factor))


_READERS = {"ShaderNodeVolumeAbsorption": _absorption, "ShaderNodeVolumeScatter": _scattering,
            "ShaderNodeVolumePrincipled": _principled, "ShaderNodeEmission": _emission,
            "ShaderNodeAddShader": _sum, "ShaderNodeMixShader": _mixture}


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
    return medium or None, list(found["losses"])

# SPDX-License-Identifier: GPL-3.0-or-later
"""Nodes that change a colour by itself, as functions of colours [n, 3], linear.

They apply to plain colours and to every pixel of an image alike.  A test holds them to Cycles.
"""

import numpy

_LUMINANCE = numpy.array([0.2126, 0.7152, 0.0722])  # Rec. 709
_STEPS_OF_RAMP = 1024


def grey(colours):
    """Returns what a number's input makes of colours: their luminance, three times."""
    return numpy.repeat(colours @ _LUMINANCE[:, None], 3, axis=1)


def _mixed(colours, changed, factor):
    return colours + factor * (changed - colours)


def _gamma(node, value):
    exponent = value("Gamma")
    return lambda c: numpy.where(c > 0, numpy.power(numpy.maximum(c, 1e-30), exponent), c)


def _invert(node, value):
    factor = value("Fac")
    return lambda c: _mixed(c, 1 - c, factor)


def _bright_contrast(node, value):
    bright, contrast = value("Bright"), value("Contrast")
    return lambda c: numpy.maximum((1 + contrast) * c + bright - 0.5 * contrast, 0)


def _hue_and_span(c):
    """Hue from 0 to 1, greatest channel and its distance from the least."""
    most = c.max(axis=1)
    span = most - c.min(axis=1)
    safe = numpy.where(span > 0, span, 1)
    red, green, blue = c.T
    hue = numpy.select([most == red, most == green],
                       [(green - blue) / safe, 2 + (blue - red) / safe], 4 + (red - green) / safe)
    return numpy.where(span > 0, hue / 6 % 1, 0), most, span


def _from_hsv(hue, saturation, value):
    corner = (hue[:, None] * 6 + numpy.array([0, 4, 2])) % 6
    pure = numpy.clip(numpy.abs(corner - 3) - 1, 0, 1)
    return value[:, None] * (1 + saturation[:, None] * (pure - 1))


def _hue_saturation(node, value):
    hue, saturation = value("Hue"), value("Saturation")
    brightness, factor = value("Value"), value("Fac")

    def change(c):
        old_hue, most, span = _hue_and_span(c)
        old = numpy.where(most > 0, span / numpy.where(most > 0, most, 1), 0)
        changed = _from_hsv((old_hue + hue + 0.5) % 1, numpy.clip(old * saturation, 0, 1),
                            most * brightness)
        return numpy.maximum(_mixed(c, changed, factor), 0)

    return change


def _ramp(node, value):
    table = numpy.array([node.color_ramp.evaluate(i / (_STEPS_OF_RAMP - 1))[:3]
                         for i in range(_STEPS_OF_RAMP)])

    def change(c):
        share = numpy.clip(c @ _LUMINANCE, 0, 1)
        return table[(share * (_STEPS_OF_RAMP - 1) + 0.5).astype(int)]

    return change


# Of a node's kind: what it takes, and how to make its function of the other inputs.
_NODES = {
    "ShaderNodeGamma": ("Color", _gamma),
    "ShaderNodeInvert": ("Color", _invert),
    "ShaderNodeBrightContrast": ("Color", _bright_contrast),
    "ShaderNodeHueSaturation": ("Color", _hue_saturation),
    "ShaderNodeValToRGB": ("Fac", _ramp),
}

_MATH = {
    "ADD": lambda a, b: a + b, "SUBTRACT": lambda a, b: a - b, "MULTIPLY": lambda a, b: a * b,
    "MINIMUM": numpy.minimum, "MAXIMUM": numpy.maximum,
    "POWER": lambda a, b: numpy.power(numpy.maximum(a, 0), b),
}


def is_adjustment(node):
    """Whether a node changes a colour by itself."""
    return node.bl_idname in _NODES


def adjustment(node, value):
    """Returns the name of the input that a node changes, and the function of colours.  value: gives
    the number at another input by its name."""
    name, make = _NODES[node.bl_idname]
    return name, make(node, value)


def arithmetic(operation, clamp, second):
    """Returns the function of a Math node whose second input is a number; None: it has no such
    function here."""
    if operation not in _MATH:
        return None
    change = _MATH[operation]
    if clamp:
        return lambda c: numpy.clip(change(grey(c), second), 0, 1)
    return lambda c: change(grey(c), second)


def blackbody(kelvin):
    """Returns the colour of a black body of luminance 1, linear Rec. 709, without negative parts.

    Planck's law times the fits to CIE 1931 of Wyman, Sloan and Shirley, JCGT 2(2), 2013.
    """
    nm = numpy.arange(380.0, 781.0, 5.0)
    power = nm ** -5 / numpy.expm1(1.4387769e7 / (nm * kelvin))

    def lobe(centre, low, high):
        t = (nm - centre) * numpy.where(nm < centre, low, high)
        return numpy.exp(-0.5 * t * t)

    x = (0.362 * lobe(442.0, 0.0624, 0.0374) + 1.056 * lobe(599.8, 0.0264, 0.0323)
         - 0.065 * lobe(501.1, 0.0490, 0.0382))
    y = 0.821 * lobe(568.8, 0.0213, 0.0247) + 0.286 * lobe(530.9, 0.0613, 0.0322)
    z = 1.217 * lobe(437.0, 0.0845, 0.0278) + 0.681 * lobe(459.0, 0.0385, 0.0725)
    xyz = numpy.array([(power * fit).sum() for fit in (x, y, z)])
    to_rgb = numpy.array([[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560],
                          [0.0556434, -0.2040259, 1.0572252]])
    return tuple(float(c) for c in numpy.maximum(to_rgb @ xyz / xyz[1], 0))

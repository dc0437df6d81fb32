"""Random terraced solids: polygons extruded to random levels from both sides of a block, some twisted and tapered."""

import math
import random

from solids.kit import at_height, extruded, minus, polygon, polygon_prism, turned, union

RADIUS = 40.0
"""Of the block, about; its thickness is half of that."""


def random_terraced(seed):
    """The solid of a seed: one body, its sources look along +z, its targets against it."""
    chance = random.Random(seed)
    thickness = chance.uniform(15, 25)
    block = extruded(polygon(_outline(chance, (0, 0), RADIUS, 0.15)), thickness)
    added = [_straight(chance, thickness) for _ in range(chance.randint(1, 3))]
    shape = union(block, *added)
    for _ in range(chance.randint(0, 2)):
        shape = _with_pocket(chance, shape, thickness)
    if chance.random() < 0.6:
        shape = _with_free_standing(chance, shape, thickness)
    return shape


def caps_of(shape):
    """(sources, targets): numbers of the level faces that look up and down."""
    sources, targets = [], []
    for number, face in enumerate(shape.Faces, 1):
        if face.Surface.TypeId != "Part::GeomPlane":
            continue
        slope = face.normalAt(0, 0).z
        if abs(slope) > 1 - 1e-9:
            (sources if slope > 0 else targets).append(number)
    return sources, targets


def _outline(chance, centre, radius, unevenness):
    """A star-shaped polygon: corners at about even angles, at distances of radius * (1 -+ unevenness)."""
    count, start = chance.randint(3, 7), chance.uniform(0, 2 * math.pi)
    step = 2 * math.pi / count
    corners = []
    for i in range(count):
        angle = start + (i + chance.uniform(-0.15, 0.15)) * step
        r = radius * chance.uniform(1 - unevenness, 1 + unevenness)
        corners.append((centre[0] + r * math.cos(angle), centre[1] + r * math.sin(angle)))
    return corners


def _place(chance, reach):
    angle, r = chance.uniform(0, 2 * math.pi), chance.uniform(0, reach)
    return r * math.cos(angle), r * math.sin(angle)


def _straight(chance, thickness):
    """A prism that stands out of the block above or below; it may stand out sideways too."""
    centre = _place(chance, 24)
    outline = polygon(_outline(chance, centre, chance.uniform(9, 20), 0.3), 0)
    inside = chance.uniform(0.3, 0.7) * thickness
    length = chance.uniform(0.4, 1.2) * thickness
    low, high = (inside, thickness + length) if chance.random() < 0.5 else (-length, inside)
    prism = extruded(outline, high - low)
    prism.translate((0, 0, low))
    return prism


def _with_pocket(chance, shape, thickness):
    """A straight pocket or hole from above or below."""
    outline = polygon(_outline(chance, _place(chance, 22), chance.uniform(4, 9), 0.2), 0)
    depth = chance.uniform(0.3, 0.8) * thickness
    tool = extruded(outline, 200)
    tool.translate((0, 0, thickness - depth if chance.random() < 0.5 else depth - 200))
    try:
        return minus(shape, tool)
    except ValueError:  # in pieces
        return shape


def _with_free_standing(chance, shape, thickness):
    """A twisted and tapered tower, or pocket, where nothing else is above it (beside it, for a pocket)."""
    for _ in range(20):
        centre, radius = _place(chance, 26), chance.uniform(6, 12)
        clear = extruded(polygon(_outline_circle(centre, 1.3 * radius)), 400)
        clear.translate((0, 0, thickness))
        if shape.common(clear).Volume > 1e-6 or not _is_over_face(shape, centre, 1.3 * radius, thickness):
            continue
        foot = _outline(chance, centre, radius / 1.3, 0.3)
        height, is_pocket = chance.uniform(0.4, 1.0) * thickness, chance.random() < 0.4
        twist, taper = chance.uniform(-40, 40), chance.uniform(0.6, 1.25)
        if is_pocket:
            height = -0.5 * height
        sections = [at_height(turned(foot, t * twist, centre, 1 + t * (taper - 1)), thickness + t * height)
                    for t in (0.0, 0.5, 1.0)]
        try:
            made = minus(shape, polygon_prism(sections)) if is_pocket else union(shape, polygon_prism(sections))
        except ValueError:
            continue
        return made
    return shape


def _outline_circle(centre, radius):
    return [(centre[0] + radius * math.cos(2 * math.pi * k / 24), centre[1] + radius * math.sin(2 * math.pi * k / 24))
            for k in range(24)]


def _is_over_face(shape, centre, radius, height):
    """Does the solid fill a disc just below the height, down to a good depth?"""
    disc = extruded(polygon(_outline_circle(centre, radius)), 0.7 * height)
    disc.translate((0, 0, 0.3 * height))
    return shape.common(disc).Volume > (1 - 1e-6) * disc.Volume

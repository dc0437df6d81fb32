"""Random solids as an engineer might draw them: the same seed, the same solid.

    shape = make("terraced", 7)      # a slab with bosses, pockets and holes, all upright
    shape = make("parts", 7)         # plates and turned parts with drafts, cross holes, fillets and chamfers
    shape = make("primitives", 7)    # boxes, cylinders, cones, spheres, wedges and tori, fused and cut

Most stand along the axes on a grid of half units, so faces touch, meet in one plane or just miss each other as they do in
drawings; some are tilted.
"""

import math
import random

import FreeCAD
import Part
from solids.kit import box, polygon, rod, vec

AXES = (vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1))


def make(family, seed):
    """The solid of a family and a seed; a Part.Shape of one valid solid."""
    source = random.Random(f"{family} {seed}")
    while True:  # a Boolean that fails or leaves nothing is drawn anew
        shape = single_solid(FAMILIES[family](source))
        if shape is not None:
            return shape


def single_solid(shape):
    """The largest solid of a shape; None where there is no sound one."""
    solids = [solid for solid in shape.Solids if solid.isValid() and solid.Volume > 1.0]
    return max(solids, key=lambda one: one.Volume, default=None)


def combined(shape, tool, is_cut):
    """Boolean with one sound solid as its result; `shape` itself where there is none."""
    try:
        result = single_solid(shape.cut(tool) if is_cut else shape.fuse(tool))
    except Part.OCCError:
        return shape
    return shape if result is None else result


def unified(shape):
    """Faces of one surface joined, where that leaves a sound solid."""
    try:
        return single_solid(shape.removeSplitter()) or shape
    except Part.OCCError:
        return shape


# Upright solids.


def outline(source, x, y, radius):
    """A convex polygon around (x, y)."""
    corners, start = source.randint(3, 7), source.uniform(0, 2)
    return [
        (x + radius * math.cos(start + 2 * math.pi * i / corners), y + radius * math.sin(start + 2 * math.pi * i / corners))
        for i in range(corners)
    ]


def upright(source, x, y, radius, low, high):
    """A round, rectangular or polygonal prism between two heights."""
    kind = source.random()
    if kind < 0.4:
        return rod(radius, vec(x, y, low), high - low)
    if kind < 0.75:
        half = radius * source.choice((0.5, 0.75, 1.0))
        return box(x - radius, x + radius, y - half, y + half, low, high)
    return Part.Face(polygon(outline(source, x, y, radius), low)).extrude(vec(0, 0, high - low))


def terraced(source):
    """A slab with bosses on both sides, pockets and through holes, upright; then turned as a whole."""
    shape = box(0, 60, 0, 50, 0, 20)
    for _ in range(source.randint(1, 5)):
        radius = source.choice((4, 6, 8, 10, 12))
        x, y = source.uniform(radius + 3, 57 - radius), source.uniform(radius + 3, 47 - radius)
        kind = source.random()
        if kind < 0.35:
            shape = combined(shape, upright(source, x, y, radius, 10, source.randint(24, 40)), False)
        elif kind < 0.55:
            shape = combined(shape, upright(source, x, y, radius, source.randint(-20, -5), 10), False)
        elif kind < 0.75:
            shape = combined(shape, upright(source, x, y, radius, source.randint(5, 15), 50), True)
        else:
            shape = combined(shape, upright(source, x, y, radius, -30, 50), True)
    shape = unified(shape)
    if source.random() < 0.5:
        axis = vec(source.uniform(-1, 1), source.uniform(-1, 1), source.uniform(-1, 1))
        shape.rotate(vec(0, 0, 0), axis, source.uniform(0, 180))
    return shape


# Unions and cuts of primitives.


def primitive(source, scale):
    """One primitive near the origin, its axis along z."""
    a, b, c = (scale * source.choice((0.5, 0.75, 1.0, 1.5)) for _ in range(3))
    kind = source.choices(("box", "cylinder", "cone", "sphere", "wedge", "torus"), (8, 7, 2, 1, 2, 1))[0]
    if kind == "box":
        return box(-a, a, -b, b, -c, c)
    if kind == "cylinder":
        return rod(a, vec(0, 0, -c), 2 * c)
    if kind == "cone":
        return Part.makeCone(a, a * source.choice((0.0, 0.5, 0.75)), 2 * c, vec(0, 0, -c))
    if kind == "sphere":
        return Part.makeSphere(a)
    if kind == "wedge":
        top = source.choice((0.0, 0.5))
        return Part.makeWedge(-a, -b, -c, -c * top, -a * top, a, b, c, c * top, a * top)
    return Part.makeTorus(1.5 * a, 0.5 * a)


def posed(source, shape, reach):
    """Moved by half units and turned: along an axis mostly, tilted at times."""
    kind = source.random()
    if kind < 0.6:
        shape.rotate(vec(0, 0, 0), source.choice(AXES), source.choice((0, 90, 180, 270)))
    elif kind < 0.75:
        shape.rotate(vec(0, 0, 0), source.choice(AXES), source.choice((30, 45, 60)))
    elif kind < 0.85:
        axis = vec(source.uniform(-1, 1), source.uniform(-1, 1), source.uniform(-1, 1))
        shape.rotate(vec(0, 0, 0), axis, source.uniform(0, 180))
    offset = [source.randint(-2 * reach, 2 * reach) / 2 for _ in range(3)]
    shape.translate(FreeCAD.Vector(*offset) * source.choice((0, 1, 1)))
    return shape


def primitives(source):
    """A block, cylinder or other primitive with one to four others fused to it or cut from it."""
    first = source.random()
    if first < 0.5:
        shape = box(-15, 15, -source.choice((8, 10, 15)), 10, 0, source.choice((6, 10, 20)))
    elif first < 0.75:
        shape = rod(source.choice((8, 12, 15)), vec(0, 0, 0), source.choice((8, 16, 30)))
    else:
        shape = primitive(source, 12)
    for _ in range(source.choice((0, 1, 1, 2, 2, 3, 4))):
        tool = posed(source, primitive(source, source.choice((4, 6, 8, 12))), 12)
        shape = combined(shape, tool, source.random() < 0.55)
    return unified(shape) if source.random() < 0.7 else shape


# Machine parts.


def with_rounded_edges(source, shape):
    """Fillets or chamfers on some edges, where OpenCASCADE can make them."""
    size = source.choice((0.5, 1.0, 2.0))
    upright_only = source.random() < 0.5
    edges = [edge for edge in shape.Edges if not upright_only or is_upright(edge)]
    chosen = source.sample(edges, min(len(edges), source.randint(1, 4)))
    try:
        made = shape.makeFillet(size, chosen) if source.random() < 0.6 else shape.makeChamfer(size, chosen)
        return single_solid(made) or shape
    except (Part.OCCError, RuntimeError):
        return shape


def is_upright(edge):
    """Straight and along z."""
    return isinstance(edge.Curve, Part.Line) and abs(edge.tangentAt(edge.FirstParameter).z) > 0.999


def drilled(source, shape):
    """A hole along an axis, through or blind, somewhere in the bounding box."""
    bounds = shape.BoundBox
    centre = vec(
        *(
            source.uniform(low + 0.25 * (high - low), high - 0.25 * (high - low))
            for low, high in ((bounds.XMin, bounds.XMax), (bounds.YMin, bounds.YMax), (bounds.ZMin, bounds.ZMax))
        )
    )
    axis = source.choice(AXES)
    start = centre if source.random() < 0.3 else centre - axis * 200
    radius = source.choice((1.0, 1.5, 2.5)) * min(bounds.XLength, bounds.YLength, bounds.ZLength) / 12
    return combined(shape, rod(radius, start, 400, axis), True)


def turned_part(source):
    """A stepped profile turned around z, by a full turn or less."""
    inner, z, points = source.choice((0.0, 3.0, 5.0)), 0.0, []
    for _ in range(source.randint(1, 4)):
        outer, height = inner + source.choice((3, 5, 8, 12)), source.choice((3, 6, 10))
        points += [(outer, z), (outer if source.random() < 0.7 else inner + 3, z + height)]
        z += height
    points = [(inner, 0.0), *points, (inner, z)]
    wire = Part.makePolygon([vec(x, 0, height) for x, height in [*points, points[0]]])
    angle = 360 if source.random() < 0.6 else source.choice((60, 90, 180, 270))
    return Part.Face(wire).revolve(vec(0, 0, 0), vec(0, 0, 1), angle)


def plate(source):
    """A plate or an angle with a rib."""
    shape = box(0, 40, 0, source.choice((20, 30)), 0, source.choice((5, 10)))
    if source.random() < 0.5:
        shape = combined(shape, box(0, source.choice((5, 8)), 0, 20, 0, source.choice((20, 30))), False)
    return unified(shape)


def drafted(source, shape):
    """With a pad or a pocket on top whose walls lean."""
    bounds = shape.BoundBox
    x, y, top = bounds.Center.x + source.uniform(-4, 4), bounds.Center.y + source.uniform(-3, 3), bounds.ZMax
    is_pocket = source.random() < 0.4
    height = 0.6 * bounds.ZLength if is_pocket else source.choice((4, 8))
    radius, share = 0.2 * min(bounds.XLength, bounds.YLength), source.choice((0.6, 0.8))
    if source.random() < 0.5:
        low, high = (Part.makeCircle(r, vec(x, y, 0)) for r in (radius, share * radius))
        foot, head = Part.Wire([low]), Part.Wire([high])
    else:
        foot, head = (
            polygon([(x + s * r, y + t * r) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
            for r in (radius, share * radius)
        )
    foot.translate(vec(0, 0, top))
    head.translate(vec(0, 0, top - height if is_pocket else top + height))
    return combined(shape, Part.makeLoft([foot, head], True, True), is_pocket)


def parts(source):
    """A plate, an angle or a turned part with drafted pads, drilled holes, fillets and chamfers."""
    shape = plate(source) if source.random() < 0.6 else turned_part(source)
    shape = single_solid(shape) or shape
    if source.random() < 0.4:
        shape = drafted(source, shape)
    for _ in range(source.choice((0, 0, 1, 1, 2))):
        shape = drilled(source, shape)
    if source.random() < 0.6:
        shape = with_rounded_edges(source, shape)
    return shape


FAMILIES = {"terraced": terraced, "primitives": primitives, "parts": parts}

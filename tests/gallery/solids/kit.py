"""A small modelling kit over FreeCAD's Part: prisms, stacks of sections, Booleans that give one solid."""

import math

import FreeCAD
import Part


def vec(x, y, z=0.0):
    """FreeCAD vector from plain numbers."""
    return FreeCAD.Vector(float(x), float(y), float(z))


Z_UP = vec(0, 0, 1)


def box(x0, x1, y0, y1, z0, z1):
    """Axis-aligned box given by its limits."""
    return Part.makeBox(x1 - x0, y1 - y0, z1 - z0, vec(x0, y0, z0))


def rod(radius, start, length, axis=Z_UP):
    """Full cylinder from `start` along `axis`."""
    return Part.makeCylinder(radius, length, start, axis)


def dome_ball(radius, centre):
    """Ball whose poles lie sideways and whose seam points down, so that a dome cut
    from its top is one face with neither pole nor seam."""
    ball = Part.makeSphere(radius)
    ball.rotate(vec(0, 0, 0), vec(0, 1, 0), 90)
    ball.translate(centre)
    return ball


def polygon(points, z=0.0):
    """Closed polygonal wire in the plane z."""
    pts = [vec(x, y, z) for x, y in points]
    return Part.makePolygon(pts + pts[:1])


def circle(radius, centre, axis=Z_UP):
    """Closed circular wire."""
    return Part.Wire([Part.Edge(Part.Circle(centre, axis, radius))])


def line(a, b):
    return Part.makeLine(a, b)


def arc(a, mid, b):
    return Part.Arc(a, mid, b).toShape()


def planar(*wires):
    """Planar face bounded by the first wire, the others being its holes."""
    return Part.makeFace(list(wires), "Part::FaceMakerBullseye")


def extruded(wire, height, *holes):
    """Right prism of a planar region with holes, along +z."""
    return planar(wire, *holes).extrude(vec(0, 0, height))


def regular(count, across_flats, turn=0.0, centre=(0.0, 0.0)):
    """Corner list of a regular polygon given by its across-flats size."""
    r = across_flats / 2.0 / math.cos(math.pi / count)
    return [(centre[0] + r * math.cos(turn + 2 * math.pi * k / count),
             centre[1] + r * math.sin(turn + 2 * math.pi * k / count))
            for k in range(count)]


def stadium(c0, c1, radius):
    """Closed wire (2 arcs, 2 lines) around the segment c0-c1 in its z plane."""
    d = (c1 - c0).normalize()
    n = Z_UP.cross(d) * radius
    t = d * radius
    return Part.Wire([arc(c0 + n, c0 - t, c0 - n), line(c0 - n, c1 - n),
                      arc(c1 - n, c1 + t, c1 + n), line(c1 + n, c0 + n)])


def union(*solids):
    """Boolean union with coplanar and co-cylindrical faces merged."""
    out = solids[0]
    if len(solids) > 1:
        out = out.multiFuse(list(solids[1:]))
    return one_solid(out.removeSplitter())


def minus(solid, *tools):
    """Boolean difference."""
    return one_solid(solid.cut(list(tools)) if len(tools) > 1 else solid.cut(tools[0]))


def one_solid(shape):
    """The only solid of a boolean result."""
    if len(shape.Solids) != 1:
        raise ValueError("expected one solid, got %d" % len(shape.Solids))
    return shape.Solids[0]


def imprint(solid, edges):
    """Split faces of `solid` along edges that lie on them."""
    compound, _ = solid.generalFuse(list(edges))
    return one_solid(compound)


def clamped_knots(pole_count, degree):
    """Uniform clamped knot vector as (knots, multiplicities)."""
    spans = pole_count - degree
    knots = [k / spans for k in range(spans + 1)]
    return knots, [degree + 1] + [1] * (spans - 1) + [degree + 1]


def sewn_solid(faces):
    """Solid bounded by faces that share their boundary curves."""
    compound = Part.Compound(faces)
    compound.sewShape(1e-5)
    solid = Part.Solid(compound.Shells[0])
    if solid.Volume < 0:
        solid = Part.Solid(compound.Shells[0].reversed())
    return solid


def bezier_prism(sections):
    """
    Solid through stacked sections.

    Every section is a closed loop of edges, each edge a list of Bezier poles
    that starts where the previous edge ends.  The walls are B-splines of
    degree <= 3 along the stack with the sections as poles, so edge k of the
    first section runs into edge k of the last one whatever the twist.  The two
    end sections must be planar.
    """
    degree_v = min(3, len(sections) - 1)
    knots_v, mults_v = clamped_knots(len(sections), degree_v)
    faces, ends = [], ([], [])
    for k in range(len(sections[0])):
        degree_u = len(sections[0][k]) - 1
        poles = [[section[k][i] for section in sections] for i in range(degree_u + 1)]
        wall = Part.BSplineSurface()
        wall.buildFromPolesMultsKnots(poles, [degree_u + 1] * 2, mults_v, [0.0, 1.0],
                                      knots_v, False, False, degree_u, degree_v)
        faces.append(wall.toShape())
        for end, row in zip(ends, (0, -1)):
            curve = Part.BezierCurve()
            curve.setPoles([column[row] for column in poles])
            end.append(curve.toShape() if degree_u > 1 else line(poles[0][row], poles[1][row]))
    faces += [planar(Part.Wire(end)) for end in ends]
    return sewn_solid(faces)


def polygon_prism(sections):
    """Solid through stacked polygons (lists of 3D corners, equal counts)."""
    return bezier_prism([[[s[i], s[(i + 1) % len(s)]] for i in range(len(s))]
                         for s in sections])


def ring_prism(sections):
    """
    Solid through stacked smooth closed rings (lists of 3D poles, equal counts):
    one periodic cubic B-spline wall and two planar ends.
    """
    count = len(sections[0])
    degree_v = min(3, len(sections) - 1)
    knots_v, mults_v = clamped_knots(len(sections), degree_v)
    wall = Part.BSplineSurface()
    wall.buildFromPolesMultsKnots(
        [[section[i] for section in sections] for i in range(count)],
        [1] * (count + 1), mults_v, [k / count for k in range(count + 1)], knots_v,
        True, False, 3, degree_v)
    face = wall.toShape()
    rims = [edge for edge in face.Edges if edge.isClosed()]
    return sewn_solid([face] + [planar(Part.Wire([rim])) for rim in rims])


def oblique_rod(radius0, centre0, radius1, centre1):
    """Round rod between two horizontal circles (ruled wall)."""
    return Part.makeLoft([circle(radius0, centre0), circle(radius1, centre1)], True, True)


def turned(points, degrees, centre=(0.0, 0.0), scale=1.0):
    """2D points turned and scaled about a centre."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [(centre[0] + scale * (c * (x - centre[0]) - s * (y - centre[1])),
             centre[1] + scale * (s * (x - centre[0]) + c * (y - centre[1])))
            for x, y in points]


def at_height(points, z):
    """2D points lifted to the plane z."""
    return [vec(x, y, z) for x, y in points]


def steps(count):
    """count + 1 evenly spaced parameters from 0 to 1."""
    return [k / count for k in range(count + 1)]


def rounded(point):
    """A point as a list of numbers with six decimals; 0.0, never -0.0."""
    return [round(c, 6) + 0.0 for c in point]

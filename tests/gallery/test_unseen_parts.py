"""Families that showed what single solids had not: each test holds for all of a family, without picks."""

import math

import pytest
from checker import expect_valid_sweep
from solids.kit import at_height, box, line, minus, planar, polygon_prism, rod, steps, turned, union, vec

from sweepmesh import Model, Options, mesh
from sweepmesh.freecad import import_freecad

import_freecad()
import Part  # noqa: E402


def meshed(shape, **options):
    model = Model.from_brep(shape.exportBrepToString(), 0)
    result = mesh(model, Options(**options))
    assert result.assessment.is_sweepable
    expect_valid_sweep(result, model)
    return result


def least(result):
    return result.quality["min_scaled_jacobian"]


def spacer(columns, rows, twist):
    """A duct with blind holes like crosses that turn this way and that, one cell's width from its walls."""
    pitch, height, depth, arm, half = 22, 36, 24, 8, 1.8
    cross = [(arm, -half), (arm, half), (half, half), (half, arm), (-half, arm), (-half, half)]
    cross += [(-x, -y) for x, y in cross]
    holes = []
    for i in range(columns):
        for j in range(rows):
            way = twist if (i + j) % 2 == 0 else -twist
            section = [
                [(x + (i + 0.5) * pitch, y + (j + 0.5) * pitch) for x, y in turned(cross, way * t)] for t in steps(6)
            ]
            holes.append(polygon_prism([at_height(s, height - depth * t) for s, t in zip(section, steps(6))]))
    return minus(box(0, pitch * columns, 0, pitch * rows, 0, height), *holes)


@pytest.mark.parametrize("columns, rows, twist, size", [(1, 1, 60, 3.4), (1, 2, 40, 3.3), (1, 3, 40, 3.1)])
def test_blind_crosses_turn_beside_walls(columns, rows, twist, size):
    """At the size that was asked for: no cell reaches from a hole that turns to the wall beside it."""
    result = meshed(spacer(columns, rows, twist), size=size)
    assert not [w for w in result.warnings if "element size" in w]
    assert least(result) > 0.15


def bent_sheet(outline, bends, width):
    """A profile of straight lines, extruded and rounded: `bends` gives the radius at a corner."""
    points = [vec(x, y) for x, y in outline]
    face = planar(Part.makePolygon(points + points[:1]))
    shape = face.extrude(vec(0, 0, width))
    for (x, y), radius in bends.items():
        at = [e for e in shape.Edges if e.BoundBox.ZLength > width / 2 and math.dist(e.CenterOfMass[:2], (x, y)) < 1e-3]
        shape = shape.makeFillet(radius, at)
    return shape


def z_bracket():
    outline = [(0, 0), (30, 0), (30, 25), (60, 25), (60, 28), (27, 28), (27, 3), (0, 3)]
    shape = bent_sheet(outline, {(30, 0): 5, (27, 3): 2, (27, 28): 5, (30, 25): 2}, 30)
    y = vec(0, 1, 0)
    return minus(shape, rod(4, vec(12, -2, 15), 10, y), rod(4, vec(48, 22, 15), 10, y))


def hat():
    outline = [(0, 0), (20, 0), (20, 20), (50, 20), (50, 0), (70, 0), (70, 3), (53, 3), (53, 23), (17, 23), (17, 3), (0, 3)]
    outer = {(20, 0): 2, (50, 0): 2, (53, 23): 5, (17, 23): 5}
    inner = {(20, 20): 2, (50, 20): 2, (53, 3): 2, (17, 3): 2}
    shape = bent_sheet(outline, {**outer, **inner}, 25)
    y = vec(0, 1, 0)
    return minus(shape, rod(3, vec(8, -2, 12.5), 10, y), rod(5, vec(35, 17, 12.5), 10, y))


@pytest.mark.parametrize("part", [z_bracket, hat])
def test_bent_sheets_are_swept_through_their_thickness(part):
    result = meshed(part())
    assert least(result) > 0.3
    assert not result.warnings


def aerofoil(tail):
    """A prism over two curves that meet at a sharp trailing edge."""
    xs = (0, 0.05, 0.2, 0.5, 0.8, 1)
    edges = []
    for half in (tail, -0.6 * tail):
        curve = Part.BSplineCurve()
        points = [vec(50 * x, half * (math.sqrt(x) - x)) for x in xs]
        curve.interpolate(Points=points if half > 0 else points[::-1])
        edges.append(curve.toShape())
    return Part.Face(Part.Wire(edges)).extrude(vec(5, 0, 30))


@pytest.mark.parametrize("tail", [8, 14])
def test_a_sharp_edge_costs_what_its_angle_does(tail):
    """The elements in it are as sharp as the edge, no others are worse, and a warning names it."""
    shape = aerofoil(tail)
    edge = next(i for i, e in enumerate(shape.Edges) if e.Length > 30 and e.BoundBox.XMin > 40)
    result = meshed(shape)
    angle = math.degrees(math.asin(least(result)))
    slope = (1 + 0.6) * tail / 2 / 50  # of both sides together at the end, where sqrt(x) - x falls by 1/2
    assert angle > 0.8 * math.degrees(slope)
    if least(result) < 0.2:
        assert any(f"Edge{edge + 1} " in w for w in result.warnings)


def cross_drilled():
    block = box(0, 40, 0, 40, 0, 40)
    return minus(block, rod(8, vec(20, 20, -5), 50), rod(5, vec(-5, 20, 20), 50, vec(1, 0, 0)))


def bearing_block():
    y = vec(0, 1, 0)
    shape = union(box(0, 80, 0, 30, 0, 12), rod(22, vec(40, 0, 30), 30, y), box(18, 62, 0, 30, 10, 30))
    shape = minus(shape, rod(14, vec(40, -5, 30), 40, y))
    return minus(shape, *[rod(4, vec(x, 15, -1), 20) for x in (9, 71)])


@pytest.mark.parametrize("part", [cross_drilled, bearing_block])
def test_of_several_ways_to_divide_rounds_a_good_one_is_taken(part):
    """The cheapest one leaves a strip beside a cut that is narrower than any element."""
    assert least(meshed(part())) > 0.3


def test_a_cusp_is_named():
    """Where a line runs into an arc that it touches a face has a corner without an angle."""
    reach, r0, r1 = 60, 12, 8
    a = math.asin((r0 - r1) / reach)
    arm = [(x + r * math.sin(a), s * r * math.cos(a)) for x, r, s in ((0, r0, 1), (reach, r1, 1), (reach, r1, -1), (0, r0, -1))]
    corners = [vec(x, y, 2) for x, y in arm]
    sides = [line(p, q) for p, q in zip(corners, corners[1:] + corners[:1])]
    web = planar(Part.Wire(sides)).extrude(vec(0, 0, 6))
    shape = union(rod(r0, vec(0, 0, 0), 10), rod(r1, vec(reach, 0, 0), 10), web)
    result = meshed(shape)
    assert least(result) < 0.2
    assert any("own angles" in w and "Vertex" in w for w in result.warnings)


def junction(outer, bore, across, across_bore):
    """Two pipes that cross: solid ones united, then bored."""
    y = vec(0, 1, 0)
    solid = union(rod(outer, vec(0, 0, -36), 72), rod(across, vec(0, -38, 0), 76, y))
    return minus(solid, union(rod(bore, vec(0, 0, -36), 72), rod(across_bore, vec(0, -38, 0), 76, y)))


@pytest.mark.parametrize("radii", [(20, 14, 12, 7), (20, 14, 17, 12), (20, 17.5, 12, 10)])
def test_crossing_pipes_are_swept_through_their_walls(radii):
    result = meshed(junction(*radii))
    assert least(result) > 0.4
    ends = [face for face, role in result.assessment.roles.items() if role == "linking"]
    assert len(ends) == 4


def spline(points):
    curve = Part.BSplineCurve()
    curve.interpolate(Points=[vec(*p) for p in points])
    return curve.toShape()


def spline_pipe():
    """A pipe along a curve in space."""
    path = Part.Wire(spline([(0, 0, 0), (0, 5, 25), (15, 20, 45), (40, 25, 50), (60, 10, 60)]))
    along = path.Edges[0].tangentAt(path.Edges[0].FirstParameter)
    outer, inner = [
        path.makePipeShell([Part.Wire(Part.Circle(vec(0, 0, 0), along, r).toShape())], True, False) for r in (6, 4)
    ]
    return minus(outer, inner)


def blade_wheel():
    """Curved blades on a disc, round a bored hub."""
    blades = []
    for i in range(6):
        def at(t, lag):
            a = math.radians(-6 * t + 60 * i + lag)
            return ((9 + 3 * t) * math.cos(a), (9 + 3 * t) * math.sin(a), 4)

        outer = [at(t, 0) for t in range(10)]
        inner = [at(t, 14 if t < 1 else 120 / (9 + 3 * t)) for t in range(10)]
        ends = [line(vec(*outer[-1]), vec(*inner[-1])), line(vec(*inner[0]), vec(*outer[0]))]
        rim = Part.Wire([spline(outer), ends[0], spline(inner[::-1]), ends[1]])
        blades.append(planar(rim).extrude(vec(0, 0, 10)))
    solid = union(rod(38, vec(0, 0, 0), 4), rod(11, vec(0, 0, 0), 14), *blades)
    return minus(solid, rod(5, vec(0, 0, -5), 60))


def letters():
    """Cutouts with many re-entrant corners."""
    h = [(0, 0), (4, 0), (4, 8), (10, 8), (10, 0), (14, 0), (14, 20), (10, 20), (10, 12), (4, 12), (4, 20), (0, 20)]
    e = [(0, 0), (12, 0), (12, 4), (4, 4), (4, 8), (10, 8), (10, 12), (4, 12), (4, 16), (12, 16), (12, 20), (0, 20)]
    holes = [polygon_prism([[(x + a, 10 + b, z) for a, b in c] for z in (-5, 15)]) for c, x in ((h, 8), (e, 28))]
    return minus(box(0, 50, 0, 40, 0, 6), *holes)


def geneva_wheel():
    def on(radius, angle):
        return vec(radius * math.cos(angle), radius * math.sin(angle), -5)

    tools = [rod(12, on(48, math.radians(60 * i + 30)), 20) for i in range(6)]
    for i in range(6):
        slot = union(box(19, 49, -2.5, 2.5, -5, 15), rod(2.5, vec(19, 0, -5), 20))
        slot.rotate(vec(0, 0, 0), vec(0, 0, 1), 60 * i)
        tools.append(slot)
    return minus(rod(40, vec(0, 0, 0), 6), *tools, rod(6, vec(0, 0, -5), 30))


@pytest.mark.parametrize("part", [spline_pipe, blade_wheel, letters, geneva_wheel])
@pytest.mark.parametrize("scale, far", [(1, 0), (0.03, 0), (1e3, 1e6)])
def test_parts_that_people_draw(part, scale, far):
    """Small, large, and far from the origin. (Smaller still, OpenCASCADE's distances to a bent pipe miss its near side.)"""
    shape = part()
    shape.scale(scale)
    shape.translate(vec(far, -2 * far, far / 3))
    assert least(meshed(shape.Solids[0])) > 0.4

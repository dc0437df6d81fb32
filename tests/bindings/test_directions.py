"""Directions, types and intervals of every linking face, as a plan tells them to whoever draws them."""

import collections

import Part
import pytest
from FreeCAD import Vector

from sweepmesh.engine import Options, mesh, plan

TURN = {"end": 1, "side": 0, "corner": -1, "reversal": -2}


def bracket():
    """An L extruded along y, with a hole through its foot."""
    points = [(0, 0), (60, 0), (60, 15), (20, 15), (20, 50), (0, 50), (0, 0)]
    foot = Part.Face(Part.makePolygon([Vector(x, 0, z) for x, z in points]))
    return foot.extrude(Vector(0, 40, 0)).cut(Part.makeCylinder(6, 20, Vector(40, 20, -2)))


def drilled_block():
    """A round hole across the sweep: its circles are edges of linking faces and have to be divided."""
    hole = Part.makeCylinder(9, 20, Vector(32, 0, 25), Vector(0, 1, 0))
    return Part.makeBox(60, 40, 50).cut(hole).cut(Part.makeCylinder(4, 50, Vector(8, 20, 0)))


SHAPES = {
    "brick": lambda: Part.makeBox(30, 20, 10),
    "tube": lambda: Part.makeCylinder(10, 30).cut(Part.makeCylinder(5, 30)),
    "bracket": bracket,
    "drilled block": drilled_block,
}


@pytest.fixture(params=SHAPES, scope="module")
def planned(request):
    """(shape, plan) of the family."""
    shape = SHAPES[request.param]()
    return shape, plan(shape.exportBrepToString(), Options(size=4.0))


def edge(shape, name):
    return shape.Edges[int(name[len("Edge") :]) - 1]


def test_every_side_of_every_linking_face_has_a_direction(planned):
    shape, made = planned
    found = collections.Counter((d.face, d.edge) for d in made.directions if d.edge)
    divided = {corner.edge for corner in made.virtual_corners}
    for name, role in made.assessment.roles.items():
        if role != "linking":
            continue
        face = shape.Faces[int(name[len("Face") :]) - 1]
        for side in face.Edges:
            number = next(i for i, e in enumerate(shape.Edges, 1) if e.isSame(side))
            n_uses = 2 if side.isSeam(face) else 1
            n_found = found[name, f"Edge{number}"]
            assert n_found > n_uses if f"Edge{number}" in divided else n_found == n_uses


def test_every_linking_face_has_sides_along_i_and_k(planned):
    _, made = planned
    for face, role in made.assessment.roles.items():
        if role != "linking":
            continue
        for axis in "ik":
            mine = [d for d in made.directions if d.face == face and d.axis == axis]
            assert mine and all(d.intervals > 0 for d in mine)


def test_intervals_of_pieces_add_up_to_those_of_the_edge(planned):
    _, made = planned
    for face, role in made.assessment.roles.items():
        if role != "linking":  # a divided face has sides along parts of its edges only
            continue
        sums = collections.Counter()
        for d in made.directions:
            if d.face == face and d.edge:
                sums[d.edge] += d.intervals
        for name, total in sums.items():
            assert total in (made.intervals[name], 2 * made.intervals[name])  # twice: a seam


def test_signs_and_ends_follow_the_edge_and_the_levels(planned):
    shape, made = planned
    pieces = collections.Counter((d.face, d.edge) for d in made.directions)
    for d in made.directions:
        if d.edge is None:
            continue
        start, end = (Part.Vertex(*point) for point in (d.start, d.end))
        assert edge(shape, d.edge).distToShape(start)[0] < 1e-6 > edge(shape, d.edge).distToShape(end)[0]
        if pieces[d.face, d.edge] > 1:
            continue
        first, last = (edge(shape, d.edge).valueAt(t) for t in edge(shape, d.edge).ParameterRange)
        begin = first if d.sign > 0 else last
        assert begin.distanceToPoint(Vector(*d.start)) < 1e-6
        if d.axis == "k":
            low, high = (level_at(shape, made, point) for point in (d.start, d.end))
            assert high - low == d.intervals
            assert made.edge_roles[d.edge] == "axial"


def level_at(shape, made, point):
    nearest = min(range(len(shape.Vertexes)), key=lambda i: shape.Vertexes[i].Point.distanceToPoint(Vector(*point)))
    return made.levels[f"Vertex{nearest + 1}"]


def test_the_types_of_a_simple_face_add_up_to_four(planned):
    shape, made = planned
    for name, role in made.assessment.roles.items():
        face = shape.Faces[int(name[len("Face") :]) - 1]
        if role != "linking" or len(face.Wires) > 1 or any(face.isSame(f) for f in closed_faces(shape)):
            continue
        total = sum(TURN[kind] for its, _, kind in made.corners if its == name)
        total += sum(TURN[corner.type] for corner in made.virtual_corners if corner.face == name)
        assert total == 4, name


def closed_faces(shape):
    """Faces with a seam."""
    return [f for f in shape.Faces if any(e.isClosed() for e in f.Edges)]


def test_virtual_corners_lie_on_divided_edges():
    shape = drilled_block()
    made = plan(shape.exportBrepToString(), Options(size=4.0))
    assert made.virtual_corners and "divided" in made.edge_roles.values()
    turning = [corner for corner in made.virtual_corners if corner.type != "side"]
    assert {made.edge_roles[corner.edge] for corner in turning} == {"divided"}
    for corner in made.virtual_corners:
        assert edge(shape, corner.edge).distToShape(Part.Vertex(*corner.point))[0] < 1e-6
        assert made.assessment.roles[corner.face] in ("linking", "divided")
    assert any(d.edge is None for d in made.directions)
    assert any("rounded edges" in text for text in mesh(shape.exportBrepToString(), Options(size=4.0)).warnings)

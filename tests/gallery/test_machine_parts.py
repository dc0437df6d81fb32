"""Parts as engineers draw them, with fillets and rounds that are tangent to caps, meshed without picks."""

import math

import pytest
from checker import expect_valid_sweep

from sweepmesh import Model, Options, mesh
from sweepmesh.freecad import import_freecad

FreeCAD = import_freecad()
import Part  # noqa: E402

Z = FreeCAD.Vector(0, 0, 1)


def rod(radius, length, x=0.0, y=0.0, z=0.0):
    return Part.makeCylinder(radius, length, FreeCAD.Vector(x, y, z))


def block(a, b, c, x=0.0, y=0.0, z=0.0):
    return Part.makeBox(a, b, c, FreeCAD.Vector(x, y, z))


def drilled(shape, radius, centres):
    for x, y in centres:
        shape = shape.cut(rod(radius, 200, x, y, -50))
    return shape


def edges_at(shape, z):
    """Edges that lie at a height."""
    return [e for e in shape.Edges if abs(e.BoundBox.ZMin - z) < 1e-6 and abs(e.BoundBox.ZMax - z) < 1e-6]


def circles_at(shape, z, radius):
    return [e for e in edges_at(shape, z) if isinstance(e.Curve, Part.Circle) and abs(e.Curve.Radius - radius) < 1e-6]


def ring(radius, count):
    return [(radius * math.cos(2 * math.pi * i / count), radius * math.sin(2 * math.pi * i / count)) for i in range(count)]


def flange():
    hub = rod(40, 8).fuse(rod(20, 30)).cut(rod(12, 50, z=-1))
    return drilled(hub.makeFillet(4, circles_at(hub, 8, 20)), 4, ring(32, 6))


def angle(radius):
    """An angle with its inner corner, or all its corners, rounded, and a hole in one leg."""
    legs = block(50, 40, 8).fuse(block(8, 40, 50)).removeSplitter()
    inner = [e for e in legs.Edges if e.BoundBox.YLength > 39 and abs(e.CenterOfMass.x - 8) + abs(e.CenterOfMass.z - 8) < 1e-6]
    corners = inner if radius > 3 else [e for e in legs.Edges if e.BoundBox.YLength > 39]
    return drilled(legs.makeFillet(radius, corners), 4, [(30, 20)])


def boss(*, root, rim):
    part = block(60, 60, 10).fuse(rod(12, 20, 30, 30, 10))
    part = part.makeFillet(root, circles_at(part, 10, 12))
    return part.makeFillet(rim, edges_at(part, 30)) if rim else part


def pocket():
    hole = block(50, 30, 10, 15, 15, 7)
    hole = hole.makeFillet(6, [e for e in hole.Edges if e.BoundBox.ZLength > 9])
    return block(80, 60, 15).cut(hole.makeFillet(2, edges_at(hole, 7)))


def cup():
    hollow = rod(17, 30, z=4)
    return rod(20, 30).cut(hollow.makeFillet(3, edges_at(hollow, 4)))


def stepped_shaft():
    shaft = rod(15, 20).fuse(rod(9, 40))
    return shaft.makeFillet(2, circles_at(shaft, 20, 9))


def rib():
    plate = block(80, 50, 5).fuse(block(6, 50, 20, 30, 0, 5)).removeSplitter()
    feet = [e for e in edges_at(plate, 5) if e.BoundBox.YLength > 49 and 29 < e.CenterOfMass.x < 37]
    return plate.makeFillet(3, feet)


def rounded_top(solid, z, radius):
    return solid.makeFillet(radius, edges_at(solid, z))


def chamfered(solid, z, length, radius):
    return solid.makeChamfer(length, circles_at(solid, z, radius))


def tee():
    return rod(10, 60, z=-30).fuse(Part.makeCylinder(7, 30, FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0))).removeSplitter()


def cross_bored():
    return rod(10, 60).cut(Part.makeCylinder(4, 40, FreeCAD.Vector(-20, 0, 30), FreeCAD.Vector(1, 0, 0)))


def lever(large, small, distance, web):
    """Two hubs and a thinner web whose sides touch both: the web's corners have no angle."""
    slope = (large - small) / distance
    side = math.sqrt(1 - slope**2)
    corners = [(r * slope + x, s * r * side, 2) for x, r, s in ((0, large, 1), (distance, small, 1), (distance, small, -1), (0, large, -1))]
    corners = [FreeCAD.Vector(*c) for c in corners]
    plate = Part.Face(Part.makePolygon([*corners, corners[0]])).extrude(web * Z)
    hubs = rod(large, web + 4).fuse(rod(small, web + 4, distance))
    return drilled(drilled(hubs.fuse(plate).removeSplitter(), large / 2, [(0, 0)]), small / 2, [(distance, 0)])


PARTS = {
    "flange_with_a_fillet": flange,
    "angle_with_a_fillet": lambda: angle(4),
    "angle_rounded_everywhere": lambda: angle(2),
    "boss_with_a_fillet": lambda: boss(root=4, rim=0),
    "boss_with_a_fillet_and_a_round": lambda: boss(root=3, rim=2),
    "pocket_with_rounds": pocket,
    "cup_with_a_fillet": cup,
    "shaft_with_a_fillet": stepped_shaft,
    "rib_with_fillets": rib,
    "pin_with_a_round": lambda: rounded_top(rod(20, 20), 20, 4),
    "block_with_a_rounded_top": lambda: rounded_top(block(40, 30, 20), 20, 3),
    "chamfered_hole": lambda: chamfered(drilled(block(50, 40, 12), 6, [(25, 20)]), 12, 1.5, 6),
    "domed_pin": lambda: rod(8, 50).fuse(Part.makeSphere(12, FreeCAD.Vector(0, 0, 41)).common(rod(8, 80))),
    "tee_of_rods": tee,
    "shaft_with_a_cross_bore": cross_bored,
}
LEAST = 0.1


@pytest.mark.parametrize("name", PARTS)
def test_is_meshed_without_picks(name):
    solid = PARTS[name]().Solids[0]
    assert solid.isValid()
    model = Model.from_brep(solid.exportBrepToString(), 0)
    result = mesh(model, Options())
    assert result.assessment.is_sweepable, result.assessment.reasons
    expect_valid_sweep(result, model)
    assert result.quality["min_scaled_jacobian"] > LEAST


@pytest.mark.parametrize("large, small, distance, web", [(12, 8, 60, 6), (10, 10, 40, 3), (20, 6, 50, 8)])
@pytest.mark.parametrize("factor", [0.7, 1.0, 1.6])
def test_webs_that_touch_their_hubs(large, small, distance, web, factor):
    """The CAD model's corners of no degrees leave room for valid elements, though not for good ones."""
    solid = lever(large, small, distance, web).Solids[0]
    model = Model.from_brep(solid.exportBrepToString(), 0)
    result = mesh(model, Options(size=factor * (solid.Volume / 3000) ** (1 / 3)))
    expect_valid_sweep(result, model)
    assert result.quality["mean_scaled_jacobian"] > 0.8


def test_picked_caps_are_taken_though_more_faces_would_be_cheaper():
    """All faces of one side of an angle that is rounded everywhere are tangent to each other, so they could be sources."""
    solid = angle(2).Solids[0]
    faces = {name: [] for name in ("sources", "targets")}
    for number, face in enumerate(solid.Faces, 1):
        if isinstance(face.Surface, Part.Plane) and abs(face.normalAt(0, 0).z) > 0.999:
            faces["sources" if face.normalAt(0, 0).z > 0 else "targets"].append(number)
    result = mesh(Model.from_brep(solid.exportBrepToString(), 0), Options(**faces))
    roles = result.assessment.roles
    assert sorted(f for f, role in roles.items() if role == "source") == [f"Face{n}" for n in faces["sources"]]
    assert [f for f, role in roles.items() if role == "target"] == [f"Face{n}" for n in faces["targets"]]

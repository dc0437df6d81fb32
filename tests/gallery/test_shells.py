"""Sweeps through the thickness of a wall, by family: closed shells, tubes, junctions, voids of other shapes."""

import math

import pytest
from checker import expect_valid_sweep
from gallery import find_judge

from sweepmesh import Options, mesh, read, write
from sweepmesh.freecad import import_freecad

FreeCAD = import_freecad()
import Part  # noqa: E402

JUDGE = find_judge()
Z = FreeCAD.Vector(0, 0, 1)


def at(x=0.0, y=0.0, z=0.0):
    return FreeCAD.Vector(x, y, z)


def rod(radius, length, foot=at(), along=Z):
    return Part.makeCylinder(radius, length, foot, along)


def block(x, y, z):
    return Part.makeBox(x, y, z, at(-x / 2, -y / 2, -z / 2))


def turned(shape, degrees, axis=Z, about=at()):
    shape = shape.copy()
    shape.rotate(about, axis, degrees)
    return shape


def ellipsoid(a, b, c):
    matrix = FreeCAD.Matrix()
    matrix.scale(a, b, c)
    return Part.makeSphere(1.0).transformGeometry(matrix)


def hexagonal(radius, height):
    corners = [at(radius * math.cos(k * math.pi / 3), radius * math.sin(k * math.pi / 3), -height / 2) for k in range(7)]
    return Part.Face(Part.makePolygon(corners)).extrude(Z * height)


def bent_rod(radius):
    """Straight, a quarter of a ring, straight."""
    corner = at(40 - 40 * math.cos(math.pi / 4), 0, 30 + 40 * math.sin(math.pi / 4))
    path = [
        Part.makeLine(at(), at(z=30)),
        Part.Arc(at(z=30), corner, at(40, 0, 70)).toShape(),
        Part.makeLine(at(40, 0, 70), at(70, 0, 70)),
    ]
    return Part.Wire(path).makePipeShell([Part.Wire(Part.makeCircle(radius))], True, False)


def tee(main, branch):
    return rod(main, 80, at(z=-40)).fuse(rod(branch, 45, at(), at(0, 1, 0)))


def flask(ball, neck, along=Z):
    return Part.makeSphere(ball).fuse(rod(neck, 45, at(), along))


# Outer and inner body, and the least scaled Jacobian to expect at a size of 3.5.
CLOSED = {
    "ball_in_ball": (Part.makeSphere(24), Part.makeSphere(12), 0.7),
    "ball_off_centre": (Part.makeSphere(24), turned(Part.makeSphere(12, at(3, 2, 1)), 70, at(1, 0.3), at(3, 2, 1)), 0.65),
    "ellipsoids": (ellipsoid(34, 24, 19), ellipsoid(17, 12, 10), 0.6),
    "rings": (Part.makeTorus(40, 14), Part.makeTorus(40, 8), 0.55),
    "box_in_box": (block(60, 50, 40), block(32, 24, 18), 0.4),
    "turned_box_in_box": (block(60, 50, 40), turned(block(32, 24, 18), 20, at(0.2, 0.3, 1)), 0.25),
    "hexagons": (hexagonal(30, 40), hexagonal(18, 20), 0.45),
    "can": (rod(20, 60), rod(12, 40, at(z=10)), 0.5),
    "can_with_turned_void": (rod(20, 60), turned(rod(12, 40, at(z=10)), 50), 0.5),
    "ball_in_box": (block(50, 46, 40), Part.makeSphere(12), 0.45),
    "box_in_ball": (Part.makeSphere(30), block(24, 20, 18), 0.45),
    "can_in_ball": (Part.makeSphere(30), rod(12, 24, at(z=-12)), 0.55),
}
OPEN = {
    "tube": (rod(20, 60), rod(12, 60), 0.95),
    "tube_with_turned_seam": (rod(20, 60), turned(rod(12, 60), 50), 0.9),
    "cone": (Part.makeCone(24, 10, 50), Part.makeCone(18, 6, 50), 0.5),
    "dome": (Part.makeSphere(24, at(), Z, 0, 90, 360), Part.makeSphere(14), 0.65),
    "elbow": (bent_rod(14), bent_rod(9), 0.8),
    "tee": (tee(20, 12), tee(14, 7), 0.45),
    "flask": (flask(30, 10), flask(24, 6), 0.45),
    "flask_with_neck_across_poles": (flask(30, 10, at(-0.8, 0.6)), flask(24, 6, at(-0.8, 0.6)), 0.45),
    "ball_with_bore_across_poles": (
        Part.makeSphere(24).cut(rod(8, 30, at(), at(-0.8, 0.6))),
        Part.makeSphere(14).fuse(rod(8, 30, at(), at(-0.8, 0.6))),
        0.5,
    ),
}


def lies_on(body, point):
    vertex = Part.Vertex(point)
    return min(face.distToShape(vertex)[0] for face in body.Faces) < 1e-5


def caps(shape, outer, inner):
    """Numbers of the faces with all their edges on the skin of one body; flat ends of open shells are none."""
    sources, targets = [], []
    for number, face in enumerate(shape.Faces, 1):
        if len(shape.Shells) == 1 and isinstance(face.Surface, Part.Plane):
            continue
        points = [edge.valueAt(0.3 * edge.FirstParameter + 0.7 * edge.LastParameter) for edge in face.Edges]
        on_outer = all(lies_on(outer, point) for point in points)
        on_inner = all(lies_on(inner, point) for point in points)
        if on_outer != on_inner:
            (sources if on_outer else targets).append(number)
    return sources, targets


def swept(outer, inner, tmp_path, **options):
    shape = outer.cut(inner).Solids[0]
    path = tmp_path / "shell.step"
    shape.exportStep(str(path))
    model = read(path)
    sources, targets = caps(Part.read(str(path)), outer, inner)
    return path, model, mesh(model, Options(size=3.5, sources=sources, targets=targets, **options))


def expect_good(path, model, result, least, tmp_path, genus=None):
    assert result.assessment.is_sweepable, [reason.text for reason in result.assessment.reasons]
    expect_valid_sweep(result, model, genus)
    assert result.quality["min_scaled_jacobian"] > least
    if JUDGE:
        write(result, tmp_path / "mesh.vtu")
        assert JUDGE(str(tmp_path / "mesh.vtu"), str(path))["failures"] == []


@pytest.mark.parametrize("name", CLOSED)
def test_closed_shells_sweep_from_skin_to_void(name, tmp_path):
    outer, inner, least = CLOSED[name]
    genus = [1, 1] if name == "rings" else [0, 0]
    expect_good(*swept(outer, inner, tmp_path), least, tmp_path, genus)


@pytest.mark.parametrize("name", OPEN)
def test_open_shells_sweep_through_their_wall(name, tmp_path):
    outer, inner, least = OPEN[name]
    expect_good(*swept(outer, inner, tmp_path), least, tmp_path)


def sector(degrees, n):
    """Part of a tube, its walls divided into n faces each."""
    part = Part.makeCylinder(20, 60, at(), Z, degrees / n).cut(rod(12, 60))
    parts = [turned(part, degrees / n * k) for k in range(n)]
    return parts[0].fuse(parts[1:])


@pytest.mark.parametrize("degrees, n", [(100, 3), (150, 3), (170, 2), (240, 4)])
def test_part_of_a_divided_pipe_wall_sweeps_like_a_straight_one(degrees, n, tmp_path):
    shape = sector(degrees, n).Solids[0]
    path = tmp_path / "shell.step"
    shape.exportStep(str(path))
    walls = [(k, f.Surface.Radius) for k, f in enumerate(Part.read(str(path)).Faces, 1) if isinstance(f.Surface, Part.Cylinder)]
    sources, targets = ([k for k, radius in walls if abs(radius - r) < 1e-6] for r in (20, 12))
    model = read(path)
    expect_good(path, model, mesh(model, Options(size=3.5, sources=sources, targets=targets)), 0.98, tmp_path)


@pytest.mark.parametrize("name", ["ball_in_ball", "box_in_box", "tube", "tee"])
def test_layers_are_as_many_as_asked_for(name, tmp_path):
    outer, inner, least = {**CLOSED, **OPEN}[name]
    path, model, result = swept(outer, inner, tmp_path, layers=5)
    expect_good(path, model, result, least, tmp_path)
    assert result.n_layers == 5


@pytest.mark.parametrize("name", [name for name in CLOSED if name != "rings"])
def test_closed_convex_shells_need_no_picks(name, tmp_path):
    outer, inner, _ = CLOSED[name]
    path = tmp_path / "shell.step"
    outer.cut(inner).Solids[0].exportStep(str(path))
    model = read(path)
    expect_good(path, model, mesh(model, Options(size=3.5)), 0.1, tmp_path, [0, 0])


@pytest.mark.parametrize("name", ["ball_in_ball", "box_in_box", "tube"])
def test_prisms_fill_shells_too(name, tmp_path):
    outer, inner, _ = {**CLOSED, **OPEN}[name]
    _, model, result = swept(outer, inner, tmp_path, element="prism")
    assert len(result.prisms) and not len(result.hexahedra)
    expect_valid_sweep(result, model)

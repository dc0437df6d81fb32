"""Planes that divide solids that cannot be swept: they are found, and the pieces really mesh."""

import FreeCAD
import Part
import pytest
import sweepmesh
from checker import expect_valid_sweep
from gallery import cases
from solids.kit import box, rod, vec


def handle(radius, thickness, base):
    """Half a ring that stands with both feet on the top (z = 0) of a base."""
    ring = Part.makeTorus(radius, thickness)
    ring.rotate(vec(0, 0, 0), vec(1, 0, 0), 90)
    return base.fuse(ring.common(box(-60, 60, -60, 60, 0, 60)))


def turned(shape, axis, degrees):
    """The same solid elsewhere in space."""
    shape.rotate(vec(0, 0, 0), axis, degrees)
    return shape


HANDLES = {
    "disc": lambda: handle(12, 3, rod(25, vec(0, 0, -10), 10)),
    "tilted": lambda: turned(handle(12, 3, rod(25, vec(0, 0, -10), 10)), vec(1, 2, 3), 50),
    "thick": lambda: handle(13, 4, rod(24, vec(0, 0, -8), 8)),
    "tall": lambda: handle(10, 2, rod(20, vec(0, 0, -30), 30)),
}


def brep(shape):
    """Text for the engine."""
    return shape.exportBrepToString()


def expect_plane(cut, shape):
    """The plane runs through the solid, and is that of its face where it names one."""
    normal, point = FreeCAD.Vector(*cut.normal), FreeCAD.Vector(*cut.point)
    heights = [(vertex.Point - point).dot(normal) for vertex in shape.Vertexes]
    assert min(heights) < 0 < max(heights)
    if cut.face is not None:
        face = shape.Faces[cut.face - 1]
        assert abs(abs(face.normalAt(0, 0).dot(normal)) - 1) < 1e-6
        assert abs((face.CenterOfMass - point).dot(normal)) < 1e-6


@pytest.mark.parametrize("name", HANDLES)
def test_a_handle_is_cut_off_and_both_pieces_mesh(name):
    shape = HANDLES[name]()
    assert not sweepmesh.assess(brep(shape)).is_sweepable
    cut = sweepmesh.suggest_cut(brep(shape))
    assert cut and len(cut.pieces) == 2
    expect_plane(cut, shape)
    assert cut.text.startswith("Cut it along the plane ") and cut.text.endswith(".")
    assert abs(sum(piece.volume for piece in cut.pieces) - shape.Volume) < 1e-6 * shape.Volume
    kept = Part.Shape()
    kept.importBrepFromString(cut.shape)
    assert len(kept.Solids) == 2
    for piece in cut.pieces:
        result = sweepmesh.mesh(piece)
        assert result.assessment.is_sweepable
        expect_valid_sweep(result, piece)


def test_a_ball_with_two_voids_is_cut_between_them():
    """Figure 7.4: every piece then has one void."""
    case = next(case for case in cases("unsweepable") if case.name == "sphere_two_voids")
    cut = sweepmesh.suggest_cut(sweepmesh.read(case.path))
    assert cut and cut.face is None and abs(abs(cut.normal[0]) - 1) < 1e-9 and abs(cut.point[0]) < 1e-6
    assert all(sweepmesh.assess(piece).is_sweepable for piece in cut.pieces)


def test_there_is_no_cut_where_none_is_needed_or_none_helps():
    assert sweepmesh.suggest_cut(brep(box(0, 3, 0, 2, 0, 1))) is None
    assert sweepmesh.suggest_cut(brep(Part.makeSphere(10))) is None

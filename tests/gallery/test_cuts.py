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


def expect_pieces_mesh(cut):
    """Each piece gives a valid mesh of all of it."""
    for piece in cut.pieces:
        result = sweepmesh.mesh(piece)
        assert result.assessment.is_sweepable
        expect_valid_sweep(result, piece)


@pytest.mark.parametrize("name", HANDLES)
def test_a_handle_is_cut_off_and_both_pieces_mesh(name):
    """As figure 7.5: neither a regular nor a radial sweep, until it is split."""
    shape = HANDLES[name]()
    assert not sweepmesh.assess(brep(shape)).is_sweepable
    cut = sweepmesh.suggest_cut(brep(shape))
    assert cut and len(cut.pieces) == 2 and cut.is_tried
    expect_plane(cut, shape)
    assert cut.text.startswith("Cut it along the plane ") and cut.text.endswith(" as a trial has shown.")
    assert abs(sum(piece.volume for piece in cut.pieces) - shape.Volume) < 1e-6 * shape.Volume
    kept = Part.Shape()
    kept.importBrepFromString(cut.shape)
    assert len(kept.Solids) == 2
    expect_pieces_mesh(cut)


@pytest.mark.parametrize("name", ["sphere_two_voids", "sphere_three_voids"])
def test_a_ball_with_voids_is_cut_between_them(name):
    """Figure 7.4: then every piece has a void of its own, and may be swept outwards."""
    case = next(case for case in cases("unsweepable") if case.name == name)
    model = sweepmesh.read(case.path)
    assert not sweepmesh.assess(model).is_sweepable
    cut = sweepmesh.suggest_cut(model)
    assert cut and cut.face is None and cut.is_tried
    assert abs(abs(cut.normal[0]) - 1) < 1e-9 and abs(cut.point[0]) < 1e-6
    assert abs(sum(piece.volume for piece in cut.pieces) - model.volume) < 1e-6 * model.volume
    expect_pieces_mesh(cut)


@pytest.mark.parametrize("axis", [(1, 0, 0), (0, 1, 0), (1, 2, 3)], ids=str)
def test_the_poles_of_a_ball_are_of_no_account(axis):
    """The same solid, with the poles of its spheres elsewhere and its voids along any line."""
    way = vec(*axis).normalize()
    solid = Part.makeSphere(20, vec(0, 0, 0), vec(3, 1, 2))
    for sign in (1, -1):
        solid = solid.cut(Part.makeSphere(5, way * (9 * sign), vec(1, sign, 0)))
    cut = sweepmesh.suggest_cut(brep(solid))
    assert cut and cut.is_tried and abs(abs(vec(*cut.normal).dot(way)) - 1) < 1e-6
    expect_pieces_mesh(cut)


def test_there_is_no_cut_where_none_is_needed_or_none_helps():
    assert sweepmesh.suggest_cut(brep(box(0, 3, 0, 2, 0, 1))) is None
    assert sweepmesh.suggest_cut(brep(Part.makeSphere(10))) is None

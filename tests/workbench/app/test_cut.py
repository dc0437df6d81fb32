"""Pieces of a solid as a document object."""
import FreeCAD
import pytest

from sweepmesh import app
from sweepmesh.engine import InputError


def test_pieces_fill_the_solid_and_share_a_face(box, document):
    pieces = app.make_cut(box, point=(4, 0, 0), normal=(1, 0, 0))
    assert sorted(round(solid.Volume, 6) for solid in pieces.Shape.Solids) == [32.0, 48.0]
    assert len(pieces.Shape.Faces) == 11, "the face between them is there once"
    assert box.Shape.Volume == pytest.approx(80.0), "the source is left as it is"
    assert app.make_sweep_mesh(pieces, size=1.0).Hexahedra == 80


def test_a_moved_solid_is_cut_where_it_is(box, document):
    box.Placement = FreeCAD.Placement(FreeCAD.Vector(5, 6, 7), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
    document.recompute()
    pieces = app.make_cut(box, point=(0, 11, 0), normal=(0, 2, 0))
    assert sorted(round(solid.Volume, 6) for solid in pieces.Shape.Solids) == [40.0, 40.0]


def test_a_plane_beside_the_solid_is_told(box, document):
    before = len(document.Objects)
    with pytest.raises(InputError):
        app.make_cut(box, point=(-1, 0, 0), normal=(1, 0, 0))
    assert len(document.Objects) == before

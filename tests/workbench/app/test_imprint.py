"""Divided caps and imprinted curves in a document, by a macro."""
import FreeCAD
import Part
import pytest

from sweepmesh import app
from sweepmesh.app.imprints import pair_color
from sweepmesh.engine import InputError


UPWARDS = {"size": 4.0, "sources": [(30, 15, 20), (10, 15, 35)], "targets": [(20, 15, 0)]}


@pytest.fixture
def block(document):
    """Two sources over one target."""
    obj = document.addObject("Part::Feature", "Block")
    obj.Shape = Part.makeBox(40, 30, 20).fuse(Part.makeBox(20, 30, 35)).removeSplitter()
    return obj


def test_the_group_holds_caps_and_curves(block, document):
    group = app.make_imprint(block, **UPWARDS)
    caps, curves = group.Group
    assert group.Label == "Imprint of Block" and caps.Document is document
    assert len(caps.Shape.Faces) == len(caps.Pairs) == len(caps.Caps) == len(caps.Roles) == 4
    assert sorted(caps.Pairs) == [1, 1, 2, 2] and sorted(caps.Roles) == ["source"] * 2 + ["target"] * 2
    assert len(curves.Shape.Wires) == len(curves.Caps) == 1
    assert curves.Shape.BoundBox.XMin == pytest.approx(20)
    assert caps.isValid() and curves.isValid()


def test_the_group_survives_saving(block, document, tmp_path):
    app.make_imprint(block, **UPWARDS)
    path = str(tmp_path / "imprint.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    restored = FreeCAD.openDocument(path)
    caps, curves = restored.Imprint.Group
    assert sorted(caps.Pairs) == [1, 1, 2, 2] and len(caps.Shape.Faces) == 4 and len(curves.Shape.Wires) == 1
    FreeCAD.closeDocument(restored.Name)


def test_pairs_have_one_colour_and_others_another(block):
    made = app.imprint(block, **UPWARDS)
    assert len(set(made.colors)) == made.details.n_pairs == 2
    for pair, color in zip(made.pairs, made.colors):
        assert color == pair_color(pair)
    for pair in (1, 2):
        target, source = made.parts_of(pair)
        assert target.Area == pytest.approx(source.Area) and target.CenterOfMass.z < source.CenterOfMass.z


def test_hundred_pairs_have_a_hundred_colours():
    assert len({tuple(round(255 * c) for c in pair_color(n)) for n in range(1, 101)}) == 100


def test_curves_of_a_cap(block):
    made = app.imprint(block, **UPWARDS)
    (cap,) = set(made.details.curve_caps)
    assert len(made.curves_on(cap)) == 1 and made.curves_on("Face99") == []


def test_a_plan_can_be_imprinted(block):
    plan = app.plan(block, **UPWARDS)
    assert app.imprint(plan).details.n_pairs == 2
    assert app.make_imprint(block, made=app.imprint(plan)).Group[0].Pairs


def test_an_unsweepable_solid_leaves_no_group(document):
    ball = document.addObject("Part::Sphere", "Ball")
    document.recompute()
    with pytest.raises(InputError, match="cannot be swept"):
        app.make_imprint(ball)
    assert document.Objects == [ball]


def test_undo_takes_the_group_away(block, document):
    document.UndoMode = 1
    document.openTransaction("imprint")
    app.make_imprint(block, **UPWARDS)
    document.commitTransaction()
    document.undo()
    assert [obj.Name for obj in document.Objects] == ["Block"]

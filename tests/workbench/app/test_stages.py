"""assess, plan and mesh as a macro calls them."""
import FreeCAD
import Part
import pytest

from sweepmesh import app
from sweepmesh.app.shapes import face_number, has_solid
from sweepmesh.engine.errors import InputError


def test_ten_lines_of_macro_do_what_the_command_line_does(tmp_path):
    solid = Part.makeBox(10, 4, 2)
    plan = app.plan(solid, size=1.0, sources=[(5, 2, 2)])
    assert plan.is_sweepable
    assert "Face6" in str(plan)
    result = app.mesh(plan)
    fem_mesh = app.to_femmesh(result)
    fem_mesh.write(str(tmp_path / "box.unv"))
    assert fem_mesh.HexaCount == len(result.hexahedra)
    assert (tmp_path / "box.unv").stat().st_size > 0


@pytest.mark.parametrize("face", ["Face6", 6, (5, 2, 2), FreeCAD.Vector(1, 1, 2), "a Part.Face"])
def test_a_face_can_be_said_in_five_ways(box, face):
    if face == "a Part.Face":
        face = box.Shape.Faces[5]
    assert face_number(box, face) == 6


@pytest.mark.parametrize("face", ["Face7", "Face0", 7, 0, "Edge1", "Facet", "", "another shape's"])
def test_a_face_that_is_none_is_an_error(box, face):
    if face == "another shape's":
        face = Part.makeBox(1, 1, 1).Faces[0]
    with pytest.raises(InputError):
        face_number(box, face)


def test_the_plan_names_what_was_picked_and_what_was_found(box):
    plan = app.plan(box, sources=["Face1"])
    assert plan.options.sources == [1] and plan.options.targets == [2]
    assert plan.faces("linking") == ["Face3", "Face4", "Face5", "Face6"]


def test_the_plan_tells_the_numbers_of_the_mesh(box):
    plan = app.plan(box, size=1.0, sources=["Face6"])
    result = app.mesh(plan)
    assert plan.intervals == result.intervals
    assert plan.details.n_layers == 2 and "layers   2" in str(plan)


def test_an_unsweepable_solid_is_an_answer_and_no_error():
    plan = app.plan(Part.makeSphere(5))
    assert not plan.is_sweepable and plan.assessment.reasons[0].text in str(plan)


def test_solids_and_what_is_none(document, box):
    empty = document.addObject("Part::Feature", "Empty")
    group = document.addObject("App::DocumentObjectGroup", "Group")
    assert has_solid(box) and has_solid(box.Shape)
    assert not has_solid(empty) and not has_solid(group) and not has_solid(Part.makePlane(1, 1))
    for wrong in (empty, group, Part.makePlane(1, 1), 7):
        with pytest.raises(InputError):
            app.assess(wrong)


def test_a_shape_of_two_solids_becomes_one_mesh(document):
    pair = document.addObject("Part::Feature", "Pair")
    pair.Shape = Part.makeCompound([Part.makeBox(4, 4, 4), Part.makeBox(2, 4, 4, FreeCAD.Vector(10, 0, 0))])
    mesh = app.make_sweep_mesh(pair, size=1.0)
    assert mesh.isValid() and mesh.FemMesh.HexaCount == 64 + 32
    names = [mesh.FemMesh.getGroupName(group) for group in mesh.FemMesh.Groups]
    assert "Face1" in names and "Face12" in names
    app.update_sweep_mesh(mesh, solid=2)
    assert mesh.Solid == 2 and mesh.FemMesh.HexaCount == 32


def test_a_shape_without_a_solid_is_told(document):
    with pytest.raises(InputError, match="no solid"):
        app.assess(Part.makeBox(1, 1, 1).Shells[0])

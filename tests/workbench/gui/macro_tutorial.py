"""The steps of the tutorial on the pipe junction, docs/tutorial.md, and its pictures."""
import os
import pathlib
import sys

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
from driver import (
    answer_file_dialog, check, choose, click_edge, click_point, click_row, go, is_panel_open, look_from, note, panel_button,
    picture, press, reveal, rows, show_all, tool_button, type_into, wait_for, widget,
)
from fem import constraint, new_analysis, show_stresses, solve

PART = pathlib.Path(os.environ["SWEEPMESH_TEST_CODE"]).parents[2] / "Resources" / "examples" / "pipe_junction.step"


def steps():
    document, pipe = open_part()
    proposal(pipe)
    other_way(pipe)
    previews(pipe)
    overrides(pipe)
    mesh(document)
    quality(document)
    analysis(document, pipe)


def open_part():
    document = FreeCAD.newDocument("Junction")
    document.UndoMode = 1
    answer_file_dialog("Std_Import", PART, "STEP")
    check("the part is opened", lambda: _solids(document))
    show_all()
    return document, _solids(document)[0]


def _solids(document):
    return [obj for obj in document.Objects if hasattr(obj, "Shape") and obj.Shape.Solids]


def proposal(pipe):
    click_point((24, 0, 15))
    press(tool_button("Create sweep mesh"))
    check("a click takes the outer wall as source", lambda: rows("sources") and "can be swept" in widget("verdict").text())
    picture("01_through_the_wall")


def other_way(pipe):
    press(widget("propose"))
    check("two ways are proposed", lambda: widget("schemes").count() == 2)
    choose("schemes", 1)
    check("along the pipe there are three sources", lambda: len(rows("sources")) == len(rows("targets")) == 3)
    check("and they can be swept", lambda: "can be swept" in widget("verdict").text())
    reveal(widget("propose"))
    picture("02_along_the_pipe")


def previews(pipe):
    type_into("meshSize", "4 mm")
    press(widget("showLevels"))
    check("the plan is made", lambda: "layers" in widget("planSummary").text())
    picture("03_levels")
    press(widget("showLevels"))
    press(widget("showPairs"))
    press(widget("showCurves"))
    check("the patches are paired", lambda: "pairs" in widget("planSummary").text())
    picture("04_pairs")
    press(widget("showPairs"))
    press(widget("showCurves"))


def overrides(pipe):
    arc = _arc_of_the_bore(pipe)
    press(widget("pickOverride"))
    type_into("overrideCount", "6")
    click_edge(pipe, arc)
    check("the arc gets its own number", lambda: rows("overrides") == [f"{arc}: 6 intervals"])
    reveal(widget("overrides"))
    picture("05_override")
    press(widget("pickOverride"))
    press(widget("showIntervals"))


def _arc_of_the_bore(pipe):
    """The edge of the bore at its side, in the outer wall, at large x and small y."""
    centres = {f"Edge{i}": edge.CenterOfMass for i, edge in enumerate(pipe.Shape.Edges, 1)}
    return next(name for name, at in centres.items() if abs(at.z) < 1e-3 and at.x > 20 and -10 < at.y < -1)


def mesh(document):
    press(panel_button("OK"))
    check("the mesh is made", lambda: not is_panel_open() and document.getObject("SweepMesh"))
    made = document.SweepMesh
    note("hexahedra", made.Hexahedra)
    check("all elements are good", made.isValid() and made.MinScaledJacobian > 0.3)
    look_from(1, -0.7, 0.6)
    picture("06_mesh")


def quality(document):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(document.SweepMesh)
    press(tool_button("Quality of the sweep mesh"))
    check("the quality is shown", lambda: widget("worst").count() > 0)
    choose("axis", 2)
    picture("07_quality")
    click_row("worst", 0)
    press(panel_button("Close"))
    wait_for(lambda: not is_panel_open())


def analysis(document, pipe):
    pipe.ViewObject.Visibility, document.SweepMesh.ViewObject.Visibility = True, False
    made = new_analysis(document)
    constraint("FEM_ConstraintFixed", pipe, _end(pipe, -1), "lw_references")
    constraint("FEM_ConstraintForce", pipe, _end(pipe, 1), "listReferences", ("spinForce", "20000"))
    made.addObject(document.SweepMesh)
    results = solve(document)
    note("largest displacement", max(vector.Length for vector in results.DisplacementVectors))
    pipe.ViewObject.Visibility = False
    show_stresses(document)
    look_from(1, -0.7, 0.6)
    picture("08_stresses")
    FreeCADGui.Control.closeDialog()


def _end(pipe, side):
    """The plane end of the pipe below (-1) or above (1)."""
    faces = enumerate(pipe.Shape.Faces, 1)
    return next(f"Face{i}" for i, face in faces if abs(face.CenterOfMass.z - 25 * side) < 1e-6)


go(steps)

"""From a STEP file to a solved analysis and to files, without leaving the GUI: FreeCAD's commands, ours in their midst."""
import os
import pathlib
import sys

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
import Part
from driver import (
    OUT, answer_file_dialog, check, click_face, go, is_panel_open, note, panel_button, picture, press, rows, show_all,
    tool_button, type_into,
)
from fem import constraint, look_at, new_analysis, show_stresses, solve

FOLDER = pathlib.Path(OUT)


def steps():
    document, pipe = import_step()
    ends = [f"Face{i}" for i, face in enumerate(pipe.Shape.Faces, 1) if face.Surface.TypeId == "Part::GeomPlane"]
    analysis = make_analysis(document, pipe, ends)
    mesh(document, analysis, pipe, ends)
    nodes_of_constraints(document, pipe, ends)
    results = solve(document)
    largest = max(vector.Length for vector in results.DisplacementVectors)
    note("largest displacement", largest)
    check("the pipe gives way a little", 0.0001 < largest < 1.0)
    show_stresses(document)
    show_all()
    picture("03_results")
    FreeCADGui.Control.closeDialog()
    export(document)


def import_step():
    path = FOLDER / "pipe.step"
    outer, inner = (Part.makeTorus(60, r, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 0, 360, 90) for r in (10, 7))
    outer.cut(inner).Solids[0].exportStep(str(path))
    document = FreeCAD.newDocument("Pipe")
    document.UndoMode = 1
    check("FreeCAD's dialog imports the STEP file", answer_file_dialog("Std_Import", path, "STEP"))
    check("as a solid", lambda: [o for o in document.Objects if hasattr(o, "Shape") and o.Shape.Solids])
    show_all()
    return document, next(o for o in document.Objects if hasattr(o, "Shape") and o.Shape.Solids)


def make_analysis(document, pipe, ends):
    analysis = new_analysis(document)
    constraint("FEM_ConstraintFixed", pipe, ends[0], "lw_references")
    constraint("FEM_ConstraintForce", pipe, ends[1], "listReferences", ("spinForce", "500"))
    check("the analysis is complete but for the mesh", len(analysis.Group) == 4)
    return analysis


def mesh(document, analysis, pipe, ends):
    FreeCADGui.activateWorkbench("SweepMeshWorkbench")
    show_all()
    FreeCADGui.Selection.clearSelection()
    look_at(pipe, ends[0])
    click_face(pipe, ends[0])
    press(tool_button("Create sweep mesh"))
    check("the panel opens for the end", lambda: rows("sources") == [ends[0]] and rows("targets") == [ends[1]])
    type_into("meshSize", "4 mm")
    picture("01_ends")
    press(panel_button("OK"))
    check("the panel closes", lambda: not is_panel_open())
    made = document.SweepMesh
    note("hexahedra", made.Hexahedra)
    check("the mesh is in the active analysis", made in analysis.Group and made.isValid())
    show_all()
    picture("02_mesh")


def nodes_of_constraints(document, pipe, ends):
    """What FreeCAD finds on a face of the solid is what the mesh has there, no more and no less."""
    mesh = document.SweepMesh.FemMesh
    for end in ends:
        group = next(g for g in mesh.Groups if mesh.getGroupName(g) == f"{end}_Nodes")
        face = pipe.Shape.getElement(end)
        found = set(mesh.getNodesByFace(face))
        check(f"{end}: constraints reach exactly its nodes", found == set(mesh.getGroupElements(group)) and found)
        plane = face.Surface
        on_plane = {n for n, p in mesh.Nodes.items() if abs((p - plane.Position).dot(plane.Axis)) < 1e-6}
        check(f"{end}: those that lie on it", found == on_plane)


def export(document):
    import Fem

    mesh = document.SweepMesh
    for suffix, text in ((".unv", "unv"), (".inp", "inp"), (".med", "med")):
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(mesh)
        path = FOLDER / f"exported{suffix}"
        path.unlink(missing_ok=True)
        check(f"{suffix}: FreeCAD's dialog asks for a file", answer_file_dialog("Std_Export", path, text))
        check(f"{suffix}: it is written", path.exists)
        again = Fem.read(str(path)) if path.exists() else Fem.FemMesh()
        check(f"{suffix}: with all elements", again.HexaCount == mesh.Hexahedra)


go(steps)

"""From a STEP file to a solved analysis without leaving the GUI: FreeCAD's own commands, and ours in their midst."""
import os
import pathlib
import sys

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
import Part
from driver import (
    OUT, check, click_face, go, is_panel_open, note, panel_button, picture, press, rows, settle, show_all, tool_button,
    type_into, wait_for,
)


def steps():
    document, pipe = import_step()
    analysis = make_analysis(document, pipe)
    mesh(document, analysis, pipe)
    solve(document, analysis)


def import_step():
    path = pathlib.Path(OUT) / "pipe.step"
    outer, inner = (Part.makeTorus(60, r, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 0, 360, 90) for r in (10, 7))
    outer.cut(inner).Solids[0].exportStep(str(path))
    document = FreeCAD.newDocument("Pipe")
    document.UndoMode = 1
    Part.insert(str(path), document.Name)
    show_all()
    return document, document.Objects[0]


def make_analysis(document, pipe):
    import FemGui
    import ObjectsFem

    ends = [f"Face{i}" for i, face in enumerate(pipe.Shape.Faces, 1) if face.Surface.TypeId == "Part::GeomPlane"]
    analysis = ObjectsFem.makeAnalysis(document, "Analysis")
    solver = ObjectsFem.makeSolverCalculixCcxTools(document)
    solver.WorkingDir = str(OUT)
    steel = ObjectsFem.makeMaterialSolid(document)
    steel.Material = {"Name": "Steel", "YoungsModulus": "210000 MPa", "PoissonRatio": "0.3"}
    fixed = ObjectsFem.makeConstraintFixed(document)
    fixed.References = [(pipe, ends[0])]
    load = ObjectsFem.makeConstraintForce(document)
    load.References, load.Force = [(pipe, ends[1])], 500.0
    for member in (solver, steel, fixed, load):
        analysis.addObject(member)
    FemGui.setActiveAnalysis(analysis)
    document.recompute()
    return analysis


def mesh(document, analysis, pipe):
    FreeCADGui.activateWorkbench("SweepMeshWorkbench")
    settle()
    end = next(f"Face{i}" for i, face in enumerate(pipe.Shape.Faces, 1) if face.normalAt(0, 0).y < -0.9)
    FreeCADGui.Selection.addSelection(pipe, end)
    settle(0.6)
    press(tool_button("Create sweep mesh"))
    check("the panel opens for the end", wait_for(lambda: rows("sources") == [end] and rows("targets")))
    type_into("meshSize", "4 mm")
    picture("01_ends")
    press(panel_button("OK"))
    check("the panel closes", wait_for(lambda: not is_panel_open(), 120))
    made = document.SweepMesh
    note("hexahedra", made.Hexahedra)
    check("the mesh is in the active analysis", made in analysis.Group and made.isValid())
    settle()
    picture("02_mesh")


def solve(document, analysis):
    from femtools.ccxtools import FemToolsCcx

    solver = next(m for m in analysis.Group if m.isDerivedFrom("Fem::FemSolverObject"))
    tools = FemToolsCcx(analysis, solver, test_mode=False)
    tools.update_objects()
    tools.setup_working_dir(str(OUT))
    tools.setup_ccx()
    check("FreeCAD finds nothing missing", not tools.check_prerequisites())
    tools.purge_results()
    tools.write_inp_file()
    check("CalculiX runs", tools.ccx_run() == 0)
    tools.load_results()
    results = document.CCX_Results
    check("there are results at every node", len(results.NodeNumbers) == document.SweepMesh.Nodes)
    largest = max(vector.Length for vector in results.DisplacementVectors)
    note("largest displacement", largest)
    check("the pipe gives way a little", 0.0001 < largest < 1.0)
    colour_results(document, results)
    picture("03_results")


def colour_results(document, results):
    shown = results.Mesh.ViewObject
    shown.setNodeColorByScalars(results.NodeNumbers, [vector.Length for vector in results.DisplacementVectors])
    document.SweepMesh.ViewObject.Visibility = False
    shown.Visibility = True
    settle()


go(steps)

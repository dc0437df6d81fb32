"""From a solid in the 3D view to a mesh, by mouse: pick, propose, mesh, undo, redo, edit, cancel."""
import os
import sys

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
from driver import (
    are_proposed, check, click_face, click_row, go, is_panel_open, marked, note, panel_button, picture, press, rows,
    settle, show_all, tool_button, type_into, wait_for, widget,
)

COMMAND = "Create sweep mesh"


def steps():
    document, brick = new_document()
    show_all()
    picture("01_workbench")
    proposal_without_picks(brick)
    picks_taken_over(brick)
    picking_and_unpicking(brick)
    lines = record()
    mesh = meshing(document, brick)
    FreeCADGui.doCommand = lines.pop(0)
    undo_and_redo(document, brick)
    editing(document, document.getObject(mesh))
    nothing_selected(brick)
    replayed(lines)


def record():
    """Keep the lines that go to FreeCAD's recorder; the first item is the recorder itself."""
    lines = [FreeCADGui.doCommand]

    def keep(line):
        lines.append(line)
        lines_run(line)

    lines_run = FreeCADGui.doCommand
    FreeCADGui.doCommand = keep
    return lines


def replayed(lines):
    """What was recorded makes the same mesh in a new document."""
    note("recorded", lines)
    document = new_document()[0]
    names = {"App": FreeCAD, "sweepmesh": __import__("sweepmesh.app")}
    for line in lines:
        exec(line, names)
    check("the recorded lines are a macro", document.SweepMesh.FemMesh.HexaCount == 200)
    check("readable in a line each", lines and all(len(line) < 120 for line in lines))


def new_document():
    document = FreeCAD.newDocument("Part")
    document.UndoMode = 1
    brick = document.addObject("Part::Box", "Brick")
    brick.Length, brick.Width, brick.Height = 20, 10, 8
    document.recompute()
    return document, brick


def open_panel():
    press(tool_button(COMMAND))
    return wait_for(lambda: is_panel_open() and rows("sources") and rows("targets"))


def close_panel():
    press(panel_button("Cancel"))
    return wait_for(lambda: not is_panel_open())


def nothing_selected(brick):
    FreeCADGui.Selection.clearSelection()
    check("the command is off without a selection", lambda: not tool_button(COMMAND).isEnabled())


def proposal_without_picks(brick):
    FreeCADGui.Selection.addSelection(brick)
    check("the command is on for a solid", lambda: tool_button(COMMAND).isEnabled())
    check("the panel opens with a proposal", open_panel())
    check("one source and one target are proposed", len(rows("sources")) == len(rows("targets")) == 1)
    picture("02_proposal")
    before = FreeCAD.ActiveDocument.Objects
    check("cancel closes the panel", close_panel())
    check("cancel leaves the document alone", FreeCAD.ActiveDocument.Objects == before)


def picks_taken_over(brick):
    FreeCADGui.Selection.clearSelection()
    click_face(brick, "Face2")
    picked = FreeCADGui.Selection.getSelectionEx()
    check("a click on the brick selects its face", picked and picked[0].SubElementNames == ("Face2",))
    check("the panel opens for a face", open_panel())
    check("the picked face is the source", rows("sources") == ["Face2"])
    check("its opposite is the target", rows("targets") == ["Face1"])
    picture("03_picked_face")


def picking_and_unpicking(brick):
    press(widget("pickTargets"))
    click_face(brick, "Face6")
    check("a click picks a target", lambda: "Face6" in rows("targets"))
    check("picking leaves nothing selected", lambda: not FreeCADGui.Selection.getSelectionEx())
    click_face(brick, "Face6")
    wait_for(lambda: rows("targets") == ["Face1"])
    check("a second click takes it back", "Face6" not in rows("targets"))
    press(widget("pickTargets"))
    press(widget("propose"))
    check("sources and targets are proposed", lambda: are_proposed("sources") and are_proposed("targets"))
    note("proposed", [rows("sources"), rows("targets")])
    press(widget("pickSources"))
    click_face(brick, "Face6")
    press(widget("pickSources"))
    wait_for(lambda: len(rows("targets")) == 1)
    check("the picked source stays", "Face6" in rows("sources") and not are_proposed("sources"))
    click_row("sources", 0)
    chosen = FreeCADGui.Selection.getSelectionEx()
    check("a row of the list selects its face", chosen and chosen[0].SubElementNames == ("Face6",))
    FreeCADGui.Selection.clearSelection()
    click_face(brick, "Face6")
    check("a face selects its row", marked("sources") == ["Face6"])
    picture("04_picking")


def meshing(document, brick):
    type_into("meshSize", "2 mm")
    press(panel_button("OK"))
    check("OK closes the panel", wait_for(lambda: not is_panel_open(), 120))
    meshes = [obj for obj in document.Objects if obj.isDerivedFrom("Fem::FemMeshObject")]
    check("there is one mesh", len(meshes) == 1)
    mesh = meshes[0]
    note("hexahedra", mesh.FemMesh.HexaCount)
    check("the mesh is valid", mesh.isValid() and mesh.FemMesh.HexaCount == 10 * 5 * 4)
    check("it keeps the picks and the size", mesh.Sources == (brick, ["Face6"]) and mesh.Size.Value == 2.0)
    check("the solid gives way to the mesh", not brick.ViewObject.Visibility and mesh.ViewObject.Visibility)
    show_all()
    picture("05_mesh")
    return mesh.Name


def undo_and_redo(document, brick):
    FreeCADGui.runCommand("Std_Undo")
    settle()
    check("one undo takes the mesh away", lambda: document.Objects == [brick])
    FreeCADGui.runCommand("Std_Redo")
    settle()
    meshes = [obj for obj in document.Objects if obj.isDerivedFrom("Fem::FemMeshObject")]
    check("redo brings it back", len(meshes) == 1 and meshes[0].FemMesh.HexaCount == 200)


def editing(document, mesh):
    FreeCADGui.ActiveDocument.setEdit(mesh.Name)
    check("editing opens the panel", wait_for(lambda: is_panel_open() and rows("sources") and rows("targets")))
    check("the panel shows the picks", rows("sources") == ["Face6"])
    type_into("meshSize", "1 mm")
    check("cancel closes it", close_panel())
    check("cancel changes nothing", mesh.Size.Value == 2.0 and mesh.FemMesh.HexaCount == 200)
    FreeCADGui.ActiveDocument.setEdit(mesh.Name)
    wait_for(lambda: is_panel_open() and rows("targets"))
    widget("layerCount").setValue(7)
    picture("06_editing")
    press(panel_button("OK"))
    check("OK closes it", wait_for(lambda: not is_panel_open(), 120))
    check("the mesh has seven layers", mesh.FemMesh.HexaCount == 10 * 5 * 7)
    FreeCADGui.runCommand("Std_Undo")
    settle()
    check("undo brings the old mesh and setting back", mesh.FemMesh.HexaCount == 200 and mesh.Layers == 0)


go(steps)

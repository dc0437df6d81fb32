"""What goes wrong: unsweepable solids, runs that are stopped, documents and shapes that go away meanwhile."""
import os
import pathlib
import sys
import time

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
from driver import (
    LEFT, NO_KEY, OUT, QTest, check, click_row, go, is_panel_open, is_shown, left_of_panels, note, panel_button,
    picture, press, row_of, rows, settle, show_all, tool_button, type_into, wait_for, widget,
)
from overlays import nodes
from pivy import coin
from PySide import QtCore

FINE = "0.072 mm"  # four million hexahedra: enough work to be stopped in, on a fast machine too


def steps():
    an_unsweepable_solid()
    a_run_that_is_stopped()
    a_setting_that_fails()
    a_shape_deleted_while_meshing()
    a_document_closed_while_meshing()
    a_shape_edited_while_meshing()
    a_shape_edited_while_the_panel_is_open()
    an_edit_that_a_script_ends()
    broken_links_can_be_edited()
    save_close_reopen_edit()
    another_document_becomes_active()


def new_brick(name="Part"):
    document = FreeCAD.newDocument(name)
    document.UndoMode = 1
    brick = document.addObject("Part::Box", "Brick")
    brick.Length, brick.Width, brick.Height = 20, 10, 8
    document.recompute()
    show_all()
    return document, brick


def open_panel(obj):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj)
    press(tool_button("Create sweep mesh"))
    return wait_for(is_panel_open)


def finish(document):
    if is_panel_open():
        press(panel_button("Cancel"))
        wait_for(lambda: not is_panel_open())
    FreeCAD.closeDocument(document.Name)
    settle()


def an_unsweepable_solid():
    document = FreeCAD.newDocument("Ball")
    ball = document.addObject("Part::Sphere", "Ball")
    document.recompute()
    show_all()
    open_panel(ball)
    check("reasons are listed", wait_for(lambda: rows("reasons")))
    note("reasons", rows("reasons"))
    click_row("reasons", 0)
    settle()
    chosen = [name for one in FreeCADGui.Selection.getSelectionEx() for name in one.SubElementNames]
    check("a click on a reason selects what it names", chosen == row_of(widget("reasons"), 0).data(QtCore.Qt.UserRole))
    picture("01_unsweepable")
    press(panel_button("OK"))
    check("the run ends", lambda: not is_shown("progress") and rows("reasons"))
    check("no mesh is made of it", is_panel_open() and document.Objects == [ball])
    finish(document)


def start_fine_run(brick):
    open_panel(brick)
    wait_for(lambda: rows("sources"))
    type_into("meshSize", FINE)
    press(panel_button("OK"))
    return wait_for(lambda: is_shown("progress"))


def a_run_that_is_stopped():
    document, brick = new_brick()
    check("a run shows its progress", start_fine_run(brick))
    picture("02_running")
    press(widget("stop"))
    start = time.time()
    check("stop ends the run", lambda: widget("meshBox").isEnabled())
    note("seconds to stop", round(time.time() - start, 2))
    check("the panel stays, the document is as before", is_panel_open() and document.Objects == [brick])
    picture("03_stopped")
    press(panel_button("OK"))
    wait_for(lambda: is_shown("progress"))
    press(panel_button("Cancel"))
    check("cancel in mid-run closes the panel", lambda: not is_panel_open())
    check("and changes nothing", document.Objects == [brick])
    finish(document)


def mesh_with_panel(brick):
    open_panel(brick)
    wait_for(lambda: rows("sources"))
    type_into("meshSize", "2 mm")
    press(panel_button("OK"))
    wait_for(lambda: not is_panel_open(), 60)


def a_setting_that_fails():
    document, brick = new_brick()
    mesh_with_panel(brick)
    mesh = document.SweepMesh
    count = mesh.FemMesh.HexaCount
    mesh.MaxElements = 10
    document.recompute()
    settle()
    check("the object shows its failure", not mesh.isValid() and mesh.Message)
    check("and keeps its mesh", mesh.FemMesh.HexaCount == count > 10)
    picture("04_failed")
    finish(document)


def a_shape_deleted_while_meshing():
    document, brick = new_brick()
    start_fine_run(brick)
    document.removeObject(brick.Name)
    check("deleting the shape closes the panel", wait_for(lambda: not is_panel_open()))
    settle(0.5)
    check("and leaves no mesh", document.Objects == [])
    finish(document)


def a_document_closed_while_meshing():
    document, brick = new_brick()
    start_fine_run(brick)
    FreeCAD.closeDocument(document.Name)
    check("closing the document closes the panel", wait_for(lambda: not is_panel_open()))
    settle(0.5)


def a_shape_edited_while_meshing():
    document, brick = new_brick()
    open_panel(brick)
    wait_for(lambda: rows("sources"))
    type_into("meshSize", "2 mm")
    QTest.mouseClick(panel_button("OK"), LEFT, NO_KEY)
    brick.Length = 30
    document.recompute()
    check("the panel closes for an edited shape, too", wait_for(lambda: not is_panel_open(), 60))
    check("and the mesh is that of the shape as it is now", document.SweepMesh.FemMesh.BoundBox.XMax == 30)
    finish(document)


def a_shape_edited_while_the_panel_is_open():
    document, brick = new_brick()
    open_panel(brick)
    wait_for(lambda: rows("sources"))
    brick.Length = 40
    document.recompute()
    check("the verdict comes anew", wait_for(lambda: "can be swept" in widget("verdict").text()))
    show_all()
    picture("05_edited")
    finish(document)


def an_edit_that_a_script_ends():
    document, brick = new_brick()
    untouched = len(nodes(brick, coin.SoNode))
    mesh_with_panel(brick)
    FreeCADGui.ActiveDocument.setEdit("SweepMesh")
    wait_for(lambda: rows("sources"))
    check("an open panel draws on the shape", len(nodes(brick, coin.SoNode)) > untouched)
    FreeCADGui.ActiveDocument.resetEdit()
    check("the panel goes", lambda: not is_panel_open() and not left_of_panels())
    check("with its drawings", len(nodes(brick, coin.SoNode)) == untouched)
    check("and shows what was visible before", document.SweepMesh.Visibility and not brick.Visibility)
    finish(document)


def broken_links_can_be_edited():
    document, brick = new_brick()
    mesh_with_panel(brick)
    mesh = document.SweepMesh
    other = document.addObject("Part::Box", "Other")
    mesh.Sources = (other, ["Face1"])
    FreeCADGui.ActiveDocument.setEdit(mesh.Name)
    check("a mesh with wrong links can be edited", wait_for(lambda: rows("sources")))
    press(panel_button("OK"))
    wait_for(lambda: not is_panel_open(), 60)
    check("which puts them right", mesh.isValid() and mesh.Sources[0] == brick)
    mesh.Shape = None
    FreeCADGui.ActiveDocument.setEdit(mesh.Name)
    settle()
    check("one without a shape is not edited", not is_panel_open())
    finish(document)


def save_close_reopen_edit():
    document, brick = new_brick()
    mesh_with_panel(brick)
    count = document.SweepMesh.FemMesh.HexaCount
    path = str(pathlib.Path(OUT) / "saved.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    document = FreeCAD.openDocument(path)
    settle()
    mesh = document.SweepMesh
    check("the mesh is there after reopening", mesh.FemMesh.HexaCount == count)
    FreeCADGui.ActiveDocument.setEdit(mesh.Name)
    check("it can be edited", wait_for(lambda: rows("sources")))
    widget("layerCount").setValue(6)
    press(panel_button("OK"))
    wait_for(lambda: not is_panel_open(), 60)
    check("and meshed again", mesh.Layers == 6 and mesh.FemMesh.HexaCount == 6 * 5 * 4)
    picture("06_reopened")
    finish(document)


def another_document_becomes_active():
    document, brick = new_brick("First")
    open_panel(brick)
    wait_for(lambda: rows("sources"))
    other = FreeCAD.newDocument("Second")
    settle()
    type_into("meshSize", "2 mm")
    press(panel_button("OK"))
    check("the panel works on", wait_for(lambda: not is_panel_open(), 60))
    check("the mesh lands with its shape", document.getObject("SweepMesh") and not other.Objects)
    FreeCAD.closeDocument(other.Name)
    finish(document)


go(steps)

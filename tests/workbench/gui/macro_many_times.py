"""The panels opened and closed again and again, while other code has seen their widgets: nothing stale turns up."""
import os
import sys

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
from driver import QtGui, check, go, is_panel_open, main_window, panel_button, press, rows, settle, wait_for

from sweepmesh import app

ROUNDS = 20


def steps():
    document = FreeCAD.newDocument("Part")
    brick = document.addObject("Part::Box", "Brick")
    document.recompute()
    mesh = app.make_sweep_mesh(brick, size=2)
    opened = sum(sweep_panel(mesh) + quality_panel(mesh) for _ in range(ROUNDS))
    check("the panels open every time", opened == 2 * ROUNDS)


def sweep_panel(mesh):
    FreeCADGui.ActiveDocument.setEdit(mesh.Name)
    is_open = wait_for(lambda: is_panel_open() and rows("targets"), 20)
    return seen_and_closed("Cancel") and is_open


def quality_panel(mesh):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(mesh)
    FreeCADGui.runCommand("SweepMesh_Quality")
    is_open = wait_for(lambda: is_panel_open() and rows("worst"), 20)
    return seen_and_closed("Close") and is_open


def seen_and_closed(button):
    # Makes PySide keep a Python half of each widget for as long as that of the main window.
    main_window().findChildren(QtGui.QWidget)
    press(panel_button(button))
    is_closed = wait_for(lambda: not is_panel_open())
    settle(0.05)
    return is_closed


go(steps)

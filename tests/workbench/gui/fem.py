"""FreeCAD's own part of an analysis, by its commands and with the mouse."""
import FreeCADGui
from driver import (
    FreeCAD, QtGui, check, click_face, is_panel_open, is_shown, panel_button, press, rows, settle, show_all, type_into,
    view, wait_for, widget,
)


def new_analysis(document):
    """A new analysis with its solver, and steel for all solids."""
    FreeCADGui.activateWorkbench("FemWorkbench")
    FreeCADGui.runCommand("FEM_Analysis")
    wait_for(lambda: document.getObject("Analysis"))
    FreeCADGui.runCommand("FEM_MaterialSolid")
    wait_for(lambda: is_shown("cb_materials"))
    cards = widget("cb_materials")
    cards.setCurrentIndex(next(i for i in range(cards.count()) if "CalculiX-Steel" in cards.itemText(i)))
    cards.activated.emit(cards.currentIndex())
    check("steel is chosen", "Steel" in cards.currentText())
    press(panel_button("OK"))
    wait_for(lambda: not is_panel_open())
    return document.Analysis


def constraint(command, pipe, face, listed, value=None):
    """Put a constraint of FreeCAD's on a face by clicking on it."""
    look_at(pipe, face)
    FreeCADGui.runCommand(command)
    wait_for(lambda: is_shown("btnAdd"))
    if value:
        type_into(*value)
    press(widget("btnAdd"))
    click_face(pipe, face)
    check(f"{command}: the face is listed", lambda: rows(listed) == [f"{pipe.Name}:{face}"])
    press(panel_button("OK"))
    wait_for(lambda: not is_panel_open())


def look_at(obj, face):
    """Turn the view so that a face looks at the user."""
    normal = obj.Shape.getElement(face).normalAt(0, 0)
    back, up = normal + FreeCAD.Vector(0.3, 0.3, 0.5), FreeCAD.Vector(0, 0, 1)
    view().setCameraOrientation(FreeCAD.Rotation(FreeCAD.Vector(), up, back, "ZYX").Q)
    view().fitAll()
    settle()


def solve(document):
    """Solve by FreeCAD's command; return the results."""
    solver = next(m for m in document.Analysis.Group if m.isDerivedFrom("Fem::FemSolverObject"))
    FreeCADGui.activateWorkbench("FemWorkbench")
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(solver)
    FreeCADGui.runCommand("FEM_SolverRun")
    check("FreeCAD's command solves it", lambda: document.getObject("CCX_Results"))
    results = document.CCX_Results
    check("there are results at every node", len(results.NodeNumbers) == document.SweepMesh.Nodes)
    return results


def show_stresses(document):
    """Show the stresses in FreeCAD's panel; it stays open."""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(document.CCX_Results)
    FreeCADGui.runCommand("FEM_ResultShow")
    check("FreeCAD shows the results", lambda: _stress_button())
    document.SweepMesh.ViewObject.Visibility = False
    press(_stress_button())


def _stress_button():
    buttons = FreeCADGui.getMainWindow().findChildren(QtGui.QRadioButton)
    return next((b for b in buttons if b.isVisible() and "Mises" in b.text()), None)

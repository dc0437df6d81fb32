"""Run by FreeCAD when it starts: shows the workbench, and the whole of the shape that was opened."""

import FreeCADGui
from PySide import QtCore


def activate():
    """Waits for FreeCAD's own start to end, which activates a workbench too."""
    FreeCADGui.activateWorkbench("SweepMeshWorkbench")
    if FreeCADGui.ActiveDocument:
        FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
        FreeCADGui.ActiveDocument.ActiveView.fitAll()


QtCore.QTimer.singleShot(500, activate)

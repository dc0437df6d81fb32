"""View provider of a sweep mesh: icon, and editing in the task panel."""
import FreeCAD
import FreeCADGui

from sweepmesh.gui.resources import icon, tr


class ViewSweep:
    """Shows the mesh as FreeCAD's FEM workbench does; a double click opens the task panel."""

    def __init__(self, view_object):
        view_object.Proxy = self

    def attach(self, view_object):
        self.Object = view_object.Object

    def getIcon(self):
        return icon("Sweep")

    def setEdit(self, view_object, mode=0):
        from sweepmesh.gui.taskpanels.task_sweep import SweepPanel

        if mode != 0:
            return None
        if view_object.Object.Shape is None:
            FreeCAD.Console.PrintError(tr("The mesh has no shape: set its property Shape first.") + "\n")
            return False
        FreeCADGui.Control.showDialog(SweepPanel(view_object.Object.Shape, mesh=view_object.Object))
        return True

    def unsetEdit(self, view_object, mode=0):
        FreeCADGui.Control.closeDialog()
        return True

    def doubleClicked(self, view_object):
        document = FreeCADGui.getDocument(view_object.Object.Document)
        if not document.getInEdit() and not FreeCADGui.Control.activeDialog():
            document.setEdit(view_object.Object.Name)
        return True

    def dumps(self):
        return None

    def loads(self, state):
        pass

    def __getstate__(self):
        return None

    def __setstate__(self, state):
        pass

"""The command that makes a sweep mesh of the selected solid."""
import FreeCADGui
from FreeCAD import Qt

from sweepmesh.gui.resources import icon, page
from sweepmesh.gui.selection import is_single_solid_selected, selected_solid

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class CreateMesh:
    """Opens the task panel for the selected solid; selected faces become sources and targets."""

    def GetResources(self):
        return {
            "Pixmap": icon("Sweep"),
            "MenuText": QT_TRANSLATE_NOOP("SweepMesh_CreateMesh", "Create sweep mesh"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "SweepMesh_CreateMesh",
                "Mesh the selected solid with swept hexahedra. Selected faces become sources,"
                " the last of several the target.",
            ),
            "WhatsThis": page("create_mesh"),
            "Accel": "S, M",
        }

    def IsActive(self):
        return is_single_solid_selected()

    def Activated(self):
        from sweepmesh.gui.taskpanels.task_sweep import SweepPanel

        shape, faces = selected_solid()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Control.showDialog(SweepPanel(shape, faces))

"""The command that shows how good a mesh is."""
import FreeCADGui
from FreeCAD import Qt

from sweepmesh.gui.resources import icon, page
from sweepmesh.gui.selection import is_single_sweep_selected, selected_sweep

QT_TRANSLATE_NOOP = Qt.QT_TRANSLATE_NOOP


class ShowQuality:
    """Opens the quality panel for the selected sweep mesh."""

    def GetResources(self):
        return {
            "Pixmap": icon("Quality"),
            "MenuText": QT_TRANSLATE_NOOP("SweepMesh_Quality", "Quality of the sweep mesh"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "SweepMesh_Quality",
                "Show the histogram of quality, the worst elements and sections of the selected sweep mesh",
            ),
            "WhatsThis": page("show_quality"),
            "Accel": "S, Q",
        }

    def IsActive(self):
        return is_single_sweep_selected()

    def Activated(self):
        from sweepmesh.gui.taskpanels.task_quality import QualityPanel

        mesh = selected_sweep()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Control.showDialog(QualityPanel(mesh))

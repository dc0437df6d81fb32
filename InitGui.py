"""FreeCAD runs this file when its window starts: it registers the workbench."""
import os
import sys

import FreeCADGui


class SweepMeshWorkbench(FreeCADGui.Workbench):
    """Swept hexahedral meshes of solids."""

    MenuText = "SweepMesh"
    ToolTip = "Swept hexahedral meshes for finite element analyses"

    def Initialize(self):
        # Names of this file are not visible in here: all imports are inside.
        import FreeCAD
        from FreeCAD import Qt

        try:
            from sweepmesh.gui.commands import COMMANDS, register
        except ImportError as error:
            FreeCAD.Console.PrintError(f"SweepMesh is not built ({error}): call ./run in its folder first.\n")
            return
        register()
        self.appendToolbar(Qt.translate("SweepMesh", "Sweep mesh"), COMMANDS)
        self.appendMenu(Qt.translate("SweepMesh", "&Sweep mesh"), COMMANDS)

    def ContextMenu(self, recipient):
        from sweepmesh.gui.commands import COMMANDS

        if recipient == "View":
            self.appendContextMenu("SweepMesh", COMMANDS[:1])

    def GetClassName(self):
        return "Gui::PythonWorkbench"


for folder in sys.path:
    icon = os.path.join(folder, "sweepmesh", os.pardir, os.pardir, "Resources", "icons", "SweepMesh.svg")
    if os.path.isfile(icon):
        SweepMeshWorkbench.Icon = os.path.normpath(icon)
        break

FreeCADGui.addWorkbench(SweepMeshWorkbench())

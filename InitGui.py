"""FreeCAD runs this file when its window starts: it registers the workbench and its page of preferences."""
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

        self.appendContextMenu("SweepMesh", COMMANDS)

    def GetClassName(self):
        return "Gui::PythonWorkbench"


# There is no __file__ here. Init.py has put the folder Mod of this addon on sys.path.
for folder in sys.path:
    resources = os.path.normpath(os.path.join(folder, os.pardir, "Resources"))
    icon = os.path.join(resources, "icons", "SweepMesh.svg")
    if os.path.isdir(os.path.join(folder, "sweepmesh", "gui")) and os.path.isfile(icon):
        SweepMeshWorkbench.Icon = icon
        FreeCADGui.addIconPath(os.path.join(resources, "icons"))
        FreeCADGui.addLanguagePath(os.path.join(resources, "translations"))
        FreeCADGui.addPreferencePage(os.path.join(resources, "ui", "Preferences.ui"), "SweepMesh")
        break

try:
    # Macros may make meshes before the workbench is opened: their views are known from the start.
    import sweepmesh.gui.viewproviders  # noqa: F401
except ImportError:
    pass  # not built: the workbench says so when it is opened
FreeCADGui.addWorkbench(SweepMeshWorkbench())

"""The workbench's commands, in the order of the toolbar."""
import FreeCADGui

from sweepmesh.gui.commands.cmd_quality import ShowQuality
from sweepmesh.gui.commands.cmd_sweep import CreateMesh

_CLASSES = {"SweepMesh_CreateMesh": CreateMesh, "SweepMesh_Quality": ShowQuality}
COMMANDS = list(_CLASSES)


def register():
    """Make the commands known to FreeCAD."""
    for name, command in _CLASSES.items():
        FreeCADGui.addCommand(name, command())

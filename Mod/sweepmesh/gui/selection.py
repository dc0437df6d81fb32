"""What is selected in the 3D view, in the words of sweeping."""
import FreeCAD
import FreeCADGui

from sweepmesh.app.objects.sweep import Sweep
from sweepmesh.app.shapes import has_solid


def is_sweep(obj):
    """Is this document object one of our meshes?"""
    return isinstance(getattr(obj, "Proxy", None), Sweep)


def selected_solid():
    """Return (object with a solid, names of its selected faces), or (None, []) unless exactly one is selected."""
    chosen = [s for s in FreeCADGui.Selection.getSelectionEx() if has_solid(s.Object) and not is_sweep(s.Object)]
    if len(chosen) != 1:
        return None, []
    return chosen[0].Object, [name for name in chosen[0].SubElementNames if name.startswith("Face")]


def selected_sweep():
    """Return the one selected sweep mesh, or None."""
    chosen = [obj for obj in FreeCADGui.Selection.getSelection() if is_sweep(obj)]
    return chosen[0] if len(chosen) == 1 else None


def is_single_solid_selected():
    """Is one object with a solid (or some of its faces) selected, and no panel open?"""
    return FreeCAD.ActiveDocument is not None and is_no_panel_open() and selected_solid()[0] is not None


def is_single_sweep_selected():
    """Is one sweep mesh that has elements selected, and no panel open?"""
    mesh = selected_sweep() if is_no_panel_open() else None
    return mesh is not None and mesh.Hexahedra + mesh.Prisms == mesh.FemMesh.VolumeCount > 0


def is_no_panel_open():
    return FreeCADGui.Control.activeDialog() in (None, False)


class Gate:
    """Selection gate that admits elements of one object only, of those kinds whose names begin with `kinds`."""

    def __init__(self, obj, *kinds):
        self._obj, self._kinds = obj, kinds

    def allow(self, document, obj, sub):
        return obj == self._obj and sub.startswith(self._kinds)

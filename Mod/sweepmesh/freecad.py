"""Finding FreeCAD from an ordinary Python."""

import contextlib
import glob
import os
import sys

from sweepmesh.engine.errors import SweepMeshError

_FOLDERS = [
    "/usr/lib/freecad-python3/lib",
    "/usr/lib/freecad/lib",
    "/usr/share/freecad/Ext",
    "/usr/share/freecad/Mod",
    *sorted(glob.glob("/usr/share/freecad/Mod/*")),
]


def import_freecad():
    """The module FreeCAD, with its workbenches importable. SweepMeshError where it is not installed.

    Inside FreeCAD it is there already. Elsewhere FREECAD_LIB may name the folder of FreeCAD.so, besides
    the places where Linux distributions put it.
    """
    if "FreeCAD" not in sys.modules:
        own = [os.environ["FREECAD_LIB"]] if "FREECAD_LIB" in os.environ else []
        sys.path.extend(folder for folder in own + _FOLDERS if folder not in sys.path)
    try:
        import FreeCAD
    except ImportError as error:
        raise SweepMeshError("FreeCAD's Python modules are not installed (Debian: apt install freecad).") from error
    return FreeCAD


@contextlib.contextmanager
def muted():
    """Keeps what OpenCASCADE and FreeCAD print in the block away from standard output."""
    sys.stdout.flush()
    kept = os.dup(1)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(kept, 1)
        os.close(kept)
        os.close(nowhere)

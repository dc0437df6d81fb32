"""For all Python tests: the package from this checkout, FreeCAD's modules, and the shared checker."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
for folder in (ROOT / "tests" / "gallery", ROOT / "Mod"):
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))

from sweepmesh.freecad import import_freecad  # noqa: E402

import_freecad()

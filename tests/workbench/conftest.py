"""FreeCAD's Python on sys.path, and fixtures that every workbench test may use."""
import glob
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [
    str(ROOT / "Mod"),
    "/usr/lib/freecad/lib",
    "/usr/share/freecad/Ext",
    "/usr/share/freecad/Mod",
    *glob.glob("/usr/share/freecad/Mod/*"),
]
import FreeCAD  # noqa: E402


@pytest.fixture
def document():
    """A new document, closed after the test."""
    doc = FreeCAD.newDocument()
    name = doc.Name
    yield doc
    if name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)


@pytest.fixture
def box(document):
    """A brick of 10 x 4 x 2 at the origin; Face1/2 are at small/large x, Face5/6 at small/large z."""
    obj = document.addObject("Part::Box", "Brick")
    obj.Length, obj.Width, obj.Height = 10, 4, 2
    document.recompute()
    return obj

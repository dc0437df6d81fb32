"""Fixtures that every workbench test may use; the helper modules beside the tests can be imported by name."""
import pathlib
import sys

import FreeCAD
import pytest

HERE = pathlib.Path(__file__).resolve().parent
for folder in (HERE / "app", HERE / "gui"):
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))


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

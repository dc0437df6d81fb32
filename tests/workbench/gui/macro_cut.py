"""A solid that cannot be swept: the cut that is offered, made by mouse, and taken back."""
import os
import sys

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
import Part
from driver import (
    check, go, is_panel_open, is_shown, panel_button, picture, press, rows, show_all, tool_button, widget,
)
from overlays import nodes
from pivy import coin


def steps():
    document = FreeCAD.newDocument("Handle")
    document.UndoMode = 1
    handle = document.addObject("Part::Feature", "Handle")
    ring = Part.makeTorus(12, 3)
    ring.rotate(FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0), 90)
    ring = ring.common(Part.makeBox(120, 120, 60, FreeCAD.Vector(-60, -60, 0)))
    handle.Shape = Part.makeCylinder(25, 10, FreeCAD.Vector(0, 0, -10)).fuse(ring)
    document.recompute()
    show_all()
    before = len(nodes(handle, coin.SoFaceSet))
    FreeCADGui.Selection.addSelection(handle)
    press(tool_button("Create sweep mesh"))
    check("it cannot be swept", lambda: "cannot be swept" in widget("verdict").text() and rows("reasons"))
    check("a cut is offered", lambda: is_shown("cutOffer") and widget("cutText").text().startswith("Cut"))
    check("and drawn", len(nodes(handle, coin.SoFaceSet)) == before + 1)
    picture("01_offer")
    press(widget("makeCut"))
    check("a panel for the pieces opens", lambda: is_shown("shapeName") and "Pieces" in widget("shapeName").text())
    check("they can be swept", lambda: "can be swept" in widget("verdict").text())
    check("the solid is there still, hidden", not handle.ViewObject.Visibility and len(document.Objects) == 2)
    check("nothing is left drawn over it", len(nodes(handle, coin.SoFaceSet)) == before)
    picture("02_pieces")
    press(panel_button("Cancel"))
    check("the panel closes", lambda: not is_panel_open())
    check("the pieces stay", len(document.Objects) == 2)
    document.undo()
    check("undo takes them away", lambda: document.Objects == [handle])
    check("and shows the solid again", lambda: handle.ViewObject.Visibility)


go(steps)

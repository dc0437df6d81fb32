"""Several sources and targets: prescribing which is swept to which, in the panel."""
import os
import sys

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
import Part
from driver import (
    CONTROL, NO_KEY, check, click_row, go, is_panel_open, is_shown, note, panel_button, picture, press, rows,
    show_all, tool_button, type_into, wait_for, widget,
)

ARROW = " \N{RIGHTWARDS ARROW} "


def steps():
    document = FreeCAD.newDocument("Part")
    document.UndoMode = 1
    stairs = document.addObject("Part::Feature", "Stairs")
    corners = [(0, 0, 0), (20, 0, 0), (20, 0, 6), (10, 0, 6), (10, 0, 14), (0, 0, 14), (0, 0, 0)]
    stairs.Shape = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 8, 0))
    document.recompute()
    show_all()
    ups = [f"Face{i}" for i, face in enumerate(stairs.Shape.Faces, 1) if face.normalAt(0.5, 0.5).z > 0.9]
    downs = [f"Face{i}" for i, face in enumerate(stairs.Shape.Faces, 1) if face.normalAt(0.5, 0.5).z < -0.9]
    FreeCADGui.Selection.addSelection(stairs, (*ups, *downs))
    press(tool_button("Create sweep mesh"))
    check("the panel opens", wait_for(lambda: "can be swept" in widget("verdict").text()))
    check("no pairs at first", not is_shown("pairs"))
    pair_all(ups, downs[0])
    mesh(document, ups, downs[0])


def mark(name, text, key=NO_KEY):
    click_row(name, rows(name).index(text), key)


def pair_all(ups, down):
    press(widget("pairFaces"))
    check("nothing marked, nothing paired", not is_shown("pairs"))
    mark("targets", down)
    for up in ups:
        mark("sources", up, CONTROL)
    chosen = FreeCADGui.Selection.getSelectionEx()
    check("all that is marked is selected", chosen and set(chosen[0].SubElementNames) == {*ups, down})
    press(widget("pairFaces"))
    check("the pairs are listed", rows("pairs") == [f"{up}{ARROW}{down}" for up in ups])
    picture("01_pairs")
    mark("pairs", f"{ups[0]}{ARROW}{down}")
    press(widget("removeFaces"))
    wait_for(lambda: len(rows("pairs")) == 1)
    check("a pair can be removed", rows("pairs") == [f"{ups[1]}{ARROW}{down}"])
    check("its faces stay", len(rows("sources")) == 2)
    check("half of the pairs is told to be none", wait_for(lambda: rows("reasons")))
    note("reason", rows("reasons"))
    picture("02_half")
    mark("targets", down)
    mark("sources", ups[0])
    press(widget("pairFaces"))
    check("the missing pair makes it whole", wait_for(lambda: "can be swept" in widget("verdict").text()))


def mesh(document, ups, down):
    type_into("meshSize", "2 mm")
    press(panel_button("OK"))
    check("the mesh is made", wait_for(lambda: not is_panel_open(), 60))
    made = document.SweepMesh
    check("it keeps the pairs", made.isValid() and set(made.Pairs) == {f"{up}={down}" for up in ups})
    FreeCADGui.ActiveDocument.setEdit(made.Name)
    check("and shows them again", wait_for(lambda: set(rows("pairs")) == {f"{up}{ARROW}{down}" for up in ups}))
    press(panel_button("Cancel"))
    wait_for(lambda: not is_panel_open())


go(steps)

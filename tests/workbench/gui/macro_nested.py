"""Solids inside a moved part and a body: picking, overlay and mesh are where the solid is."""
import os
import sys

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
from driver import (
    check, click_point, go, is_panel_open, note, panel_button, picture, press, rows, settle, show_all, tool_button,
    type_into, wait_for, widget,
)


def steps():
    document = FreeCAD.newDocument("Nested")
    part = document.addObject("App::Part", "Part")
    body = document.addObject("PartDesign::Body", "Body")
    part.addObject(body)
    block = document.addObject("PartDesign::AdditiveBox", "Block")
    body.addObject(block)
    block.Length, block.Width, block.Height = 20, 10, 8
    body.Placement.Base = FreeCAD.Vector(0, 0, 5)
    part.Placement = FreeCAD.Placement(FreeCAD.Vector(40, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
    document.addObject("Part::Box", "Elsewhere")
    document.recompute()
    show_all()
    pick_in_place(document, part, body)


def global_point(part, body, local):
    return part.Placement.multVec(body.Placement.multVec(FreeCAD.Vector(*local)))


def pick_in_place(document, part, body):
    top = global_point(part, body, (10, 5, 8))
    click_point(top)
    picked = FreeCADGui.Selection.getSelectionEx()
    note("picked", [(p.Object.Name, p.SubElementNames) for p in picked])
    press(tool_button("Create sweep mesh"))
    check("the panel opens", wait_for(lambda: is_panel_open() and rows("sources")))
    source = rows("sources")[0]
    press(widget("pickSources"))
    click_point(top)
    check("a click in place takes the face back", wait_for(lambda: rows("sources") != [source]))
    click_point(top)
    check("and another one picks it", wait_for(lambda: source in rows("sources")))
    press(widget("pickSources"))
    wait_for(lambda: rows("targets"))
    picture("01_nested")
    type_into("meshSize", "2 mm")
    press(panel_button("OK"))
    wait_for(lambda: not is_panel_open(), 60)
    mesh = document.SweepMesh
    check("the mesh is made", mesh.isValid() and mesh.FemMesh.HexaCount == 10 * 5 * 4)
    bounds = mesh.FemMesh.BoundBox
    check("in the solid's own coordinates, like FreeCAD's own meshes", (bounds.XMin, bounds.ZMax) == (0, 8))
    picture("02_nested_mesh")


go(steps)

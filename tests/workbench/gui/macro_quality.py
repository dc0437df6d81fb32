"""The quality panel: histogram, threshold, section, worst elements."""
import os
import sys

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
import Part
from driver import (
    LEFT, NO_KEY, OUT, QTest, check, choose, click_row, go, is_panel_open, is_shown, note, panel_button, picture,
    place_of, press, settle, show_all, tool_button, wait_for, widget,
)
from PySide import QtCore

from sweepmesh import app


def steps():
    document = FreeCAD.newDocument("Part")
    frustum = document.addObject("Part::Feature", "Frustum")
    base, top = (Part.makePolygon(ring) for ring in (square(10, 0), square(3, 12)))
    frustum.Shape = Part.makeLoft([base, top], True)
    document.recompute()
    mesh = app.make_sweep_mesh(frustum, size=1.5)
    frustum.ViewObject.Visibility = False
    note("message", mesh.Message)
    show_all()
    check("the command is off without a mesh", lambda: not tool_button("Quality of the sweep mesh").isEnabled())
    FreeCADGui.Selection.addSelection(mesh)
    press(tool_button("Quality of the sweep mesh"))
    check("the panel opens", wait_for(is_panel_open))
    check("all worst elements are listed", widget("worst").count() == min(20, mesh.Hexahedra))
    check("the mesh gives way to the coloured one", lambda: not mesh.ViewObject.Visibility and drawn(mesh))
    check("and nothing is to be waited for", not is_shown("busy"))
    picture("01_quality")
    threshold(mesh)
    section(mesh)
    worst(mesh)
    press(panel_button("Close"))
    check("the panel closes", wait_for(lambda: not is_panel_open()))
    check("the mesh is shown again", mesh.ViewObject.Visibility)
    an_undone_mesh_closes_the_panel(*a_reopened_mesh(document, mesh))


def square(half, z):
    corners = [(-half, -half), (half, -half), (half, half), (-half, half), (-half, -half)]
    return [FreeCAD.Vector(x, y, z) for x, y in corners]


def overlay(mesh):
    root = mesh.ViewObject.RootNode
    return root.getChild(root.getNumChildren() - 1)


def drawn(mesh):
    """Number of quads that the overlay draws now."""
    if overlay(mesh).getNumChildren() < 2:
        return 0
    faces = overlay(mesh).getChild(1).getChild(1)
    return faces.getChild(faces.getNumChildren() - 1).coordIndex.getNum() // 5


def threshold(mesh):
    whole = drawn(mesh)
    bars = widget("histogram")
    middle = sorted(mesh.ScaledJacobians)[mesh.Hexahedra // 2]
    at = bars.bar(1 + int(middle * 10)).center().toPoint()
    QTest.mouseClick(bars, LEFT, NO_KEY, at)
    settle()
    check("a click on a bar sets the threshold", abs(widget("threshold").value() - (int(middle * 10) + 1) / 10) < 1e-9)
    widget("threshold").setValue(round(middle - 0.01, 2))
    settle()
    note("quads", [whole, drawn(mesh)])
    check("fewer elements are drawn", drawn(mesh) != whole)
    picture("02_threshold")
    widget("threshold").setValue(1.0)


def depths(mesh):
    """The range of y of what is drawn."""
    group = overlay(mesh).getChild(1)
    ys = [point.getValue()[1] for point in group.getChild(0).point.getValues()]
    return min(ys), max(ys)


def section(mesh):
    whole = depths(mesh)
    choose("axis", 2)
    half = depths(mesh)
    check("a section leaves what is before it", half[0] == whole[0] and half[1] < 0.3 * whole[1])
    slider = widget("position")
    QTest.mouseClick(slider, LEFT, NO_KEY, QtCore.QPoint(slider.width() // 3, slider.height() // 2))
    settle()
    note("sections", [whole, half, depths(mesh)])
    check("its slider moves it", depths(mesh)[1] < half[1])
    picture("03_section")
    choose("axis", 0)
    check("none shows the whole again", depths(mesh) == whole)


def worst(mesh):
    rows = widget("worst")
    click_row("worst", 0)
    check("a click on a row shows one element", drawn(mesh) == 6)
    QTest.mouseDClick(rows.viewport(), LEFT, NO_KEY, place_of(rows, 0))
    settle()
    picture("04_worst")


def an_undone_mesh_closes_the_panel(document, mesh):
    FreeCADGui.Selection.addSelection(mesh)
    press(tool_button("Quality of the sweep mesh"))
    wait_for(is_panel_open)
    document.removeObject(mesh.Name)
    check("deleting the mesh closes the panel", wait_for(lambda: not is_panel_open()))


def a_reopened_mesh(document, mesh):
    """Its elements come from FreeCAD's mesh, not from the engine's result."""
    path, whole = str(OUT / "quality.FCStd"), drawn_in_panel(mesh)
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    document = FreeCAD.openDocument(path)
    settle()
    check("a reopened mesh is drawn, too", drawn_in_panel(document.SweepMesh) == whole > 0)
    return document, document.SweepMesh


def drawn_in_panel(mesh):
    """How many quads the panel draws of all of a mesh."""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(mesh)
    press(tool_button("Quality of the sweep mesh"))
    wait_for(lambda: is_shown("worst") and drawn(mesh))
    count = drawn(mesh)
    press(panel_button("Close"))
    wait_for(lambda: not is_panel_open())
    return count


go(steps)

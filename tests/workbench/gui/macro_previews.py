"""The previews of the sweep panel: roles, vertex types, intervals; switched, and following the settings."""
import os
import sys
import time

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
import Part
from driver import (
    check, go, is_panel_open, note, panel_button, picture, press, rows, settle, show_all, tool_button, type_into,
    wait_for, widget,
)
from overlays import face_colours, letters, line_lengths, nodes, tick_points
from pivy import coin


def steps():
    document = FreeCAD.newDocument("Part")
    step = document.addObject("Part::Feature", "Step")
    corners = [(0, 0, 0), (20, 0, 0), (20, 0, 6), (10, 0, 6), (10, 0, 14), (0, 0, 14), (0, 0, 0)]
    step.Shape = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 8, 0))
    document.recompute()
    show_all()
    untouched = len(nodes(step, coin.SoNode))
    FreeCADGui.Selection.addSelection(step, facing(step, up=True) + facing(step, up=False))
    press(tool_button("Create sweep mesh"))
    check("the picks can be swept", wait_for(lambda: "can be swept" in widget("verdict").text()))
    check("two sources, one target", (len(rows("sources")), len(rows("targets"))) == (2, 1))
    check("nothing but roles is drawn", letters(step) == [])
    picture("01_roles")
    switches(step)
    settings(step)
    press(panel_button("Cancel"))
    wait_for(lambda: not is_panel_open())
    settle()
    check("the panel takes its drawings away", len(nodes(step, coin.SoNode)) == untouched)
    two_hundred_faces(document)


def facing(obj, up):
    """Names of the faces that look up (or down)."""
    side = 1 if up else -1
    return tuple(f"Face{i}" for i, face in enumerate(obj.Shape.Faces, 1) if face.normalAt(0.5, 0.5).z * side > 0.9)


def n_ticks(obj):
    return len(tick_points(obj))


def n_pairs(obj, roles):
    """How many faces are drawn in each colour that is no role's."""
    others = [colour for colour in face_colours(obj) if colour not in roles]
    return sorted(others.count(colour) for colour in set(others))


def redraw():
    """Seconds that one picture takes: with software rendering most of a preview's time."""
    start = time.time()
    FreeCADGui.ActiveDocument.ActiveView.redraw()
    return round(time.time() - start, 3)


def switches(step):
    press(widget("showTypes"))
    check("vertex types are drawn", wait_for(lambda: "C" in letters(step), 5))
    check("one corner on each side, ends elsewhere", letters(step).count("C") == 2 and "E" in letters(step))
    picture("02_types")
    press(widget("showTypes"))
    check("and taken away", wait_for(lambda: letters(step) == [], 5))
    press(widget("showIntervals"))
    check("intervals are drawn", wait_for(lambda: len(letters(step)) == len(step.Shape.Edges), 5))
    picture("03_intervals")
    press(widget("showIntervals"))
    check("and taken away, too", wait_for(lambda: letters(step) == [], 5))
    roles = face_colours(step)
    press(widget("showLevels"))
    check("levels colour the caps", wait_for(lambda: len(set(face_colours(step)) - set(roles)) == 3, 5))
    picture("06_levels")
    press(widget("showLevels"))
    check("roles come back", wait_for(lambda: face_colours(step) == roles, 5))
    press(widget("showCurves"))
    check("the imprinted curve is drawn", wait_for(lambda: line_lengths(step) == [8.0], 20))
    press(widget("showPairs"))
    check("paired patches have one colour", wait_for(lambda: n_pairs(step, roles) == [2, 2], 20))
    check("as many pairs are told", "2" in widget("planSummary").text())
    picture("07_pairs")
    press(widget("showCurves"))
    press(widget("showPairs"))
    check("they go, too", wait_for(lambda: face_colours(step) == roles and line_lengths(step) == [], 5))
    press(widget("showIntervals"))


def settings(step):
    type_into("meshSize", "2 mm")
    check("they follow the size", wait_for(lambda: "10" in letters(step), 5))
    numbers = letters(step)
    widget("layerCount").setValue(14)
    check("and the layers", wait_for(lambda: letters(step) != numbers and "14" in letters(step), 5))
    type_into("meshSize", "0 mm")
    wait_for(lambda: "10" not in letters(step), 5)
    press(widget("showRoles"))
    picture("04_intervals_only")


def two_hundred_faces(document):
    for obj in document.Objects:
        obj.ViewObject.Visibility = False
    star = document.addObject("Part::Feature", "Star")
    rim = [FreeCAD.Vector(30 + 3 * (i % 2), 0, 0) for i in range(200)]
    rim = [FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 1.8 * i).multVec(point) for i, point in enumerate(rim)]
    star.Shape = Part.Face(Part.makePolygon([*rim, rim[0]])).extrude(FreeCAD.Vector(0, 0, 5))
    document.recompute()
    show_all()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(star)
    settle(0.6)
    press(tool_button("Create sweep mesh"))
    wait_for(lambda: rows("sources"))
    widget("showIntervals").setChecked(True)
    wait_for(lambda: n_ticks(star) > 400, 20)
    before, start = n_ticks(star), time.time()
    widget("layerCount").setValue(9)
    changed = wait_for(lambda: n_ticks(star) != before, 20)
    note("seconds for 202 faces", {"until drawn": round(time.time() - start, 3), "redraw": redraw()})
    check("a preview of 202 faces follows", changed)
    picture("05_two_hundred_faces")
    press(panel_button("Cancel"))
    wait_for(lambda: not is_panel_open())


go(steps)

"""Overrides of edges by mouse: picked, listed, changed, taken back, meshed, recorded, undone, edited again."""
import os
import sys

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
import Part
from driver import (
    check, choose, click_edge, click_face, click_point, click_row, click_vertex, double_click_in_tree, go,
    is_panel_open, marked, note, panel_button, picture, press, reveal, rows, settle, show_all, tool_button, type_into,
    type_shortcut, wait_for, widget,
)
from overlays import letters, tick_points

COUNT, LENGTH, GROWTH, TYPE = range(4)


def steps():
    document, brick = new_document()
    upright, front = edge_along(brick, "z"), edge_along(brick, "x")
    open_panel(brick)
    counts(brick, upright, front)
    lengths(brick, front)
    growth(brick, upright)
    gate(brick)
    follow_each_other(brick, upright)
    mesh = meshing(document, brick, upright, front)
    undo_and_redo(document, mesh)
    edit_again(document, mesh, upright)
    elements_and_tolerance(document)
    contradiction(document, mesh)
    FreeCAD.closeDocument(document.Name)
    vertex_types()


def new_document():
    document = FreeCAD.newDocument("Part")
    document.UndoMode = 1
    brick = document.addObject("Part::Box", "Brick")
    brick.Length, brick.Width, brick.Height = 20, 10, 8
    document.recompute()
    show_all()
    return document, brick


def edge_along(brick, axis):
    """An edge along an axis that can be seen: at large x, small y and large z."""
    for i, edge in enumerate(brick.Shape.Edges, 1):
        centre, way = edge.CenterOfMass, edge.tangentAt(edge.FirstParameter)
        seen = {"x": centre.z > 7 and centre.y < 1, "z": centre.x > 19 and centre.y < 1}
        if abs(getattr(way, axis)) > 0.9 and seen[axis]:
            return f"Edge{i}"
    raise LookupError(axis)


def open_panel(brick):
    FreeCADGui.Selection.addSelection(brick, ("Face6", "Face5"))
    press(tool_button("Create sweep mesh"))
    check("the panel opens", wait_for(lambda: is_panel_open() and "can be swept" in widget("verdict").text()))
    type_into("meshSize", "2 mm")


def counts(brick, upright, front):
    press(widget("pickOverride"))
    check("picking shows the intervals", wait_for(lambda: letters(brick).count("4") == 4))
    type_into("overrideCount", "6")
    click_edge(brick, upright)
    check("a click on an edge lists it", wait_for(lambda: rows("overrides") == [f"{upright}: 6 intervals"]))
    check("the preview follows, tied edges too", wait_for(lambda: letters(brick).count("6") == 4))
    picture("01_count")
    click_edge(brick, upright)
    check("a second click takes it back", wait_for(lambda: rows("overrides") == []))
    check("in the preview, too", wait_for(lambda: letters(brick).count("4") == 4))
    click_edge(brick, upright)
    type_into("overrideCount", "12")
    click_edge(brick, front)
    expected = sorted([f"{upright}: 6 intervals", f"{front}: 12 intervals"])
    check("several edges have their own", wait_for(lambda: sorted(rows("overrides")) == expected))
    check("all in the preview", wait_for(lambda: (letters(brick).count("6"), letters(brick).count("12")) == (4, 2)))
    press(widget("pickOverride"))


def lengths(brick, front):
    choose("overrideKind", LENGTH)
    press(widget("pickOverride"))
    type_into("overrideSize", "2.5 mm")
    click_edge(brick, front)
    check("a length takes the place of a count", wait_for(lambda: letters(brick).count("8") == 2))
    check("in the list as well", len(rows("overrides")) == 2 and any("2.5" in row for row in rows("overrides")))
    picture("02_length")
    press(widget("pickOverride"))


def growth(brick, upright):
    choose("overrideKind", GROWTH)
    press(widget("pickOverride"))
    type_into("overrideRatio", "1.5")
    click_edge(brick, upright, part_at(brick, upright, top=True))
    check("a growth is listed", wait_for(lambda: any("growth" in row for row in rows("overrides"))))
    check("it begins where the edge was clicked", wait_for(lambda: is_dense_at(brick, upright, top=True)))
    picture("03_growth")
    click_edge(brick, upright, part_at(brick, upright, top=False))
    check("a click at the other end turns it", wait_for(lambda: is_dense_at(brick, upright, top=False)))
    press(widget("overrideBoth"))
    click_edge(brick, upright)
    check("it can begin at both ends", wait_for(lambda: any("both ends" in row for row in rows("overrides"))))
    press(widget("pickOverride"))


def part_at(brick, edge, top):
    """Where on an upright edge its upper (or lower) end is near."""
    shape = brick.Shape.getElement(edge)
    rises = shape.valueAt(shape.LastParameter).z > shape.valueAt(shape.FirstParameter).z
    return 0.85 if rises == top else 0.15


def is_dense_at(brick, edge, top):
    """Are the ticks of an upright edge nearer to each other at its upper (or lower) end?"""
    corner = brick.Shape.getElement(edge).CenterOfMass
    heights = sorted({round(p[2], 6) for p in tick_points(brick) if abs(p[0] - corner.x) + abs(p[1] - corner.y) < 1e-6})
    if len(heights) < 3:
        return False
    low, high = heights[1] - heights[0], heights[-1] - heights[-2]
    return high < 0.9 * low if top else low < 0.9 * high


def gate(brick):
    press(widget("pickOverride"))
    before = rows("overrides")
    click_face(brick, "Face6")
    check("a face is not admitted", rows("overrides") == before and not FreeCADGui.Selection.getSelectionEx())
    press(widget("pickSources"))
    check("another button lets this one go", not widget("pickOverride").isChecked())
    press(widget("pickSources"))


def follow_each_other(brick, upright):
    row = next(i for i, text in enumerate(rows("overrides")) if "6 intervals" in text)
    click_row("overrides", row)
    chosen = FreeCADGui.Selection.getSelectionEx()
    check("a marked row selects its edge", chosen and chosen[0].SubElementNames == (upright,))
    check("and shows its value", widget("overrideCount").isVisible() and widget("overrideCount").value() == 6)
    type_into("overrideCount", "5")
    check("a marked row can be changed", wait_for(lambda: f"{upright}: 5 intervals" in rows("overrides")))
    check("the preview follows", wait_for(lambda: "6" not in letters(brick)))
    FreeCADGui.Selection.clearSelection()
    click_edge(brick, upright)
    names = [text.split(":")[0] for text in marked("overrides")]
    check("an edge selects its rows", set(names) == {upright})
    row = next(i for i, text in enumerate(rows("overrides")) if "growth" in text)
    click_row("overrides", row)
    press(widget("removeOverrides"))
    check("a row can be removed", wait_for(lambda: not any("growth" in text for text in rows("overrides"))))
    picture("04_list")


def meshing(document, brick, upright, front):
    lines, run = [], FreeCADGui.doCommand

    def keep(line):
        lines.append(line)
        run(line)

    FreeCADGui.doCommand = keep
    reveal(widget("sweepRatio"))
    type_into("sweepRatio", "1.2")
    press(panel_button("OK"))
    check("OK closes the panel", wait_for(lambda: not is_panel_open(), 120))
    FreeCADGui.doCommand = run
    note("recorded", lines)
    mesh = document.SweepMesh
    check("the mesh has the counts", mesh.isValid() and n_on(mesh, brick, front) == 9 and n_on(mesh, brick, upright) == 6)
    check("the object keeps them", (mesh.EdgeCounts, mesh.EdgeSizes) == ([f"{upright}=5"], [f"{front}=2.5"]))
    check("and the growth", (mesh.SweepBias, mesh.SweepBiasBoth) == (1.2, False))
    check("what was done is recorded", f'edge_count={{"{upright}": 5}}' in lines[0] and "sweep_bias=(1.2, False)" in lines[0])
    picture("05_mesh")
    return mesh


def selected_names():
    return [name for one in FreeCADGui.Selection.getSelectionEx() for name in one.SubElementNames]


def n_on(mesh, brick, edge):
    """Number of nodes on an edge."""
    return len(mesh.FemMesh.getNodesByEdge(brick.Shape.getElement(edge)))


def undo_and_redo(document, mesh):
    type_shortcut("Std_Undo")
    check("Ctrl+Z takes the mesh back", wait_for(lambda: document.getObject("SweepMesh") is None))
    type_shortcut("Std_Redo")
    check("its opposite brings it again", wait_for(lambda: document.getObject("SweepMesh") is not None))
    again = document.SweepMesh
    check("with its mesh and overrides", again.FemMesh.VolumeCount == again.Hexahedra > 0 and again.EdgeCounts)


def edit_again(document, mesh, upright):
    mesh, brick = document.SweepMesh, document.Brick
    before = mesh.Hexahedra
    double_click_in_tree(mesh.Label)
    wait_for(lambda: rows("overrides"))
    check("editing shows the solid", brick.ViewObject.Visibility and not mesh.ViewObject.Visibility)
    check("editing lists them again", wait_for(lambda: f"{upright}: 5 intervals" in rows("overrides")))
    check("and the growth along the sweep", widget("sweepRatio").value() == 1.2)
    click_row("overrides", rows("overrides").index(f"{upright}: 5 intervals"))
    type_into("overrideCount", "7")
    press(panel_button("OK"))
    wait_for(lambda: not is_panel_open(), 120)
    check("and the mesh afterwards", mesh.ViewObject.Visibility and not brick.ViewObject.Visibility)
    check("an edited count is meshed", mesh.FemMesh.HexaCount == before // 5 * 7 and mesh.EdgeCounts == [f"{upright}=7"])
    FreeCADGui.runCommand("Std_Undo")
    check("undo brings the old one back", wait_for(lambda: mesh.FemMesh.HexaCount == before))
    check("and its setting", mesh.EdgeCounts == [f"{upright}=5"])


def elements_and_tolerance(document):
    mesh = document.SweepMesh
    before = mesh.FemMesh.HexaCount
    FreeCADGui.ActiveDocument.setEdit(mesh.Name)
    wait_for(lambda: rows("overrides") and "can be swept" in widget("verdict").text())
    choose("elementKind", 1)
    choose("elementOrder", 1)
    type_into("imprintTolerance", "0.3 mm")
    press(panel_button("OK"))
    check("other elements are meshed", wait_for(lambda: not is_panel_open(), 120) and mesh.isValid())
    check("prisms", mesh.FemMesh.HexaCount == 0 and mesh.FemMesh.PrismCount == mesh.Prisms > 0)
    first = next(iter(mesh.FemMesh.Volumes))
    check("of second order", len(mesh.FemMesh.getElementNodes(first)) == 15)
    check("and the imprint tolerance is kept", mesh.ImprintTolerance.Value == 0.3)
    FreeCADGui.ActiveDocument.setEdit(mesh.Name)
    wait_for(lambda: rows("overrides"))
    shown = widget("elementKind").currentIndex(), widget("elementOrder").currentIndex()
    check("all is shown again", shown == (1, 1) and widget("imprintTolerance").property("rawValue") == 0.3)
    press(panel_button("Cancel"))
    wait_for(lambda: not is_panel_open())
    type_shortcut("Std_Undo")
    check("undo brings the hexahedra back", lambda: mesh.FemMesh.HexaCount == before and mesh.FemMesh.PrismCount == 0)
    check("and the old tolerance", mesh.ImprintTolerance.Value == 0)


def contradiction(document, mesh):
    mesh = document.SweepMesh
    brick = mesh.Shape
    FreeCADGui.ActiveDocument.setEdit(mesh.Name)
    wait_for(lambda: rows("overrides") and "can be swept" in widget("verdict").text())
    left = next(
        f"Edge{i}" for i, edge in enumerate(brick.Shape.Edges, 1)
        if abs(edge.tangentAt(edge.FirstParameter).z) > 0.9 and edge.CenterOfMass.x < 1 and edge.CenterOfMass.y < 1
    )
    choose("overrideKind", COUNT)
    press(widget("pickOverride"))
    type_into("overrideCount", "9")
    click_edge(brick, left)
    check("settings that contradict each other are told", wait_for(lambda: "not with these" in widget("verdict").text()))
    note("contradiction", rows("reasons"))
    check("with the edges", any("Edge" in row for row in rows("reasons")))
    picture("06_contradiction")
    click_edge(brick, left)
    check("and settled by taking one back", wait_for(lambda: widget("verdict").text() == "The solid can be swept."))
    check("then nothing is listed against them", rows("reasons") == [])
    press(panel_button("Cancel"))
    wait_for(lambda: not is_panel_open())
    settle(0.1)


def vertex_types():
    document = FreeCAD.newDocument("Stairs")
    stairs = document.addObject("Part::Feature", "Stairs")
    corners = [(0, 0, 0), (20, 0, 0), (20, 0, 6), (10, 0, 6), (10, 0, 14), (0, 0, 14), (0, 0, 0)]
    stairs.Shape = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 8, 0))
    document.recompute()
    show_all()
    front = next(f"Face{i}" for i, face in enumerate(stairs.Shape.Faces, 1) if face.normalAt(0, 0).y < -0.9)
    inner = next(f"Vertex{i}" for i, v in enumerate(stairs.Shape.Vertexes, 1) if tuple(v.Point) == (10, 0, 6))
    FreeCADGui.Selection.addSelection(stairs)
    press(tool_button("Create sweep mesh"))
    check("the front is a cap at first", wait_for(lambda: front in rows("sources") + rows("targets")))
    choose("overrideKind", TYPE)
    press(widget("pickOverride"))
    choose("overrideType", 2)
    click_vertex(stairs, inner)
    check("a vertex alone is not admitted", rows("overrides") == [])
    click_point((4, 0, 4))
    check("a face shows that it is meant", wait_for(lambda: selected_names() == [front]))
    click_vertex(stairs, inner)
    check("a vertex of it gets the type", wait_for(lambda: rows("overrides") == [f"{inner} of {front}: corner"]))
    check("and makes it a linking face", wait_for(lambda: rows("sources") and front not in rows("sources") + rows("targets")))
    check("that turns there", wait_for(lambda: "C" in letters(stairs)))
    picture("07_types")
    click_vertex(stairs, inner)
    check("a second click takes it back", wait_for(lambda: front in rows("sources") + rows("targets")))
    check("out of the list, too", rows("overrides") == [])
    click_vertex(stairs, inner)
    wait_for(lambda: rows("overrides") and "can be swept" in widget("verdict").text())
    type_into("meshSize", "2 mm")
    press(panel_button("OK"))
    check("the type is meshed", wait_for(lambda: not is_panel_open(), 120) and document.SweepMesh.isValid())
    check("and kept", document.SweepMesh.VertexTypes == [f"{front}:{inner}=corner"])


go(steps)

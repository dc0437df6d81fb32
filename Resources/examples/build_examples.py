"""Builds the example parts beside this script: /usr/bin/python3 build_examples.py"""

import math
import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parents[1] / "Mod"))

from sweepmesh.freecad import import_freecad  # noqa: E402

FreeCAD = import_freecad()
import Part  # noqa: E402


def manifold_elbow():
    """A 90 degree elbow with three channels: its caps are the two planar ends, everything between is swept."""
    bend, lobe, wall, channel, straight = 60, 12, 11, 6, 25
    centre = FreeCAD.Vector(bend, 0, 0)
    axes = [
        centre + FreeCAD.Vector(lobe * math.cos(angle), lobe * math.sin(angle), 0)
        for angle in (math.radians(90 + 120 * i) for i in range(3))
    ]
    section = Part.makeFace([_hull(axes, wall), *(_circle(axis, channel) for axis in axes)], "Part::FaceMakerBullseye")
    elbow = section.revolve(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(0, 1, 0), 90)
    legs = [section.extrude(FreeCAD.Vector(0, 0, straight))]
    end = section.copy()
    end.rotate(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(0, 1, 0), 90)
    legs.append(end.extrude(FreeCAD.Vector(-straight, 0, 0)))
    return elbow.multiFuse(legs).Solids[0]


def pipe_junction():
    """A thick pipe along z with a bore across it: its floors and ceilings are quarters of the bore's wall."""
    outer, inner, height, cross = 24, 12, 50, 7
    foot, up = FreeCAD.Vector(0, 0, -height / 2), FreeCAD.Vector(0, 0, 1)
    pipe = Part.makeCylinder(outer, height, foot, up).cut(Part.makeCylinder(inner, height, foot, up))
    start = FreeCAD.Vector(-1.5 * outer, 0, 0)
    bore = Part.Face(_quartered_circle(start, cross)).extrude(FreeCAD.Vector(3 * outer, 0, 0))
    return pipe.cut(bore).Solids[0]


def _quartered_circle(centre, radius):
    """A circle across x in four arcs; two of them lie above and below the centre."""
    at = [math.radians(angle) for angle in range(45, 406, 45)]
    points = [centre + FreeCAD.Vector(0, radius * math.cos(a), radius * math.sin(a)) for a in at]
    return Part.Wire([Part.Arc(*points[i : i + 3]).toShape() for i in range(0, 8, 2)])


def _circle(centre, radius):
    return Part.Wire([Part.Circle(centre, FreeCAD.Vector(0, 0, 1), radius).toShape()])


def _hull(centres, radius):
    """The outline of round rods that a belt holds together: arcs and the lines that touch them."""
    edges, count = [], len(centres)
    for i, centre in enumerate(centres):
        before, after = centres[i - 1], centres[(i + 1) % count]
        start, end = _right_of(before, centre) * radius, _right_of(centre, after) * radius
        middle = (start + end).normalize() * radius
        edges.append(Part.Arc(centre + start, centre + middle, centre + end).toShape())
        edges.append(Part.makeLine(centre + end, after + end))
    return Part.Wire(edges)


def _right_of(a, b):
    """The unit vector to the right of the way from a to b."""
    along = (b - a).normalize()
    return FreeCAD.Vector(along.y, -along.x, 0)


def write(shape, name):
    """A STEP file with nothing in it that changes from run to run."""
    path = FOLDER / f"{name}.step"
    shape.exportStep(str(path))
    text = re.sub(r"'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d'", "'2000-01-01T00:00:00'", path.read_text())
    path.write_text(re.sub(r"'Open CASCADE STEP translator [0-9. ]+'", f"'{name}'", text))
    print(f"{path.name}: {len(shape.Faces)} faces, volume {shape.Volume:.1f}, valid {shape.isValid()}")


if __name__ == "__main__":
    write(manifold_elbow(), "manifold_elbow")
    write(pipe_junction(), "pipe_junction")

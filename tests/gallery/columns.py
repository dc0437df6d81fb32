"""Counts of an imprint by another route: the caps of an upright solid laid over each other by OpenCASCADE's Booleans."""

import FreeCAD
import Part
from solids.registry import caps

UP = FreeCAD.Vector(0, 0, 1)


def upright(shape, axis):
    """The shape turned so that `axis` is vertical."""
    turned = shape.copy()
    turned.Placement = FreeCAD.Placement(FreeCAD.Vector(), FreeCAD.Rotation(axis, UP)) * turned.Placement
    return turned


def n_columns(shape, axis=UP):
    """How many pieces there are, over all pieces that the caps' outlines divide the plan into, of the solid above each."""
    shape = upright(shape, axis)
    flat = []
    for cap in caps(shape, UP) + caps(shape, UP * -1):
        face = cap.copy()
        face.translate(FreeCAD.Vector(0, 0, -cap.CenterOfMass.z))
        flat.append(face)
    pieces = flat[0].generalFuse(flat[1:])[0].Faces
    return sum(_n_intervals(shape, _inner_point(piece)) for piece in pieces)


def n_levels(shape, axis=UP):
    """How many heights there are at which caps lie."""
    shape = upright(shape, axis)
    return len({round(cap.CenterOfMass.z, 6) for cap in caps(shape, UP) + caps(shape, UP * -1)})


def _inner_point(face):
    """A point that is well inside: the middle of the largest triangle."""
    points, triangles = face.tessellate(0.01)
    a, b, c = max(
        ([points[i] for i in triangle] for triangle in triangles),
        key=lambda t: (t[1] - t[0]).cross(t[2] - t[0]).Length,
    )
    return (a + b + c) / 3


def _n_intervals(shape, point):
    """How often a vertical line enters the solid."""
    box = shape.BoundBox
    low, high = FreeCAD.Vector(point.x, point.y, box.ZMin - 1), FreeCAD.Vector(point.x, point.y, box.ZMax + 1)
    return len(Part.makeLine(low, high).common(shape).Edges)

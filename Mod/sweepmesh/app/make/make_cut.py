"""Cut a solid that cannot be swept into pieces that can."""
import FreeCAD
import Part

from sweepmesh.app.shapes import shape_of
from sweepmesh.engine.errors import input_error


def make_cut(source, point, normal, name="Pieces"):
    """Put the pieces of a document object's solids, cut along a plane, into its document; return the new object.

    point, normal  the plane; `sweepmesh.engine.suggest_cut` finds one

    Neighbouring pieces share the face between them. The source is left as it is; the pieces do not follow it.
    An InputError where the plane misses the solids.
    """
    shape = shape_of(source)
    pieces = shape.generalFuse([_plane_across(shape, FreeCAD.Vector(*point), FreeCAD.Vector(*normal))])[0].Solids
    if len(pieces) <= len(shape.Solids):
        raise input_error(f"The plane does not cut {source.Label}.")
    obj = source.Document.addObject("Part::Feature", name)
    obj.Shape = Part.makeCompound(pieces)
    obj.Label = f"Pieces of {source.Label}"
    return obj


def _plane_across(shape, point, normal):
    """A square of the plane that reaches beyond the shape."""
    box = shape.BoundBox
    half = 2 * box.DiagonalLength
    square = Part.makePlane(2 * half, 2 * half, FreeCAD.Vector(-half, -half, 0))
    foot = box.Center - normal * (box.Center - point).dot(normal) * (1 / normal.dot(normal))
    square.Placement = FreeCAD.Placement(foot, FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), normal))
    return square

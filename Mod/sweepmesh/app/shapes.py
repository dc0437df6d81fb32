"""What is to be meshed: from a document object or a Part shape to what the engine takes."""
import FreeCAD
import Part

from sweepmesh import engine
from sweepmesh.engine.errors import input_error


def shape_of(source):
    """Return the Part shape of a document object; a Part shape is returned as it is."""
    shape = source if isinstance(source, Part.Shape) else getattr(source, "Shape", None)
    if not isinstance(shape, Part.Shape):
        label = getattr(source, "Label", source)
        raise input_error(f"{label} is no shape and has none: select a solid.")
    if shape.isNull():
        raise input_error("The shape is empty.")
    return shape


def brep_of(source):
    """Return the BREP text of a document object or a shape, faces numbered as FreeCAD numbers them.

    Raises InputError where there is no solid to mesh.
    """
    shape = shape_of(source)
    if not shape.Solids:
        raise input_error("The shape holds no solid: only solids can be swept.")
    return shape.exportBrepToString()


def has_solid(source):
    """Is this an object or a shape that holds a solid?"""
    shape = source if isinstance(source, Part.Shape) else getattr(source, "Shape", None)
    return isinstance(shape, Part.Shape) and not shape.isNull() and len(shape.Solids) > 0


def proposed_size(source, n_elements):
    """Return an edge length, rounded to two digits, that makes about `n_elements` elements of the smallest solid."""
    volume = min((abs(solid.Volume) for solid in shape_of(source).Solids), default=0.0)
    return float(f"{(volume / n_elements) ** (1 / 3):.2g}")


def face_number(source, face):
    """Return the number of a face of `source`: 7 for Face7.

    `face` is a name ("Face7"), a number from 1, a Part.Face of the shape, or a point (x, y, z) on the face.
    """
    shape = shape_of(source)
    if isinstance(face, str):
        number = _number_in_name(face)
    elif isinstance(face, Part.Face):
        number = _number_of_face(shape, face)
    elif isinstance(face, FreeCAD.Vector) or hasattr(face, "__len__"):
        number = engine.face_at(brep_of(shape), tuple(float(x) for x in face))
    else:
        number = int(face)
    if not 1 <= number <= len(shape.Faces):
        raise input_error(f"There is no face {face}: the shape has Face1 to Face{len(shape.Faces)}.")
    return number


def _number_in_name(name):
    digits = name[len("Face"):]
    if not name.startswith("Face") or not digits.isdigit():
        raise input_error(f"{name} is no name of a face: Face7 would be one.")
    return int(digits)


def _number_of_face(shape, face):
    for number, candidate in enumerate(shape.Faces, 1):
        if candidate.isSame(face):
            return number
    raise input_error("The face is none of the shape's faces.")

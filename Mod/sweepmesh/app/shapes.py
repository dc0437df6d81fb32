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
        number = _number_in_name("Face", face)
    elif isinstance(face, Part.Face):
        number = _number_of(shape.Faces, face)
    elif isinstance(face, FreeCAD.Vector) or hasattr(face, "__len__"):
        number = engine.face_at(brep_of(shape), tuple(float(x) for x in face))
    else:
        number = int(face)
    if not 1 <= number <= len(shape.Faces):
        raise input_error(f"There is no face {face}: the shape has Face1 to Face{len(shape.Faces)}.")
    return number


def edge_number(source, edge):
    """Return the number of an edge of `source`: 5 for Edge5, given by name, by number from 1, or as a Part.Edge."""
    shape = shape_of(source)
    if isinstance(edge, str):
        number = _number_in_name("Edge", edge)
    elif isinstance(edge, Part.Edge):
        number = _number_of(shape.Edges, edge)
    else:
        number = int(edge)
    if not 1 <= number <= len(shape.Edges):
        raise input_error(f"There is no edge {edge}: the shape has Edge1 to Edge{len(shape.Edges)}.")
    return number


def vertex_number(source, vertex):
    """Return the number of a vertex of `source`: 7 for Vertex7, given by name, by number, or as a Part.Vertex."""
    shape = shape_of(source)
    if isinstance(vertex, str):
        number = _number_in_name("Vertex", vertex)
    elif isinstance(vertex, Part.Vertex):
        number = _number_of(shape.Vertexes, vertex)
    else:
        number = int(vertex)
    if not 1 <= number <= len(shape.Vertexes):
        raise input_error(f"There is no vertex {vertex}: the shape has Vertex1 to Vertex{len(shape.Vertexes)}.")
    return number


def _number_in_name(kind, name):
    digits = name[len(kind):]
    if not name.startswith(kind) or not digits.isdigit():
        raise input_error(f"{name} is no name of a {kind.lower()}: {kind}7 would be one.")
    return int(digits)


def _number_of(elements, element):
    for number, candidate in enumerate(elements, 1):
        if candidate.isSame(element):
            return number
    kind = element.ShapeType.lower()
    raise input_error(f"The {kind} is none of those of the shape.")

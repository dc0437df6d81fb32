"""From SHAPE on the command line to a Model, and from FACE to the number of a face."""

import dataclasses
import math
import pathlib
import re
from typing import List, Optional

from sweepmesh.engine import Model, face_at, read
from sweepmesh.engine.errors import input_error
from sweepmesh.engine.model import as_model
from sweepmesh.freecad import import_freecad, muted

MESH_SUFFIXES = {".stl", ".obj", ".ply", ".off", ".3mf", ".amf", ".vtk", ".vtu", ".msh", ".inp", ".unv", ".med"}

POINT_TOLERANCE = 1e-3
"""A point that names a face may be this far from it, as a fraction of the model's size."""


@dataclasses.dataclass
class Source:
    """Where a shape comes from."""

    path: pathlib.Path
    object_name: Optional[str] = None
    """Of the object in an .FCStd file."""


@dataclasses.dataclass
class Shape:
    """A shape that was read."""

    model: Model
    source: Source
    warnings: List[str] = dataclasses.field(default_factory=list)


def read_shape(path, object_name=None):
    """Reads SHAPE. Raises InputError."""
    path = pathlib.Path(path)
    if path.suffix.lower() in MESH_SUFFIXES:
        raise input_error(f"{path} is a mesh, not a CAD solid: give a STEP, IGES, BREP or FCStd file.")
    is_document = path.suffix.lower() == ".fcstd"
    if object_name and not is_document:
        raise input_error(f"--object names an object of an .FCStd file, which {path} is not.")
    with muted():
        if is_document:
            return _read_document(path, object_name)
        return Shape(read(path), Source(path))


def _read_document(path, object_name):
    if not path.is_file():
        raise input_error(f"There is no file {path}.")
    chosen, warnings = _choose_object(_open_document(path), path, object_name)
    model = as_model(chosen.Shape.exportBrepToString())
    return Shape(model, Source(path, chosen.Name), warnings)


def _open_document(path):
    freecad = import_freecad()
    try:
        return freecad.openDocument(str(path), True)
    except Exception as error:  # FreeCAD raises various types for a broken file
        reason = " ".join(str(error).split()).rstrip(" .")
        raise input_error(f"{path} cannot be read as a FreeCAD document: {reason}.") from error


def _choose_object(document, path, name):
    """The object to mesh, and warnings about the choice."""
    if name:
        found = document.getObject(name) or next(iter(document.getObjectsByLabel(name)), None)
        if found is None:
            raise input_error(f"{path} has no object {name}.")
        if not _has_solid(found):
            raise input_error(f"The object {name} ({found.TypeId}) of {path} is no solid.")
        return found, []
    solids = [item for item in document.Objects if _has_solid(item)]
    results = [item for item in solids if not any(_has_solid(user) for user in item.InList)]
    if not results:
        others = ", ".join(f"{item.Name} ({item.TypeId})" for item in document.Objects[:5])
        raise input_error(f"{path} holds no solid" + (f", only {others}." if others else "."))
    if len(results) == 1:
        return results[0], []
    names = ", ".join(item.Name for item in results)
    return results[0], [f"{path} has the solids {names}; {results[0].Name} is used (see --object)."]


def _has_solid(item):
    shape = getattr(item, "Shape", None)
    return bool(shape is not None and getattr(shape, "Solids", None))


def face_number(model, text):
    """The number of the face that FACE names: "Face7" or a point "x,y,z" on it."""
    return _number(model, text, "Face", model.n_faces, "faces", _face_near)


def vertex_number(model, text):
    """The number of the vertex that VERTEX names: "Vertex7" or a point "x,y,z" at it."""
    return _number(model, text, "Vertex", model.n_vertices, "vertices", _vertex_near)


def _number(model, text, kind, count, plural, nearest):
    name = re.fullmatch(kind + r"(\d+)", text.strip())
    if name:
        number = int(name[1])
        if not 1 <= number <= count:
            raise input_error(
                f"The shape has no {text}: its {plural} are {kind}1 to {kind}{count}.", "assess", [text]
            )
        return number
    number, distance = nearest(model, _point(text, kind))
    if distance > POINT_TOLERANCE * model.model_size:
        raise input_error(
            f"The point {text} lies on no {kind.lower()}: the nearest, {kind}{number}, is {distance:.4g} away.",
            "assess",
            [f"{kind}{number}"],
        )
    return number


def _face_near(model, point):
    """(number, distance) of the nearest face."""
    face = face_at(model, point)
    return face, model.distance_to_face(face - 1, point)


def _vertex_near(model, point):
    """(number, distance) of the nearest vertex."""
    distance, number = min((math.dist(point, model.vertex_point(i)), i + 1) for i in range(model.n_vertices))
    return number, distance


def _point(text, kind):
    """The point that x,y,z names; InputError where it is none."""
    try:
        point = [float(part) for part in text.split(",")]
    except ValueError:
        point = []
    if len(point) != 3 or not all(math.isfinite(part) for part in point):
        raise input_error(f"'{text}' names no {kind.lower()}: give a name as {kind}7 or a point as 1.5,0,20.")
    return point


def vertex_type(model, text):
    """(face, vertex, type) of FACE:VERTEX=TYPE."""
    parts = re.fullmatch(r"([^:=]+):([^:=]+)=([^:=]+)", text)
    if not parts:
        raise input_error(f"'{text}' is no vertex type: give it as Face3:Vertex7=CORNER.")
    return face_number(model, parts[1]), vertex_number(model, parts[2]), parts[3].strip()


def face_pair(model, text):
    """The numbers (source, target) of SOURCE=TARGET."""
    parts = text.split("=")
    if len(parts) != 2:
        raise input_error(f"'{text}' is no pair: give it as Face3=Face5.")
    return face_number(model, parts[0]), face_number(model, parts[1])


def document_object(source):
    """FreeCAD's object for a Source: in its document, or in a new one where it comes from another file."""
    if source.object_name:
        return _open_document(source.path).getObject(source.object_name)
    freecad = import_freecad()
    import Part

    document = freecad.newDocument("SweepMesh", hidden=True, temp=True)
    made = document.addObject("Part::Feature", re.sub(r"\W", "_", source.path.stem))
    made.Label = source.path.stem
    made.Shape = Part.read(str(source.path))
    return made

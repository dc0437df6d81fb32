"""Names of faces and vertices as FreeCAD shows them: "Face7" and 7 mean the same."""

import re

from sweepmesh.engine.errors import input_error


def face_number(face):
    """7 for "Face7" and for 7. Raises InputError for what is neither."""
    return _number("Face", face)


def vertex_number(vertex):
    """7 for "Vertex7" and for 7. Raises InputError for what is neither."""
    return _number("Vertex", vertex)


def _number(kind, given):
    name = re.fullmatch(rf"(?:{kind})?([1-9]\d*)", str(given).strip())
    if not name:
        raise input_error(f"'{given}' is no name of a {kind.lower()}: {kind}7 would be one.")
    return int(name[1])

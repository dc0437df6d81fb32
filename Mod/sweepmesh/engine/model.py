"""Reading shapes. A Model can be given wherever BREP text can: it saves reading the shape again."""

from sweepmesh.engine._sweepmesh import Model
from sweepmesh.engine.worker import run

__all__ = ["Model", "as_model", "face_at", "read"]


def read(path, solid=0):
    """Model of a solid of a STEP, IGES or BREP file; `solid` counts from 0."""
    return run(lambda _context: Model.from_file(str(path), solid))


def as_model(shape):
    """The Model of BREP text (`Part.Shape.exportBrepToString()`); a Model is returned as it is."""
    return shape if isinstance(shape, Model) else Model.from_brep(shape, 0)


def face_at(shape, point):
    """Number of the face nearest to a point (x, y, z): 7 means Face7."""
    return as_model(shape).nearest_face(point) + 1

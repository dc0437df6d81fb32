"""Reading shapes. A Model can be given wherever BREP text can: it saves reading the shape again."""

from sweepmesh.engine._sweepmesh import Model, solids_of
from sweepmesh.engine.errors import input_error
from sweepmesh.engine.worker import run

__all__ = ["Model", "as_model", "chosen_solids", "face_at", "read"]


def read(path, solid=0):
    """Model of a solid of a STEP, IGES or BREP file; `solid` counts from 0."""
    return run(lambda _context: Model.from_file(str(path), solid))


def as_model(shape):
    """The Model of BREP text (`Part.Shape.exportBrepToString()`); a Model is returned as it is."""
    return shape if isinstance(shape, Model) else Model.from_brep(shape, 0)


def chosen_solids(model, number=None):
    """Models of the solids of a shape: all of them, or number `number` alone (from 1)."""
    if number is None:
        return solids_of(model) if model.n_solids > 1 else [model]
    if not 1 <= number <= model.n_solids:
        raise input_error(f"There is no solid {number}: the shape has {model.n_solids}.", "read")
    return [model.of_solid(number - 1)]


def face_at(shape, point):
    """Number of the face nearest to a point (x, y, z): 7 means Face7."""
    model = as_model(shape)
    nearest = [solid.nearest_face(point) for solid in chosen_solids(model)]
    return min(nearest, key=lambda face: model.distance_to_face(face, point)) + 1

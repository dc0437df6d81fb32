"""The errors that the engine raises; the classes are made by the C++ module, which raises them too.

Each has `stage` ("read", "assess", "intervals", ...) and `entities` ("Face7", ...); the text is one whole
sentence for the user. InvalidMeshError has `elements` besides, the indices of those that stay inverted, and ImprintError
`failure`: "unreachable", "collision", "open_run" or "no_room".
"""

from sweepmesh.engine._sweepmesh import (
    Cancelled,
    ImprintError,
    InputError,
    InvalidMeshError,
    SolverError,
    SweepMeshError,
)

__all__ = [
    "Cancelled",
    "ImprintError",
    "InputError",
    "InvalidMeshError",
    "SolverError",
    "SweepMeshError",
    "input_error",
]


def input_error(sentence, stage="read", entities=()):
    """An InputError of the given stage, ready to be raised."""
    error = InputError(sentence)
    error.stage = stage
    error.entities = list(entities)
    return error

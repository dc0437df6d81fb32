"""The stages of the pipeline, each one call."""

import time

from sweepmesh.engine import _sweepmesh
from sweepmesh.engine.model import as_model, chosen_solids
from sweepmesh.engine.options import Options
from sweepmesh.engine.results import Assessment, Result
from sweepmesh.engine.worker import run


def assess(shape, options=None, progress=None):
    """Can the solid, or each solid of several, be swept, from which faces to which?

    `shape` is BREP text (`Part.Shape.exportBrepToString()`) or a Model. Returns an Assessment; that a solid
    cannot be swept is a normal answer. Raises InputError for a shape or an option that cannot be used.
    """
    options = options or Options()

    def work(context):
        solids = chosen_solids(as_model(shape), options.solid)
        return _sweepmesh.assess(solids, options.picks(solids[0]), context)

    return Assessment.from_core(run(work, options.threads, progress))


def mesh(shape, options=None, progress=None):
    """The swept mesh of a solid, or of all solids of a shape, as a Result.

    `shape` is BREP text or a Model. A solid that cannot be swept gives a Result without elements whose
    assessment has the reasons. Raises InputError, SolverError, InvalidMeshError, or Cancelled when
    `progress.is_cancelled()` says so.
    """
    options = options or Options()
    started = time.perf_counter()
    seconds = {}

    def work(context):
        solids = chosen_solids(as_model(shape), options.solid)
        seconds["read"] = time.perf_counter() - started
        core = _sweepmesh.sweep(solids, options.picks(solids[0]), options.to_core(), context)
        return core, _sweepmesh.scaled_jacobians(core, context)

    result = Result.from_core(*run(work, options.threads, progress))
    result.seconds = {**seconds, **result.seconds}
    result.seconds["total"] = time.perf_counter() - started
    return result

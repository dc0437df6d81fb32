"""The command line from arguments to exit status."""

import dataclasses
import json
import os
import signal
import sys
import time

from sweepmesh import engine, output
from sweepmesh.cli import report as reports
from sweepmesh.cli import shapes
from sweepmesh.cli.arguments import make_parser
from sweepmesh.cli.progress import progress_bar
from sweepmesh.cli.writing import write_all
from sweepmesh.engine.errors import input_error

DONE, FAILED, UNSWEEPABLE = 0, 1, 2
"""Exit statuses."""

NO_LIMIT = 2**31 - 1
"""Elements at most with --force: connectivity is of 32 bits."""


def main(arguments=None):
    """Runs the command line and ends the process with its exit status."""
    end_with(lambda: _run(make_parser().parse_args(arguments)))


def end_with(work):
    """Ends the process with the status that `work` returns; whatever it raises becomes a sentence and FAILED."""
    for stop in (signal.SIGINT, signal.SIGTERM):  # a shell may have had SIGINT ignored
        signal.signal(stop, signal.default_int_handler)
    try:
        status = work()
    except engine.SweepMeshError as error:
        status = _fail(str(error))
    except KeyboardInterrupt:
        status = _fail("Interrupted; files that were not finished are not left behind.")
    except BrokenPipeError:
        sys.stdout = None
        status = FAILED
    except MemoryError:
        status = _fail("There is not enough memory for this mesh: choose a larger size.")
    except Exception as error:  # no traceback reaches a user; the sentence says what there is to report
        status = _fail(f"An unexpected error, {type(error).__name__}: {' '.join(str(error).split())}.")
    _leave(status)


def _run(arguments):
    """Does what the arguments say; returns the exit status."""
    started = time.perf_counter()
    for path in arguments.out:
        output.check_path(path, has_polyhedra=arguments.element == "polyhedron", order=arguments.order)
    if arguments.report:
        output.check_folder(arguments.report)
    if arguments.cut:
        _check_pieces_path(arguments.cut)
    state = {"assessment": None, "result": None, "seconds": {}, "warnings": [], "cut": None}
    try:
        _work(arguments, state)
    except engine.SweepMeshError as error:
        if not arguments.force:
            error.args = (str(error).replace("lift the limit", "lift the limit with --force"),)
        _write_report(arguments.report, error=error, **state)
        raise
    state["seconds"]["total"] = time.perf_counter() - started
    report = _write_report(arguments.report, **state)
    if not arguments.quiet:
        for warning in state["warnings"]:
            print(f"sweepmesh: warning: {warning}", file=sys.stderr)
    is_sweepable = state["assessment"].is_sweepable
    if not arguments.quiet:
        print(reports.text_of(report))
    elif not is_sweepable:
        print(reports.text_of(report), file=sys.stderr)
    return DONE if is_sweepable else UNSWEEPABLE


def _check_pieces_path(path):
    """Raises InputError."""
    if not path.lower().endswith((".brep", ".brp")):
        raise input_error(f"The pieces of a cut are written as BREP: {path} has another suffix than .brep.")
    output.check_folder(path)


def _work(arguments, state):
    """Reads, assesses or meshes, and writes; what is known goes into `state` as soon as it is."""
    seconds, warnings = state["seconds"], state["warnings"]
    with progress_bar(not arguments.quiet) as progress:
        with _timed(seconds, "read"):
            shape = shapes.read_shape(arguments.shape, arguments.object)
        warnings += shape.warnings
        options = make_options(arguments, shape.model)
        if arguments.assess:
            with _timed(seconds, "assess"):
                state["assessment"] = engine.assess(shape.model, options, progress)
            if not state["assessment"].is_sweepable:
                _look_for_cut(shape.model, options, state, progress)
            return
        result = engine.mesh(shape.model, options, progress)
        if arguments.cut and not result.assessment.is_sweepable:
            shape, options, result = _mesh_pieces(shape, options, result, arguments.cut, state, progress)
        warnings += result.warnings
        state.update(result=result, assessment=result.assessment)
        if result.assessment.is_sweepable:
            with _timed(seconds, "write"):
                write_all(arguments.out, result, shape, options, progress)


def _mesh_pieces(shape, options, result, path, state, progress):
    """The pieces that the suggested cut leaves, written to `path`, and their mesh; all as given where there is none."""
    cut = engine.suggest_cut(shape.model, options, progress)
    if cut is None or shape.model.n_solids > 1:
        return shape, options, result
    with output.replacing(path) as temporary:
        temporary.write_text(cut.shape)
    state["cut"] = cut
    state["warnings"].append(f"The solid is cut into {len(cut.pieces)} pieces, which are in {path}: {cut.text}")
    pieces = shapes.read_shape(path)
    options = dataclasses.replace(options, solid=None, sources=[], targets=[], pairs=[], vertex_types=[])
    return pieces, options, engine.mesh(pieces.model, options, progress)


def _look_for_cut(model, options, state, progress):
    """Adds the plane that would help, where there is one, to the state and to the first reason."""
    cut = engine.suggest_cut(model, options, progress)
    if cut:
        state["cut"] = cut
        state["assessment"].reasons[0].text += " " + cut.text


def make_options(arguments, model):
    """The engine's Options from the arguments."""
    return engine.Options(
        size=arguments.size,
        layers=arguments.layers,
        element=arguments.element,
        order=arguments.order,
        threads=arguments.threads,
        solid=arguments.solid,
        max_elements=NO_LIMIT if arguments.force else None,
        sources=[shapes.face_number(model, face) for face in arguments.source],
        targets=[shapes.face_number(model, face) for face in arguments.target],
        pairs=[shapes.face_pair(model, pair) for pair in arguments.pair],
        vertex_types=[shapes.vertex_type(model, text) for text in arguments.type],
    )


def _write_report(path, **state):
    report = reports.make_report(**state)
    if path:
        try:
            with output.replacing(path) as temporary, open(temporary, "w", encoding="utf-8") as file:
                json.dump(report, file, indent=1)
                file.write("\n")
        except OSError as error:
            raise engine.InputError(f"The report {path} cannot be written: {error.strerror}.") from error
    return report


class _timed:
    """Adds the time that a block takes to seconds[stage]."""

    def __init__(self, seconds, stage):
        self._seconds, self._stage = seconds, stage

    def __enter__(self):
        self._started = time.perf_counter()

    def __exit__(self, *_exception):
        self._seconds[self._stage] = time.perf_counter() - self._started


def _fail(sentence):
    print(f"sweepmesh: {sentence}", file=sys.stderr)
    return FAILED


def _leave(status):
    """Ends the process at once: an interrupted worker may still run, and FreeCAD's exit hooks are slow."""
    for stream in (sys.stdout, sys.stderr):
        try:
            if stream:
                stream.flush()
        except BrokenPipeError:
            pass
    os._exit(status)

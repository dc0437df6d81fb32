"""Meshes the example part, solves a small analysis on it and draws both: python -m sweepmesh.demo [FOLDER]"""

import contextlib
import os
import pathlib
import sys
import tempfile
import time

import numpy

from sweepmesh import Options, SweepMeshError, engine, output
from sweepmesh.cli import report as reports
from sweepmesh.cli import shapes
from sweepmesh.cli.main import DONE, end_with
from sweepmesh.cli.progress import progress_bar
from sweepmesh.demo import analysis as fem
from sweepmesh.demo import picture
from sweepmesh.engine.writers import vtu
from sweepmesh.freecad import import_freecad, muted

ROOT = pathlib.Path(__file__).resolve().parents[3]
PART = ROOT / "Resources" / "examples" / "manifold_elbow.step"
SIZE, FORCE = 2.5, 2000
FIXED, LOADED = (-25.0, 0.0, -60.0), (60.0, 0.0, 25.0)
"""Points on the two ends of the part."""


def main(folder):
    """Does it all; files go to `folder`. Returns the exit status."""
    folder.mkdir(parents=True, exist_ok=True)
    files = {suffix: folder / (PART.stem + suffix) for suffix in (".vtu", ".inp", ".FCStd", ".png")}
    seconds = {}
    print(f"{PART.name}: a 90 degree elbow with three channels, swept from end to end\n")
    with _timed(seconds, "read"):
        shape = shapes.read_shape(PART)
    options = Options(size=SIZE)
    with progress_bar(True) as progress:
        result = engine.mesh(shape.model, options, progress)
    if not result.assessment.is_sweepable:
        raise SweepMeshError(" ".join(reason.text for reason in result.assessment.reasons))
    with _timed(seconds, "write"):
        output.write(result, files[".inp"])
    print(reports.text_of(reports.make_report(result.assessment, result, seconds)), "\n")

    with _timed(seconds, "analysis"):
        displacements, stresses = _analyse(shape, options, result, files[".FCStd"])
    largest = numpy.linalg.norm(displacements, axis=1).max()
    print(f"CalculiX: {FORCE} N across the free end moves it by {largest:.4f} mm;", end=" ")
    print(f"largest von Mises stress {stresses.max():.1f} MPa ({seconds['analysis']:.1f} s)\n")

    _write_results(files[".vtu"], result, displacements, stresses)
    with picture.display():
        picture.draw(files[".vtu"], files[".png"])
    for path in files.values():
        print(f"{os.path.relpath(path)}  {path.stat().st_size / 1e6:.2f} MB")
    return DONE


def _analyse(shape, options, result, path):
    """FreeCAD's document with part, mesh and solved analysis, saved as `path`; displacements and stresses."""
    import_freecad()
    part = shapes.document_object(shape.source)
    ends = [f"Face{engine.face_at(shape.model, point)}" for point in (FIXED, LOADED)]
    analysis = fem.make_analysis(part, *ends, FORCE, _straight_edge(part))
    output.add_sweep_mesh(result, part, options, analysis)
    with tempfile.TemporaryDirectory() as folder, muted():
        solved = fem.solve(analysis, folder)
    with output.replacing(path) as temporary:
        part.Document.saveCopy(str(temporary))
    return solved


def _straight_edge(part):
    """The name of the first straight edge of the free end: across its channels."""
    for i, edge in enumerate(part.Shape.Edges):
        if edge.Curve.TypeId == "Part::GeomLine" and all(abs(v.Z - LOADED[2]) < 1e-6 for v in edge.Vertexes):
            return f"Edge{i + 1}"
    raise SweepMeshError("The example part has no straight edge at its free end.")


def _write_results(path, result, displacements, stresses):
    with output.replacing(path) as temporary:
        vtu.write_result(temporary, result, {"Displacement": displacements, "VonMises": stresses})


@contextlib.contextmanager
def _timed(seconds, stage):
    started = time.perf_counter()
    yield
    seconds[stage] = time.perf_counter() - started


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "out"
    end_with(lambda: main(target))

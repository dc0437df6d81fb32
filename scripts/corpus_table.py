"""Prints verdict and mesh of every CAD file of a folder: corpus_table.py [FOLDER]

By default of the folder `corpus` in a folder `shared` beside the checkout, or where SWEEPMESH_SHARED points. No picks are
made. One line a file: faces, verdict, elements, least and mean scaled Jacobian, seconds, what the independent judge says.
The exit status is 1 where a file that was called sweepable gave no mesh, or one that the judge does not accept.
"""

import os
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "Mod"), str(ROOT / "tests" / "gallery")]

from gallery import find_judge  # noqa: E402

import sweepmesh  # noqa: E402

SUFFIXES = (".step", ".stp", ".brep", ".brp", ".iges", ".igs")


def row(path, judge):
    """(line, did verdict and mesher agree) of a file."""
    name = f"{path.stem:<34}"
    try:
        model = sweepmesh.read(path)
        name += f"{len(model.faces):>4} faces  "
        result = sweepmesh.mesh(model)
    except sweepmesh.SweepMeshError as error:
        return f"{name}{'error':<12}{error.stage}: {error}", False
    found = result.assessment
    if not found.is_sweepable:
        seconds = result.seconds["assess"]
        is_late = result.seconds["total"] > 2 * seconds + 1
        reasons = "; ".join(f"{reason.kind}: {reason.text}" for reason in found.reasons)
        return f"{name}{'folded' if is_late else 'refused':<12}{seconds:>6.2f} s  {reasons}", not is_late
    failures = judged(path, result, judge)
    quality = result.quality
    return (
        f"{name}{'meshed':<12}{result.seconds['total']:>6.2f} s {result.n_elements:>7} elements"
        f"  SJ {quality['min_scaled_jacobian']:.3f} {quality['mean_scaled_jacobian']:.3f}  "
        + ("; ".join(failures) or ("judge ok" if judge else "not judged"))
    ), not failures


def judged(path, result, judge):
    """What the judge finds wrong."""
    if judge is None:
        return []
    with tempfile.TemporaryDirectory() as folder:
        mesh_path = pathlib.Path(folder) / "mesh.vtu"
        sweepmesh.write(result, mesh_path)
        return [str(failure) for failure in judge(str(mesh_path), str(path))["failures"]]


def main():
    """Prints the table."""
    shared = pathlib.Path(os.environ.get("SWEEPMESH_SHARED", ROOT.parent / "shared"))
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else shared / "corpus"
    paths = sorted(path for path in folder.glob("*") if path.suffix.lower() in SUFFIXES)
    if not paths:
        print(f"There are no CAD files in {folder}.")
        return 0
    judge = find_judge()
    agree = True
    for path in paths:
        line, agrees = row(path, judge)
        print(line, flush=True)
        agree &= agrees
    return 0 if agree else 1


if __name__ == "__main__":
    sys.exit(main())

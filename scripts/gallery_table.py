"""Meshes the gallery and prints a table: gallery_table.py [--kind 1-1] [NAME...]

One line for each solid without picks and with the picks of each scheme: verdict, hexahedra, least and mean scaled
Jacobian, inverted elements, seconds, and what the independent judge says where it is found beside the checkout.
"""

import argparse
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "Mod"), str(ROOT / "tests" / "gallery")]

from gallery import cases, find_judge, manifest  # noqa: E402

import sweepmesh  # noqa: E402

HEADER = f"{'solid':<38}{'verdict':<13}{'hexes':>8}{'min SJ':>8}{'mean SJ':>9}{'inv':>5}{'s':>7}  judge"


def row(case, judge):
    """The line of a case."""
    try:
        _, result = case.mesh()
    except sweepmesh.SweepMeshError as error:
        return f"{case.label:<38}{'error':<13}{type(error).__name__}, {error.stage}: {error}"
    found = result.assessment
    if not found.is_sweepable:
        return f"{case.label:<38}{found.verdict:<13}{found.reasons[0].text}"
    quality = result.quality
    return (
        f"{case.label:<38}{found.verdict:<13}{result.n_elements:>8}{quality['min_scaled_jacobian']:>8.3f}"
        f"{quality['mean_scaled_jacobian']:>9.3f}{quality['n_inverted']:>5}{result.seconds['total']:>7.2f}"
        f"  {judged(case, result, judge)}"
    )


def judged(case, result, judge):
    """What the judge says: ok, or its failures."""
    if judge is None:
        return "-"
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "mesh.vtu"
        sweepmesh.write(result, path)
        return "; ".join(map(str, judge(str(path), str(case.path))["failures"])) or "ok"


def main():
    """Prints the table."""
    kinds = sorted({entry["kind"] for entry in manifest().values()})
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="solids (default: all of the kind)")
    parser.add_argument("--kind", action="append", choices=kinds, help="repeatable (default: 1-1)")
    chosen = parser.parse_args()
    judge = find_judge()
    print(HEADER)
    for case in cases(*(chosen.kind or (kinds if chosen.names else ["1-1"]))):
        if not chosen.names or case.name in chosen.names:
            print(row(case, judge), flush=True)


if __name__ == "__main__":
    main()

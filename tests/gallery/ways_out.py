"""Follows the way out that a refusal offers: a solid that cannot be swept is cut along the suggested plane and meshed.

    /usr/bin/python3 tests/gallery/ways_out.py [FIRST [COUNT [FAMILY]]]

Of the random solids of a family (random_solids.py) those that are refused are cut where a cut is offered, and each piece
is meshed by itself. Prints a line for each, and how often the way led to meshes. The exit status is 1 where one in ten
leads nowhere.
"""

import collections
import pathlib
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
for folder in (HERE, HERE.parents[1] / "Mod"):
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))

from sweepmesh.freecad import import_freecad  # noqa: E402

import_freecad()
import sweepmesh  # noqa: E402
from checker import expect_valid_sweep  # noqa: E402
from random_solids import make  # noqa: E402

MOST = 0.1
"""Share of the offered ways that may lead nowhere."""


def way_out(shape):
    """("sweepable" | "unsound" | "none" | "led" | "lost", what was offered, or what came of it)."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "solid.brep"
        shape.exportBrep(str(path))
        try:
            model = sweepmesh.read(path)
        except sweepmesh.InputError as error:
            return "unsound", str(error)
    verdict = sweepmesh.assess(model)
    if verdict.is_sweepable:
        return "sweepable", ""
    cut = sweepmesh.suggest_cut(model)
    if cut is None:
        return "none", verdict.reasons[0].text
    return ("lost", fault) if (fault := fault_of(cut)) else ("led", cut.text)


def fault_of(cut):
    """Why a piece of a cut has no valid mesh; empty where all have one."""
    for piece in cut.pieces:
        try:
            result = sweepmesh.mesh(piece)
            if not result.assessment.is_sweepable:
                return f"{cut.text} A piece is refused: {result.assessment.reasons[0].text}"
            expect_valid_sweep(result, piece)
        except (sweepmesh.SweepMeshError, AssertionError) as error:
            return f"{cut.text} {error}"
    return ""


def main():
    """Prints the ways and the rate."""
    first, count = (int(text) for text in (sys.argv[1:3] + ["0", "40"][len(sys.argv[1:3]) :]))
    family = sys.argv[3] if len(sys.argv) > 3 else "primitives"
    counts = collections.Counter()
    for seed in range(first, first + count):
        outcome, text = way_out(make(family, seed))
        counts[outcome] += 1
        if outcome in ("none", "led", "lost"):
            print(f"{family} {seed:<7}{outcome:<6}{text}", flush=True)
    offered = counts["led"] + counts["lost"]
    print(
        f"{count} solids, {offered + counts['none']} refused: {offered} with a cut, "
        f"of which {counts['led']} led to meshes and {counts['lost']} did not"
    )
    return 0 if counts["lost"] <= MOST * max(1, offered) else 1


if __name__ == "__main__":
    sys.exit(main())

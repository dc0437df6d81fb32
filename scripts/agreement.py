"""Prints how often verdict and mesher disagree: agreement.py [--solids 240] [--first SEED] [--family NAME] [--all]

Over the gallery without picks, random terraced solids, random unions and cuts of primitives and random machine parts, each solid is assessed,
meshed where it is called sweepable, judged, and tried with picks where it is called unsweepable. tests/gallery/agreement.py
says what the outcomes mean. The exit status is 1 where more than one solid in a hundred disagrees.
"""

import argparse
import collections
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "Mod"), str(ROOT / "tests" / "gallery")]

from agreement import FAILING, OUTCOMES, run_all  # noqa: E402

FAMILIES = ("gallery", "terraced", "primitives", "parts")
MOST = 0.01
"""Share of solids that may disagree, each way."""


def jobs_of(family, n_solids, first):
    """The jobs of a family."""
    if family != "gallery":
        return [["random", family, first + i] for i in range(n_solids)]
    from gallery import cases, manifest

    kinds = {entry["kind"] for entry in manifest().values()}
    return [["file", str(case.path)] for case in cases(*kinds) if case.scheme < 0 and case.entry["solids"] == 1]


def line_of(examined):
    """One solid."""
    return (
        f"{examined.name:<28}{examined.outcome:<9}{examined.n_faces:>4} faces{examined.n_elements:>7} elements"
        f"{examined.least:>7.3f}{examined.assess_seconds:>7.2f} s{examined.seconds:>7.2f} s  {examined.detail[:300]}"
    )


def print_rates(family, done):
    """Counts of the outcomes of a family; returns whether the rates are small enough."""
    counts = collections.Counter(examined.outcome for examined in done)
    failing = sum(counts[outcome] for outcome in FAILING)
    listed = ", ".join(f"{counts[outcome]} {outcome}" for outcome in OUTCOMES if counts[outcome])
    print(
        f"{family:<12}{len(done):>4} solids: {listed}; called sweepable and failed {failing / len(done):.1%}, "
        f"called unsweepable and meshed {counts['missed'] / len(done):.1%}"
    )
    return max(failing, counts["missed"]) <= MOST * len(done)


def main():
    """Prints the solids that disagree (with --all: every one) and the rates."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--solids", type=int, default=120, help="of each random family (default: 120)")
    parser.add_argument("--first", type=int, default=0, help="the first seed (default: 0)")
    parser.add_argument("--family", action="append", choices=FAMILIES, help="repeatable (default: all)")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--all", action="store_true", help="print a line for every solid")
    chosen = parser.parse_args()

    def report(examined):
        if chosen.all or not examined.agrees:
            print(line_of(examined), flush=True)

    everything, families = [], {}
    for family in chosen.family or FAMILIES:
        families[family] = run_all(jobs_of(family, chosen.solids, chosen.first), chosen.processes, report=report)
        everything += families[family]
    for family, done in families.items():
        print_rates(family, done)
    return 0 if print_rates("all", everything) else 1


if __name__ == "__main__":
    sys.exit(main())

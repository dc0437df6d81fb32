#!/usr/bin/python3
"""Table of all methods of placement on the solids of a gallery that are swept one to one or many to one.

    placement_table.py PROGRAM [--all] [--quick] [--markdown] [--factor F] [--gallery FOLDER] [SOLID ...]

PROGRAM is sweepmesh_bench_methods. Without names: the solids of the thesis' chapters 2 to 4 (the figures in FIGURES),
with --all every one. FOLDER holds gallery.json and its shapes; by default it is the one in $SWEEPMESH_SHARED/gallery
or in a folder `shared` beside the checkout. F multiplies the element sizes, --quick leaves out the methods that take
seconds. Each row is followed by what beats the
first method in its solid: a greater least or mean scaled Jacobian (to four digits) of any other.
Ends with 1 if one does whose mesh is valid, or if the first method leaves an element inverted.
"""
import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

FIGURES = {"2.1", "3.9", "3.11", "3.13", "3.15", "4.1", "4.4", "4.5", "4.7"}
OURS = "harmonic_residual"


def gallery_folder():
    beside = Path(__file__).resolve().parents[2].parent / "shared"
    return Path(os.environ.get("SWEEPMESH_SHARED", beside)) / "gallery"


def figures_of(solid):
    return {f.strip() for f in solid["figure"].split(",")}


def is_placed(solid):
    """Whether the solid belongs into the table: no sources above one another."""
    return solid["kind"] in ("1-1", "M-1")


def is_in_table(solid):
    return is_placed(solid) and bool(figures_of(solid) & FIGURES)


def chosen(solids, options):
    for solid in solids:
        if options.solids:
            is_wanted = solid["name"] in options.solids
        else:
            is_wanted = is_placed(solid) if options.all else is_in_table(solid)
        if is_wanted:
            yield solid


def run(program, folder, solid, factor=1.0, is_quick=False):
    """Rows of one solid: method, then the columns as printed."""
    scheme = solid["schemes"][0]
    picks = [str(x) for kind in ("source", "target") for p in scheme[kind + "s"] for x in (kind, *p)]
    command = [program, solid["name"], str(folder / solid["file"]), str(factor * solid["element_size"]), *picks]
    command[1:1] = ["--quick"] * is_quick
    lines = subprocess.run(command, capture_output=True, text=True).stdout.splitlines()
    return [line.split(None, 7)[1:] for line in lines]


def beats(rows):
    """Methods that have a greater least or mean value than ours; True for those without an inverted element."""
    values = {r[0]: [float(x) for x in r[2:5]] for r in rows if len(r) > 4 and r[2] != "-"}
    if OURS not in values:
        return [("no mesh", True)]
    inverted, least, mean = values.pop(OURS)
    out = [("inverted", True)] if inverted else []
    for method, (n, other_least, other_mean) in values.items():
        for what, own, other in (("min", least, other_least), ("mean", mean, other_mean)):
            if other > own + 5e-5:
                out.append(("%s has %s %.4f and %d inverted" % (method, what, other, n), n == 0))
    return out


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--markdown", action="store_true")
    parser.add_argument("--factor", type=float, default=1.0)
    parser.add_argument("--gallery", type=Path, default=gallery_folder())
    parser.add_argument("solids", nargs="*")
    options = parser.parse_intermixed_args()
    line = "| %s | %s | %s | %s | %s | %s |" if options.markdown else "%-18s %7s %8s %8s %8s %9s"
    is_beaten = False
    for solid in chosen(json.loads((options.gallery / "gallery.json").read_text())["solids"], options):
        print("\n%s, figure %s\n" % (solid["name"], solid["figure"]))
        print(line % ("method", "hexes", "inverted", "min", "mean", "seconds"))
        if options.markdown:
            print("|---|---|---|---|---|---|")
        rows = run(options.program, options.gallery, solid, options.factor, options.quick)
        for row in rows:
            print(line % tuple((row + [""] * 6)[:6]))
        better = beats(rows)
        print("\n" + ("; ".join(text for text, _ in better) or "No method has a greater min or mean."), flush=True)
        is_beaten = is_beaten or any(is_valid for _, is_valid in better)
    return 1 if is_beaten else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
"""Table of all methods of placement on the solids of a gallery.

    placement_table.py PROGRAM [GALLERY] [FACTOR]

PROGRAM is sweepmesh_bench_methods; GALLERY a folder with gallery.json and its shapes, by default the one in
$SWEEPMESH_SHARED/gallery or in a folder `shared` beside the checkout. FACTOR multiplies the element sizes. Only
solids of the kind 1-1 have all methods; the others are left out.
"""
import json
import os
import subprocess
import sys
from pathlib import Path


def gallery_folder():
    beside = Path(__file__).resolve().parents[2].parent / "shared"
    return Path(os.environ.get("SWEEPMESH_SHARED", beside)) / "gallery"


def main():
    program = sys.argv[1]
    folder = Path(sys.argv[2]) if len(sys.argv) > 2 else gallery_folder()
    factor = float(sys.argv[3]) if len(sys.argv) > 3 else 1.0
    print("%-30s %-18s %7s %7s %8s %8s %8s" % ("solid", "method", "hexes", "inverted", "min", "mean", "seconds"),
          flush=True)
    for solid in json.loads((folder / "gallery.json").read_text())["solids"]:
        if solid["kind"] != "1-1":
            continue
        scheme = solid["schemes"][0]
        picks = [str(x) for kind in ("source", "target") for point in scheme[kind + "s"] for x in (kind, *point)]
        subprocess.run([program, solid["name"], str(folder / solid["file"]), str(factor * solid["element_size"]), *picks])


main()

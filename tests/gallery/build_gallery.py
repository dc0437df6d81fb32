"""Builds the gallery: solids that a swept mesher must serve or refuse, as STEP files with a manifest.

    /usr/bin/python3 build_gallery.py FOLDER              all of them, and FOLDER/gallery.json
    /usr/bin/python3 build_gallery.py FOLDER brick gear   only these, no manifest

Every solid follows a figure of Cai's thesis on sweeping (captions and descriptions; dimensions are free). Each
builder in solids/ is a function whose docstring names the figure and the difficulty; lengths are millimetres.
In the manifest a face is named by a point on it that is far from its edges, so that the numbering of faces does
not matter. The exit status is 1 when a solid fails its own checks (closed, valid, genus, caps).
"""

import argparse
import json
import os
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
for folder in (HERE, HERE.parents[1] / "Mod"):
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))

from sweepmesh.freecad import import_freecad  # noqa: E402

FreeCAD = import_freecad()
import Part  # noqa: E402
from solids import many_to_many, many_to_one, one_to_one, plates, radial_and_unsweepable, rounds  # noqa: E402, F401
from solids.kit import one_solid, rounded  # noqa: E402
from solids.registry import SOLIDS, interior_point  # noqa: E402


KINDS = ["1-1", "M-1", "M-N", "radial", "unsweepable", "submap"]
"""In the order of the manifest."""


def shell_genus(shell):
    """Genus of a closed shell from the Euler characteristic of its cells."""
    edges = [e for e in shell.Edges if not e.Degenerated]
    chi = len(shell.Vertexes) - len(edges) + sum(2 - len(f.Wires) for f in shell.Faces)
    return (2 - chi) // 2


def face_count(shape):
    """Faces summed over the solids (a contact face of two solids counts twice)."""
    return sum(len(body.Faces) for body in shape.Solids)


def two_digits(x):
    """x rounded to two significant digits."""
    return float("%.2g" % x)


def face_indices(shape, faces):
    """Positions of the given faces in shape.Faces."""
    return [next(k for k, other in enumerate(shape.Faces) if other.isSame(face))
            for face in faces]


def check_scheme(shape, entry, kind):
    """Complaints about a scheme; an empty list when it is sound."""
    trouble = []
    sources, targets = entry["sources"], entry["targets"]
    used = face_indices(shape, sources + targets)
    if len(set(used)) != len(used):
        trouble.append("a face is used twice")
    if kind == "1-1" and (len(sources), len(targets)) != (1, 1):
        trouble.append("1-1 with %d/%d caps" % (len(sources), len(targets)))
    if kind == "M-1" and not (len(sources) > 1 and len(targets) == 1):
        trouble.append("M-1 with %d/%d caps" % (len(sources), len(targets)))
    if kind == "M-N" and not (len(sources) > 1 and len(targets) > 1):
        trouble.append("M-N with %d/%d caps" % (len(sources), len(targets)))
    for source in sources:
        for target in targets:
            if any(a.isSame(b) for a in source.Edges for b in target.Edges):
                trouble.append("a source touches a target along an edge")
    for face in sources + targets:
        vertex = Part.Vertex(FreeCAD.Vector(*rounded(interior_point(face))))
        distances = sorted((vertex.distToShape(f)[0], k) for k, f in enumerate(shape.Faces))
        if distances[0][0] > 1e-5 or not shape.Faces[distances[0][1]].isSame(face):
            trouble.append("a face point is off its face")
        if len(distances) > 1 and distances[1][0] < 1e-3:
            trouble.append("a face point is ambiguous")
    return trouble


def write_step(shape, path, name):
    """STEP file without anything that changes from run to run."""
    shape.exportStep(path)
    with open(path) as handle:
        text = handle.read()
    text = re.sub(r"'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d'", "'2000-01-01T00:00:00'", text)
    text = re.sub(r"'Open CASCADE STEP translator [0-9. ]+'", "'%s'" % name, text)
    with open(path, "w") as handle:
        handle.write(text)


def manifest_entry(spec, shape, schemes, extra):
    """JSON record of one solid."""
    size = spec["size"] or two_digits((shape.Volume / spec["hexes"]) ** (1 / 3.0))
    box_ = shape.BoundBox
    record = dict(
        name=spec["name"], file=spec["name"] + ".step", figure=spec["figure"],
        kind=spec["kind"], about=spec["about"], note=spec["note"],
        expected=dict(verdict="unsweepable" if spec["unsweepable"] else "sweepable",
                      reason=spec["reason"]),
        element_size=size, hexes_about=int(round(shape.Volume / size ** 3, -2)),
        volume=round(shape.Volume, 6), area=round(shape.Area, 6),
        solids=len(shape.Solids), faces=face_count(shape),
        edges=len([e for e in shape.Edges if not e.Degenerated]),
        vertices=len(shape.Vertexes),
        genus=sorted(shell_genus(s) for s in shape.Shells),
        shortest_edge=round(min(e.Length for e in shape.Edges if not e.Degenerated), 4),
        box=[rounded((box_.XMin, box_.YMin, box_.ZMin)),
             rounded((box_.XMax, box_.YMax, box_.ZMax))],
        schemes=[])
    for entry in schemes:
        out = {key: value for key, value in entry.items()
               if key not in ("sources", "targets", "body")}
        for side in ("sources", "targets"):
            out[side] = [rounded(interior_point(face)) for face in entry[side]]
        record["schemes"].append(out)
    record.update(extra)
    return record


def build_one(spec, folder):
    """Build, check and write one solid; returns (record, complaints, bytes)."""
    result = spec["build"]()
    shape, schemes = result[0], result[1]
    extra = result[2] if len(result) > 2 else {}
    trouble = []
    if shape.ShapeType != "Compound" or len(shape.Solids) == 1:
        shape = one_solid(shape)
        if shape.ShapeType != "Solid":
            trouble.append("not a solid")
    for body in shape.Solids:
        if not (body.isValid() and body.Volume > 0 and all(s.isClosed() for s in body.Shells)):
            trouble.append("not a valid closed solid")
    genus = sorted(shell_genus(s) for s in shape.Shells)
    if genus != spec["genus"]:
        trouble.append("genus %s, expected %s" % (genus, spec["genus"]))
    for entry in schemes:
        kind = entry.get("kind", spec["kind"])
        trouble += check_scheme(entry.get("body", shape), entry, kind)
    path = os.path.join(folder, spec["name"] + ".step")
    write_step(shape, path, spec["name"])
    again = Part.read(path)
    if abs(again.Volume - shape.Volume) > 1e-6 * shape.Volume:
        trouble.append("STEP volume %g, built %g" % (again.Volume, shape.Volume))
    if face_count(again) != face_count(shape) or len(again.Solids) != len(shape.Solids):
        trouble.append("STEP has %d faces in %d solids" % (face_count(again), len(again.Solids)))
    if not again.isValid():
        trouble.append("STEP re-read is not valid")
    size = os.path.getsize(path)
    if size > 1000000:
        trouble.append("STEP file is %d bytes" % size)
    return manifest_entry(spec, shape, schemes, extra), trouble, size


def main(folder, manifest, only):
    """Build everything (or just the names in `only`) and print the table."""
    os.makedirs(folder, exist_ok=True)
    records, failures = [], 0
    print("%-28s %-11s %5s %11s %5s %7s %6s %4s  %s" % (
        "name", "kind", "faces", "volume", "size", "hexes", "kB", "gen", "result"))
    for spec in sorted(SOLIDS, key=lambda spec: KINDS.index(spec["kind"])):
        if only and spec["name"] not in only:
            continue
        try:
            record, trouble, size = build_one(spec, folder)
        except Exception as error:  # a failed solid must not hide the others
            if only:
                raise
            failures += 1
            print("%-28s FAILED: %s" % (spec["name"], error))
            continue
        failures += bool(trouble)
        records.append(record)
        print("%-28s %-11s %5d %11.1f %5.2g %7d %6.1f %4s  %s" % (
            record["name"], record["kind"], record["faces"], record["volume"],
            record["element_size"], record["hexes_about"], size / 1000.0,
            "+".join(str(g) for g in record["genus"]), "; ".join(trouble) or "ok"))
    if not only:
        with open(os.path.join(folder, manifest), "w") as handle:
            json.dump(dict(units="mm", solids=records), handle, indent=1)
            handle.write("\n")
    print("%d solids, %d with trouble" % (len(records), failures))
    return 1 if failures else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder")
    parser.add_argument("names", nargs="*", help="solids to build (default: all)")
    options = parser.parse_args()
    sys.exit(main(options.folder, "gallery.json", options.names))

"""Solids that are not sound: every run ends, with a verdict or with a sentence, and never crashes or hangs."""

import subprocess
import sys

import FreeCAD
import Part
import pytest
from gallery import ROOT
from solids.kit import box, polygon, rod, vec

SECONDS = 60
END = """
import sys
sys.path.insert(0, sys.argv[1])
import sweepmesh
try:
    model = sweepmesh.read(sys.argv[2])
    found = sweepmesh.assess(model)
    print("verdict", found.verdict, len(found.reasons))
    result = sweepmesh.mesh(model)
    print("mesh", result.n_elements)
except sweepmesh.SweepMeshError as error:
    print("error", error)
"""


def shell_of(faces):
    """A solid made of a shell of these faces, whatever they are."""
    return Part.Solid(Part.Shell(faces))


def inside_out():
    """A box whose faces all look inwards."""
    return shell_of([face.reversed() for face in box(0, 3, 0, 2, 0, 1).Faces])


def one_face_reversed():
    """A box of which one face looks inwards."""
    faces = box(0, 3, 0, 2, 0, 1).Faces
    return shell_of([faces[0].reversed(), *faces[1:]])


def open_shell():
    """A box without its lid, made a solid."""
    return shell_of(box(0, 3, 0, 2, 0, 1).Faces[:5])


def two_faces_only():
    """Two faces that meet in an edge."""
    return shell_of(box(0, 3, 0, 2, 0, 1).Faces[:3:2])


def self_intersecting():
    """The prism of a bow tie."""
    return Part.Face(polygon([(0, 0), (4, 3), (4, 0), (0, 3)])).extrude(vec(0, 0, 2))


def overlapping_shells():
    """Two boxes that overlap, as the shells of one solid."""
    return Part.makeSolid(Part.Compound([box(0, 3, 0, 3, 0, 3).Shells[0], box(2, 5, 0, 3, 0, 3).Shells[0]]))


def void_outside():
    """A shell that is meant as a void but lies outside of the solid."""
    solid = Part.Solid(box(0, 3, 0, 3, 0, 3).Shells[0])
    return Part.Solid(Part.Compound([solid.Shells[0], box(8, 9, 0, 1, 0, 1).Shells[0].reversed()]).Shells[0])


def tiny_edges():
    """A prism over a circle of four hundred edges, some of a ten-thousandth of the size."""
    import math

    points = []
    for i in range(100):
        angle = 2 * math.pi * i / 100
        for k in range(4):
            points.append((10 * math.cos(angle + k * 1e-4), 10 * math.sin(angle + k * 1e-4)))
    return Part.Face(polygon(points)).extrude(vec(0, 0, 5))


def sliver():
    """A box of a ten-thousandth of its length in thickness."""
    return box(0, 100, 0, 100, 0, 0.01)


def edge_inside_a_face():
    """A box on whose lid an edge is drawn that bounds nothing: it has no direction there."""
    faces = box(0, 3, 0, 2, 0, 1).Faces
    lid = max(faces, key=lambda face: face.CenterOfMass.z)
    drawn = Part.makeLine(vec(1, 1, 1), vec(2, 1, 1))
    pieces = lid.generalFuse([drawn])[0].Faces
    return shell_of([face for face in faces if not face.isSame(lid)] + pieces)


def touching_along_an_edge():
    """Two boxes that share one edge."""
    return box(0, 1, 0, 1, 0, 1).fuse(box(1, 2, 1, 2, 0, 1))


def tangent_cylinders():
    """A bore that touches the wall from inside."""
    return box(0, 10, 0, 10, 0, 5).cut(rod(3, vec(3, 5, -1), 10))


def pointed_cone():
    """A face with a degenerate edge."""
    return Part.makeCone(5, 0, 10)


def far_away():
    """A small box a long way from the origin."""
    return box(1e6, 1e6 + 1, 1e6, 1e6 + 1, 0, 1)


def mirrored():
    """A solid with a mirroring placement."""
    return box(0, 3, 0, 2, 0, 1).cut(rod(0.3, vec(1, 1, -1), 3)).mirror(vec(0, 0, 0), vec(1, 0, 0))


def scaled_unevenly():
    """A sphere of B-spline faces, squashed."""
    matrix = FreeCAD.Matrix()
    matrix.scale(1.0, 0.01, 1.0)
    return Part.makeSphere(10).transformGeometry(matrix)


SOLIDS = [
    inside_out, one_face_reversed, open_shell, two_faces_only, self_intersecting, overlapping_shells, void_outside,
    tiny_edges, sliver, edge_inside_a_face, touching_along_an_edge, tangent_cylinders, pointed_cone, far_away, mirrored, scaled_unevenly,
]  # fmt: skip


@pytest.mark.parametrize("build", SOLIDS, ids=lambda build: build.__name__)
def test_the_run_ends_with_a_verdict_or_a_sentence(build, tmp_path):
    path = tmp_path / "solid.brep"
    build().exportBrep(str(path))
    done = subprocess.run(
        [sys.executable, "-c", END, str(ROOT / "Mod"), str(path)], capture_output=True, text=True, timeout=SECONDS
    )
    assert done.returncode == 0, f"exit status {done.returncode}: {done.stderr[-500:]}"
    last = done.stdout.strip().splitlines()[-1]
    assert last.split()[0] in ("mesh", "error")
    if last.startswith("error"):
        assert last.endswith(".")

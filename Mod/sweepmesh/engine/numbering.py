"""Orders of nodes in the formats and programs that a mesh goes to, from the order of `Result`.

    hexahedron       7------6     prism      5        VTK's and Abaqus' order of hexahedra, Abaqus' order
                    /|     /|               /|\\       of prisms: the first ring is counterclockwise seen
                   4------5 |              3---4      from the second. Each permutation below gives the
                   | 3----|-2              | 2 |      columns to take: `hexahedra[:, TO_SMESH[8]]`.
                   |/     |/               |/ \\|
                   0------1                0---1

A polyhedron is a prism over a polygon of five corners or more, its rings as those of the others.
Elements are told apart by their number of nodes: 8 and 6, and 20 and 15 with mid-side nodes, which follow the
corners: those of the first ring's sides, of the second ring's, and those from ring to ring.
"""

VTK_TYPES = {8: 12, 6: 13, 20: 25, 15: 26}
VTK_POLYHEDRON = 42
ABAQUS_TYPES = {8: "C3D8", 6: "C3D6", 20: "C3D20", 15: "C3D15"}

_HEXAHEDRON_MIRRORED = [0, 3, 2, 1, 4, 7, 6, 5, 11, 10, 9, 8, 15, 14, 13, 12, 16, 19, 18, 17]
_PRISM_MIRRORED = [0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13]

TO_VTK = {8: list(range(8)), 20: list(range(20)), 6: _PRISM_MIRRORED[:6], 15: _PRISM_MIRRORED}
"""VTK's wedge is the mirror image: the normal of its first triangle points out of the element."""

TO_SMESH = {8: _HEXAHEDRON_MIRRORED[:8], 20: _HEXAHEDRON_MIRRORED, 6: _PRISM_MIRRORED[:6], 15: _PRISM_MIRRORED}
"""SMESH (FreeCAD's Fem.FemMesh) keeps the mirror image of both."""

HEXAHEDRON_SIDES = [(0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]
PRISM_SIDES = [(0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)]
"""Corners of the sides S1, S2, ... of Abaqus and CalculiX."""


def polyhedron_faces(n):
    """Corners of the faces of a polyhedron over n corners, counterclockwise seen from outside: rings, then sides."""
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    return [tuple(reversed(range(n))), tuple(range(n, 2 * n)), *sides]

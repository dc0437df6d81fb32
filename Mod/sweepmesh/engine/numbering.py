"""Orders of nodes in the formats and programs that a mesh goes to, from the order of `Result`.

    hexahedron       7------6     prism      5        VTK's and Abaqus' order of hexahedra, Abaqus' order
                    /|     /|               /|\\       of prisms: the first ring is counterclockwise seen
                   4------5 |              3---4      from the second. Each permutation below gives the
                   | 3----|-2              | 2 |      columns to take: `hexahedra[:, HEXAHEDRON_TO_SMESH]`.
                   |/     |/               |/ \\|
                   0------1                0---1
"""

VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON, VTK_HEXAHEDRON, VTK_WEDGE = 5, 9, 7, 12, 13

PRISM_TO_VTK = [0, 2, 1, 3, 5, 4]
"""VTK's wedge is the mirror image: the normal of its first triangle points out of the element."""

HEXAHEDRON_TO_SMESH = [0, 3, 2, 1, 4, 7, 6, 5]
PRISM_TO_SMESH = [0, 2, 1, 3, 5, 4]
"""SMESH (FreeCAD's Fem.FemMesh) keeps the mirror image of both."""

HEXAHEDRON_SIDES = [(0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]
PRISM_SIDES = [(0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)]
"""Corners of the sides S1, S2, ... of Abaqus and CalculiX."""

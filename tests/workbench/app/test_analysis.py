"""Swept meshes in FreeCAD's FEM workbench, solved by CalculiX, against theory and against fine tetrahedra."""
import math

import FreeCAD
import numpy as np
import Part
import pytest
from analysis import SHEAR, YOUNG, add_tetrahedra, make_analysis, mean_displacement, ring_inertia, solve

from sweepmesh import app

FORCE = 1000.0  # N


class Cantilever:
    """A brick fixed at one end and loaded across the other."""

    length, side = 100.0, 10.0  # mm
    fine = 2.5  # mm, size of the tetrahedra to compare with
    fixed, loaded, axis = "Face1", "Face2", (0, 0, 1)

    @classmethod
    def shape(cls, document):
        brick = document.addObject("Part::Box", "Brick")
        brick.Length, brick.Width, brick.Height = cls.length, cls.side, cls.side
        document.recompute()
        return brick

    @classmethod
    def theory(cls):
        """Timoshenko's beam: bending and shear."""
        inertia = cls.side**4 / 12
        return FORCE * cls.length**3 / (3 * YOUNG * inertia) + FORCE * cls.length / (5 / 6 * SHEAR * cls.side**2)


class BentPipe:
    """A quarter of a ring of pipe, fixed at one end and loaded across its plane at the other."""

    radius, outer, inner = 100.0, 10.0, 6.0  # mm
    fine = 3.0  # mm, size of the tetrahedra to compare with
    fixed, loaded, axis = "Face2", "Face3", (0, 0, 1)

    @classmethod
    def shape(cls, document):
        pipe = document.addObject("Part::Feature", "BentPipe")
        pipe.Shape = cls.quarter_torus(cls.outer).cut(cls.quarter_torus(cls.inner)).Solids[0]
        document.recompute()
        return pipe

    @classmethod
    def quarter_torus(cls, radius):
        return Part.makeTorus(cls.radius, radius, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 0, 360, 90)

    @classmethod
    def theory(cls):
        """Castigliano's theorem for a quarter ring loaded across its plane: bending, torsion and shear."""
        inertia = ring_inertia(cls.outer, cls.inner)
        bending = math.pi / 4 * FORCE * cls.radius**3 / (YOUNG * inertia)
        torsion = (3 * math.pi / 4 - 2) * FORCE * cls.radius**3 / (SHEAR * 2 * inertia)
        area = math.pi * (cls.outer**2 - cls.inner**2)
        shear = 2.0 * FORCE * cls.radius * math.pi / 2 / (SHEAR * area)  # 2.0: shape factor of a thin ring
        return bending + torsion + shear


def deflection(part, document, tmp_path, add_mesh):
    """How far the loaded face moves along the load on the mesh that `add_mesh(analysis, shape)` makes."""
    shape = part.shape(document)
    analysis = make_analysis(shape, part.fixed, part.loaded, FORCE, part.axis)
    mesh = add_mesh(analysis, shape)
    result = solve(analysis, tmp_path / "ccx")
    moved = mean_displacement(result, mesh.FemMesh, shape.Shape.getElement(part.loaded))
    return abs(moved.dot(FreeCAD.Vector(*part.axis)))


def swept(**settings):
    return lambda analysis, shape: app.make_sweep_mesh(shape, analysis=analysis, **settings)


def tetrahedra(size):
    return lambda analysis, shape: add_tetrahedra(analysis, shape, size)


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    """Deflection on a fine mesh of FreeCAD's own second-order tetrahedra, by part; each is solved once."""
    solved = {}

    def of(part):
        if part not in solved:
            doc = FreeCAD.newDocument()
            solved[part] = deflection(part, doc, tmp_path_factory.mktemp("tets"), tetrahedra(part.fine))
            FreeCAD.closeDocument(doc.Name)
        return solved[part]

    return of


@pytest.mark.parametrize("part", [Cantilever, BentPipe])
def test_the_fine_tetrahedra_agree_with_theory(part, reference):
    """Theory lies 0.8 % (brick) and 0.5 % (pipe) above them, as it lets the fixed end contract."""
    assert reference(part) == pytest.approx(part.theory(), rel=0.01)


# Linear hexahedra with full integration bend too stiffly: in an element of length a along a beam of height
# h, the bending that it cannot show comes out as shear strain, and the energy grows by about G/E (a/h)^2 =
# 0.38 (a/h)^2; the contraction across the beam that it cannot show either adds to that (0.55 (a/h)^2 measured).
# With 8 elements over the height that is 0.9 %, and with halved elements a quarter of it. Around the pipe their
# straight edges cut off 1.3 % of the section's inertia, which makes up for it. Elements of second order have
# neither fault.
@pytest.mark.parametrize(
    "part, settings, tolerance",
    [
        (Cantilever, {"size": 1.25}, 0.01),
        (BentPipe, {"size": 2.0}, 0.01),
        (Cantilever, {"size": 1.25, "element": "prism"}, 0.005),
        (Cantilever, {"size": 2.5, "order": 2}, 0.0005),
        (BentPipe, {"size": 3.0, "order": 2}, 0.002),
        (BentPipe, {"size": 5.0, "order": 2, "element": "prism"}, 0.005),
    ],
)
def test_swept_meshes_agree_with_fine_tetrahedra_and_with_theory(
    part, settings, tolerance, reference, document, tmp_path
):
    mine = deflection(part, document, tmp_path, swept(sources=[part.fixed], targets=[part.loaded], **settings))
    print(part.__name__, settings, {"swept": mine, "tetrahedra": reference(part), "theory": part.theory()})
    assert mine == pytest.approx(reference(part), rel=tolerance)
    assert mine == pytest.approx(part.theory(), rel=0.02)


def test_the_error_of_linear_hexahedra_falls_with_the_square_of_their_size(reference, tmp_path):
    errors = []
    for size in (5.0, 2.5):
        other = FreeCAD.newDocument()
        errors.append(1 - deflection(Cantilever, other, tmp_path, swept(size=size)) / reference(Cantilever))
        FreeCAD.closeDocument(other.Name)
    print(errors)
    assert 0 < errors[1] < errors[0] and 3.0 < errors[0] / errors[1] < 5.0


@pytest.mark.parametrize("order", [1, 2])
def test_constraints_reach_every_node_of_their_face(order, document):
    shape = BentPipe.shape(document)
    mesh = app.make_sweep_mesh(shape, size=4.0, order=order).FemMesh
    for number, face in enumerate(shape.Shape.Faces, 1):
        group = next(g for g in mesh.Groups if mesh.getGroupName(g) == f"Face{number}_Nodes")
        assert sorted(mesh.getGroupElements(group)) == sorted(mesh.getNodesByFace(face))
        elements = next(g for g in mesh.Groups if mesh.getGroupName(g) == f"Face{number}")
        assert sorted(mesh.getGroupElements(elements)) == sorted(mesh.getFacesByFace(face))
        assert len(mesh.getVolumesByFace(face)) == len(mesh.getFacesByFace(face))


def test_an_analysis_takes_the_mesh_as_its_own(document, box):
    from femtools.membertools import get_mesh_to_solve

    analysis = make_analysis(box, "Face1", "Face2", FORCE, (0, 0, 1))
    mesh = app.make_sweep_mesh(box, analysis=analysis, size=1.0)
    assert get_mesh_to_solve(analysis) == (mesh, "")


def test_constraints_reach_every_node_of_edges_and_vertices(document):
    shape = BentPipe.shape(document)
    result = app.mesh(shape, size=4.0)
    mesh = app.to_femmesh(result)
    for number, vertex in enumerate(shape.Shape.Vertexes, 1):
        assert list(mesh.getNodesByVertex(vertex)) == nodes_on(result, 0, number)
    for number, edge in enumerate(shape.Shape.Edges, 1):
        ends = {i for i, v in enumerate(shape.Shape.Vertexes, 1) for e in edge.Vertexes if e.isSame(v)}
        own = set(nodes_on(result, 1, number)).union(*(nodes_on(result, 0, end) for end in ends))
        assert set(mesh.getNodesByEdge(edge)) == own


def nodes_on(result, kind, number):
    """Ids of the nodes whose own CAD entity this is (kind 0: vertex, 1: edge)."""
    return [int(i) + 1 for i in np.flatnonzero((result.owner_kind == kind) & (result.owner_number == number))]

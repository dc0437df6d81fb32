"""What reaches FreeCAD's FemMesh: orientation, ids, groups, faces."""
import types

import FreeCAD as App
import numpy as np
import Part
import pytest

from sweepmesh import app
from sweepmesh.app.femmesh import to_femmesh
from sweepmesh.engine.errors import InputError
from sweepmesh.engine.results import EDGE, FACE, VERTEX


def grid_result(n):
    """A cube of n x n x n hexahedra (sides of 1) as the engine would return it; its base and top as faces."""
    axis = np.arange(n + 1.0)
    points = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1).reshape(-1, 3)
    ids = np.arange(len(points)).reshape(n + 1, n + 1, n + 1)
    base = [ids[:-1, :-1], ids[1:, :-1], ids[1:, 1:], ids[:-1, 1:]]
    hexes = np.stack([b[..., :-1] for b in base] + [b[..., 1:] for b in base], -1).reshape(-1, 8)
    bottom = np.stack([b[..., 0] for b in base][::-1], -1).reshape(-1, 4)
    top = np.stack([b[..., -1] for b in base], -1).reshape(-1, 4)
    quads = np.concatenate([bottom, top])
    return types.SimpleNamespace(
        points=points,
        hexahedra=hexes.astype(np.int32),
        prisms=np.zeros((0, 6), np.int32),
        n_polyhedra=0,
        boundary_offsets=np.arange(0, quads.size + 1, 4),
        boundary_nodes=quads.ravel(),
        boundary_faces=np.repeat([5, 6], n * n),
    )


def prism_result():
    """A cube cut into two prisms, with its triangles and quads as the faces 1 and 2."""
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float)
    return types.SimpleNamespace(
        points=points,
        hexahedra=np.zeros((0, 8), np.int32),
        prisms=np.array([[0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7]], np.int32),
        n_polyhedra=0,
        boundary_offsets=np.array([0, 3, 6, 10]),
        boundary_nodes=np.array([0, 2, 1, 0, 3, 2, 0, 1, 5, 4]),
        boundary_faces=np.array([1, 1, 2]),
    )


def first_face_normal_points_out(mesh, element, ring):
    nodes = [mesh.getNodeById(n) for n in mesh.getElementNodes(element)]
    normal = (nodes[1] - nodes[0]).cross(nodes[2] - nodes[0])
    return normal.dot(nodes[ring] - nodes[0]) < 0


def group(mesh, name):
    return next(g for g in mesh.Groups if mesh.getGroupName(g) == name)


def test_hexahedra_are_oriented_as_freecad_wants_them():
    mesh = to_femmesh(grid_result(3))
    assert mesh.HexaCount == 27 and all(first_face_normal_points_out(mesh, e, 4) for e in mesh.Volumes)


def test_prisms_are_oriented_as_freecad_wants_them():
    mesh = to_femmesh(prism_result())
    assert mesh.PrismCount == 2 and all(first_face_normal_points_out(mesh, e, 3) for e in mesh.Volumes)


@pytest.mark.parametrize("element, corners", [("hex", 8), ("prism", 6)])
def test_mid_side_nodes_are_at_the_middle_of_their_sides(element, corners):
    sides = {8: [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]}
    sides[6] = [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)]
    mesh = to_femmesh(app.mesh(Part.makeBox(3, 2, 2), size=1.0, element=element, order=2))
    for volume in mesh.Volumes:
        nodes = [mesh.getNodeById(n) for n in mesh.getElementNodes(volume)]
        assert len(nodes) == corners + len(sides[corners])
        for middle, (a, b) in zip(nodes[corners:], sides[corners]):
            assert middle.distanceToPoint((nodes[a] + nodes[b]) / 2) < 1e-9


def test_coordinates_are_exact():
    result = grid_result(2)
    result.points = result.points * (1.0 / 3.0) + 0.1
    mesh = to_femmesh(result)
    assert all(tuple(mesh.getNodeById(i + 1)) == tuple(p) for i, p in enumerate(result.points))


def test_ids_run_without_a_gap():
    mesh = to_femmesh(grid_result(3))
    assert sorted(mesh.Nodes) == list(range(1, 65))
    assert sorted(mesh.Volumes) + sorted(mesh.Faces) == list(range(1, 27 + 18 + 1))


def test_every_face_has_its_groups():
    mesh = to_femmesh(grid_result(3))
    assert mesh.getGroupElementType(group(mesh, "Face6")) == "Face"
    assert list(mesh.getGroupElements(group(mesh, "Solid"))) == list(range(1, 28))
    top = mesh.getGroupElements(group(mesh, "Face6_Nodes"))
    assert len(top) == 16 and all(mesh.getNodeById(n).z == 3 for n in top)
    corners = {n for e in mesh.getGroupElements(group(mesh, "Face6")) for n in mesh.getElementNodes(e)}
    assert corners == set(top)


def test_triangles_and_quads_of_one_boundary():
    mesh = to_femmesh(prism_result())
    assert (mesh.TriangleCount, mesh.QuadrangleCount) == (2, 1)


def test_polygons_are_refused_with_their_face():
    result = grid_result(1)
    result.boundary_faces = np.array([3])
    result.boundary_offsets = np.array([0, 5])
    with pytest.raises(InputError, match="Face3") as caught:
        to_femmesh(result)
    assert caught.value.entities == ["Face3"]


def test_polyhedra_are_refused_with_a_way_out():
    result = app.mesh(Part.makeCylinder(2, 3), size=1.0, element="polyhedron")
    assert result.n_polyhedra > 0
    with pytest.raises(InputError, match="no polyhedra.*hexahedra or prisms"):
        to_femmesh(result)


def test_no_file_is_left_behind(tmp_path, monkeypatch):
    monkeypatch.setattr("os.access", lambda *_: False)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    assert to_femmesh(grid_result(2)).HexaCount == 8
    assert not list(tmp_path.iterdir())


def owned(result, kind, number):
    """Ids of the nodes of which the engine says that they lie there."""
    return set(np.flatnonzero((result.owner_kind == kind) & (result.owner_number == number)) + 1)


def number_of(elements, element):
    return next(i for i, each in enumerate(elements, 1) if each.isSame(element))


@pytest.mark.parametrize("order", [1, 2])
def test_freecad_finds_on_each_face_and_edge_exactly_the_nodes_that_lie_there(order):
    pipe = Part.makeTorus(30, 10, App.Vector(), App.Vector(0, 0, 1), 0, 360, 90).cut(Part.makeTorus(30, 6))
    shape = pipe.Solids[0]
    result = app.mesh(shape, size=4.0, order=order)
    mesh = to_femmesh(result)
    for number, edge in enumerate(shape.Edges, 1):
        found = set(mesh.getNodesByEdge(edge))
        ends = [owned(result, VERTEX, number_of(shape.Vertexes, vertex)) for vertex in edge.Vertexes]
        assert found >= owned(result, EDGE, number).union(*ends), f"Edge{number}"
        assert len(found) == order * result.intervals[f"Edge{number}"] + (0 if edge.isClosed() else 1), f"Edge{number}"
    for number, face in enumerate(shape.Faces, 1):
        group = next(g for g in mesh.Groups if mesh.getGroupName(g) == f"Face{number}_Nodes")
        found = set(mesh.getNodesByFace(face))
        assert found == set(mesh.getGroupElements(group)), f"Face{number}"
        assert found >= owned(result, FACE, number), f"Face{number}"

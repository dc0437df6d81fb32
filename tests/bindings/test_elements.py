"""Hexahedra and prisms of first and second order: valid meshes, and the same mesh in every file format."""

import subprocess

import Fem
import numpy
import Part
import pytest
from checker import expect_valid_sweep
from FreeCAD import Vector

import sweepmesh
from sweepmesh import Model, Options
from sweepmesh.engine.writers import inp

LENGTH, YOUNG, PRESSURE = 40.0, 210000.0, 100.0
KINDS = [("hex", 1), ("hex", 2), ("prism", 1), ("prism", 2)]
NAMES = {("hex", 1): "C3D8", ("hex", 2): "C3D20", ("prism", 1): "C3D6", ("prism", 2): "C3D15"}


def _ring(radius):
    """A disc in the plane y = 0, 40 from the z axis."""
    return Part.Face(Part.Wire(Part.makeCircle(radius, Vector(40, 0, 0), Vector(0, 1, 0))))


SOLIDS = {
    "brick": lambda: Part.makeBox(LENGTH, 10, 10),
    "drilled brick": lambda: Part.makeBox(LENGTH, 20, 20).cut(
        Part.makeCylinder(5, LENGTH, Vector(0, 10, 10), Vector(1, 0, 0))
    ),
    "bent pipe": lambda: _ring(10).cut(_ring(6)).revolve(Vector(), Vector(0, 0, 1), 90).Solids[0],
}
GENUS = {"brick": [0], "drilled brick": [1], "bent pipe": [1]}


def mesh_of(solid, element, order, size=4.0):
    """Model and mesh of one of the SOLIDS, the brick swept along x."""
    model = Model.from_brep(SOLIDS[solid]().exportBrepToString(), 0)
    picks = {"sources": [2], "targets": [1]} if solid == "brick" else {}
    return model, sweepmesh.mesh(model, Options(size=size, element=element, order=order, **picks))


@pytest.mark.parametrize("element, order", KINDS)
@pytest.mark.parametrize("solid", SOLIDS)
def test_every_kind_of_element_makes_a_valid_mesh(solid, element, order):
    model, result = mesh_of(solid, element, order)
    expect_valid_sweep(result, model, GENUS[solid])
    widths = {("hex", 1): 8, ("hex", 2): 20, ("prism", 1): 6, ("prism", 2): 15}
    elements = result.hexahedra if element == "hex" else result.prisms
    assert elements.shape[1] == widths[element, order] and len(elements) == result.n_elements


@pytest.mark.parametrize("element", ["hex", "prism"])
def test_mid_side_nodes_lie_between_their_corners(element):
    _, result = mesh_of("brick", element, 2)
    elements = result.hexahedra if element == "hex" else result.prisms
    ring = 4 if element == "hex" else 3
    first, second = range(ring), range(ring, 2 * ring)
    sides = [(i, (i + 1) % ring) for i in first]
    sides += [(ring + a, ring + b) for a, b in sides] + list(zip(first, second))
    for column, (a, b) in enumerate(sides, 2 * ring):
        middles = (result.points[elements[:, a]] + result.points[elements[:, b]]) / 2
        assert numpy.allclose(result.points[elements[:, column]], middles, atol=1e-9)


def test_mid_side_nodes_lie_on_curved_faces():
    model, result = mesh_of("bent pipe", "hex", 2)
    radius = numpy.hypot(numpy.hypot(result.points[:, 0], result.points[:, 1]) - 40, result.points[:, 2])
    on_walls = result.boundary_nodes[
        numpy.repeat(~numpy.isin(result.boundary_faces, caps_of(result)), numpy.diff(result.boundary_offsets))
    ]
    assert numpy.minimum(abs(radius[on_walls] - 10), abs(radius[on_walls] - 6)).max() < 1e-6


def caps_of(result):
    """Numbers of the sources and targets."""
    return [int(face[4:]) for face, role in result.assessment.roles.items() if role in ("source", "target")]


@pytest.mark.parametrize("element, order", KINDS)
@pytest.mark.parametrize("solid", SOLIDS)
def test_the_boundary_has_a_side_of_an_element_each(solid, element, order):
    _, result = mesh_of(solid, element, order)
    elements, sides = inp.boundary_sides(result)
    nodes = result.hexahedra if element == "hex" else result.prisms
    for polygon, (number, side) in enumerate(zip(elements, sides)):
        start, size = result.boundary_offsets[polygon], result.boundary_sizes()[polygon]
        corners = set(result.boundary_nodes[start : start + size])
        table = inp.numbering.HEXAHEDRON_SIDES if element == "hex" else inp.numbering.PRISM_SIDES
        assert {nodes[number - 1, i] for i in table[side - 1]} == corners


@pytest.mark.parametrize("element, order", KINDS)
def test_calculix_pulls_a_bar_as_long_as_hooke_says(tmp_path, element, order):
    """Wrong node orders or sides give a negative Jacobian, or a load on another side."""
    model, result = mesh_of("brick", element, order, size=5.0)
    sweepmesh.write(result, tmp_path / "bar.inp")
    assert f"TYPE={NAMES[element, order]}," in (tmp_path / "bar.inp").read_text()
    (tmp_path / "job.inp").write_text(
        "*INCLUDE, INPUT=bar.inp\n*MATERIAL, NAME=M\n*ELASTIC\n"
        f"{YOUNG}, 0\n*SOLID SECTION, ELSET=Solid, MATERIAL=M\n*BOUNDARY\nNodes_Face1, 1, 3\n"
        f"*STEP\n*STATIC\n*DSLOAD\nFace2, P, {-PRESSURE}\n*NODE PRINT, NSET=Nodes_Face2\nU\n*END STEP\n"
    )
    subprocess.run(["ccx", "job"], cwd=tmp_path, check=True, stdout=subprocess.DEVNULL)
    rows = [line.split() for line in (tmp_path / "job.dat").read_text().splitlines() if len(line.split()) == 4]
    stretched = [float(row[1]) for row in rows if row[0].isdigit()]
    assert len(stretched) > 4
    assert stretched == pytest.approx([PRESSURE * LENGTH / YOUNG] * len(stretched), rel=1e-5)


@pytest.mark.parametrize("suffix", [".vtu", ".inp", ".unv", ".med"])
@pytest.mark.parametrize("element, order", KINDS)
def test_files_read_back_have_the_same_mesh(tmp_path, element, order, suffix):
    _, result = mesh_of("drilled brick", element, order)
    path = tmp_path / f"mesh{suffix}"
    sweepmesh.write(result, path)
    again = Fem.read(str(path))
    assert (again.NodeCount, again.VolumeCount) == (len(result.points), result.n_elements)
    assert (again.HexaCount, again.PrismCount) == (len(result.hexahedra), len(result.prisms))
    nodes = numpy.array([tuple(node) for _, node in sorted(again.Nodes.items())])
    assert numpy.allclose(nodes, result.points, atol=1e-9)


def test_a_vtu_file_is_exact(tmp_path):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    _, result = mesh_of("bent pipe", "hex", 1)
    sweepmesh.write(result, tmp_path / "mesh.vtu")
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(tmp_path / "mesh.vtu"))
    reader.Update()
    grid = reader.GetOutput()
    assert numpy.array_equal(vtk_to_numpy(grid.GetPoints().GetData()), result.points)
    assert numpy.array_equal(vtk_to_numpy(grid.GetCells().GetConnectivityArray()), result.hexahedra.ravel())
    assert numpy.array_equal(vtk_to_numpy(grid.GetPointData().GetArray("OwnerNumber")), result.owner_number)
    assert numpy.array_equal(vtk_to_numpy(grid.GetCellData().GetArray("ScaledJacobian")), result.scaled_jacobians)


@pytest.mark.parametrize("suffix", [".vtu", ".inp", ".unv"])
def test_a_failed_write_leaves_nothing(tmp_path, suffix, monkeypatch):
    _, result = mesh_of("brick", "hex", 1)
    result.points = None  # any writer fails on this
    with pytest.raises(Exception):
        sweepmesh.write(result, tmp_path / f"mesh{suffix}")
    assert list(tmp_path.iterdir()) == []

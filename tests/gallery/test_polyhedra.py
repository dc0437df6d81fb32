"""Polyhedral prisms: every kind of sweep, closed, valid and of the solid's volume, and as VTK reads them."""

import numpy
import pytest
import touching
from checker import expect_valid_sweep, mesh_volume
from gallery import cases
from test_shells import CLOSED, OPEN, caps
from touching import expect_one_mesh

from sweepmesh import Options, engine, mesh, read, write
from sweepmesh.freecad import import_freecad

import_freecad()


def meshed(shape, **options):
    """(Model, Result) of a FreeCAD shape in polyhedra."""
    model = engine.Model.from_brep(shape.exportBrepToString(), 0)
    return model, mesh(model, Options(element="polyhedron", **options))


FREE = [case for case in cases("1-1", "M-1", "M-N", "submap", "radial") if case.scheme < 0]
"""Every solid of the gallery that can be swept, once."""


@pytest.mark.parametrize("case", FREE, ids=lambda case: case.label)
def test_every_sweep_can_be_polyhedral(case):
    model = read(case.path)
    result = mesh(model, Options(size=1.3 * case.size, element="polyhedron"))
    assert result.assessment.is_sweepable, [reason.text for reason in result.assessment.reasons]
    expect_valid_sweep(result, model, case.genus)
    assert not len(result.prisms) or result.n_polyhedra > 0
    assert len(result.scaled_jacobians) == result.n_elements


@pytest.mark.parametrize("name", [*CLOSED, *OPEN])
def test_walls_and_shells(name):
    outer, inner, _ = {**CLOSED, **OPEN}[name]
    shape = outer.cut(inner)
    sources, targets = caps(shape, outer, inner)
    model, result = meshed(shape, size=4, sources=sources, targets=targets)
    assert result.assessment.is_sweepable, [reason.text for reason in result.assessment.reasons]
    expect_valid_sweep(result, model)


@pytest.mark.parametrize("name", ["L cut across", "rod in three", "rod on a block", "boxes on both sides"])
def test_touching_solids_have_one_mesh(name):
    shape = {**touching.STACKS, **touching.MIXED}[name]()
    model, result = meshed(shape, size=(shape.Volume / 600) ** (1 / 3))
    assert result.n_polyhedra > 0
    expect_one_mesh(result, model, shape)


def vtk_grid(path):
    """The file as VTK reads it."""
    import vtk

    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def nodes_of(cell):
    """As plain numbers: VTK hands out one object for all faces of a cell."""
    return [cell.GetPointId(n) for n in range(cell.GetNumberOfPoints())]


def faces_in_vtk(grid):
    """The faces of each cell as VTK knows them: [[nodes, ...], ...]."""
    cells = (grid.GetCell(i) for i in range(grid.GetNumberOfCells()))
    return [[nodes_of(cell.GetFace(f)) for f in range(cell.GetNumberOfFaces())] for cell in cells]


def volumes_by_vtk(grid):
    """Of each cell, by VTK's own measure."""
    import vtk

    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    array = sizes.GetOutput().GetCellData().GetArray("Volume")
    return [array.GetValue(i) for i in range(array.GetNumberOfTuples())]


def volume_within(points, faces):
    """By the divergence theorem: with the faces' own order of nodes, so that a face turned inwards is seen."""
    six = 0.0
    for face in faces:
        a = points[face]
        middle = a.mean(axis=0)
        six += (numpy.cross(a, numpy.roll(a, -1, axis=0)) @ middle).sum()
    return six / 6


@pytest.mark.parametrize("kind", ["1-1", "M-N"])
def test_vtk_reads_closed_cells_of_the_solids_volume(kind, tmp_path):
    case = cases(kind)[0]
    model = read(case.path)
    result = mesh(model, Options(size=1.5 * case.size, element="polyhedron"))
    write(result, tmp_path / "mesh.vtu")
    grid = vtk_grid(tmp_path / "mesh.vtu")
    assert grid.GetNumberOfCells() == result.n_elements
    types = numpy.array([grid.GetCellType(i) for i in range(grid.GetNumberOfCells())])
    assert (types == 42).sum() == result.n_polyhedra > 0
    points = result.points - result.points.mean(axis=0)
    uses, total = {}, 0.0
    for faces in faces_in_vtk(grid):
        sides = [side for face in faces for side in zip(face, face[1:] + face[:1])]
        assert sorted(sides) == sorted((b, a) for a, b in sides), "a cell is not closed"
        volume = volume_within(points, faces)
        assert volume > 0
        total += volume
        for face in faces:
            uses[frozenset(face)] = uses.get(frozenset(face), 0) + 1
    assert set(uses.values()) == {1, 2}
    assert sum(count == 1 for count in uses.values()) == len(result.boundary_faces)
    assert total == pytest.approx(mesh_volume(result), rel=1e-9)
    volumes = volumes_by_vtk(grid)  # which takes tetrahedra where sides are not plane
    assert min(volumes) > 0 and sum(volumes) == pytest.approx(mesh_volume(result), rel=0.01)
    scaled = grid.GetCellData().GetArray("ScaledJacobian")
    assert [scaled.GetValue(i) for i in range(len(types))] == result.scaled_jacobians.tolist()
    expect_valid_sweep(result, model, case.genus)

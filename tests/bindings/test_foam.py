"""OpenFOAM's polyMesh, read back from its files: order, orientation, closed cells, patches."""

import re

import FreeCAD
import numpy
import Part
import pytest

from sweepmesh import Options, SweepMeshError, engine, mesh, write


def stepped():
    """A block with a step and a hole: two levels, several faces."""
    block = Part.makeBox(30, 20, 8).fuse(Part.makeBox(12, 20, 6, FreeCAD.Vector(0, 0, 8))).removeSplitter()
    return block.cut(Part.makeCylinder(3, 8, FreeCAD.Vector(21, 10, 0)))


def touching():
    """Two boxes with a common face."""
    boxes = [Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, FreeCAD.Vector(10, 0, 0))]
    return Part.Compound(boxes[0].generalFuse(boxes[1:])[0].Solids)


def read_list(path):
    """The text of each item of a list file, and its header."""
    text = path.read_text()
    header, body = text.split("}\n", 1)
    count, items = re.fullmatch(r"\s*(\d+)\n\(\n(.*)\)\n", body, re.DOTALL).groups()
    return header, int(count), items


def read_case(folder):
    """points, faces, owner, neighbour, patches {name: (start, count)} of a polyMesh."""
    header, n_points, items = read_list(folder / "points")
    assert "class vectorField;" in header
    points = numpy.array([line[1:-1].split() for line in items.splitlines()], float)
    header, n_faces, items = read_list(folder / "faces")
    assert "class faceList;" in header
    faces = []
    for line in items.splitlines():
        size, nodes = re.fullmatch(r"(\d+)\((.*)\)", line).groups()
        faces.append([int(n) for n in nodes.split()])
        assert len(faces[-1]) == int(size)
    labels = []
    for name in ("owner", "neighbour"):
        header, n, items = read_list(folder / name)
        assert "class labelList;" in header and f"nPoints: {n_points}" in header
        labels.append(numpy.array(items.split(), int))
        assert len(labels[-1]) == n
    _, n_patches, items = read_list(folder / "boundary")
    form = r"(\w+)\s*\{\s*type patch;\s*nFaces (\d+);\s*startFace (\d+);\s*\}"
    patches = {name: (int(start), int(count)) for name, count, start in re.findall(form, items)}
    assert (len(points), len(faces), len(patches)) == (n_points, n_faces, n_patches)
    return points, faces, *labels, patches


def area_vector(points, face):
    p = points[face] - points[face[0]]
    return 0.5 * numpy.cross(p, numpy.roll(p, -1, axis=0)).sum(axis=0)


@pytest.fixture(params=["hex", "prism", "polyhedron"])
def element(request):
    return request.param


@pytest.mark.parametrize("shape", [stepped, touching])
def test_the_files_hold_a_mesh_as_openfoam_wants_it(shape, element, tmp_path):
    solid = shape()
    model = engine.Model.from_brep(solid.exportBrepToString(), 0)
    result = mesh(model, Options(size=3, element=element))
    assert (result.n_polyhedra > 0) == (element == "polyhedron")
    write(result, tmp_path / "part.foam")
    points, faces, owner, neighbour, patches = read_case(tmp_path / "constant" / "polyMesh")
    n_cells, n_inside = result.n_elements, len(neighbour)
    assert numpy.array_equal(points, result.points) and len(owner) == len(faces)
    assert owner.min() == 0 and max(owner.max(), neighbour.max()) == n_cells - 1
    # Upper triangular order.
    assert (owner[:n_inside] < neighbour).all()
    pairs = owner[:n_inside] * n_cells + neighbour
    assert (numpy.diff(pairs) > 0).all(), "faces inside are not in order, or two cells share two"
    # Patches follow one another and are the CAD faces.
    assert sorted(patches.values()) == list(patches.values())
    end = n_inside
    for name, (start, count) in patches.items():
        assert start == end and (numpy.diff(owner[start : start + count]) >= 0).all()
        end += count
        face = solid.Faces[int(name[4:]) - 1]
        for row in faces[start : start + count : 7]:
            middle = Part.Vertex(FreeCAD.Vector(*points[row].mean(axis=0)))
            assert face.distToShape(middle)[0] < 0.5
    assert end == len(faces)
    uses = [face.hashCode() for part in solid.Solids for face in part.Faces]
    outer = {i for i, face in enumerate(solid.Faces, 1) if uses.count(face.hashCode()) == 1}
    assert {int(name[4:]) for name in patches} == outer
    # Faces look out of their owner, and those of each cell close it.
    areas = numpy.array([area_vector(points, face) for face in faces])
    middles = numpy.array([points[face].mean(axis=0) for face in faces])
    out, volumes = numpy.zeros((n_cells, 3)), numpy.zeros(n_cells)
    for cells, sign in ((owner, 1.0), (neighbour, -1.0)):
        n = len(cells)
        numpy.add.at(out, cells, sign * areas[:n])
        numpy.add.at(volumes, cells, sign * (areas[:n] * middles[:n]).sum(axis=1) / 3)
    assert abs(out).max() < 1e-9 * abs(areas).max()
    assert volumes.min() > 0
    assert volumes.sum() == pytest.approx(solid.Volume, rel=0.02)


def test_a_second_mesh_takes_the_place_of_the_first(tmp_path):
    shape = Part.makeBox(10, 10, 10).exportBrepToString()
    for size in (2, 5):
        write(mesh(shape, Options(size=size)), tmp_path / "box.foam")
    points, *_ = read_case(tmp_path / "constant" / "polyMesh")
    assert len(points) == 27
    assert sorted(path.name for path in tmp_path.iterdir()) == ["box.foam", "constant"]
    assert sorted(path.name for path in (tmp_path / "constant").iterdir()) == ["polyMesh"]


def test_mid_side_nodes_are_refused(tmp_path):
    result = mesh(Part.makeBox(10, 10, 10).exportBrepToString(), Options(size=5, order=2))
    with pytest.raises(SweepMeshError, match="no mid-side nodes"):
        write(result, tmp_path / "box.foam")
    assert list(tmp_path.iterdir()) == []

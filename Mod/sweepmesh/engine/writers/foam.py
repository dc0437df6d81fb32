"""OpenFOAM's polyMesh: points, and faces between cells, with one patch for each CAD face.

Faces between two cells come first, in upper triangular order: by the lower cell (the owner), then by the higher
one (the neighbour). Then those of each patch, by their cell. The nodes of a face are counterclockwise seen from
outside its owner.
"""

import dataclasses

import numpy

from sweepmesh.engine import numbering


@dataclasses.dataclass
class PolyMesh:
    """The faces of a mesh and what lies on their two sides."""

    nodes: numpy.ndarray
    """(n, w): the nodes of each face, -1 behind those with fewer than the others."""
    owner: numpy.ndarray
    """Per face: the cell that it looks out of; cells count hexahedra, prisms, polyhedra."""
    neighbour: numpy.ndarray
    """Of the first faces, those inside: the cell on the other side."""
    patches: list
    """[(number of the CAD face, its first face, how many)]; they follow the faces inside."""


def write_result(folder, result):
    """Writes the files points, faces, owner, neighbour and boundary of a Result into an existing folder."""
    mesh = poly_mesh(result)
    n_faces, n_inside = len(mesh.owner), len(mesh.neighbour)
    note = f"nPoints: {len(result.points)} nCells: {result.n_elements} nFaces: {n_faces} nInternalFaces: {n_inside}"
    _write(folder, "points", "vectorField", "(%.17g %.17g %.17g)\n", [result.points])
    _write(folder, "owner", "labelList", "%d\n", [mesh.owner[:, None]], note)
    _write(folder, "neighbour", "labelList", "%d\n", [mesh.neighbour[:, None]], note)
    _write_faces(folder, mesh)
    with _file(folder, "boundary", "polyBoundaryMesh") as file:
        file.write(f"{len(mesh.patches)}\n(\n")
        for number, start, count in mesh.patches:
            file.write(f"Face{number}\n{{\n    type patch;\n    nFaces {count};\n    startFace {start};\n}}\n")
        file.write(")\n")


def poly_mesh(result):
    """The PolyMesh of a Result of first order."""
    nodes, cells = _faces_of_elements(result)
    _, same = numpy.unique(numpy.sort(nodes, axis=1), axis=0, return_inverse=True)
    order = numpy.argsort(same.ravel(), kind="stable")  # of two that are the same, that of the lower cell first
    is_first = numpy.diff(same.ravel()[order], prepend=-1) > 0
    is_pair = numpy.append(~is_first[1:], False) & is_first
    inner, other = order[is_pair], order[1:][is_pair[:-1]]
    upper = numpy.lexsort((cells[other], cells[inner]))
    inner, neighbour = inner[upper], cells[other][upper]
    outer = order[is_first & ~is_pair]
    patch = _cad_faces(result, nodes[outer])
    outer_order = numpy.lexsort((cells[outer], patch))
    outer, patch = outer[outer_order], patch[outer_order]
    numbers, starts, counts = numpy.unique(patch, return_index=True, return_counts=True)
    faces = numpy.concatenate([inner, outer])
    patches = list(zip(numbers.tolist(), (starts + len(inner)).tolist(), counts.tolist()))
    return PolyMesh(nodes[faces], cells[faces], neighbour, patches)


def _kinds(result):
    """[(nodes of the elements of one kind, their faces seen from outside, their cells)]."""
    kinds, first = [], 0
    for nodes, faces in (
        (result.hexahedra, numbering.polyhedron_faces(4)),
        (result.prisms, numbering.polyhedron_faces(3)),
    ):
        kinds.append((nodes, faces, first + numpy.arange(len(nodes))))
        first += len(nodes)
    for its, nodes in result.polyhedra_by_corners():
        kinds.append((nodes, numbering.polyhedron_faces(nodes.shape[1] // 2), first + its))
    return kinds


def _faces_of_elements(result):
    """(nodes, cell) of every face of every element, cell by cell; -1 behind faces with few nodes."""
    kinds = _kinds(result)
    width = max(len(face) for _, faces, _ in kinds for face in faces)
    rows, cells = [], []
    for nodes, faces, its in kinds:
        for face in faces:
            padded = numpy.full((len(nodes), width), -1)
            padded[:, : len(face)] = nodes[:, list(face)]
            rows.append(padded)
            cells.append(its)
    rows, cells = numpy.concatenate(rows), numpy.concatenate(cells)
    order = numpy.argsort(cells, kind="stable")
    return rows[order], cells[order]


def _cad_faces(result, polygons):
    """The number of the CAD face of each polygon, all of them on the boundary."""
    given = numpy.full((len(result.boundary_faces), polygons.shape[1]), -1)
    sizes = numpy.diff(result.boundary_offsets)
    for column in range(polygons.shape[1]):
        has = sizes > column
        given[has, column] = result.boundary_nodes[result.boundary_offsets[:-1][has] + column]
    both = numpy.sort(numpy.concatenate([given, polygons]), axis=1)
    _, same = numpy.unique(both, axis=0, return_inverse=True)
    face_of = numpy.zeros(same.max() + 1, int)
    face_of[same.ravel()[: len(given)]] = result.boundary_faces
    return face_of[same.ravel()[len(given) :]]


def _file(folder, name, kind, note=""):
    file = open(folder / name, "w", encoding="ascii")
    lines = ["version 2.0;", "format ascii;", f"class {kind};", *([f'note "{note}";'] if note else [])]
    lines += ['location "constant/polyMesh";', f"object {name};"]
    file.write("FoamFile\n{\n" + "".join(f"    {line}\n" for line in lines) + "}\n\n")
    return file


def _write(folder, name, kind, form, blocks, note=""):
    """A list of rows, block after block."""
    with _file(folder, name, kind, note) as file:
        file.write(f"{sum(map(len, blocks))}\n(\n")
        for rows in blocks:
            file.writelines(form % tuple(row) for row in rows.tolist())
        file.write(")\n")


def _write_faces(folder, mesh):
    sizes = (mesh.nodes >= 0).sum(axis=1)
    forms = {size: f"{size}(" + " ".join(["%d"] * size) + ")\n" for size in numpy.unique(sizes).tolist()}
    with _file(folder, "faces", "faceList") as file:
        file.write(f"{len(sizes)}\n(\n")
        for row, size in zip(mesh.nodes.tolist(), sizes.tolist()):
            file.write(forms[size] % tuple(row[:size]))
        file.write(")\n")

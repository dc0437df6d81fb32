"""A mesh of the engine as FreeCAD's own `Fem.FemMesh`.

`Fem.FemMesh` has no way to take arrays. Measured for a million hexahedra: adding nodes and elements one by
one 4 s, through a .vtu file in memory 2.5 s (exact, as the file holds float64), .med 5 s, .unv 7 s. So the
mesh goes through a raw .vtu, in memory where the system has such a folder.

FreeCAD wants SMESH's node order, in which the first face's normal points out of the element: the mirror image
of VTK's. Its reader takes a file's order as it stands, so the order is changed here.
"""
import os
import tempfile

import Fem
import numpy as np

from sweepmesh.engine.errors import input_error
from sweepmesh.engine.numbering import TO_SMESH, VTK_TYPES
from sweepmesh.engine.writers.vtu import write_vtu

_FACE_TYPES = {3: 5, 4: 9, 6: 22, 8: 23}  # nodes per element -> VTK's number of the kind


def to_femmesh(result):
    """Return the mesh of an engine's `Result` as a `Fem.FemMesh`.

    Element ids run from 1 without a gap: hexahedra, prisms, then the boundary faces (those of Face1 first).
    Groups: `Solid` (all volumes), and for every CAD face that has elements `Face7` (its face elements) and
    `Face7_Nodes` (its nodes, those on its edges included). Node ids are the engine's indices plus 1.

    Raises InputError for polyhedra and for boundary polygons, which FreeCAD has no elements for.
    """
    if result.n_polyhedra:
        refuse_polyhedra()
    volumes = _volume_blocks(result)
    faces, face_numbers = _face_blocks(result)
    mesh = _through_file(result.points, volumes + faces)
    n_volumes = sum(len(cells) for _, cells in volumes)
    _add_groups(mesh, n_volumes, faces, face_numbers)
    return mesh


def refuse_polyhedra():
    """Raises the InputError that says where polyhedra can go instead."""
    raise input_error(
        "FreeCAD's FEM meshes hold no polyhedra: choose hexahedra or prisms, or write a .vtu or .foam file from the command line.",
        "write",
    )


def _volume_blocks(result):
    blocks = []
    for elements in (result.hexahedra, result.prisms):
        if len(elements):
            n_nodes = elements.shape[1]
            blocks.append((VTK_TYPES[n_nodes], elements[:, TO_SMESH[n_nodes]]))
    return blocks


def _face_blocks(result):
    """Boundary faces as blocks of one type and one CAD face each, and the CAD face of each block."""
    starts = np.asarray(result.boundary_offsets[:-1])
    sizes = np.diff(result.boundary_offsets)
    numbers = np.asarray(result.boundary_faces)
    blocks, block_numbers = [], []
    for number in np.unique(numbers):
        for size in np.unique(sizes[numbers == number]):
            if size not in _FACE_TYPES:
                sentence = f"FreeCAD's FEM meshes have no face element of {size} nodes, as there is on Face{number}."
                raise input_error(sentence, "write", [f"Face{number}"])
            rows = starts[(numbers == number) & (sizes == size)]
            nodes = np.asarray(result.boundary_nodes)[rows[:, None] + np.arange(size)]
            blocks.append((_FACE_TYPES[size], nodes))
            block_numbers.append(int(number))
    return blocks, block_numbers


def _through_file(points, blocks):
    folder = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    handle, path = tempfile.mkstemp(suffix=".vtu", prefix="sweepmesh_", dir=folder)
    os.close(handle)
    try:
        write_vtu(path, points, blocks)
        return Fem.read(path)
    finally:
        os.remove(path)


def _add_groups(mesh, n_volumes, faces, face_numbers):
    _add_group(mesh, "Solid", "Volume", range(1, n_volumes + 1))
    ids, nodes = {}, {}
    first = n_volumes + 1
    for number, (_, cells) in zip(face_numbers, faces):
        ids.setdefault(number, []).extend(range(first, first + len(cells)))
        nodes.setdefault(number, []).append(cells.ravel())
        first += len(cells)
    for number in ids:
        _add_group(mesh, f"Face{number}", "Face", ids[number])
        on_face = np.unique(np.concatenate(nodes[number])) + 1
        _add_group(mesh, f"Face{number}_Nodes", "Node", on_face.tolist())


def _add_group(mesh, name, kind, ids):
    mesh.addGroupElements(mesh.addGroup(name, kind), list(ids))

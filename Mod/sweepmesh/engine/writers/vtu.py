"""VTK's XML format for unstructured grids, all numbers exact (raw appended binary, float64)."""

import numpy

from sweepmesh.engine import numbering


def write_result(path, result, point_data=None):
    """Writes the volume elements of a Result, and `point_data` {name: array with a row a node} with them.

    Points carry `OwnerKind` (0 vertex, 1 edge, 2 face, 3 inside) and `OwnerNumber`, from 1 as in FreeCAD;
    cells carry `ScaledJacobian`.
    """
    blocks = [
        (numbering.VTK_TYPES[nodes.shape[1]], nodes[:, numbering.TO_VTK[nodes.shape[1]]])
        for nodes in (result.hexahedra, result.prisms)
    ]
    write_vtu(
        path,
        result.points,
        blocks,
        polyhedra=result,
        point_data={"OwnerKind": result.owner_kind, "OwnerNumber": result.owner_number, **(point_data or {})},
        cell_data={"ScaledJacobian": result.scaled_jacobians},
    )


def write_vtu(path, points, blocks, point_data=None, cell_data=None, polyhedra=None):
    """Writes points (n, 3), blocks of cells [(VTK's cell type, (m, k) node indices), ...] and a Result's polyhedra.

    `point_data` and `cell_data` are {name: array with a row each}; cells count through the blocks in order, then
    come the polyhedra, with the nodes of each of their faces. Exact, uncompressed; about 41 bytes an element and 24 a
    point, 480 a hexagonal prism.
    """
    blocks = [(kind, nodes) for kind, nodes in blocks if len(nodes)]
    sizes = numpy.concatenate([numpy.full(len(nodes), nodes.shape[1]) for _, nodes in blocks] or [[]])
    kinds = numpy.concatenate([numpy.full(len(nodes), kind) for kind, nodes in blocks] or [[]])
    connectivity = numpy.concatenate([numpy.ravel(nodes) for _, nodes in blocks] or [[]])
    faces = {}
    if polyhedra is not None and polyhedra.n_polyhedra:
        connectivity = numpy.concatenate([connectivity, polyhedra.polyhedron_nodes])
        streams, ends = _face_streams(polyhedra)
        faces = {"faces": streams, "faceoffsets": numpy.concatenate([numpy.full(len(sizes), -1), ends])}
        sizes = numpy.concatenate([sizes, numpy.diff(polyhedra.polyhedron_offsets)])
        kinds = numpy.concatenate([kinds, numpy.full(len(ends), numbering.VTK_POLYHEDRON)])
    sections = {
        "PointData": dict(point_data or {}),
        "CellData": dict(cell_data or {}),
        "Points": {"Points": numpy.asarray(points, numpy.float64)},
        "Cells": {
            "connectivity": connectivity.astype(numpy.int32),
            "offsets": numpy.cumsum(sizes).astype(numpy.int64),
            "types": kinds.astype(numpy.uint8),
            **faces,
        },
    }
    with open(path, "wb") as file:
        arrays = _write_header(file, sections, len(points), len(sizes))
        for array in arrays:
            file.write(numpy.uint64(array.nbytes).tobytes())
            file.write(array.data)
        file.write(b"\n</AppendedData>\n</VTKFile>\n")


def _face_streams(polyhedra):
    """VTK's description of polyhedra: of each the number of faces, and each face's number of nodes and nodes.

    Also where the description of each ends.
    """
    corners = numpy.diff(polyhedra.polyhedron_offsets) // 2
    ends = numpy.cumsum(7 * corners + 3)
    stream = numpy.empty(ends[-1], numpy.int64)
    for its, nodes in polyhedra.polyhedra_by_corners():
        n = nodes.shape[1] // 2
        columns = [numpy.full(len(its), n + 2)]
        for face in numbering.polyhedron_faces(n):
            columns += [numpy.full(len(its), len(face)), *nodes[:, list(face)].T]
        stream[(ends[its] - len(columns))[:, None] + numpy.arange(len(columns))] = numpy.stack(columns, axis=1)
    return stream, ends.astype(numpy.int64)


_TYPES = {"f8": "Float64", "f4": "Float32", "i8": "Int64", "i4": "Int32", "i1": "Int8", "u1": "UInt8"}


def _write_header(file, sections, n_points, n_cells):
    """Writes the XML part; returns the arrays that are to follow, in order."""
    arrays, lines, offset = [], [], 0
    for section, content in sections.items():
        lines.append(f"<{section}>")
        for name, values in content.items():
            array = numpy.ascontiguousarray(values)
            kind = _TYPES[array.dtype.str[1:]]
            width = array.shape[1] if array.ndim == 2 else 1
            lines.append(
                f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{width}"'
                f' format="appended" offset="{offset}"/>'
            )
            arrays.append(array)
            offset += 8 + array.nbytes
        lines.append(f"</{section}>")
    file.write(
        (
            '<?xml version="1.0"?>\n'
            '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n'
            f'<UnstructuredGrid>\n<Piece NumberOfPoints="{n_points}" NumberOfCells="{n_cells}">\n'
            + "\n".join(lines)
            + '\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding="raw">\n_'
        ).encode()
    )
    return arrays

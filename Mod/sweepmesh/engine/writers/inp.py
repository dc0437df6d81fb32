"""Abaqus' input format, as CalculiX reads it: the mesh with sets and surfaces, without materials or steps."""

import numpy

from sweepmesh.engine import numbering

LINE_WIDTH = 10
"""Numbers on a line; the format allows 16."""


def write_result(path, result):
    """Writes nodes, elements and for each CAD face a node set `Nodes_Face7` and a surface `Face7`.

    Elements are C3D8, C3D6, or C3D20, C3D15 of second order. Nodes and elements are numbered from 1:
    hexahedra, then prisms. The element set `Solid` has all.
    """
    with open(path, "w", encoding="ascii") as file:
        file.write("** SweepMesh\n*NODE, NSET=Nodes\n")
        _write_rows(file, result.points, "%.16g")
        first = 1
        for nodes in (result.hexahedra, result.prisms):
            if len(nodes):
                file.write(f"*ELEMENT, TYPE={numbering.ABAQUS_TYPES[nodes.shape[1]]}, ELSET=Solid\n")
                _write_rows(file, nodes + 1, "%d", first)
                first += len(nodes)
        _write_faces(file, result)


def _write_rows(file, rows, form, first=1):
    """Each row on a line with its number before it, long ones on several lines."""
    separators = [",\n" if (i + 1) % LINE_WIDTH == 0 else ", " for i in range(rows.shape[1])]
    template = "%d" + "".join(separator + form for separator in separators) + "\n"
    file.writelines(template % (first + i, *row) for i, row in enumerate(rows.tolist()))


def _write_faces(file, result):
    elements, sides = boundary_sides(result)
    face_of_node = numpy.repeat(result.boundary_faces, numpy.diff(result.boundary_offsets))
    for face in numpy.unique(result.boundary_faces):
        nodes = numpy.unique(result.boundary_nodes[face_of_node == face]) + 1
        file.write(f"*NSET, NSET=Nodes_Face{face}\n")
        for start in range(0, len(nodes), LINE_WIDTH):
            file.write(", ".join(map(str, nodes[start : start + LINE_WIDTH])) + "\n")
        file.write(f"*SURFACE, NAME=Face{face}, TYPE=ELEMENT\n")
        its = result.boundary_faces == face
        file.writelines(f"{element}, S{side}\n" for element, side in zip(elements[its], sides[its]))


def boundary_sides(result):
    """For each polygon of the boundary the number of its element and of that element's side, both from 1."""
    on_boundary = numpy.zeros(len(result.points), bool)
    on_boundary[result.boundary_nodes] = True
    keys, elements, sides = [], [], []
    first = 1
    for nodes, table in (
        (result.hexahedra, numbering.HEXAHEDRON_SIDES),
        (result.prisms, numbering.PRISM_SIDES),
    ):
        for side, corners in enumerate(table, 1):
            candidates = numpy.flatnonzero(on_boundary[nodes[:, list(corners)]].all(axis=1))
            keys.append(_keys(nodes[candidates][:, list(corners)]))
            elements.append(first + candidates)
            sides.append(numpy.full(len(candidates), side))
        first += len(nodes)
    keys, elements, sides = numpy.concatenate(keys), numpy.concatenate(elements), numpy.concatenate(sides)
    order = numpy.argsort(keys)
    rows = order[numpy.searchsorted(keys, _keys(_corners(result)), sorter=order)]
    return elements[rows], sides[rows]


def _corners(result):
    """The corners of the boundary's polygons as an (n, 4) array, -1 for a triangle's fourth."""
    starts, sizes = result.boundary_offsets[:-1], result.boundary_sizes()
    corners = result.boundary_nodes[starts[:, None] + numpy.minimum(numpy.arange(4), sizes[:, None] - 1)]
    corners[sizes == 3, 3] = -1
    return corners


def _keys(polygons):
    """One sortable value a polygon of three or four nodes, equal for the same nodes in whatever order."""
    padded = numpy.full((len(polygons), 4), -1, numpy.int64)
    padded[:, : polygons.shape[1]] = polygons
    return numpy.sort(padded, axis=1).view(_KEY).ravel()


_KEY = numpy.dtype([(name, numpy.int64) for name in "abcd"])

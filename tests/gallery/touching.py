"""Solids that touch: shapes of several solids to mesh, and what must be true of their one mesh."""

import FreeCAD
import numpy
import Part
from checker import (
    boundary_polygons,
    cells,
    element_faces,
    expect_on_entities,
    expect_positive,
    rolled,
)
from solids.kit import box, planar, polygon, rod, vec

from sweepmesh.engine.results import INSIDE

# --- shapes -----------------------------------------------------------------------------------------------------------


def fragments(*solids):
    """The solids divided at each other, with common faces: what FreeCAD's BooleanFragments makes."""
    pieces = solids[0].generalFuse(list(solids[1:]))[0].Solids if len(solids) > 1 else solids[0].Solids
    return Part.Compound(pieces)


def cut_by(shape, *planes):
    """A solid divided by planes, each (point, normal); the pieces have common faces."""
    size = 4 * shape.BoundBox.DiagonalLength
    tools = []
    for point, normal in planes:
        tool = Part.makePlane(size, size, vec(-size / 2, -size / 2, 0))
        turn = FreeCAD.Rotation(vec(0, 0, 1), vec(*normal))
        tool.Placement = FreeCAD.Placement(vec(*point), turn).multiply(tool.Placement)
        tools.append(tool)
    return Part.Compound(shape.generalFuse(tools)[0].Solids)


def prism(points, z0, z1):
    """Upright prism over a polygon."""
    return planar(polygon(points, z0)).extrude(vec(0, 0, z1 - z0))


def half_ring(radius, thickness):
    """Half a torus that stands on its two ends at z = 0."""
    ring = Part.makeTorus(radius, thickness)
    ring.rotate(vec(0, 0, 0), vec(1, 0, 0), 90)
    return ring.common(box(-60, 60, -60, 60, 0, 60))


# --- what must be true ------------------------------------------------------------------------------------------------


def contact_faces(shape, tolerance=1e-6):
    """Numbers of the faces that two solids have in common, and of those that coincide, as sets of numbers."""
    numbers = {face.hashCode(): number for number, face in enumerate(shape.Faces, 1)}
    uses = {}
    for index, solid in enumerate(shape.Solids):
        for face in solid.Faces:
            uses.setdefault(numbers[face.hashCode()], set()).add(index)
    shared = {number for number, solids in uses.items() if len(solids) == 2}
    alone = [number for number, solids in uses.items() if len(solids) == 1]
    coincident = set()
    for i, one in enumerate(alone):
        for two in alone[:i]:
            a, b = shape.Faces[one - 1], shape.Faces[two - 1]
            if uses[one] == uses[two] or abs(a.Area - b.Area) > 1e-6 * a.Area:
                continue
            if (a.CenterOfMass - b.CenterOfMass).Length < tolerance and a.common(b).Area > 0.999 * a.Area:
                coincident.update((one, two))
    return shared, coincident


def expect_one_mesh(result, model, shape):
    """The meshes of all solids are one on every common face, and nothing is said against it."""
    assert result.assessment.is_sweepable, [reason.text for reason in result.assessment.reasons]
    assert result.warnings == []
    expect_glued(result, model, shape, *contact_faces(shape))


def expect_glued(result, model, shape, shared, coincident):
    """No node is there twice; a contact's polygons lie between two elements, all others on one."""
    corners = cells(result)
    expect_positive(result)
    expect_on_entities(result, model, 1e-6 * model.model_size)
    expect_no_doubles(result.points, 1e-6 * model.model_size)
    faces = element_faces(corners)
    unique, inverse, counts = numpy.unique(
        numpy.sort(faces, axis=1), axis=0, return_inverse=True, return_counts=True
    )
    assert counts.max() <= 2, "a face has more than two elements"
    polygons = boundary_polygons(result)
    is_contact = numpy.isin(result.boundary_faces, sorted(shared | coincident))
    outer = rolled(faces[counts[inverse.ravel()] == 1])
    assert sorted(map(tuple, outer)) == sorted(map(tuple, rolled(polygons[~is_contact])))
    inner = {tuple(row) for row in unique[counts == 2]}
    inner_polygons = [tuple(row) for row in numpy.sort(polygons[is_contact], axis=1)]
    assert all(polygon in inner for polygon in inner_polygons), "a contact is open"
    for number in shared | coincident:
        assert (result.boundary_faces == number).any(), f"Face{number} has no polygons"
    if not coincident:
        assert len(set(inner_polygons)) == len(inner_polygons), "a common face's polygons are there twice"
    used = numpy.unique(numpy.concatenate([nodes.ravel() for nodes, _ in corners]))
    assert len(used) <= len(result.points)
    expect_volume(result, shape)
    assert (result.owner_kind[result.boundary_nodes] != INSIDE).all()


def expect_no_doubles(points, tolerance):
    """No two nodes at one place."""
    along = points @ numpy.array([0.414, 0.732, 0.541])
    order = numpy.argsort(along)
    for step in range(1, 12):
        a, b = order[:-step], order[step:]
        near = numpy.linalg.norm(points[a] - points[b], axis=1) < tolerance
        assert not near.any(), f"nodes {a[near][:5]} and {b[near][:5]} lie on each other"


def expect_volume(result, shape):
    """Elements fill the solids but for what chords cut off curved faces."""
    low = result.points.mean(axis=0)
    total = 0.0
    for nodes, faces in cells(result):
        for face in faces:  # the divergence theorem on the two triangulations of each face, averaged
            corner = [result.points[nodes[:, i]] - low for i in face]
            turns = [(0, i, i + 1) for i in range(1, len(face) - 1)]
            turns += [(1, 2, 3), (1, 3, 0)] if len(face) == 4 else turns
            for a, b, c in turns:
                total += numpy.einsum("ij,ij->", corner[a], numpy.cross(corner[b], corner[c])) / 12
    assert abs(total - shape.Volume) < 0.03 * shape.Volume, f"volume {total:g}, exact {shape.Volume:g}"


# --- families ---------------------------------------------------------------------------------------------------------

L_SHAPE = [(0, 0), (30, 0), (30, 12), (12, 12), (12, 30), (0, 30)]

STACKS = {
    "two boxes, one on the other": lambda: fragments(box(0, 20, 0, 10, 0, 8), box(0, 20, 0, 10, 8, 20)),
    "two boxes side by side": lambda: fragments(box(0, 20, 0, 10, 0, 8), box(20, 50, 0, 10, 0, 8)),
    "L cut across": lambda: cut_by(prism(L_SHAPE, 0, 20), ((0, 0, 9), (0, 0, 1))),
    "L cut along": lambda: cut_by(prism(L_SHAPE, 0, 20), ((12, 0, 0), (1, 0, 0))),
    "L cut aslant": lambda: cut_by(prism(L_SHAPE, 0, 20), ((6, 6, 0), (1, -1, 0))),
    "rod in three": lambda: cut_by(rod(8, vec(0, 0), 40), ((0, 0, 10), (0, 0, 1)), ((0, 0, 25), (0, 0, 1))),
    "rod in halves": lambda: cut_by(rod(8, vec(0, 0), 40), ((0, 0, 0), (1, 0, 0))),
    "pin in a plate": lambda: fragments(
        box(-20, 20, -20, 20, 0, 6).cut(rod(8, vec(0, 0), 6)), rod(8, vec(0, 0), 6)
    ),
    "drilled block in four": lambda: cut_by(
        box(-20, 20, -15, 15, 0, 12).cut(rod(6, vec(0, 0), 12)), ((0, 0, 0), (1, 0, 0)), ((0, 0, 0), (0, 1, 0))
    ),
    "ring of wedges": lambda: cut_by(
        Part.makeTorus(20, 5), ((0, 0, 0), (1, 0, 0)), ((0, 0, 0), (0, 1, 0))
    ),
}

MIXED = {
    "tee of boxes": lambda: fragments(box(0, 40, 0, 10, 0, 10), box(15, 25, 10, 40, 0, 10)),
    "rod on a block": lambda: fragments(box(0, 40, 0, 30, 0, 10), rod(8, vec(20, 15, 10), 30)),
    "rod on its side": lambda: fragments(box(0, 40, 0, 30, 0, 10), rod(4, vec(40, 15, 5), 30, vec(1, 0, 0))),
    "box on a larger box": lambda: fragments(box(0, 40, 0, 30, 0, 10), box(10, 25, 8, 20, 10, 25)),
    "boxes on both sides": lambda: fragments(
        box(0, 40, 0, 30, 0, 10), box(10, 25, 8, 20, 10, 25), box(15, 35, 4, 14, -12, 0)
    ),
    "equal pads on both sides": lambda: fragments(
        box(0, 40, 0, 30, 0, 10), rod(8, vec(20, 15, 10), 12), rod(8, vec(20, 15, -6), 6)
    ),
    "tower": lambda: fragments(box(0, 40, 0, 30, 0, 10), box(10, 25, 8, 20, 10, 25), box(0, 40, 0, 30, 25, 35)),
    "pin through two plates": lambda: fragments(
        box(-20, 20, -20, 20, 0, 6).cut(rod(8, vec(0, 0), 6)),
        box(-20, 20, -20, 20, 6, 14).cut(rod(8, vec(0, 0, 6), 8)),
        rod(8, vec(0, 0), 14),
    ),
    "handle on a disc": lambda: cut_by(
        rod(25, vec(0, 0, -10), 10).fuse(half_ring(12, 3)), ((0, 0, 0), (0, 0, 1))
    ),
    "bracket": lambda: fragments(box(0, 40, 0, 20, 0, 8), box(0, 8, 0, 20, 8, 40), box(8, 30, 6, 14, 8, 16)),
}

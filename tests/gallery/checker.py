"""What must be true of every swept mesh, whatever the solid: `expect_valid_sweep`.

Nothing here uses the mesher's own quality or topology code, only numpy, and the CAD model for distances.
"""

import numpy

from sweepmesh.engine.model import chosen_solids
from sweepmesh.engine.results import EDGE, FACE, INSIDE, VERTEX

# Faces of the elements with outward normals, and the three neighbours of each corner (right-handed).
HEX_FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
HEX_CORNERS = [(1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3)]
PRISM_FACES = [(0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)]
PRISM_CORNERS = [(1, 2, 3), (2, 0, 4), (0, 1, 5), (5, 4, 0), (3, 5, 1), (4, 3, 2)]

SHORTEST_EDGE = 1e-3
"""Of the median edge: what is shorter has shrunk to nothing, whatever its angles are."""
AREA_SLACK = 0.15
"""A face of chords may lack this much of a curved face: a circle of four chords lacks 10 % of its length."""
SAMPLE = 1500
"""Distances are measured for at most so many nodes a check, spread evenly: each is a search in the CAD model."""


def expect_valid_sweep(result, model, genus=None):
    """Asserts that `result` is a valid mesh of all solids of `model`. `genus` is that of each shell, if known."""
    assert result.n_elements > 0, "no elements"
    solids = chosen_solids(model)
    corners = cells(result)
    expect_conforming(result, corners, has_contacts=len(solids) > 1)
    expect_positive(result)
    expect_nodes_apart(result, corners)
    if len(solids) == 1:
        expect_counts(result)
    if genus is not None and len(solids) == 1:  # the shells of solids that touch are joined
        expect_topology(result, corners, genus)
    tolerance = 1e-6 * model.model_size
    expect_on_entities(result, model, tolerance)
    expect_faces_covered(result, solids, tolerance)
    expect_volume(result, model, sum(solid.volume for solid in solids))


def over_polygon(n):
    """Faces and neighbours of corners, as above, of a prism over n corners."""
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    low = [((i + 1) % n, (i - 1) % n, n + i) for i in range(n)]
    high = [(n + (i - 1) % n, n + (i + 1) % n, i) for i in range(n)]
    return [tuple(range(n - 1, -1, -1)), tuple(range(n, 2 * n)), *sides], low + high


def kinds(result):
    """[(corners, faces, neighbours of corners)] of the kinds of elements that there are."""
    simple = [(result.hexahedra[:, :8], HEX_FACES, HEX_CORNERS), (result.prisms[:, :6], PRISM_FACES, PRISM_CORNERS)]
    offsets, sizes = result.polyhedron_offsets, numpy.diff(result.polyhedron_offsets)
    for size in numpy.unique(sizes):
        nodes = result.polyhedron_nodes[offsets[:-1][sizes == size][:, None] + numpy.arange(size)]
        simple.append((nodes, *over_polygon(size // 2)))
    return [kind for kind in simple if len(kind[0])]


def cells(result):
    """[(corners, faces)] of the kinds of elements that there are."""
    return [(nodes, faces) for nodes, faces, _ in kinds(result)]


def is_second_order(result):
    """Are there mid-side nodes?"""
    return result.hexahedra.shape[1] == 20 or result.prisms.shape[1] == 15


def element_faces(corners):
    """All faces of all elements as an array of four columns or more; those with fewer corners have -1 behind them."""
    rows = []
    width = max(4, *(len(face) for _, faces in corners for face in faces))
    for nodes, faces in corners:
        for face in faces:
            columns = nodes[:, list(face)]
            pad = numpy.full((len(nodes), width - len(face)), -1, columns.dtype)
            rows.append(numpy.hstack([columns, pad]))
    return numpy.vstack(rows)


def boundary_polygons(result):
    """The corners of the boundary as an array of four columns or more, those with fewer corners with -1 behind them."""
    starts, sizes = result.boundary_offsets[:-1], result.boundary_sizes()
    width = max(4, *numpy.diff(result.polyhedron_offsets) // 2, 0)  # as in `element_faces`
    polygons = numpy.full((len(sizes), width), -1)
    for column in range(polygons.shape[1]):
        has = sizes > column
        polygons[has, column] = result.boundary_nodes[starts[has] + column]
    return polygons


def rolled(polygons):
    """The same polygons from their lowest node on, so that equal cycles are equal rows."""
    polygons = polygons.copy()
    sizes = (polygons >= 0).sum(axis=1)
    for size in numpy.unique(sizes):
        for _ in range(size - 1):
            wrong = (sizes == size) & (polygons[:, 0] != polygons[:, :size].min(axis=1))
            polygons[wrong, :size] = numpy.roll(polygons[wrong, :size], -1, axis=1)
    return polygons


def expect_conforming(result, corners, has_contacts=False):
    """Inner faces have two elements, outer ones are the boundary's polygons, outward; no node is unused.

    Where solids touch, polygons of the faces that they have in common lie between two elements.
    """
    faces = element_faces(corners)
    _, inverse, counts = numpy.unique(numpy.sort(faces, axis=1), axis=0, return_inverse=True, return_counts=True)
    assert counts.max() <= 2, "a face has more than two elements"
    outer = rolled(faces[counts[inverse.ravel()] == 1])
    polygons = boundary_polygons(result)
    given = rolled(polygons[is_outer(polygons, corners)] if has_contacts else polygons)
    assert sorted(map(tuple, outer)) == sorted(map(tuple, given)), "the boundary is not that of the elements"
    used = [result.hexahedra.ravel(), result.prisms.ravel(), result.polyhedron_nodes]
    used = numpy.unique(numpy.concatenate(used))
    assert len(used) == len(result.points) and used[-1] == len(result.points) - 1, "nodes without an element"
    on_boundary = numpy.zeros(len(result.points), bool)
    on_boundary[result.boundary_nodes] = True
    assert numpy.array_equal(on_boundary, result.owner_kind != INSIDE), "owners do not fit the boundary"


def is_outer(polygons, corners):
    """Per polygon: it is a face of one element only, not of two. Each must be one of some element."""
    faces = numpy.sort(element_faces(corners), axis=1)
    _, inverse, counts = numpy.unique(
        numpy.vstack([faces, numpy.sort(polygons, axis=1)]), axis=0, return_inverse=True, return_counts=True
    )
    uses = numpy.bincount(inverse.ravel()[: len(faces)], minlength=len(counts))[inverse.ravel()[len(faces) :]]
    assert uses.min() > 0, "a boundary polygon is no face of an element"
    return uses == 1


def corner_jacobians(points, nodes, corners):
    """(m, corners) determinants of the three unit edges that leave each corner."""
    columns = []
    for corner, others in enumerate(corners):
        edges = points[nodes[:, list(others)]] - points[nodes[:, [corner]]]
        lengths = numpy.linalg.norm(edges, axis=2)
        assert lengths.min() > 0, "an edge has no length"
        columns.append(numpy.linalg.det(edges / lengths[:, :, None]))
    return numpy.stack(columns, axis=1)


def expect_positive(result):
    """Every corner of every element has a positive Jacobian, and the quality report agrees."""
    worst = []
    for nodes, _, corners in kinds(result):
        worst.append(corner_jacobians(result.points, nodes, corners).min(axis=1))
    worst = numpy.concatenate(worst)
    assert worst.min() > 0, f"{(worst <= 0).sum()} of {len(worst)} elements are inverted"
    assert result.quality["n_inverted"] == 0
    assert sum(result.quality["histogram"]) == len(worst)
    if len(worst) == len(result.hexahedra):  # others are scaled differently
        assert result.quality["min_scaled_jacobian"] <= worst.min() + 1e-9


def expect_nodes_apart(result, corners):
    """No edge may have shrunk to (nearly) nothing, which no scaled Jacobian shows."""
    faces = element_faces(corners)
    lengths = []
    for a, b in zip(faces.T, following(faces).T):
        is_edge = a >= 0
        lengths.append(numpy.linalg.norm(result.points[a[is_edge]] - result.points[b[is_edge]], axis=1))
    lengths = numpy.concatenate(lengths)
    assert lengths.min() > SHORTEST_EDGE * numpy.median(lengths), f"an edge of length {lengths.min()}"


def expect_counts(result):
    """Edges carry as many nodes as their intervals say; a one-to-one sweep is quads times layers.

    The mid-side nodes of a seam, which has the same face on both sides, may belong to that face.
    """
    order = 2 if is_second_order(result) else 1
    on_edge = result.owner_number[result.owner_kind == EDGE]
    for name, intervals in result.intervals.items():
        number = int(name[len("Edge") :])
        n_nodes = (on_edge == number).sum()
        assert n_nodes in (order * intervals - 1, intervals - 1), f"{name}: {n_nodes} nodes, {intervals} intervals"
    roles = result.assessment.roles
    sources = [int(face[len("Face") :]) for face, role in roles.items() if role == "source"]
    targets = [int(face[len("Face") :]) for face, role in roles.items() if role == "target"]
    if len(sources) == len(targets) == 1 and "divided" not in roles.values():
        n_source = (result.boundary_faces == sources[0]).sum()
        assert n_source == (result.boundary_faces == targets[0]).sum()
        assert result.n_elements == n_source * result.n_layers


def following(polygons):
    """The next corner behind each one, around polygons with -1 for what they lack."""
    out = numpy.roll(polygons, -1, axis=1)
    last = (polygons >= 0).sum(axis=1) - 1
    rows = numpy.arange(len(polygons))
    out[rows, last] = polygons[:, 0]
    return out


def n_unique_edges(polygons):
    """The number of edges of polygons with -1 for missing nodes; and that of directed ones."""
    pairs = numpy.stack([polygons, following(polygons)], axis=2).reshape(-1, 2)
    pairs = pairs[pairs.min(axis=1) >= 0]
    directed = len(numpy.unique(pairs, axis=0))
    return len(numpy.unique(numpy.sort(pairs, axis=1), axis=0)), directed


def expect_topology(result, corners, genus):
    """The boundary is closed and has the solid's Euler number; the complex of the elements half of it."""
    euler = sum(2 - 2 * g for g in genus)
    boundary = boundary_polygons(result)
    n_edges, n_directed = n_unique_edges(boundary)
    assert n_directed == 2 * n_edges, "the boundary is not closed"
    on_boundary = len(numpy.unique(boundary[boundary >= 0]))
    assert on_boundary - n_edges + len(boundary) == euler, "the boundary has another topology than the solid"
    faces = element_faces(corners)
    n_faces = len(numpy.unique(numpy.sort(faces, axis=1), axis=0))
    n_all_edges, _ = n_unique_edges(faces)
    n_corners = len(numpy.unique(faces[faces >= 0]))
    chi = n_corners - n_all_edges + n_faces - result.n_elements
    assert 2 * chi == euler, "the elements leave or close a void"


def spread(items, limit=SAMPLE):
    """At most `limit` of the items, evenly spread."""
    return items[:: max(1, -(-len(items) // limit))]


def expect_on_entities(result, model, tolerance):
    """Every CAD vertex is a node; every boundary node lies on the entity that owns it."""
    for node in numpy.flatnonzero(result.owner_kind == VERTEX):
        exact = model.vertex_point(int(result.owner_number[node]) - 1)
        assert numpy.linalg.norm(result.points[node] - exact) <= tolerance, "a node is off its vertex"
    for kind, distance in ((EDGE, model.distance_to_edge), (FACE, model.distance_to_face)):
        for node in spread(numpy.flatnonzero(result.owner_kind == kind)):
            off = distance(int(result.owner_number[node]) - 1, result.points[node])
            assert off <= tolerance, f"node {node} is {off:g} off its {('edge', 'face')[kind - 1]}"


def polygon_areas(points, polygons):
    """The lengths of the area vectors: of quads half the cross product of the diagonals."""
    filled = numpy.where(polygons < 0, polygons[:, [0]], polygons)
    p = points[filled] - points[filled[:, [0]]]
    return 0.5 * numpy.linalg.norm(numpy.cross(p[:, 1:-1], p[:, 2:]).sum(axis=1), axis=1)


def expect_faces_covered(result, solids, tolerance):
    """Each CAD face has polygons, all of their nodes lie on it, and their areas add up to its own."""
    polygons = boundary_polygons(result)
    areas = polygon_areas(result.points, polygons)
    solid_of = {face: solid for solid in solids for face in solid.faces}
    assert set(result.boundary_faces) == {face + 1 for face in solid_of}, "a CAD face has no polygons"
    for face, model in sorted(solid_of.items(), key=lambda item: item[0]):
        its = result.boundary_faces == face + 1
        exact, meshed = model.area(face), areas[its].sum()
        assert abs(meshed - exact) <= AREA_SLACK * exact, f"Face{face + 1}: area {meshed:g}, exact {exact:g}"
        nodes = numpy.unique(polygons[its])
        for node in spread(nodes[nodes >= 0], 300):
            off = model.distance_to_face(face, result.points[node])
            assert off <= tolerance, f"node {node} is {off:g} off Face{face + 1}"


def mesh_volume(result):
    """Volume inside the boundary, by the divergence theorem; each polygon is a fan around the mean of its corners."""
    polygons = boundary_polygons(result)
    polygons = polygons[is_outer(polygons, cells(result))]
    points = result.points - result.points.mean(axis=0)
    has = polygons >= 0
    middles = (points[polygons] * has[:, :, None]).sum(axis=1) / has.sum(axis=1)[:, None]
    total = 0.0
    for i, successor in enumerate(following(polygons).T):
        a, b, c = middles[has[:, i]], points[polygons[has[:, i], i]], points[successor[has[:, i]]]
        total += numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6
    return total


def expect_volume(result, model, exact):
    """The volume is the solids', but for what the chords cut off: at most area times the largest sag."""
    polygons = boundary_polygons(result)
    filled = numpy.where(polygons < 0, polygons[:, [0]], polygons)
    centres = result.points[filled].mean(axis=1)  # of those with fewer corners another point within
    sag = max(
        model.distance_to_face(int(result.boundary_faces[i]) - 1, centres[i])
        for i in spread(numpy.arange(len(centres)), 500)
    )
    area = polygon_areas(result.points, polygons).sum()
    slack = 2 * sag * area + 1e-9 * exact
    assert abs(mesh_volume(result) - exact) <= slack, (
        f"volume {mesh_volume(result):g}, exact {exact:g}, allowed difference {slack:g}"
    )

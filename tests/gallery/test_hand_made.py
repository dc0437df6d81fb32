"""Sweeping a solid as a whole is at least as good as cutting it by hand into one-to-one pieces."""

import numpy
import pytest
from checker import HEX_FACES, expect_valid_sweep
from hand_made import Terraces, glued, ring, swept
from solids.kit import circle, polygon, vec


def crank():
    """A web between a pin above and a journal below of nearly its size, as those of a crankshaft: their circles cross
    at a small angle."""
    web = polygon([(-24, -18), (24, -18), (24, 18), (-24, 18)])
    return Terraces(web, 10, [(circle(10, vec(2, 0, 0)), 14)], [(circle(11, vec(-2, 0, 0)), 12)])


def pads():
    """Eight-cornered pads above and below, one a little beside the other: some of their sides run near each other."""
    plate = polygon([(-26, -22), (26, -22), (26, 22), (-26, 22)])
    above, below = ring(14, (1.6, 0.6), 8, 0.1), ring(15, (-1.6, -0.6), 8, 0.1)
    return Terraces(plate, 12, [(polygon(above), 9)], [(polygon(below), 8)])


def outer_area(mesh):
    """Area of the faces that belong to one hexahedron only."""
    faces = numpy.vstack([mesh.hexahedra[:, list(face)] for face in HEX_FACES])
    _, first, counts = numpy.unique(numpy.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    corners = mesh.points[faces[first[counts == 1]]]
    return numpy.linalg.norm(numpy.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]), axis=1).sum() / 2


@pytest.mark.parametrize("build, size", [(crank, 2.0), (pads, 2.5)])
def test_the_whole_is_at_least_as_good_as_pieces_glued_together(build, size):
    terraces = build()
    by_hand = glued(terraces.pieces(), size)
    shape = terraces.whole()
    assert outer_area(by_hand) == pytest.approx(shape.Area, rel=0.02), "the pieces are not glued everywhere"
    model, whole = swept(shape, size)
    expect_valid_sweep(whole, model)
    print(
        f"{build.__name__}: by hand {len(by_hand.hexahedra)} hexahedra, {by_hand.scaled_jacobians.min():.3f} min,"
        f" {by_hand.scaled_jacobians.mean():.3f} mean; swept {whole.n_elements}, "
        f"{whole.scaled_jacobians.min():.3f}, {whole.scaled_jacobians.mean():.3f}"
    )
    assert 0.5 < len(by_hand.hexahedra) / whole.n_elements < 2
    assert whole.scaled_jacobians.min() >= by_hand.scaled_jacobians.min()
    assert whole.scaled_jacobians.mean() >= by_hand.scaled_jacobians.mean()

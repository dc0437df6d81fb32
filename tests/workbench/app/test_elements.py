"""Arrays of a FemMesh's elements and the skin of some of them."""
import time

import numpy as np
import pytest
from test_femmesh import grid_result, prism_result

from sweepmesh.app.elements import Elements
from sweepmesh.app.femmesh import to_femmesh


def volume(points, quads):
    """Volume inside closed quads by the divergence theorem."""
    a, b, c, d = (points[quads[:, i]] for i in range(4))
    return sum(np.einsum("ij,ij->i", p, np.cross(q, r)).sum() for p, q, r in ((a, b, c), (a, c, d))) / 6


def from_femmesh(result):
    return Elements.of_femmesh(to_femmesh(result))


SOLIDS = [(grid_result(3), 27.0), (prism_result(), 1.0)]


@pytest.mark.parametrize("result, expected", SOLIDS, ids=["hexahedra", "prisms"])
@pytest.mark.parametrize("made", [Elements.of_result, from_femmesh])
def test_the_skin_of_all_elements_bounds_the_solid_outwards(result, expected, made):
    elements = made(result)
    quads, owners = elements.skin(np.ones(len(elements.ids), bool))
    assert volume(elements.points, quads) == pytest.approx(expected)
    assert set(owners) <= set(range(len(elements.ids)))


def test_the_skin_of_some_elements_has_no_inner_faces():
    elements = Elements.of_result(grid_result(3))
    chosen = elements.centres[:, 2] < 2
    quads, owners = elements.skin(chosen)
    assert len(quads) == 9 + 9 + 4 * 3 * 2
    assert volume(elements.points, quads) == pytest.approx(18.0)
    assert chosen[owners].all()


def test_no_elements_have_no_skin():
    elements = from_femmesh(grid_result(1))
    quads, owners = elements.skin(np.zeros(1, bool))
    assert len(quads) == len(owners) == 0


def test_both_ways_give_the_same_elements():
    result = grid_result(3)
    one, other = Elements.of_result(result), from_femmesh(result)
    assert one.ids.tolist() == other.ids.tolist()
    assert one.centres == pytest.approx(other.centres)
    chosen = one.centres[:, 0] < 1
    assert sorted(map(sorted, one.skin(chosen)[0].tolist())) == sorted(map(sorted, other.skin(chosen)[0].tolist()))


def test_neighbouring_prisms_share_their_triangles():
    points = np.array([[0, 0, z] for z in range(3)] + [[1, 0, z] for z in range(3)] + [[0, 1, z] for z in range(3)], float)
    lower, upper = [0, 3, 6, 1, 4, 7], [4, 7, 1, 5, 8, 2]  # the shared triangle begins at another corner
    elements = Elements(points, np.array([1, 2]), [(np.arange(2), np.array([lower, upper]))])
    quads, _ = elements.skin(np.array([True, True]))
    assert len(quads) == 2 + 6 and volume(points, quads) == pytest.approx(1.0)


def test_many_elements_take_little_time():
    result = grid_result(40)
    start = time.process_time()
    elements = Elements.of_result(result)
    quads, _ = elements.skin(elements.centres[:, 0] < 20)
    assert len(quads) == 2 * 40 * 40 + 4 * 40 * 20
    assert (time.process_time() - start) * 1e6 / len(elements.ids) < 4.0, "seconds for a million"

"""Arrays of a FemMesh's elements and the skin of some of them."""
import numpy as np
import pytest
from test_femmesh import grid_result, prism_result

from sweepmesh.app.elements import Elements
from sweepmesh.app.femmesh import to_femmesh


def volume(points, quads):
    """Volume inside closed quads by the divergence theorem."""
    a, b, c, d = (points[quads[:, i]] for i in range(4))
    return sum(np.einsum("ij,ij->i", p, np.cross(q, r)).sum() for p, q, r in ((a, b, c), (a, c, d))) / 6


SOLIDS = [(grid_result(3), 27.0), (prism_result(), 1.0)]


@pytest.mark.parametrize("result, expected", SOLIDS, ids=["hexahedra", "prisms"])
def test_the_skin_of_all_elements_bounds_the_solid_outwards(result, expected):
    elements = Elements(to_femmesh(result))
    quads, owners = elements.skin(np.ones(len(elements.ids), bool))
    assert volume(elements.points, quads) == pytest.approx(expected)
    assert set(owners) <= set(range(len(elements.ids)))


def test_the_skin_of_some_elements_has_no_inner_faces():
    elements = Elements(to_femmesh(grid_result(3)))
    chosen = elements.centres[:, 2] < 2
    quads, owners = elements.skin(chosen)
    assert len(quads) == 9 + 9 + 4 * 3 * 2
    assert volume(elements.points, quads) == pytest.approx(18.0)
    assert chosen[owners].all()


def test_no_elements_have_no_skin():
    elements = Elements(to_femmesh(grid_result(1)))
    quads, owners = elements.skin(np.zeros(1, bool))
    assert len(quads) == len(owners) == 0

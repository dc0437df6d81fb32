"""Random terraced solids: how many are meshed, and that it matters little how they lie and how large they are.

SWEEPMESH_RANDOM=100 meshes so many; `rate_of_terraces.py` prints a line for each.
"""

import os

import pytest
from rate_of_terraces import attempt, table
from solids.random_terraces import random_terraced

COUNT = int(os.environ.get("SWEEPMESH_RANDOM", "20"))
LEAST_RATE = 0.9


def test_most_are_meshed_and_the_others_say_why():
    """A mesh is checked in full; a failure is a typed error, or a verdict, that names faces, edges or vertices."""
    outcomes = table(range(COUNT))
    meshed = [outcome for outcome in outcomes if outcome.n_elements]
    assert len(meshed) >= LEAST_RATE * len(outcomes)
    for outcome in outcomes:
        assert outcome.n_elements or (outcome.refusal.endswith(".") and outcome.entities)


@pytest.mark.parametrize("seed", range(100, 100 + max(4, COUNT // 5)))
def test_turned_and_scaled_solids_are_meshed_alike(seed):
    """The same counts of elements, nodes and layers; where walls lean or twist, of layers."""
    upright = attempt(seed, check=False)
    is_straight = all(face.Surface.TypeId == "Part::GeomPlane" for face in random_terraced(seed).Faces)
    for scale in (1e-3, 1e3):
        turned = attempt(seed, scale, check=False)
        assert turned.n_layers == upright.n_layers
        if is_straight:
            assert (turned.n_elements, turned.n_nodes) == (upright.n_elements, upright.n_nodes)
        else:
            assert 0.8 < turned.n_elements / upright.n_elements < 1.25

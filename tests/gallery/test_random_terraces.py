"""Random terraced solids: how many are meshed, and that it does not matter how they lie and how large they are.

SWEEPMESH_RANDOM=100 meshes so many; `rate_of_terraces.py` prints a line for each, `rate_of_turned.py` those that differ.
"""

import os

from rate_of_terraces import table
from rate_of_turned import unlike

COUNT = int(os.environ.get("SWEEPMESH_RANDOM", "20"))
LEAST_RATE = 0.9
TIES = [116, 119, 135, 136, 147, 162, 255]
"""Solids in which rounding errors once decided: ties, triangulations, a tolerance of the file."""


def test_most_are_meshed_and_the_others_say_why():
    """A mesh is checked in full; a failure is a typed error, or a verdict, that names faces, edges or vertices."""
    outcomes = table(range(COUNT))
    meshed = [outcome for outcome in outcomes if outcome.n_elements]
    assert len(meshed) >= LEAST_RATE * len(outcomes)
    for outcome in outcomes:
        assert outcome.n_elements or (outcome.refusal.endswith(".") and outcome.entities)


def test_turned_and_scaled_solids_are_meshed_alike():
    """The same counts of elements, nodes and layers, whether walls are upright, lean or twist."""
    assert not unlike(sorted({*range(100, 96 + COUNT), *TIES}))

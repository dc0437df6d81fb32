"""Random terraced solids: how many are meshed, and that it matters little how they lie and how large they are.

SWEEPMESH_RANDOM=100 meshes so many; `rate_of_terraces.py` prints a line for each.
"""

import os

from rate_of_terraces import attempt, table

COUNT = int(os.environ.get("SWEEPMESH_RANDOM", "20"))
LEAST_RATE = 0.9
MOST_UNLIKE = 0.05
"""Of the solids: where a patch is poor, which of its candidates is best may still hang on rounding."""


def test_most_are_meshed_and_the_others_say_why():
    """A mesh is checked in full; a failure is a typed error, or a verdict, that names faces, edges or vertices."""
    outcomes = table(range(COUNT))
    meshed = [outcome for outcome in outcomes if outcome.n_elements]
    assert len(meshed) >= LEAST_RATE * len(outcomes)
    for outcome in outcomes:
        assert outcome.n_elements or (outcome.refusal.endswith(".") and outcome.entities)


def test_turned_and_scaled_solids_are_meshed_alike():
    """The same counts of elements, nodes and layers, whether walls are upright, lean or twist."""
    others = []
    for seed in range(100, 100 + COUNT):
        counts = {counts_of(attempt(seed, scale, check=False)) for scale in (1.0, 1e-3, 1e3)}
        print(seed, counts)
        if len(counts) > 1:
            others.append(seed)
    print(f"{COUNT - len(others)} of {COUNT} have the same counts however they lie")
    assert len(others) <= MOST_UNLIKE * COUNT


def counts_of(outcome):
    return outcome.n_elements, outcome.n_nodes, outcome.n_layers

"""Verdict and mesher agree: a sample of what scripts/agreement.py counts."""

import collections

import pytest
from agreement import FAILING, run_all

N_SOLIDS = 12
"""Of each family; the rates over more are printed by the command."""


@pytest.mark.parametrize("family", ["terraced", "primitives", "parts"])
def test_verdict_and_mesher_agree(family):
    done = run_all([["random", family, seed] for seed in range(N_SOLIDS)])
    counts = collections.Counter(examined.outcome for examined in done)
    assert counts["crashed"] == counts["hung"] == 0, done
    failing = [examined for examined in done if examined.outcome in FAILING]
    assert len(failing) <= 1 and counts["missed"] <= 1, [(e.name, e.outcome, e.detail) for e in done if not e.agrees]
    assert counts["meshed"] >= N_SOLIDS / 2


def test_the_same_seed_gives_the_same_solid():
    from random_solids import FAMILIES, make

    for family in FAMILIES:
        assert make(family, 3).exportBrepToString() == make(family, 3).exportBrepToString()
        assert make(family, 3).Volume != make(family, 4).Volume

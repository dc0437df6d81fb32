"""Parts with caps on several levels are meshed without picks, at the size that was asked for."""

import pytest
from checker import expect_valid_sweep
from solids.stepped_parts import PARTS

from sweepmesh import Options, engine, mesh

LEAST = 0.15
"""Scaled Jacobian: no corner of these parts asks for less."""


@pytest.mark.parametrize("name", PARTS)
def test_is_meshed_with_good_elements(name):
    model = engine.Model.from_brep(PARTS[name]().exportBrepToString(), 0)
    result = mesh(model, Options())
    assert result.assessment.is_sweepable
    expect_valid_sweep(result, model)
    assert not result.warnings
    assert result.quality["min_scaled_jacobian"] > LEAST

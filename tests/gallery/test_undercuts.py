"""Tubes with an undercut below a shoulder: columns from the foot end on the ledge's rim, not on another cap."""

import itertools

import Part
import pytest
import sweepmesh
from checker import expect_valid_sweep
from solids.kit import vec
from sweepmesh.engine.model import as_model


def undercut_tube(bore, foot, neck, rim):
    """Turned: a cone from the foot's radius in to the neck's, a ledge out to the rim's, a shoulder back to the neck's."""
    outline = [(bore, 0), (foot, 0), (neck, 3), (rim, 3), (rim, 7), (neck, 7), (neck, 14), (bore, 14)]
    wire = Part.makePolygon([vec(x, 0, z) for x, z in [*outline, outline[0]]])
    return Part.Face(wire).revolve(vec(0, 0, 0), vec(0, 0, 1), 360)


@pytest.mark.parametrize(("foot", "rim"), itertools.product((9, 11), (12, 15)))
def test_an_undercut_tube_is_swept_along_its_axis(foot, rim):
    text = undercut_tube(3, foot, 6, rim).exportBrepToString()
    result = sweepmesh.mesh(text, sweepmesh.Options())
    assert result.assessment.is_sweepable
    expect_valid_sweep(result, as_model(text))
    assert result.quality["min_scaled_jacobian"] > 0.3

"""The plan of a sweep: what it says in FreeCAD's numbers."""

import Part
import pytest

from sweepmesh import engine
from sweepmesh.engine import InputError, Options


def brick():
    """60 x 40 x 20: Face5 is the bottom, Face6 the top."""
    return Part.makeBox(60, 40, 20)


def test_a_plan_says_what_mesh_does():
    shape, options = brick().exportBrepToString(), Options(size=10.0, sources=[6])
    plan, result = engine.plan(shape, options), engine.mesh(shape, options)
    assert plan.size == 10.0 and plan.n_layers == 2
    assert plan.intervals == result.intervals
    assert plan.assessment.roles == result.assessment.roles


def test_numbers_are_freecad_s():
    shape = brick()
    plan = engine.plan(shape.exportBrepToString(), Options(size=10.0, sources=[6]))
    for number, edge in enumerate(shape.Edges, 1):
        upright = abs(edge.tangentAt(edge.FirstParameter).z) > 0.5
        assert plan.edge_roles[f"Edge{number}"] == ("axial" if upright else "transverse")
        assert plan.intervals[f"Edge{number}"] == round(edge.Length / 10)
    for number, vertex in enumerate(shape.Vertexes, 1):
        assert plan.levels[f"Vertex{number}"] == round(vertex.Z / 10)
    assert len(plan.corners) == 4 * 4
    assert {kind for _, _, kind in plan.corners} == {"end"}


def test_an_unsweepable_solid_has_no_numbers():
    plan = engine.plan(Part.makeSphere(5).exportBrepToString())
    assert not plan.assessment.is_sweepable and plan.assessment.reasons
    assert not (plan.corners or plan.intervals or plan.levels or plan.edge_roles)


def test_wrong_options_are_refused():
    with pytest.raises(InputError):
        engine.plan(brick().exportBrepToString(), Options(size=-1.0))

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


def test_two_solids_have_one_plan_with_the_size_of_the_smaller():
    small, large = Part.makeBox(4, 4, 4), Part.makeBox(20, 20, 20)
    large.translate((50, 0, 0))
    both = Part.makeCompound([small, large])
    plan, result = engine.plan(both.exportBrepToString()), engine.mesh(both.exportBrepToString())
    assert plan.size == result.size == engine.plan(small.exportBrepToString()).size
    assert plan.intervals == result.intervals and plan.n_layers == result.n_layers
    assert plan.assessment.roles == result.assessment.roles
    assert len(plan.corners) == 32


def test_picks_of_several_solids_go_to_their_own():
    first, second = Part.makeBox(20, 20, 10), Part.makeBox(20, 20, 10)
    second.translate((50, 0, 0))
    shape = Part.makeCompound([first, second]).exportBrepToString()
    plan = engine.plan(shape, Options(size=5.0, sources=[6, 7]))
    assert plan.assessment.roles["Face6"] == plan.assessment.roles["Face7"] == "source"
    assert plan.assessment.roles["Face8"] == "target"


def test_one_unsweepable_solid_of_two_is_named():
    second = Part.makeSphere(5)
    second.translate((50, 0, 0))
    plan = engine.plan(Part.makeCompound([brick(), second]).exportBrepToString())
    assert not plan.assessment.is_sweepable
    assert all(reason.text.startswith("Solid 2: ") for reason in plan.assessment.reasons)

"""What a plan shows on the edges of a solid is where the mesh then has its nodes (a plan is of each solid alone)."""

import numpy
import pytest
from gallery import cases

import sweepmesh
from sweepmesh import engine
from sweepmesh.engine.results import EDGE

TOLERANCE = 1e-6  # of an element; ends of pieces of a divided edge are exact to the CAD model's 1e-7 only


CASES = [case for case in cases("1-1", "M-1", "M-N", "submap", "radial") if case.entry["solids"] == 1]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.label)
def test_planned_nodes_are_those_of_the_mesh(case):
    model = sweepmesh.read(case.path)
    options = sweepmesh.Options(size=case.size, **case.picks(model))
    plan, result = engine.plan(model, options), sweepmesh.mesh(model, options)
    assert plan.intervals == result.intervals
    for name, planned in plan.edge_nodes.items():
        on_edge = (result.owner_kind == EDGE) & (result.owner_number == int(name[len("Edge") :]))
        found = result.points[on_edge]
        assert len(found) == len(planned) - 2, name
        distances = numpy.linalg.norm(planned[1:-1, None] - found[None], axis=2)
        assert numpy.all(distances.min(axis=1, initial=numpy.inf) < TOLERANCE * case.size), name

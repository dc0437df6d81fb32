"""What a plan shows on the edges of a solid is where the mesh then has its nodes (a plan is of each solid alone).

A plan is of the first scheme, a mesh of the best where the first one's elements are poor: then the mesh's own faces are planned.
"""

import dataclasses

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
    if plan.assessment.roles != result.assessment.roles:
        plan = engine.plan(model, dataclasses.replace(options, **faces_of(result.assessment.roles)))
    assert plan.intervals == result.intervals
    for name, planned in plan.edge_nodes.items():
        on_edge = (result.owner_kind == EDGE) & (result.owner_number == int(name[len("Edge") :]))
        found = result.points[on_edge]
        assert len(found) == len(planned) - 2, name
        distances = numpy.linalg.norm(planned[1:-1, None] - found[None], axis=2)
        assert numpy.all(distances.min(axis=1, initial=numpy.inf) < TOLERANCE * case.size), name


def faces_of(roles):
    """The picks that ask for these roles."""
    numbers = {role: [int(name[len("Face") :]) for name in roles if roles[name] == role] for role in ("source", "target")}
    return {"sources": numbers["source"], "targets": numbers["target"]}

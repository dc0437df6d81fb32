"""The figures of the thesis' chapters 5 and 8: how their solids are divided, and how good their meshes are."""

import FreeCAD
import Part
import pytest
from checker import expect_valid_sweep
from columns import UP, n_columns, n_levels
from gallery import Case, manifest

from sweepmesh import Options, engine, mesh, read

X = FreeCAD.Vector(1, 0, 0)
LEAST = 0.15
"""Scaled Jacobian of the worst element."""

PAIRS = {
    "two_by_two": 4,  # figures 5.1a and 5.14: S1a-T1a, S1b-T2a, S2a-T1b, S2b-T2b
    "two_by_two_stepped": 4,
    "growing_hole_multi": 5,  # figure 5.1b: the smaller source does not reach the third target
    "step_both_sides": 3,  # figures 5.5 and 5.10
    "multi_levels": 11,
    "typhoon_hole": 7,
    "crankshaft": 27,
    "grid_spacer": 5,
    "inlet_part": 16,
    "inlet_assembly": 18,
    "caterpillar_part": 10,
}
UPRIGHT = {
    "two_by_two": UP,
    "two_by_two_stepped": UP,
    "step_both_sides": UP,
    "multi_levels": UP,
    "crankshaft": X,
    "caterpillar_part": UP,
}
"""Solids whose columns are straight, and along which axis: their counts are known by another route."""


def case_of(name, scheme=0):
    return Case(name, manifest()[name], scheme)


def imprint_of(case, size=None):
    model = read(case.path)
    return engine.imprint(model, Options(size=size or case.size, **case.picks(model)))


def meshed(name, scheme=0, least=LEAST):
    """The checked mesh of a solid's scheme."""
    case = case_of(name, scheme)
    model, result = case.mesh()
    expect_valid_sweep(result, model, case.genus)
    assert result.quality["min_scaled_jacobian"] >= least
    return result


def roles_in(result, role):
    return [face for face, its in result.assessment.roles.items() if its == role]


@pytest.mark.parametrize("name", PAIRS)
def test_sources_and_targets_are_divided_into_pairs(name):
    imprint = imprint_of(case_of(name))
    assert imprint.n_pairs == PAIRS[name]


@pytest.mark.parametrize("name", UPRIGHT)
def test_pairs_are_as_many_as_columns(name):
    """Every column of the solid over a piece of its plan is a pair, where next to nothing is merged (tangent arcs)."""
    case = case_of(name)
    imprint = imprint_of(case, size=case.size / 200)
    shape = Part.read(str(case.path))
    assert all(distance < case.size / 200 for _, _, distance in imprint.merges)
    assert imprint.n_pairs == n_columns(shape, UPRIGHT[name])


@pytest.mark.parametrize("name", UPRIGHT)
def test_layers_grow_with_the_heights_of_caps(name):
    """Caps that do not lie over each other may share a layer, though not against the order of their heights."""
    case = case_of(name)
    model, shape = read(case.path), Part.read(str(case.path))
    plan = engine.plan(model, Options(size=case.size, **case.picks(model)))
    layers = {}
    for face in plan.assessment.roles:
        if plan.assessment.roles[face] == "linking":
            continue
        cap = shape.Faces[int(face[4:]) - 1]
        its = {
            plan.levels[f"Vertex{number}"]
            for number, vertex in enumerate(shape.Vertexes, 1)
            if any(vertex.isSame(other) for other in cap.Vertexes)
        }
        assert len(its) == 1, f"{face} lies on several layers"
        layers[round(cap.CenterOfMass.dot(UPRIGHT[name]), 6)] = its.pop()
    assert len(layers) == n_levels(shape, UPRIGHT[name])
    in_order = [layer for _, layer in sorted(layers.items())]
    assert in_order == sorted(in_order) and in_order[0] == 0 and in_order[-1] == plan.n_layers


def test_figure_5_1a_two_sources_over_two_targets():
    result = meshed("two_by_two", least=0.5)
    assert len(roles_in(result, "source")) == len(roles_in(result, "target")) == 2
    meshed("two_by_two_stepped", least=0.5)


def test_figure_5_1b_a_growing_hole_pushes_the_curves_aside():
    result = meshed("growing_hole_multi", least=0.3)
    assert len(roles_in(result, "source")) == 2 and len(roles_in(result, "target")) == 3


def test_figures_5_5_and_5_10_edges_overlap_fully_and_in_part():
    meshed("step_both_sides", least=0.5)


def test_figure_5_15_many_levels():
    meshed("multi_levels", least=0.3)


@pytest.mark.parametrize("factor", [0.93, 1.0, 1.07])
def test_figure_5_16_typhoon_hole(factor):
    case = case_of("typhoon_hole")
    model = read(case.path)
    result = mesh(model, Options(size=factor * case.size, **case.picks(model)))
    expect_valid_sweep(result, model, case.genus)
    assert result.quality["min_scaled_jacobian"] >= LEAST


def test_figures_5_18_and_8_10_crankshaft():
    result = meshed("crankshaft", least=0.3)
    assert len(roles_in(result, "source")) == len(roles_in(result, "target"))


def test_figure_8_2_the_better_scheme_of_the_pipe_junction():
    """The histogram (figure 8.3) of one scheme is better than the other's: fewer elements below any limit."""
    first, second = meshed("pipe_junction", 0), meshed("pipe_junction", 1)
    assert first.quality["min_scaled_jacobian"] > second.quality["min_scaled_jacobian"] + 0.2
    assert first.quality["mean_scaled_jacobian"] > second.quality["mean_scaled_jacobian"]
    for limit in (0.3, 0.5):
        shares = [(result.scaled_jacobians < limit).mean() for result in (first, second)]
        assert shares[0] <= shares[1]


def test_figure_8_4_grid_spacer():
    result = meshed("grid_spacer", least=0.25)
    assert len(roles_in(result, "target")) == 1 or len(roles_in(result, "source")) == 1


def test_figure_8_6_inlet_parts():
    meshed("inlet_part", least=0.3)
    for scheme in range(len(manifest()["inlet_assembly"]["schemes"])):
        meshed("inlet_assembly", scheme)


def test_figure_8_8_caterpillar_part():
    meshed("caterpillar_part", least=0.3)

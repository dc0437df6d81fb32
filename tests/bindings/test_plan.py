"""The plan of a sweep: what it says in FreeCAD's numbers."""

import numpy
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


def upright_edges(shape):
    """Numbers of the edges along z."""
    return [n for n, edge in enumerate(shape.Edges, 1) if abs(edge.tangentAt(edge.FirstParameter).z) > 0.5]


def test_the_nodes_of_edges_lie_on_them_at_the_ends_of_the_intervals():
    shape = brick()
    plan = engine.plan(shape.exportBrepToString(), Options(size=10.0, sources=[6]))
    for number, edge in enumerate(shape.Edges, 1):
        expected = [tuple(point) for point in edge.discretize(Number=plan.intervals[f"Edge{number}"] + 1)]
        assert plan.edge_nodes[f"Edge{number}"].tolist() == pytest.approx(numpy.array(expected), abs=1e-9)


@pytest.mark.parametrize("wish, count", [({"edge_count": 7}, 7), ({"edge_size": 2.5}, 8)])
def test_a_wish_for_one_edge_changes_what_is_tied_to_it(wish, count):
    shape = brick()
    upright = upright_edges(shape)
    wishes = {name: {upright[0]: value} for name, value in wish.items()}
    options = Options(size=10.0, sources=[6], **wishes)
    plan, result = engine.plan(shape.exportBrepToString(), options), engine.mesh(shape.exportBrepToString(), options)
    assert result.n_layers == plan.n_layers == count
    assert all(plan.intervals[f"Edge{number}"] == count for number in upright)
    assert plan.intervals == result.intervals


@pytest.mark.parametrize("is_symmetric", [False, True])
def test_a_bias_spaces_the_nodes_of_its_edge(is_symmetric):
    shape = brick()
    edge = upright_edges(shape)[0]
    options = Options(size=2.0, sources=[6], edge_bias={edge: (1.3, is_symmetric)})
    brep = shape.exportBrepToString()
    steps = numpy.diff(engine.plan(brep, options).edge_nodes[f"Edge{edge}"][:, 2])
    ratios = steps[1:] / steps[:-1]
    assert ratios[:4] == pytest.approx(numpy.full(4, 1.3))
    assert ratios[-4:] == pytest.approx(numpy.full(4, 1 / 1.3 if is_symmetric else 1.3))
    corner = shape.Edges[edge - 1].Vertexes[0].Point
    points = engine.mesh(brep, options).points
    on_edge = points[numpy.hypot(points[:, 0] - corner.x, points[:, 1] - corner.y) < 1e-9]
    assert numpy.diff(numpy.sort(on_edge[:, 2])) == pytest.approx(steps, abs=1e-9)


def test_a_bias_of_the_sweep_is_that_of_all_edges_along_it():
    shape = brick()
    plan = engine.plan(shape.exportBrepToString(), Options(size=4.0, sources=[6], targets=[5], sweep_bias=(2.0, False)))
    heights = {tuple(numpy.round(numpy.sort(plan.edge_nodes[f"Edge{e}"][:, 2]), 9)) for e in upright_edges(shape)}
    assert len(heights) == 1
    steps = numpy.diff(heights.pop())
    assert steps[1:] / steps[:-1] == pytest.approx(numpy.full(4, 2.0))


@pytest.mark.parametrize("wish", [{"edge_count": {99: 3}}, {"edge_size": {0: 1.0}}, {"edge_bias": {13: (1.0, False)}}])
def test_edges_that_the_shape_has_not_are_refused(wish):
    with pytest.raises(InputError) as raised:
        engine.plan(brick().exportBrepToString(), Options(size=10.0, **wish))
    assert raised.value.entities == [f"Edge{next(iter(next(iter(wish.values()))))}"]


@pytest.mark.parametrize(
    "wish",
    [
        {"edge_count": {1: 0}},
        {"edge_size": {1: -1.0}},
        {"edge_bias": {1: (0.0, False)}},
        {"sweep_bias": (-1.0, True)},
        {"imprint_tolerance": -0.1},
        {"edge_count": {1: 2_000_000_000}},
    ],
)
def test_wishes_without_sense_are_refused(wish):
    with pytest.raises(InputError):
        engine.mesh(brick().exportBrepToString(), Options(size=10.0, **wish))


def test_wishes_go_to_the_solid_that_has_the_edge():
    first, second = Part.makeBox(20, 20, 10), Part.makeBox(20, 20, 10)
    second.translate((50, 0, 0))
    shape = Part.makeCompound([first, second])
    edge = next(n for n in upright_edges(shape) if n > 12)
    for run in (engine.plan, engine.mesh):
        made = run(shape.exportBrepToString(), Options(size=5.0, sources=[6, 12], edge_count={edge: 9}))
        assert made.intervals[f"Edge{edge}"] == 9
        assert all(made.intervals[f"Edge{n}"] == 2 for n in upright_edges(shape) if n <= 12)


def shifted_pads(shift):
    """A plate with pads above and below whose edges are `shift` apart."""
    plate = Part.makeBox(40, 20, 5)
    above, below = Part.makeBox(20, 20, 5), Part.makeBox(20 + shift, 20, 5)
    above.translate((0, 0, 5))
    below.translate((0, 0, -5))
    return plate.fuse([above, below]).removeSplitter().Solids[0]


def test_the_imprint_tolerance_decides_what_becomes_one():
    brep = shifted_pads(0.5).exportBrepToString()
    up = [n for n, face in enumerate(shifted_pads(0.5).Faces, 1) if face.normalAt(0.5, 0.5).z > 0.9]
    down = [n for n, face in enumerate(shifted_pads(0.5).Faces, 1) if face.normalAt(0.5, 0.5).z < -0.9]
    apart = engine.mesh(brep, Options(size=2.5, sources=up, targets=down, imprint_tolerance=0.1))
    as_one = engine.mesh(brep, Options(size=2.5, sources=up, targets=down, imprint_tolerance=0.7))
    shortest = [
        min(numpy.diff(numpy.unique(numpy.round(result.points[:, 0], 6)))) for result in (apart, as_one)
    ]
    assert shortest[0] <= 0.5 + 1e-6 and apart.n_elements > as_one.n_elements

"""assess and mesh: plain values in, plain values out; progress, cancelling and errors on the way."""

import threading
import time

import numpy
import Part
import pytest
from checker import expect_valid_sweep
from FreeCAD import Vector

import sweepmesh
from sweepmesh import Cancelled, InputError, Model, Options, Progress, SweepMeshError
from sweepmesh.engine import _sweepmesh


def brick():
    """60 x 40 x 25: Face5 is the bottom, Face6 the top."""
    return Part.makeBox(60, 40, 25).exportBrepToString()


def test_options_default_to_the_core_s():
    options, core = Options(), _sweepmesh.SweepOptions()
    assert (options.size, options.layers, options.order) == (core.size, core.layers, core.order)
    assert options.element == core.element.name
    assert options.to_core().max_elements == core.max_elements


def test_options_reach_the_core():
    core = Options(size=2.5, layers=4, element="prism", order=2, max_elements=77).to_core()
    assert (core.size, core.layers, core.element.name, core.order, core.max_elements) == (2.5, 4, "prism", 2, 77)


def test_polyhedra_are_rings_in_compressed_rows():
    model = Model.from_brep(Part.makeCylinder(10, 12).exportBrepToString(), 0)
    result = sweepmesh.mesh(model, Options(size=3, element="polyhedron"))
    expect_valid_sweep(result, model, [0])
    assert result.n_elements == len(result.hexahedra) + len(result.prisms) + result.n_polyhedra
    sizes = numpy.diff(result.polyhedron_offsets)
    assert sizes.min() >= 10 and (sizes % 2 == 0).all() and sizes.sum() == len(result.polyhedron_nodes)
    seen = numpy.concatenate([its for its, _ in result.polyhedra_by_corners()])
    assert sorted(seen) == list(range(result.n_polyhedra))
    for its, nodes in result.polyhedra_by_corners():
        low, high = numpy.split(result.points[nodes], 2, axis=1)
        heights = (high - low) @ (0, 0, 1)
        area = numpy.cross(low[:, 1:-1] - low[:, :1], low[:, 2:] - low[:, :1]).sum(axis=1) @ (0, 0, 0.5)
        assert (heights * area[:, None] > 0).all(), "the first ring is not counterclockwise seen from the second"
    with pytest.raises(InputError, match="no second order"):
        sweepmesh.mesh(model, Options(element="polyhedron", order=2))


def test_an_assessment_names_roles_and_schemes():
    found = sweepmesh.assess(brick())
    assert found.verdict == "sweepable" and found.is_sweepable and not found.reasons
    assert found.roles == found.schemes[0]
    assert set(found.roles) == {f"Face{i}" for i in range(1, 7)}
    assert sorted(found.roles.values()) == ["linking"] * 4 + ["source", "target"]


def test_picks_are_kept():
    found = sweepmesh.assess(brick(), Options(sources=[5], targets=[6]))
    assert (found.roles["Face5"], found.roles["Face6"]) == ("source", "target")


def test_an_unsweepable_solid_is_an_answer_with_reasons():
    shape = Part.makeSphere(10).cut(Part.makeSphere(2, Vector(4, 0, 0))).cut(Part.makeSphere(2, Vector(-4, 0, 0)))
    found = sweepmesh.assess(shape.exportBrepToString())
    assert found.verdict == "unsweepable" and not found.schemes and found.roles == {}
    assert found.reasons and all(reason.text.endswith(".") for reason in found.reasons)
    assert {reason.kind for reason in found.reasons} <= set(_sweepmesh.ReasonKind.__members__)
    result = sweepmesh.mesh(shape.exportBrepToString())
    assert result.assessment == found and result.n_elements == 0 and len(result.points) == 0


@pytest.mark.parametrize("source, target", [(6, 5), (5, 6), (1, 2), (3, 4)])
def test_a_brick_is_meshed_from_any_side(source, target):
    model = Model.from_brep(brick(), 0)
    result = sweepmesh.mesh(model, Options(size=5, sources=[source], targets=[target]))
    expect_valid_sweep(result, model, genus=[0])
    assert result.assessment.roles[f"Face{source}"] == "source"
    assert len(result.hexahedra) == 12 * 8 * 5 and result.size == 5


def test_arrays_have_the_promised_types():
    result = sweepmesh.mesh(brick(), Options(size=5))
    n_nodes, n_polygons = len(result.points), len(result.boundary_faces)
    for name, dtype, shape in [
        ("points", numpy.float64, (n_nodes, 3)),
        ("hexahedra", numpy.int32, (480, 8)),
        ("prisms", numpy.int32, (0, 6)),
        ("boundary_offsets", numpy.int32, (n_polygons + 1,)),
        ("boundary_nodes", numpy.int32, (4 * n_polygons,)),
        ("boundary_faces", numpy.int32, (n_polygons,)),
        ("owner_kind", numpy.int8, (n_nodes,)),
        ("owner_number", numpy.int32, (n_nodes,)),
    ]:
        array = getattr(result, name)
        assert (array.dtype, array.shape) == (dtype, shape), name


def test_arrays_outlive_the_run():
    points = sweepmesh.mesh(brick(), Options(size=5)).points
    copy = points.copy()
    for _ in range(3):
        sweepmesh.mesh(brick(), Options(size=4))
    assert numpy.array_equal(points, copy)


def test_layers_can_be_given():
    result = sweepmesh.mesh(brick(), Options(size=5, layers=7, sources=[6], targets=[5]))
    assert result.n_layers == 7 and len(result.hexahedra) == 12 * 8 * 7


def test_a_size_is_chosen_where_none_is_given():
    result = sweepmesh.mesh(brick())
    assert result.size > 0 and 1000 < len(result.hexahedra) < 9000


def test_quality_and_times_are_reported():
    result = sweepmesh.mesh(brick(), Options(size=5))
    assert result.quality["min_scaled_jacobian"] == pytest.approx(1)
    assert set(result.area_deviation) == {f"Face{i}" for i in range(1, 7)}
    assert all(deviation == pytest.approx(0, abs=1e-9) for deviation in result.area_deviation.values())
    assert result.quality["mean_scaled_jacobian"] == pytest.approx(1)
    assert result.quality["n_inverted"] == 0
    assert sum(result.quality["histogram"]) == 480 and len(result.quality["histogram"]) == 20
    assert {"read", "total"} < set(result.seconds)
    assert all(seconds >= 0 for seconds in result.seconds.values())


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_threads_do_not_change_the_mesh(threads):
    first, second = (sweepmesh.mesh(brick(), Options(size=3, threads=n)) for n in (0, threads))
    assert numpy.array_equal(first.points, second.points)
    assert numpy.array_equal(first.hexahedra, second.hexahedra)


WRONG = {
    "size zero": dict(size=0.0),
    "size negative": dict(size=-1.0),
    "size not a number": dict(size=float("nan")),
    "size infinite": dict(size=float("inf")),
    "no layers": dict(layers=0),
    "unknown source": dict(sources=[7]),
    "unknown target": dict(targets=[0]),
    "unknown pair": dict(pairs=[(1, 9)]),
    "source is target": dict(sources=[3], targets=[3]),
    "element kind": dict(element="tetra"),
    "order": dict(order=3),
    "too many elements": dict(size=0.01),
    "far too many elements": dict(size=1e-30),
}


@pytest.mark.parametrize("what", WRONG)
def test_wrong_options_are_input_errors(what):
    with pytest.raises(InputError) as caught:
        sweepmesh.mesh(brick(), Options(**WRONG[what]))
    assert str(caught.value).endswith(".") and "\n" not in str(caught.value)
    assert caught.value.stage


def test_an_unknown_face_is_named():
    with pytest.raises(InputError, match="Face9") as caught:
        sweepmesh.assess(brick(), Options(sources=[9]))
    assert caught.value.entities == ["Face9"]


def test_the_limit_says_the_count_and_can_be_set():
    with pytest.raises(InputError, match=r"\d{3}"):
        sweepmesh.mesh(brick(), Options(size=5, max_elements=100))
    assert sweepmesh.mesh(brick(), Options(size=5, max_elements=1000)).n_elements == 480


class Watcher(Progress):
    """Keeps what it is told; says stop after the first word."""

    def __init__(self, stops=False):
        self.seen, self.threads, self._stops = [], set(), stops

    def update(self, fraction, message):
        self.seen.append((fraction, message))
        self.threads.add(threading.current_thread())

    def is_cancelled(self):
        return self._stops


def test_progress_is_told_in_the_callers_thread():
    watcher = Watcher()
    sweepmesh.mesh(brick(), Options(size=0.5), watcher)
    assert watcher.seen and all(0 <= fraction <= 1 for fraction, _ in watcher.seen)
    assert watcher.threads == {threading.current_thread()}


def test_a_run_can_be_cancelled_within_a_second():
    started = time.perf_counter()
    with pytest.raises(Cancelled) as caught:
        sweepmesh.mesh(brick(), Options(size=0.3), Watcher(stops=True))
    assert time.perf_counter() - started < 1.5
    assert isinstance(caught.value, SweepMeshError) and caught.value.stage


def test_an_error_of_the_watcher_ends_the_run():
    class Broken(Progress):
        def is_cancelled(self):
            raise KeyError("watcher")

    with pytest.raises(KeyError):
        sweepmesh.mesh(brick(), Options(size=0.5), Broken())


def test_runs_can_go_on_in_several_threads_at_once():
    results = [None] * 3

    def work(i):
        results[i] = sweepmesh.mesh(brick(), Options(size=3))

    threads = [threading.Thread(target=work, args=(i,)) for i in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(numpy.array_equal(result.points, results[0].points) for result in results)

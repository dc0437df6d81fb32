"""The imprint as shapes: what must be true of divided caps, pairs and curves, over the gallery's solids."""

import Part
import pytest
from gallery import cases

from sweepmesh import engine, read
from sweepmesh.engine import ImprintError, InputError, Options

REFUSED = {"hollow_box_shell-scheme0", "pipe_junction-scheme0"}
"""Imprinting does not serve these."""

SOLIDS = [
    case
    for case in cases("1-1", "M-1", "M-N")
    if case.scheme == 0 and case.entry["solids"] == 1 and case.label not in REFUSED
]


def shape_of(brep):
    shape = Part.Shape()
    shape.importBrepFromString(brep)
    return shape


def stepped_block():
    """Two sources over one target: there are two pairs and one curve, on the target at x = 20."""
    return Part.makeBox(40, 30, 20).fuse(Part.makeBox(20, 30, 35)).removeSplitter()


def upwards(shape, **options):
    """Options for a sweep along z: all faces that look up are sources, those that look down targets."""
    slopes = [face.normalAt(0, 0).z for face in shape.Faces]
    sources = [number for number, z in enumerate(slopes, 1) if z > 0.9]
    targets = [number for number, z in enumerate(slopes, 1) if z < -0.9]
    return Options(sources=sources, targets=targets, **options)


def imprinted(shape, size):
    return engine.imprint(shape.exportBrepToString(), upwards(shape, size=size))


@pytest.mark.parametrize("case", SOLIDS, ids=lambda case: case.label)
def test_divided_caps_are_the_caps(case):
    model = read(case.path)
    imprint = engine.imprint(model, Options(size=case.size, **case.picks(model)))
    caps, curves = shape_of(imprint.caps), shape_of(imprint.curves)
    assert caps.isValid()
    assert len(caps.Faces) == len(imprint.parts)
    assert len(curves.Wires) == len(imprint.curve_caps)
    expect_each_pair_has_a_source_and_a_target(imprint)
    areas = {}
    for part, face in zip(imprint.parts, caps.Faces):
        areas[part.cap] = areas.get(part.cap, 0.0) + face.Area
        assert imprint.assessment.roles[part.cap] == part.role
    for cap, area in areas.items():
        assert area == pytest.approx(model.area(int(cap[4:]) - 1), rel=1e-3)


def expect_each_pair_has_a_source_and_a_target(imprint):
    sides = {pair: set() for pair in range(1, imprint.n_pairs + 1)}
    for part in imprint.parts:
        sides[part.pair].add((part.role, part.cap))
    for pair, its in sides.items():
        assert sorted(role for role, _ in its) == ["source", "target"], f"pair {pair}: {its}"


@pytest.mark.parametrize("case", SOLIDS, ids=lambda case: case.label)
def test_curves_lie_on_their_caps(case):
    model = read(case.path)
    imprint = engine.imprint(model, Options(size=case.size, **case.picks(model)))
    for cap, wire in zip(imprint.curve_caps, shape_of(imprint.curves).Wires):
        for point in wire.discretize(23):
            assert model.distance_to_face(int(cap[4:]) - 1, point) < 1e-5 * model.model_size


def test_a_step_divides_the_target_below_it():
    shape = stepped_block()
    imprint = imprinted(shape, 4.0)
    assert imprint.n_pairs == 2 and len(imprint.curve_caps) == 1
    (curve,) = shape_of(imprint.curves).Wires
    assert curve.Length == pytest.approx(30) and (curve.BoundBox.XMin, curve.BoundBox.ZMin) == pytest.approx((20, 0))
    lower = shape.Faces[int(imprint.curve_caps[0][4:]) - 1]
    assert lower.Area == pytest.approx(40 * 30)


def test_faces_of_a_pair_lie_over_each_other():
    imprint = imprinted(stepped_block(), 4.0)
    faces = {}
    for part, face in zip(imprint.parts, shape_of(imprint.caps).Faces):
        faces.setdefault(part.pair, []).append(face.CenterOfMass)
    for low, high in faces.values():
        assert (low.x, low.y) == pytest.approx((high.x, high.y)) and low.z != high.z


def test_normals_point_out_of_the_solid():
    shape = stepped_block()
    imprint = imprinted(shape, 4.0)
    for face in shape_of(imprint.caps).Faces:
        outside = face.CenterOfMass + 0.01 * face.normalAt(0, 0)
        assert not shape.isInside(outside, 1e-6, True)


def test_near_edges_are_reported_as_merged():
    """The step below lies a tenth of a size beside the one above."""
    below = Part.makeBox(20.4, 30, 12)
    below.translate((0, 0, -12))
    shape = stepped_block().fuse(below).removeSplitter()
    imprint = imprinted(shape, 4.0)
    assert imprint.n_pairs == 2 and imprint.merges
    for kept, merged, distance in imprint.merges:
        assert kept != merged and distance == pytest.approx(0.4)
    apart = imprinted(shape, 0.8)
    assert apart.n_pairs == 3 and not apart.merges


def test_a_cap_with_seam_and_pole_is_divided():
    """The dome's seam runs across the imprinted rim of the blind hole below it, and through its pole."""
    ball = Part.makeSphere(30)
    shape = Part.makeCylinder(12, 40).common(ball).cut(Part.makeCylinder(5, 10))
    imprint = engine.imprint(shape.exportBrepToString(), Options(size=3.0))
    caps = shape_of(imprint.caps)
    assert imprint.n_pairs == 2 and caps.isValid()
    expect_each_pair_has_a_source_and_a_target(imprint)
    dome = sum(f.Area for f, part in zip(caps.Faces, imprint.parts) if f.Surface.TypeId == "Part::GeomSphere")
    assert dome == pytest.approx(max(f.Area for f in shape.Faces if f.Surface.TypeId == "Part::GeomSphere"), rel=1e-6)


def test_one_to_one_caps_stay_whole():
    imprint = engine.imprint(Part.makeBox(4, 5, 6).exportBrepToString(), Options(sources=[6]))
    assert imprint.n_pairs == 1 and not imprint.curve_caps
    assert [(part.cap, part.role) for part in imprint.parts] == [("Face5", "target"), ("Face6", "source")]


def test_pairs_of_several_solids_have_numbers_of_their_own():
    second = stepped_block()
    second.translate((100, 0, 0))
    both = Part.makeCompound([stepped_block(), second])
    imprint = imprinted(both, 4.0)
    assert imprint.n_pairs == 4 and len(imprint.curve_caps) == 2
    expect_each_pair_has_a_source_and_a_target(imprint)


def test_an_unsweepable_solid_has_nothing_but_reasons():
    imprint = engine.imprint(Part.makeSphere(5).exportBrepToString())
    assert not imprint.assessment.is_sweepable and imprint.assessment.reasons
    assert imprint.n_pairs == 0 and not imprint.parts and not imprint.curve_caps


def test_wrong_options_are_refused():
    with pytest.raises(InputError):
        engine.imprint(Part.makeBox(1, 1, 1).exportBrepToString(), Options(size=-1.0))


def test_imprint_errors_say_how_they_failed():
    """Pockets from above and below with a membrane between them that is thinner than the tolerances."""
    shape = Part.makeBox(60, 50, 20)
    above, below = Part.makeBox(30, 30, 20), Part.makeBox(30, 20, 20)
    above.translate((10, 10, 10 + 5e-6))
    below.translate((20, 15, -10))
    shape = shape.cut([above, below])
    with pytest.raises(ImprintError) as caught:
        imprinted(shape, 4.0)
    assert caught.value.failure == "no_room" and caught.value.stage == "imprint"
    assert len(caught.value.entities) == 2
    with pytest.raises(ImprintError):
        engine.mesh(shape.exportBrepToString(), upwards(shape, size=4.0))

"""The verdict on every solid of the gallery, with the picks of each of its schemes and without any."""

import math
import time

import FreeCAD
import Part
import pytest
import sweepmesh
from checker import expect_valid_sweep
from gallery import cases
from solids.kit import polygon, rod, vec
from sweepmesh import Options
from sweepmesh.engine.model import as_model

KINDS = ("1-1", "M-1", "M-N", "radial", "submap", "unsweepable")

# What each refused solid's first reason has to be.
REASONS = {
    "sphere_two_voids": "topological",
    "sphere_three_voids": "topological",
    "genus3_cross_drilled": "topological",
    "curved_through_hole": "geometric",
    "prescribed_mismatch": "prescribed",
}


def chosen_scheme(case):
    """The manifest's scheme that the case picks; empty without picks."""
    return case.entry["schemes"][case.scheme] if case.scheme >= 0 else {}


def verdict(case):
    """What the manifest says of a case: a solid that can be swept may be unsweepable as picked, and the other way round."""
    if "feasible" in chosen_scheme(case):
        return "sweepable" if chosen_scheme(case)["feasible"] else "unsweepable"
    if case.name == "prescribed_mismatch":
        return "sweepable"  # only its pairs are impossible
    return case.entry["expected"]["verdict"]


def single_solids(*kinds):
    """Cases of one solid each."""
    return [case for case in cases(*kinds) if case.entry["solids"] == 1]


@pytest.mark.parametrize("case", single_solids(*KINDS), ids=lambda case: case.label)
def test_verdict_is_the_manifests(case):
    model = sweepmesh.read(case.path)
    asked = Options(**case.picks(model))
    start = time.monotonic()
    found = sweepmesh.assess(model, asked)
    assert time.monotonic() - start < 10
    assert found.verdict == verdict(case), [reason.text for reason in found.reasons]
    if found.is_sweepable:
        for faces, role in ((asked.sources, "source"), (asked.targets, "target")):
            assert all(found.roles[f"Face{face}"] == role for face in faces)
    else:
        first = found.reasons[0]
        assert first.kind == REASONS[case.name] and first.text.endswith(".") and first.entities


@pytest.mark.parametrize(
    "case", [case for case in single_solids("M-1", "M-N") if case.scheme >= 0], ids=lambda case: case.label
)
def test_sources_alone_lead_to_the_same_targets(case):
    """Half of the picks is enough: the other half is found."""
    model = sweepmesh.read(case.path)
    both = Options(**case.picks(model))
    found = sweepmesh.assess(model, Options(sources=both.sources))
    assert found.is_sweepable, [reason.text for reason in found.reasons]
    assert all(found.roles[f"Face{face}"] == "source" for face in both.sources)


def slanted(degrees):
    """A block with a bore and a top that slants so much, which makes its edge that sharp."""
    height = 10 * math.tan(math.radians(degrees))
    outline = Part.Face(polygon([(0, 0), (10, 0), (10, 4 + height), (0, 4)]))
    block = outline.extrude(vec(0, 0, 10))
    block.rotate(vec(0, 0, 0), vec(1, 0, 0), 90)
    return block.cut(rod(2, vec(5, -5, -1), 100))


@pytest.mark.parametrize("degrees", [50, 66, 70, 75])
def test_poor_angles_are_swept_where_nothing_better_is_found(degrees):
    """Beyond 65 degrees off its type an edge is taken only in a scheme that can be laid out; the mesh then is valid."""
    shape = as_model(slanted(degrees).exportBrepToString())
    found = sweepmesh.assess(shape)
    assert found.is_sweepable, [reason.text for reason in found.reasons]
    result = sweepmesh.mesh(shape)
    assert result.assessment.is_sweepable
    expect_valid_sweep(result, shape)
    if degrees < 60:
        assert not result.warnings


def named(shape, name):
    """The face, edge or vertex of that name."""
    kind, number = name.rstrip("0123456789"), int(name.lstrip("FaceEdgVrtx"))
    return {"Face": shape.Faces, "Edge": shape.Edges, "Vertex": shape.Vertexes}[kind][number - 1]


def read_shape(case):
    """The solid for FreeCAD."""
    shape = Part.Shape()
    shape.read(str(case.path))
    return shape


def refused(name, scheme=-1):
    """(shape, entities of the first reason) of a solid of the gallery."""
    case = next(c for c in single_solids("unsweepable") if c.name == name and c.scheme == scheme)
    model, shape = sweepmesh.read(case.path), read_shape(case)
    reason = sweepmesh.assess(model, Options(**case.picks(model))).reasons[0]
    return case, shape, [named(shape, entity) for entity in reason.entities]


@pytest.mark.parametrize("name, radii", [("sphere_two_voids", [8, 8, 30]), ("sphere_three_voids", [7, 7, 7, 32])])
def test_shells_that_nothing_links_are_named_all(name, radii):
    _, _, entities = refused(name)
    assert sorted(round(face.Surface.Radius, 6) for face in entities) == radii


def test_the_drilled_ball_names_its_round_face():
    _, _, entities = refused("genus3_cross_drilled")
    assert [round(face.Surface.Radius, 6) for face in entities if isinstance(face, Part.Face)] == [30]
    assert all(isinstance(entity, Part.Face) for entity in entities)


@pytest.mark.parametrize("scheme", [-1, 0])
def test_the_curved_hole_names_its_wall_and_a_straight_edge(scheme):
    _, shape, entities = refused("curved_through_hole", scheme)
    faces = [entity for entity in entities if isinstance(entity, Part.Face)]
    edges = [entity for entity in entities if isinstance(entity, Part.Edge)]
    bent = [face for face in shape.Faces if not isinstance(face.Surface, Part.Plane)]
    assert len(faces) == 1 and len(edges) == 2
    assert any(faces[0].isSame(face) for face in bent), "not the wall of the hole"
    seam = max(edges, key=lambda edge: edge.Length)
    assert any(seam.isSame(edge) for edge in faces[0].Edges) and seam.Length > 70
    straight = min(edges, key=lambda edge: edge.Length)
    assert abs(straight.Length - 70) < 1e-6 and abs(abs(straight.tangentAt(0).z) - 1) < 1e-6


def test_impossible_pairs_name_the_pair_and_the_walls_between():
    case, shape, entities = refused("prescribed_mismatch", 0)
    pair = entities[:2]
    assert sorted(round(face.CenterOfMass.z, 6) for face in pair) == [0, 36]
    wanted = case.entry["schemes"][0]
    tops = [FreeCAD.Vector(*point) for point in wanted["sources"]]
    feet = [FreeCAD.Vector(*point) for point in wanted["targets"]]
    source, target = sorted(pair, key=lambda face: -face.CenterOfMass.z)
    assert any(
        source.distToShape(Part.Vertex(tops[i]))[0] < 1e-6 and target.distToShape(Part.Vertex(feet[k]))[0] < 1e-6
        for i, k in wanted["pairs"]
    ), "not a pair that was picked"
    walls = entities[2:]
    assert walls and all(abs(face.normalAt(0, 0).z) < 1e-6 for face in walls)
    assert all(wall.distToShape(target)[0] < 1e-6 for wall in walls), "a wall that does not stand on the target"

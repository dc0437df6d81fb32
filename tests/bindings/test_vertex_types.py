"""Vertex types as the user wants them: kept by plan and mesh, or refused in one sentence that names the vertices."""

import Part
import pytest
from checker import expect_valid_sweep
from FreeCAD import Vector

from sweepmesh import InputError, Model, Options, mesh
from sweepmesh.engine import assess, plan

OUTLINE = [(0, 0), (60, 0), (80, 20), (80, 60), (0, 60)]


def chamfered_block():
    """A block with a chamfer along one edge: swept along y, the chamfer may be a linking face or one more target."""
    points = [Vector(x, y, 0) for x, y in [*OUTLINE, OUTLINE[0]]]
    return Part.Face(Part.makePolygon(points)).extrude(Vector(0, 0, 24))


def number_of(items, point):
    """The number of the face or vertex at a point."""
    return 1 + min(range(len(items)), key=lambda i: items[i].distToShape(Part.Vertex(*point))[0])


SHAPE = chamfered_block()
FRONT, CHAMFER, TOP = (number_of(SHAPE.Faces, point) for point in ((40, 30, 24), (70, 10, 12), (40, 60, 12)))
FIRST, SECOND = (number_of(SHAPE.Vertexes, (*point, 24)) for point in ((60, 0), (80, 20)))

# The types at the chamfer's two corners, and what the chamfer becomes by them.
CHOICES = {"linking": ("end", "side"), "target": ("side", "end")}


def options(first, second, form="names"):
    """Options with types at the chamfer's corners, in each form that a user may give them."""
    triples = [(FRONT, FIRST, first), (FRONT, SECOND, second)]
    named = [(f"Face{face}", f"Vertex{vertex}", kind.upper()) for face, vertex, kind in triples]
    forms = {
        "numbers": triples,
        "names": named,
        "dict": {(face, vertex): kind for face, vertex, kind in named},
    }
    return Options(size=5.0, sources=[TOP], vertex_types=forms[form])


@pytest.mark.parametrize("form", ["numbers", "names", "dict"])
@pytest.mark.parametrize("role", CHOICES)
def test_types_hold_in_the_plan(role, form):
    planned = plan(SHAPE.exportBrepToString(), options(*CHOICES[role], form))
    found = {(face, vertex): kind for face, vertex, kind in planned.corners}
    assert tuple(found[f"Face{FRONT}", f"Vertex{vertex}"] for vertex in (FIRST, SECOND)) == CHOICES[role]
    roles = planned.assessment.roles
    assert (roles[f"Face{FRONT}"], roles[f"Face{CHAMFER}"]) == ("linking", role)


@pytest.mark.parametrize("role", CHOICES)
def test_types_hold_in_the_mesh(role):
    model = Model.from_brep(SHAPE.exportBrepToString(), 0)
    result = mesh(model, options(*CHOICES[role]))
    expect_valid_sweep(result, model, genus=[0])
    assert result.assessment.roles[f"Face{CHAMFER}"] == role


def test_types_of_several_solids_go_to_their_own():
    other = Part.makeBox(20, 20, 20, Vector(200, 0, 0))
    both = Part.makeCompound([other, SHAPE])
    face, vertex = FRONT + len(other.Faces), FIRST + len(other.Vertexes)
    planned = plan(both.exportBrepToString(), Options(size=5.0, vertex_types={(face, vertex): "side"}))
    assert (f"Face{face}", f"Vertex{vertex}", "side") in planned.corners


def brick_types(*triples):
    return Options(size=10.0, vertex_types=list(triples))


def test_types_that_cannot_hold_together_are_named():
    """The corners of a face of four sides are all END."""
    found = assess(Part.makeBox(60, 40, 20).exportBrepToString(), brick_types((1, 1, "side"), (1, 2, "end")))
    (reason,) = found.reasons
    assert found.verdict == "unsweepable" and reason.kind == "prescribed"
    assert reason.entities == ["Vertex1", "Face1"] and "Vertex1 of Face1 as SIDE" in reason.text


WRONG = {
    "two types": ([(1, 1, "side"), (1, 1, "end")], "as SIDE and as END", ["Vertex1", "Face1"]),
    "vertex of another face": ([(1, 8, "end")], "Vertex8 is not a vertex of Face1", ["Vertex8", "Face1"]),
    "unknown face": ([(9, 1, "end")], "Face9", ["Face9"]),
    "unknown vertex": ([(1, 99, "end")], "Vertex99", ["Vertex99", "Face1"]),
    "unknown type": ([(1, 1, "round")], "round", []),
    "no name": ([("Edge1", 1, "end")], "Edge1", []),
    "no triples": ([("Face1", "end")], "vertex types", []),
}


@pytest.mark.parametrize("what", WRONG)
def test_wrong_types_are_input_errors(what):
    triples, words, entities = WRONG[what]
    for call in (assess, plan, mesh):
        with pytest.raises(InputError, match=f"(?i){words}") as caught:
            call(Part.makeBox(60, 40, 20).exportBrepToString(), brick_types(*triples))
        assert str(caught.value).endswith(".") and list(caught.value.entities) == entities

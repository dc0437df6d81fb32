"""What a refusal offers as the way out, followed by machine: it leads to a valid mesh."""

import itertools
import re

import Part
import pytest
import sweepmesh
from checker import expect_valid_sweep
from random_solids import make
from solids.kit import box, polygon, rod, vec
from sweepmesh import Options
from sweepmesh.engine import plan
from sweepmesh.engine.model import as_model
from ways_out import way_out

# "this vertex as CORNER"

TYPES = ("end", "side", "corner", "reversal")


def l_block():
    return Part.Face(polygon([(0, 0), (40, 0), (40, 10), (15, 10), (15, 30), (0, 30)])).extrude(vec(0, 0, 20))


def stepped():
    return box(0, 40, 0, 30, 0, 10).fuse(box(10, 25, 8, 20, 10, 22)).removeSplitter()


def ridge():
    return Part.Face(polygon([(0, 0), (30, 0), (30, 12), (15, 20), (0, 12)])).extrude(vec(0, 0, 25))


SOLIDS = {"brick": lambda: Part.makeBox(60, 40, 20), "l_block": l_block, "stepped": stepped, "ridge": ridge}


def refused_types(shape):
    """(types, reason) of single vertex types, on the faces as they are linked without any, that cannot hold."""
    text = shape.exportBrepToString()
    planned = plan(text, Options())
    for face, vertex, kind in planned.corners[:24]:
        for other in TYPES:
            if other.upper() == kind.upper():
                continue
            types = [(face, vertex, other.upper())]
            found = sweepmesh.assess(text, Options(vertex_types=types))
            if not found.is_sweepable:
                yield types, found.reasons[0]


@pytest.mark.parametrize("name", SOLIDS)
def test_the_offered_vertex_type_leads_to_a_mesh(name):
    shape = SOLIDS[name]()
    model = as_model(shape.exportBrepToString())
    followed = set()
    for types, reason in itertools.islice(refused_types(shape), 6):
        assert reason.kind == "prescribed" and f"{types[0][1]} of {types[0][0]}" in reason.text
        offer = re.search(r"It can with (Vertex\d+) of (Face\d+) as ([A-Z]+)\.", reason.text)
        assert offer, reason.text
        vertex, face, kind = offer.groups()
        assert (face, vertex) == types[0][:2] and kind != types[0][2]
        if (face, vertex, kind) in followed:
            continue
        followed.add((face, vertex, kind))
        result = sweepmesh.mesh(model, Options(vertex_types=[(face, vertex, kind)]))
        assert result.assessment.is_sweepable, result.assessment.reasons[0].text
        expect_valid_sweep(result, model)
    assert followed


# "pick this face too"


def numbers(text):
    return [int(number) for number in re.findall(r"Face(\d+)", text)]


def refused_picks(model):
    """(sources, targets, reason) of pairs of faces that cannot be source and target."""
    n_faces = len(model.faces)
    for source, target in itertools.permutations(range(1, n_faces + 1), 2):
        found = sweepmesh.assess(model, Options(sources=[source], targets=[target]))
        if not found.is_sweepable and "It can with" in found.reasons[0].text:
            yield source, target, found.reasons[0]


@pytest.mark.parametrize("name", ["l_block", "stepped"])
def test_the_offered_faces_lead_to_a_mesh(name):
    model = as_model(SOLIDS[name]().exportBrepToString())
    followed = set()
    for source, target, reason in itertools.islice(refused_picks(model), 12):
        offer = re.search(r"It can with (.*) as sources and (.*) as targets\.", reason.text)
        assert reason.kind == "prescribed" and offer, reason.text
        assert set(reason.entities) <= {f"Face{source}", f"Face{target}"}
        sources, targets = (tuple(numbers(part)) for part in offer.groups())
        if len(reason.entities) == 1:
            kept = ({source, target} - {numbers(reason.entities[0])[0]}).pop()
            assert kept in (sources if kept == source else targets), "what was not to blame is given up"
        if (sources, targets) in followed:
            continue
        followed.add((sources, targets))
        result = sweepmesh.mesh(model, Options(sources=list(sources), targets=list(targets)))
        assert result.assessment.is_sweepable, result.assessment.reasons[0].text
        expect_valid_sweep(result, model)
    assert followed


# "cut here"


def holed(axis=(0, 0, 1), degrees=0.0, apart=10):
    """Figure 7.5: a hollow within, which a radial sweep could serve, and beside it a bore from end to end, which a regular
    one could: not both at once."""
    block = box(-20, 20, -15, 15, -10, 10).cut(Part.makeSphere(5, vec(-apart, 0, 0)))
    block = block.cut(rod(3, vec(apart, 0, -30), 60))
    block.rotate(vec(0, 0, 0), vec(*axis), degrees)
    return block


@pytest.mark.parametrize("axis, degrees, apart", [((0, 0, 1), 0, 10), ((1, 2, 3), 50, 10), ((1, 0, 0), 90, 8)])
def test_a_hollow_beside_a_bore_is_cut_between_them(axis, degrees, apart):
    """Neither radially nor regularly, but both after a cut."""
    shape = holed(axis, degrees, apart)
    found = sweepmesh.assess(shape.exportBrepToString())
    assert not found.is_sweepable and found.reasons[0].kind == "topological"
    hollow = [f"Face{i}" for i, face in enumerate(shape.Faces, 1) if isinstance(face.Surface, Part.Sphere)]
    assert found.reasons[0].entities == hollow
    outcome, text = way_out(shape)
    assert outcome == "led", text


def test_no_offered_cut_leads_nowhere():
    outcomes = {seed: way_out(make("primitives", seed)) for seed in range(41000, 41030)}
    lost = {seed: text for seed, (outcome, text) in outcomes.items() if outcome == "lost"}
    assert not lost
    assert any(outcome == "led" for outcome, _ in outcomes.values())

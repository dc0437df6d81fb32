"""The figures of chapter 6 and A.2: vertex types of a face by itself, and the face as a linking face of a sweep.

The plates of the gallery are swept across their thickness elsewhere; here along their plane, so that the figure's
face is a linking face and its types are those of the sweep.
"""

import collections

import pytest
from checker import expect_valid_sweep
from gallery import Case, find_judge, manifest

import sweepmesh
from sweepmesh.engine import InputError, Options, face_at, face_types, plan

JUDGE = find_judge()
TURN = {"end": 1, "side": 0, "corner": -1, "reversal": -2}
ENTRIES = manifest()
NEAR = 1e-3


class Figure:
    """A plate with the record of the face that the figure shows."""

    def __init__(self, name):
        self.case = Case(name, ENTRIES[name])
        self.model = sweepmesh.read(self.case.path)
        self.record = ENTRIES[name]["submap"]
        self.face = f"Face{face_at(self.model, self.record['face'])}"

    def vertex(self, x, y):
        """The name of the vertex at a place of the face."""
        z = self.record["face"][2]
        points = [self.model.vertex_point(i) for i in range(self.model.n_vertices)]
        nearest = min(range(len(points)), key=lambda i: distance(points[i], (x, y, z)))
        return f"Vertex{nearest + 1}"

    def along_its_plane(self, types=(), coarser=2.0):
        """Options of a sweep that has the face as a linking face with these types, {(x, y): type}."""
        picks = {(self.face, self.vertex(*at)): kind for at, kind in dict(types).items()}
        return Options(size=coarser * self.case.size, vertex_types=picks)


def distance(a, b):
    return sum((x - y) ** 2 for x, y in zip(a, b)) ** 0.5


def expect_mesh(figure, options, folder):
    """A valid mesh, to the judge too, in which the figure's face is a linking face."""
    result = sweepmesh.mesh(figure.model, options)
    expect_valid_sweep(result, figure.model, figure.case.genus)
    assert result.assessment.roles[figure.face] == "linking"
    if JUDGE:
        sweepmesh.write(result, folder / "mesh.vtu")
        assert JUDGE(str(folder / "mesh.vtu"), str(figure.case.path))["failures"] == []


def types_in_plan(figure, options):
    """{(x, y): type} of the face's corners, virtual ones too, in the plan of a sweep."""
    made = plan(figure.model, options)
    points = figure.model.vertex_point
    found = {
        tuple(round(float(x), 2) for x in points(int(vertex[6:]) - 1)[:2]): kind
        for face, vertex, kind in made.corners
        if face == figure.face
    }
    virtual = {
        tuple(round(x, 2) for x in corner.point[:2]): corner.type
        for corner in made.virtual_corners
        if corner.face == figure.face
    }
    return found, virtual


@pytest.mark.parametrize(
    "name, templates",
    [
        ("ambiguous_angles_plate", True),  # 6.1, 6.8
        ("reversal_to_side_plate", False),  # 6.6: as in the figure, the shoulders have no virtual vertices
        ("fillet_round_chamfer_plate", True),  # 6.3, 6.7
        ("multiply_connected_plate", True),  # 6.4
        ("corner_to_side_plate", True),  # A.2
    ],
)
def test_a_face_by_itself_gets_the_types_of_its_figure(name, templates):
    figure = Figure(name)
    corners = face_types(figure.model, figure.face, templates=templates)
    expected = figure.record["vertices"] + (figure.record["virtual_vertices"] if templates else [])
    assert len(corners) == len(expected)
    for item in expected:
        corner = min(corners, key=lambda corner: distance(corner.point, item["point"]))
        assert distance(corner.point, item["point"]) < NEAR
        assert corner.type == item["expected"].lower(), item
    assert sum(TURN[corner.type] for corner in corners) == 4 - 4 * figure.record["holes"]


def test_figure_6_1_both_classifications_are_reachable(tmp_path):
    """One by default, the other by the user's types; both are meshed as linking faces."""
    figure = Figure("ambiguous_angles_plate")
    foot, top = (50, 20), (30, 38)
    stepped, flat = {foot: "corner", top: "end"}, {foot: "side", top: "side"}
    by_default = face_types(figure.model, figure.face)
    given = {(figure.face, figure.vertex(*at)): kind for at, kind in flat.items()}
    by_user = face_types(figure.model, figure.face, given)
    for corners, wanted in ((by_default, stepped), (by_user, flat)):
        types = {corner.vertex: corner.type for corner in corners}
        assert all(types[figure.vertex(*at)] == kind for at, kind in wanted.items())
    for number, wanted in enumerate((stepped, flat)):
        options = figure.along_its_plane(wanted)
        found, _ = types_in_plan(figure, options)
        assert found[foot] == wanted[foot] and found[top] == wanted[top]
        folder = tmp_path / str(number)
        folder.mkdir()
        expect_mesh(figure, options, folder)


def test_figure_6_6_is_solved_by_ours_and_not_by_the_older_model(tmp_path):
    """The cusp of 350 degrees becomes SIDE, a change of two; bound to one, only an END on a straight shoulder is left."""
    figure = Figure("reversal_to_side_plate")
    cusp = figure.vertex(45, 38)
    ours = {corner.vertex: corner for corner in face_types(figure.model, figure.face, templates=False)}
    assert ours[cusp].nearest == "reversal" and ours[cusp].type == "side"
    assert all(corner.angle < 175 for corner in ours.values() if corner.type == "end")
    older = face_types(figure.model, figure.face, templates=False, older_model=True)
    changes = {corner.vertex: abs(TURN[corner.type] - TURN[corner.nearest]) for corner in older}
    assert max(changes.values()) <= 1 and changes[cusp] <= 1
    impossible = [corner for corner in older if corner.type == "end" and corner.angle > 175]
    assert impossible, "the older model found types that its angles allow"
    options = figure.along_its_plane({(45, 38): "side"})
    assert types_in_plan(figure, options)[0][45, 38] == "side"
    expect_mesh(figure, options, tmp_path)


def test_figure_6_7_all_five_templates_in_one_sweep(tmp_path):
    """Quarter, half and three-quarter rounds, a fillet, a full circle and a chamfer, in one linking face."""
    figure = Figure("fillet_round_chamfer_plate")
    chamfer = {(12, 0): "end", (0, 12): "side"}  # a sweep's chamfer turns at its own vertices
    options = figure.along_its_plane(chamfer)
    found, virtual = types_in_plan(figure, options)
    assert {at: found[at] for at in chamfer} == chamfer
    rounds = [
        (tuple(round(x, 2) for x in item["point"][:2]), item["expected"].lower())
        for item in figure.record["virtual_vertices"]
        if distance(item["point"][:2], (6, 6)) > NEAR
    ]
    assert len(rounds) == 1 + 2 + 3 + 1 + 4
    for at, kind in rounds:
        near = min(virtual, key=lambda place: distance(place, at))
        assert distance(near, at) < 0.5 and virtual[near] == kind, at
    expect_mesh(figure, options, tmp_path)


@pytest.mark.parametrize("name", ["corner_to_side_plate", "multiply_connected_plate"])  # A.2, section 6.4
def test_the_face_is_a_linking_face_of_a_sweep(name, tmp_path):
    figure = Figure(name)
    types = {tuple(item["point"][:2]): item["expected"].lower() for item in figure.record["vertices"]}
    options = figure.along_its_plane(types)
    assert types_in_plan(figure, options)[0] == {tuple(round(x, 2) for x in at): kind for at, kind in types.items()}
    expect_mesh(figure, options, tmp_path)


def test_figure_a_2_a_user_cannot_hold_what_does_not_close():
    """The notch as CORNER with END at all other vertices adds up to three; the sentence names the vertices."""
    figure = Figure("corner_to_side_plate")
    given = {(figure.face, figure.vertex(*at)): "end" for at in ((0, 0), (80, 0), (80, 50), (0, 50))}
    given[figure.face, figure.vertex(40, 24)] = "corner"
    with pytest.raises(InputError) as caught:
        face_types(figure.model, figure.face, given)
    assert figure.vertex(40, 24) in caught.value.entities and str(caught.value).endswith(".")


def test_figure_6_9_a_gear_with_a_keyway():
    """The hub is a circle less a keyway: four CORNERs in its middle, END where the keyway leaves it."""
    model = sweepmesh.read(Case("gear", ENTRIES["gear"]).path)
    top = face_at(model, ENTRIES["gear"]["schemes"][0]["sources"][0])
    corners = face_types(model, top)
    hub = [corner for corner in corners if corner.loop == 1]
    count = collections.Counter((corner.vertex is None, corner.type) for corner in hub)
    assert count == {(True, "corner"): 4, (False, "corner"): 2, (False, "end"): 2}
    assert all(corner.type == corner.nearest for corner in hub)
    assert sum(TURN[corner.type] for corner in corners) == 0


@pytest.mark.parametrize("name", ["gear", "bearing_block", "blade_twist", "l_bracket"])  # 6.9, 6.10, 6.11, 6.2
def test_linking_faces_of_parts_close(name):
    """Around every linking face the types add up to 4 - 4 g, or to 0 where it closes around a hole."""
    case = Case(name, ENTRIES[name])
    made = plan(sweepmesh.read(case.path), Options(size=2 * case.size))
    sums = collections.Counter()
    for face, _, kind in made.corners:
        sums[face] += TURN[kind]
    for corner in made.virtual_corners:
        sums[corner.face] += TURN[corner.type]
    linking = [face for face, role in made.assessment.roles.items() if role == "linking"]
    assert linking and all(sums[face] % 4 == 0 and sums[face] <= 4 for face in linking)

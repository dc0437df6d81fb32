"""Model: the numbers of FreeCAD, and clear errors for what is no solid."""

import Part
import pytest
from FreeCAD import Vector

from sweepmesh import InputError, Model, SweepMeshError, face_at, read

SHAPES = {
    "brick": lambda: Part.makeBox(6, 4, 2.5),
    "cylinder": lambda: Part.makeCylinder(2, 5),
    "ball": lambda: Part.makeSphere(3),
    "tube": lambda: Part.makeCylinder(2, 5).cut(Part.makeCylinder(1, 5)),
    "torus": lambda: Part.makeTorus(5, 1),
}


@pytest.fixture(params=SHAPES)
def shape(request):
    """One solid of the family as a Part.Shape."""
    return SHAPES[request.param]()


@pytest.fixture(params=["brep", "step", "brep file"])
def model(request, shape, tmp_path):
    """Its Model, each way that it can come in."""
    if request.param == "brep":
        return Model.from_brep(shape.exportBrepToString(), 0)
    path = tmp_path / ("shape.step" if request.param == "step" else "shape.brep")
    shape.exportStep(str(path)) if request.param == "step" else shape.exportBrep(str(path))
    return read(path)


def test_faces_have_the_numbers_of_freecad(shape, model):
    assert model.n_faces == len(shape.Faces)
    assert model.n_edges == len(shape.Edges)
    assert model.n_vertices == len(shape.Vertexes)
    for i, face in enumerate(shape.Faces):
        assert model.area(i) == pytest.approx(face.Area, rel=1e-6)
        u0, u1, v0, v1 = face.ParameterRange
        point = tuple(face.valueAt(0.4 * u0 + 0.6 * u1, 0.3 * v0 + 0.7 * v1))
        if face.distToShape(Part.Vertex(*point))[0] < 1e-9:
            assert face_at(model, point) == i + 1
            assert model.distance_to_face(i, point) == pytest.approx(0, abs=1e-7)


def test_a_model_knows_its_solid(shape, model):
    assert model.n_solids == 1
    assert model.faces == list(range(len(shape.Faces)))
    assert model.volume == pytest.approx(shape.Volume, rel=1e-6)
    assert model.model_size >= shape.BoundBox.DiagonalLength * 0.99


def test_distances_to_edges_and_vertices():
    shape = SHAPES["brick"]()
    model = Model.from_brep(shape.exportBrepToString(), 0)
    for i, edge in enumerate(shape.Edges):
        middle = edge.valueAt(edge.FirstParameter + edge.Length / 2)
        assert model.distance_to_edge(i, tuple(middle)) == pytest.approx(0, abs=1e-9)
        assert model.distance_to_edge(i, (3, 2, 1.25)) == pytest.approx(
            edge.distToShape(Part.Vertex(3, 2, 1.25))[0], abs=1e-9
        )
    for i, vertex in enumerate(shape.Vertexes):
        assert tuple(model.vertex_point(i)) == pytest.approx(tuple(vertex.Point))


NO_SOLIDS = {
    "nothing": lambda: "",
    "noise": lambda: "DBRep_DrawableShape\n\nCASCADE Topology V1, 1\nLocations 7\n",
    "face": lambda: Part.makePlane(2, 3).exportBrepToString(),
    "wire": lambda: Part.makePolygon([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 0)]).exportBrepToString(),
    "open shell": lambda: Part.Shell(Part.makeBox(1, 1, 1).Faces[:5]).exportBrepToString(),
    "solid of an open shell": lambda: Part.Solid(Part.Shell(Part.makeBox(1, 1, 1).Faces[:5])).exportBrepToString(),
}


@pytest.mark.parametrize("kind", NO_SOLIDS)
def test_what_is_no_solid_is_an_input_error(kind):
    with pytest.raises(InputError) as caught:
        Model.from_brep(NO_SOLIDS[kind](), 0)
    assert isinstance(caught.value, SweepMeshError) and isinstance(caught.value, RuntimeError)
    assert caught.value.stage == "read"
    assert str(caught.value).endswith(".") and "\n" not in str(caught.value)


def test_a_solid_that_is_not_there_is_an_input_error():
    with pytest.raises(InputError):
        Model.from_brep(SHAPES["brick"]().exportBrepToString(), 1)


def test_the_solids_of_a_compound_keep_their_own_faces():
    first, second = Part.makeBox(1, 1, 1), Part.makeCylinder(1, 1, Vector(5, 0, 0))
    text = Part.Compound([first, second]).exportBrepToString()
    assert [Model.from_brep(text, i).faces for i in (0, 1)] == [list(range(6)), [6, 7, 8]]
    assert Model.from_brep(text, 1).volume == pytest.approx(second.Volume)

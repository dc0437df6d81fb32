"""What is prescribed for single edges: in settings, in properties, in the mesh, and through saving."""
import FreeCAD
import numpy
import Part
import pytest

from sweepmesh import app, engine
from sweepmesh.app import overrides
from sweepmesh.app.objects.sweep import options_of

UPRIGHT = "Edge1"  # of the fixture's box: along z
FIXED = {"sources": ["Face6"], "targets": ["Face5"]}


def heights(sweep):
    """z of the nodes at the corner x = y = 0, ascending."""
    return numpy.sort([p.z for p in sweep.FemMesh.Nodes.values() if abs(p.x) + abs(p.y) < 1e-9])


def test_a_count_is_kept_exactly(box):
    sweep = app.make_sweep_mesh(box, size=1.0, edge_count={UPRIGHT: 7}, **FIXED)
    assert sweep.EdgeCounts == ["Edge1=7"]
    assert len(heights(sweep)) == 8 and sweep.Hexahedra == 10 * 4 * 7


def test_a_size_is_that_of_its_edge(box):
    sweep = app.make_sweep_mesh(box, size=1.0, edge_size={1: 0.25}, **FIXED)
    assert sweep.EdgeSizes == ["Edge1=0.25"] and len(heights(sweep)) == 9


def test_a_bias_is_that_of_its_edge(box):
    sweep = app.make_sweep_mesh(box, size=0.5, edge_bias={box.Shape.Edges[0]: 2.0}, **FIXED)
    steps = numpy.diff(heights(sweep))
    assert sweep.EdgeBiases == ["Edge1=2.0"]
    assert steps[1:] / steps[:-1] == pytest.approx(2.0) or steps[:-1] / steps[1:] == pytest.approx(2.0)


def test_a_bias_of_the_sweep_reaches_every_edge_along_it(box):
    sweep = app.make_sweep_mesh(box, size=0.5, sweep_bias=1.5, **FIXED)
    steps = numpy.diff(heights(sweep))
    assert steps[1:] / steps[:-1] == pytest.approx(1.5)
    assert (sweep.SweepBias, sweep.SweepBiasBoth) == (1.5, False)


def test_properties_can_be_edited_by_hand(box, document):
    sweep = app.make_sweep_mesh(box, size=1.0, **FIXED)
    sweep.EdgeCounts = ["Edge1 = 5"]
    sweep.SweepBias, sweep.SweepBiasBoth = 1.2, True
    document.recompute()
    steps = numpy.diff(heights(sweep))
    assert steps == pytest.approx(steps[::-1]) and steps[1] / steps[0] == pytest.approx(1.2)


@pytest.mark.parametrize(
    "name, text",
    [("EdgeCounts", "Edge1"), ("EdgeCounts", "Face1=3"), ("EdgeCounts", "Edge1=1.5"), ("EdgeSizes", "Edge=2"),
     ("EdgeBiases", "Edge1=1.2 all"), ("EdgeBiases", "Edge0=1.2"), ("VertexTypes", "Face3=corner"),
     ("VertexTypes", "Face3:Vertex7="), ("VertexTypes", "Face3:Edge7=end"), ("VertexTypes", "Face3:Vertex1=round")],
)
def test_a_text_that_says_nothing_is_told(box, document, name, text):
    sweep = app.make_sweep_mesh(box, size=1.0, **FIXED)
    setattr(sweep, name, [text])
    document.recompute()
    assert not sweep.isValid() and text.partition("=")[2] in sweep.Message
    assert (text in sweep.Message and name in sweep.Message) or "vertex type" in sweep.Message
    assert sweep.FemMesh.HexaCount == 80


def test_an_edge_that_is_not_there_is_told_and_the_mesh_stays(box, document):
    sweep = app.make_sweep_mesh(box, size=1.0, **FIXED)
    sweep.EdgeCounts = ["Edge99=3"]
    document.recompute()
    assert not sweep.isValid() and "Edge99" in sweep.Message and sweep.FemMesh.HexaCount == 80
    with pytest.raises(engine.InputError):
        app.plan(box, edge_count={"Edge99": 3})


def test_demands_that_contradict_each_other_are_told(box):
    sweep = app.make_sweep_mesh(box, size=1.0, edge_count={"Edge1": 7, "Edge3": 4}, **FIXED)
    assert not sweep.isValid() and "Edge" in sweep.Message


SETTINGS = {
    "edge_count": {1: 7},
    "edge_size": {2: 1 / 3, 4: 0.7},
    "edge_bias": {1: (1.1, True), 3: (1 / 1.3, False)},
    "vertex_types": {(1, 1): "end", (3, 2): "end"},
    "sweep_bias": (1.2, True),
    "imprint_tolerance": 0.125,
}


def test_all_survive_saving(box, document, tmp_path):
    sweep = app.make_sweep_mesh(box, size=1.0, **SETTINGS)
    path = str(tmp_path / "saved.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    options = options_of(FreeCAD.openDocument(path).SweepMesh)
    assert {name: getattr(options, name) for name in SETTINGS} == SETTINGS


def test_undo_takes_them_back(box, document):
    document.UndoMode = 1
    sweep = app.make_sweep_mesh(box, size=1.0, **FIXED)
    document.openTransaction("more")
    app.update_sweep_mesh(sweep, edge_count={"Edge1": 7}, sweep_bias=1.5)
    document.commitTransaction()
    assert sweep.FemMesh.HexaCount == 280
    document.undo()
    assert (sweep.EdgeCounts, sweep.SweepBias, sweep.FemMesh.HexaCount) == ([], 1.0, 80)
    document.redo()
    assert (sweep.EdgeCounts, sweep.SweepBias, sweep.FemMesh.HexaCount) == (["Edge1=7"], 1.5, 280)


def test_they_can_be_taken_away(box):
    sweep = app.make_sweep_mesh(box, size=1.0, **SETTINGS)
    app.update_sweep_mesh(
        sweep, edge_count={}, edge_size={}, edge_bias=None, vertex_types={}, sweep_bias=None, imprint_tolerance=None
    )
    options, plain = options_of(sweep), engine.Options()
    assert all(getattr(options, name) == getattr(plain, name) for name in SETTINGS)


@pytest.mark.parametrize("name, values", [(name, SETTINGS[name]) for name in overrides.PROPERTIES])
def test_texts_and_settings_are_the_same(name, values):
    assert overrides.from_texts(name, overrides.to_texts(values)) == values


def stairs(document):
    """A solid with one inner corner along y, at (10, y, 6)."""
    corners = [(0, 0, 0), (20, 0, 0), (20, 0, 6), (10, 0, 6), (10, 0, 14), (0, 0, 14), (0, 0, 0)]
    obj = document.addObject("Part::Feature", "Stairs")
    obj.Shape = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 8, 0))
    return obj


def test_a_vertex_type_changes_how_the_solid_is_swept(document):
    obj = stairs(document)
    front = next(i for i, face in enumerate(obj.Shape.Faces, 1) if face.normalAt(0, 0).y < -0.9)
    inner = next(i for i, v in enumerate(obj.Shape.Vertexes, 1) if v.Point.isEqual(FreeCAD.Vector(10, 0, 6), 1e-6))
    types = {(f, v): kind for f, v, kind in app.plan(obj, size=2.0).details.corners}
    assert (f"Face{front}", f"Vertex{inner}") not in types, "the front is a cap where nothing is prescribed"
    sweep = app.make_sweep_mesh(obj, size=2.0, vertex_types={(f"Face{front}", f"Vertex{inner}"): "corner"})
    assert sweep.isValid() and sweep.VertexTypes == [f"Face{front}:Vertex{inner}=corner"]
    assert sweep.Roles[f"Face{front}"] == "linking" and sweep.Hexahedra > 0

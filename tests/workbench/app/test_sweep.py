"""The document object: settings, links, recompute, failure, save and reopen."""
import types

import FreeCAD
import pytest

from sweepmesh import app, engine
from sweepmesh.app.kept_meshes import KeptMeshes
from sweepmesh.app.objects.sweep import TABLE, Sweep, options_of


def reopened(document, tmp_path):
    path = str(tmp_path / "saved.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    return FreeCAD.openDocument(path)


@pytest.fixture
def sweep(box):
    return app.make_sweep_mesh(box, size=1.0)


def volume_of(fem_mesh):
    """Volume of the hexahedra by the divergence theorem over the boundary faces."""
    total = 0.0
    for face in fem_mesh.Faces:
        nodes = [fem_mesh.getNodeById(n) for n in fem_mesh.getElementNodes(face)]
        for i in range(1, len(nodes) - 1):
            total += nodes[0].dot(nodes[i].cross(nodes[i + 1])) / 6.0
    return total


def test_mesh_is_freecads_own_and_fills_the_solid(sweep, box):
    assert sweep.isDerivedFrom("Fem::FemMeshObject")
    assert sweep.isValid() and sweep.Message == ""
    assert sweep.Verdict == "sweepable" and sorted(sweep.Roles) == [f"Face{i}" for i in range(1, 7)]
    assert sweep.Hexahedra == sweep.FemMesh.HexaCount > 0
    assert sweep.Nodes == sweep.FemMesh.NodeCount
    assert sweep.MinScaledJacobian > 0 and sum(sweep.Histogram) == sweep.Hexahedra
    assert volume_of(sweep.FemMesh) == pytest.approx(box.Shape.Volume)


def test_polyhedra_are_refused_before_meshing(sweep, document):
    n_before = sweep.FemMesh.HexaCount
    sweep.Element = "polyhedron"
    document.recompute()
    assert not sweep.isValid() and "hold no polyhedra" in sweep.Message
    assert sweep.FemMesh.HexaCount == n_before


def test_it_keeps_to_picked_faces(box):
    sweep = app.make_sweep_mesh(box, size=1.0, sources=["Face2"], targets=[1])
    assert sweep.Sources == (box, ["Face2"]) and sweep.Targets == (box, ["Face1"])
    assert sweep.Roles["Face2"] == "source" and sweep.Roles["Face1"] == "target"


def test_a_change_of_the_shape_makes_a_new_mesh(sweep, box, document):
    before = sweep.Hexahedra
    box.Length = 20
    document.recompute()
    assert sweep.Hexahedra > before
    assert volume_of(sweep.FemMesh) == pytest.approx(box.Shape.Volume)


def test_a_moved_shape_moves_the_mesh(sweep, box, document):
    box.Placement.Base = FreeCAD.Vector(5, 6, 7)
    document.recompute()
    bounds = sweep.FemMesh.BoundBox
    assert (bounds.XMin, bounds.YMin, bounds.ZMin) == pytest.approx((5, 6, 7))


def test_what_changes_no_mesh_runs_no_mesher(sweep, document, monkeypatch):
    monkeypatch.setattr(engine, "mesh", lambda *_: pytest.fail("meshed again"))
    sweep.touch()
    document.recompute()
    assert sweep.isValid()


def test_settings_survive_save_and_reopen(box, document, tmp_path):
    app.make_sweep_mesh(box, size=1.0, layers=3, sources=["Face5"], targets=["Face6"], max_elements=5000, refuse_folds=False)
    count = document.SweepMesh.Hexahedra
    restored = reopened(document, tmp_path)
    sweep = restored.SweepMesh
    assert isinstance(sweep.Proxy, Sweep)
    assert (sweep.Size.Value, sweep.Layers, sweep.MaxElements, sweep.RefuseFolds) == (1.0, 3, 5000, False)
    assert sweep.Shape == restored.Brick and sweep.Sources == (restored.Brick, ["Face5"])
    assert sweep.FemMesh.HexaCount == count and sweep.isValid()
    names = [sweep.FemMesh.getGroupName(group) for group in sweep.FemMesh.Groups]
    assert "Solid" in names and "Face6" in names
    sweep.Layers = 4
    restored.recompute()
    assert sweep.Hexahedra == count // 3 * 4
    FreeCAD.closeDocument(restored.Name)


def test_a_document_without_some_properties_gets_them(sweep, document, tmp_path):
    sweep.removeProperty("Warnings")
    restored = reopened(document, tmp_path)
    assert "Warnings" in restored.SweepMesh.PropertiesList
    FreeCAD.closeDocument(restored.Name)


def test_a_failed_run_leaves_the_old_mesh_and_says_why(sweep, box, document):
    count = sweep.FemMesh.HexaCount
    sweep.MaxElements = 3
    document.recompute()
    assert not sweep.isValid() and sweep.Message
    assert sweep.FemMesh.HexaCount == count and sweep.Size.Value == 1.0
    sweep.MaxElements = 0
    document.recompute()
    assert sweep.isValid() and sweep.Message == ""


def test_an_unsweepable_solid_gives_the_reasons(sweep, document):
    sphere = document.addObject("Part::Sphere", "Ball")
    document.recompute()
    count = sweep.FemMesh.HexaCount
    sweep.Shape = sphere
    document.recompute()
    assert sweep.Verdict == "unsweepable" and sweep.Reasons
    assert not sweep.isValid() and sweep.Reasons[0] in sweep.Message
    assert sweep.FemMesh.HexaCount == count


@pytest.mark.parametrize("kind", ["deleted", "face of another", "not a face"])
def test_broken_links_are_told_in_one_sentence(sweep, box, document, kind):
    if kind == "deleted":
        document.removeObject(box.Name)
    elif kind == "face of another":
        other = document.addObject("Part::Box", "Other")
        document.recompute()
        sweep.Sources = (other, ["Face1"])
    else:
        sweep.Sources = (box, ["Edge1"])
    sweep.touch()
    document.recompute()
    assert not sweep.isValid() and sweep.Message.endswith(".")
    assert sweep.FemMesh.HexaCount > 0


def test_undo_takes_the_object_away_and_redo_brings_it_back(box, document):
    document.UndoMode = 1
    document.openTransaction("mesh")
    app.make_sweep_mesh(box, size=1.0)
    document.commitTransaction()
    count = document.SweepMesh.FemMesh.HexaCount
    document.undo()
    assert document.getObject("SweepMesh") is None
    document.redo()
    assert document.SweepMesh.FemMesh.HexaCount == count


def test_undo_of_a_setting_brings_the_old_mesh_back(sweep, document):
    document.UndoMode = 1
    count = sweep.FemMesh.HexaCount
    document.openTransaction("edit")
    app.update_sweep_mesh(sweep, layers=7)
    document.commitTransaction()
    changed = sweep.FemMesh.HexaCount
    document.undo()
    assert sweep.Layers == 0 and sweep.FemMesh.HexaCount == sweep.Hexahedra == count != changed
    document.redo()
    assert sweep.Layers == 7 and sweep.FemMesh.HexaCount == sweep.Hexahedra == changed


def test_undo_without_a_kept_mesh_is_put_right_by_a_recompute(sweep, document, monkeypatch):
    monkeypatch.setattr("sweepmesh.app.kept_meshes.KeptMeshes.get", lambda *_: None)
    document.UndoMode = 1
    count = sweep.FemMesh.HexaCount
    document.openTransaction("edit")
    app.update_sweep_mesh(sweep, layers=7)
    document.commitTransaction()
    document.undo()
    document.recompute()
    assert sweep.FemMesh.HexaCount == sweep.Hexahedra == count


def test_kept_meshes_are_let_go_oldest_first():
    kept = KeptMeshes(max_nodes=10)
    for key, n_nodes in (("a", 4), ("b", 5), ("c", 4)):
        kept.keep(key, types.SimpleNamespace(NodeCount=n_nodes))
    assert kept.get("a") is None and kept.get("b").NodeCount == 5 and kept.get("c").NodeCount == 4


def test_every_option_has_a_property_and_comes_back(box):
    picks = {"sources": [6], "targets": [5], "pairs": [(6, 5)], "solid": 1}
    options = engine.Options(size=1.0, layers=2, order=2, max_elements=999, **picks)
    mesh = app.make_sweep_mesh(box, options)
    assert mesh.isValid(), mesh.Message
    assert options_of(mesh) == options


def test_every_property_has_a_text_and_a_group(sweep):
    for row in TABLE:
        assert row.text and row.group
        assert sweep.getDocumentationOfProperty(row.name) and sweep.getGroupOfProperty(row.name) == row.group

"""The example macros run and do what they say."""
import pathlib

import FreeCAD
import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[3] / "Resources" / "examples"


@pytest.fixture
def run(monkeypatch, tmp_path):
    """Run a macro as FreeCAD does and return its names; its documents are closed after the test."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    before = set(FreeCAD.listDocuments())

    def execute(name):
        path = EXAMPLES / f"{name}.FCMacro"
        names = {"__name__": "__main__"}
        exec(compile(path.read_text(encoding="utf-8"), str(path), "exec"), names)
        return names

    yield execute
    for name in set(FreeCAD.listDocuments()) - before:
        FreeCAD.closeDocument(name)


def test_there_are_five_and_each_has_a_test_and_says_what_it_does():
    macros = sorted(path.stem for path in EXAMPLES.glob("*.FCMacro"))
    assert macros == sorted(name[len("test_") :] for name in globals() if name[len("test_") :] in macros)
    assert len(macros) >= 5
    assert all(path.read_text(encoding="utf-8").startswith('"""') for path in EXAMPLES.glob("*.FCMacro"))


def test_cantilever(run):
    names = run("cantilever")
    assert names["deflection"] == pytest.approx(names["theory"], rel=0.01)


def test_bent_pipe(run, tmp_path):
    mesh = run("bent_pipe")["mesh"]
    assert mesh.isValid() and mesh.MinScaledJacobian > 0
    assert {path.suffix for path in tmp_path.rglob("bent_pipe.*")} == {".unv", ".inp", ".vtk"}


def test_dimension_study(run):
    names = run("dimension_study")
    counts = [row[1] for row in names["table"]]
    assert len(set(counts)) > 1 and names["mesh"].isValid()
    assert all(row[2] > 0 for row in names["table"])


def test_size_study(run):
    table = run("size_study")["table"]
    assert [row[1] for row in table] == sorted(row[1] for row in table)
    assert all(row[2] > 0 for row in table)


def test_all_solids(run):
    FreeCAD.newDocument("Solids")
    cylinder, sphere = run("all_solids")["meshes"]
    assert cylinder.isValid() and cylinder.Hexahedra > 0
    assert not sphere.isValid() and sphere.Message

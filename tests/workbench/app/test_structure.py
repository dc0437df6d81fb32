"""The Python layers point one way: gui -> app -> engine; sizes stay in measure."""
import ast
import pathlib

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
PACKAGE = ROOT / "Mod" / "sweepmesh"

FORBIDDEN = {
    "engine": {"FreeCAD", "FreeCADGui", "PySide", "pivy", "sweepmesh.app", "sweepmesh.gui"},
    "app": {"FreeCADGui", "PySide", "PySide2", "pivy", "sweepmesh.gui", "sweepmesh.cli"},
    "gui": {"PySide2", "PySide6", "sweepmesh.cli"},
}


def imports(path):
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield node.module or ""


def modules(layer):
    return [path for path in sorted((PACKAGE / layer).rglob("*.py")) if "writers" not in path.parts]


@pytest.mark.parametrize("layer", FORBIDDEN)
def test_no_layer_imports_one_above_it(layer):
    wrong = [
        (path.relative_to(PACKAGE).as_posix(), name)
        for path in modules(layer)
        for name in imports(path)
        if any(name == other or name.startswith(other + ".") for other in FORBIDDEN[layer])
    ]
    assert wrong == []


@pytest.mark.parametrize("name, limit", [("Init.py", 40), ("InitGui.py", 60)])
def test_what_freecad_runs_at_its_start_is_short(name, limit):
    assert len((ROOT / name).read_text().splitlines()) <= limit


def test_functions_can_be_read_without_scrolling():
    long = [
        (path.name, node.name)
        for layer in ("app", "gui")
        for path in modules(layer)
        for node in ast.walk(ast.parse(path.read_text()))
        if isinstance(node, ast.FunctionDef) and node.end_lineno - node.lineno >= 40
    ]
    assert not long


def test_every_folder_says_what_may_live_in_it():
    folders = {path.parent for layer in ("app", "gui") for path in modules(layer)}
    assert all((folder / "README.md").is_file() for folder in folders)


def test_folders_of_the_root_hide_no_packages():
    assert not [folder for folder in ("Mod", "core", "tests", "bindings") if (ROOT / folder / "__init__.py").exists()]

"""Includes and imports run one way, down the pipeline, and outside libraries stay in their folders."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CORE = ROOT / "core" / "sweepmesh"

# Each stage with the stages whose headers it may include besides base and itself.
STAGES = {
    "base": set(),
    "model": set(),
    "numerics": set(),
    "scheme": {"model", "numerics"},
    "intervals": {"model", "numerics", "scheme"},
    "imprint": {"model", "numerics", "scheme", "intervals", "surface"},
    "surface": {"model", "numerics", "scheme", "intervals"},
    "volume": {"numerics", "surface", "quality"},
    "quality": {"model", "volume", "surface"},
}
STAGES["pipeline"] = set(STAGES)

# Header patterns of outside libraries and the folders that may include them (in .cpp files only).
LIBRARIES = {
    "OpenCASCADE": (r"\.hxx[\">]", ["model"]),
    "CGAL": (r"[<\"]CGAL/", ["numerics/cgal"]),
    "lp_solve": (r"lp_lib\.h", ["numerics/lp"]),
    "pybind11": (r"[<\"]pybind11/", []),
    "Python": (r"[<\"]Python\.h", []),
}

INCLUDE = re.compile(r'^\s*#\s*include\s+(["<].*[">])', re.M)


def sources():
    return sorted(p for p in CORE.rglob("*") if p.suffix in (".h", ".cpp"))


def stage_of(path):
    parts = path.relative_to(CORE).parts
    return parts[0] if len(parts) > 1 else None


def includes(path):
    return INCLUDE.findall(path.read_text())


@pytest.mark.parametrize("path", sources(), ids=lambda p: str(p.relative_to(CORE)))
def test_stage_includes_only_what_comes_before_it(path):
    stage = stage_of(path)
    allowed = STAGES[stage] | {"base", stage}
    used = {m.group(1) for inc in includes(path) if (m := re.match(r'["<]sweepmesh/(\w+)/', inc))}
    assert used <= allowed, f"{stage} must not include {sorted(used - allowed)}"


@pytest.mark.parametrize("path", sources(), ids=lambda p: str(p.relative_to(CORE)))
def test_outside_libraries_stay_in_their_folders(path):
    folder = str(path.relative_to(CORE).parent)
    for name, (pattern, folders) in LIBRARIES.items():
        if any(re.search(pattern, inc) for inc in includes(path)):
            assert folder in folders, f"{name} is included outside its folder"
            assert path.suffix == ".cpp" or path.name == "impl.h", f"{name} is included by a header"


def test_workbench_layers_point_one_way():
    package = ROOT / "Mod" / "sweepmesh"
    forbidden = {"engine": ("app", "gui"), "app": ("gui",)}
    for layer, above in forbidden.items():
        for path in sorted((package / layer).rglob("*.py")):
            text = path.read_text()
            for name in above:
                assert not re.search(rf"(from|import)\s+sweepmesh\.{name}\b", text), path
    for path in sorted((package / "app").rglob("*.py")):
        assert not re.search(r"^\s*(from|import)\s+PySide", path.read_text(), re.M), path


def test_no_folder_of_the_root_is_a_python_package():
    for folder in ("core", "tests", "Mod", "bindings", "Resources", "docs"):
        assert not (ROOT / folder / "__init__.py").exists()

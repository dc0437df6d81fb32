"""The demonstration, and the scripts that ./run and ./test are made of."""

import os
import pathlib
import re
import subprocess
import sys

import FreeCAD
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = {
    "passed": '<testcase name="a"/>',
    "failed": '<testcase name="a"><failure/></testcase>',
    "error": '<testcase name="a"><error/></testcase>',
    "failed in ctest": '<testcase name="a" status="fail"><failure/></testcase>',
    "skipped": '<testcase name="a"><skipped/></testcase>',
}


def test_the_demonstration_leaves_mesh_analysis_and_picture(tmp_path):
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "Mod")}
    command = [sys.executable, "-m", "sweepmesh.demo", tmp_path]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    assert {path.name for path in tmp_path.iterdir()} == {f"manifold_elbow{s}" for s in (".vtu", ".inp", ".FCStd", ".png")}
    for word in ("Plan", "Scaled Jacobian", "####", "Times", "CalculiX", "inverted 0"):
        assert word in done.stdout
    moved = float(re.search(r"moves it by ([\d.]+) mm", done.stdout)[1])
    assert moved == pytest.approx(0.0999, rel=0.02)  # as second-order hexahedra of the same size say
    picture = (tmp_path / "manifold_elbow.png").read_bytes()
    assert picture[:4] == b"\x89PNG" and len(picture) > 100_000
    document = FreeCAD.openDocument(str(tmp_path / "manifold_elbow.FCStd"))
    kinds = {item.TypeId for item in document.Objects}
    FreeCAD.closeDocument(document.Name)
    assert any("FemMesh" in kind for kind in kinds) and any("FemResult" in kind for kind in kinds)


def count(folder, *suites):
    command = [sys.executable, ROOT / "scripts" / "count_tests.py", folder, *suites]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.returncode, done.stdout.splitlines()[-1]


@pytest.mark.parametrize("kind", CASES)
def test_counts_are_summed_over_runners(tmp_path, kind):
    (tmp_path / "one.xml").write_text(f"<testsuites><testsuite>{CASES[kind]}</testsuite></testsuites>")
    (tmp_path / "two.xml").write_text(f"<testsuite>{CASES['passed']}{CASES['passed']}</testsuite>")
    passed, failed = {"passed": (3, 0), "skipped": (2, 0)}.get(kind, (2, 1))
    assert count(tmp_path, "one", "two") == (1 if failed else 0, f"{passed} passed, {failed} failed")


def test_a_runner_that_crashed_or_found_nothing_is_a_failure(tmp_path):
    (tmp_path / "one.xml").write_text("<testsuite></testsuite>")
    assert count(tmp_path, "one", "two") == (1, "0 passed, 2 failed")


@pytest.mark.parametrize("arguments, word", [(["no_such.step"], "no file"), ([], "no display")])
def test_the_window_needs_a_file_and_a_display(arguments, word):
    environment = {name: value for name, value in os.environ.items() if "DISPLAY" not in name}
    done = subprocess.run([ROOT / "scripts" / "gui.sh", *arguments], env=environment, capture_output=True, text=True)
    assert done.returncode == 1 and word in done.stderr and len(done.stderr.splitlines()) == 1


def test_every_package_is_named_once_and_used():
    lines = (ROOT / "scripts" / "packages.txt").read_text().splitlines()
    rows = [line.split() for line in lines if line and not line.startswith("#")]
    assert all(len(row) == 2 and row[1] in ("run", "test") for row in rows)
    assert len({row[0] for row in rows}) == len(rows) > 10

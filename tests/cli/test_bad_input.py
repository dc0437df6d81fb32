"""Bad input: one clear sentence, status 1, no traceback, no file."""

import json
import os
import re
import signal
import time

import pytest

# File, and a word that the sentence must have.
BAD_SHAPES = {
    "no such file": ("no_such_file.step", "no_such_file.step"),
    "no such document": ("no_such_file.FCStd", "no_such_file.FCStd"),
    "empty STEP": ("empty.step", "empty.step"),
    "noise as STEP": ("noise.step", "noise.step"),
    "truncated STEP": ("truncated.step", "truncated.step"),
    "empty BREP": ("empty.brep", "empty.brep"),
    "noise as BREP": ("noise.brep", "noise.brep"),
    "empty document": ("empty.FCStd", "empty.FCStd"),
    "noise as document": ("noise.FCStd", "noise.FCStd"),
    "no shape at all": ("notes.txt", "notes.txt"),
    "folder": ("folder.step", "folder.step"),
    "open shell": ("open_shell.step", "open shell"),
    "solid with an open shell": ("open_solid.brep", "not closed"),
    "wire": ("wire.step", "no solid"),
    "mesh": ("mesh.stl", "is a mesh"),
    "document with a mesh and a sketch": ("no_solid.FCStd", "Sketch"),
    "document with nothing": ("nothing.FCStd", "no solid"),
}

BAD_OPTIONS = {
    "unknown face": (["--source", "Face7"], "Face7"),
    "face number 0": (["--target", "Face0"], "Face0"),
    "unknown face in a pair": (["--pair", "Face1=Face17"], "Face17"),
    "no face at all": (["--source", "Edge1"], "Edge1"),
    "point of two numbers": (["--source", "1,2"], "1,2"),
    "point that is no number": (["--source", "nan,0,0"], "nan"),
    "point off the shape": (["--source", "300,0,0"], "300,0,0"),
    "pair of one": (["--pair", "Face1"], "Face1"),
    "source is target": (["--source", "Face5", "--target", "Face5"], "Face5"),
    "source is target in a pair": (["--pair", "Face5=Face5"], "Face5"),
    "type without a type": (["--type", "Face1:Vertex1"], "CORNER"),
    "type of no kind": (["--type", "Face1:Vertex1=ROUND"], "ROUND"),
    "type at an unknown vertex": (["--type", "Face1:Vertex77=END"], "Vertex77"),
    "type at a vertex of another face": (["--type", "Face1:Vertex8=END"], "Vertex8"),
    "type off the shape": (["--type", "Face1:1,2,3=END"], "1,2,3"),
    "types that differ": (["--type", "Face1:Vertex1=END", "--type", "Face1:Vertex1=SIDE"], "Vertex1"),
    "type on a source": (["--source", "Face1", "--type", "Face1:Vertex1=END"], "Vertex1"),
    "size zero": (["--size", "0"], "size"),
    "size negative": (["--size=-2"], "size"),
    "size not a number": (["--size", "nan"], "size"),
    "size infinite": (["--size", "inf"], "size"),
    "size a word": (["--size", "small"], "size"),
    "size tiny": (["--size", "0.01"], "--force"),
    "size far too tiny": (["--size", "1e-30"], "--force"),
    "no layers": (["--layers", "0"], "layer"),
    "negative layers": (["--layers=-3"], "layer"),
    "far too many layers": (["--layers", "2000000000"], "--force"),
    "layers a fraction": (["--layers", "1.5"], "layers"),
    "unknown element": (["--element", "tetra"], "element"),
    "unknown order": (["--order", "3"], "order"),
    "unknown option": (["--colour"], "--colour"),
    "unknown suffix": (["--out", "mesh.xyz"], "mesh.xyz"),
    "no suffix": (["--out", "mesh"], "mesh"),
    "folder that is not there": (["--out", "nowhere/mesh.vtu"], "nowhere"),
    "out is a folder": (["--out", "."], "suffix"),
    "report is a folder": (["--report", "."], "folder"),
    "report where there is no folder": (["--report", "nowhere/report.json"], "nowhere"),
    "object of no document": (["--object", "Brick"], "--object"),
    "solid that is not there": (["--solid", "2"], "solid"),
    "solid 0": (["--solid", "0"], "olid"),
}


def assert_one_sentence(done, folder):
    """Status 1, one line on standard error, nothing on standard output, no mesh left."""
    assert done.returncode == 1, (done.returncode, done.stderr)
    assert done.stdout == ""
    lines = done.stderr.strip().splitlines()
    assert len(lines) == 1, done.stderr
    assert lines[0].startswith("sweepmesh: ") and lines[0].endswith(".")
    assert "Traceback" not in done.stderr and "Error:" not in done.stderr
    assert [path.name for path in folder.iterdir() if path.suffix != ".json"] == []


@pytest.mark.parametrize("what", BAD_SHAPES)
def test_bad_shapes(sweepmesh, shapes, tmp_path, what):
    name, word = BAD_SHAPES[what]
    done = sweepmesh(shapes / name, "--out", "mesh.vtu", "--report", "report.json")
    assert_one_sentence(done, tmp_path)
    assert word in done.stderr


@pytest.mark.parametrize("what", BAD_OPTIONS)
def test_bad_options(sweepmesh, shapes, tmp_path, what):
    options, word = BAD_OPTIONS[what]
    done = sweepmesh(shapes / "brick.step", *options)
    assert_one_sentence(done, tmp_path)
    assert word in done.stderr
    assert done.stderr.count("--force") <= 1


@pytest.mark.parametrize("options", [["--size", "0.01"], ["--size", "1e-30"], ["--layers", "2000000000"]])
def test_counts_that_explode_are_said(sweepmesh, shapes, options):
    assert re.search(r"\d[\d.,' ]*\d|\d+e\+?\d+", sweepmesh(shapes / "brick.step", *options).stderr)


def test_a_size_far_above_the_solid_gives_one_element_or_a_sentence(sweepmesh, shapes, tmp_path):
    done = sweepmesh(shapes / "brick.step", "--size", "1e30")
    if done.returncode:
        assert_one_sentence(done, tmp_path)
    else:
        assert re.search(r"hexa +1\n", done.stdout)


@pytest.mark.parametrize(
    "options, word",
    [
        (["--element", "polyhedron", "--order", "2"], "no second order"),
        (["--element", "polyhedron", "--out", "brick.inp"], ".inp files hold no polyhedra. Write .vtu or .foam"),
        (["--element", "polyhedron", "--out", "brick.FCStd"], "no polyhedra"),
        (["--element", "polyhedron", "--out", "brick.vtu", "--out", "brick.unv"], "no polyhedra"),
        (["--order", "2", "--out", "brick.foam"], "no mid-side nodes"),
    ],
)
def test_what_elements_do_not_go_with_is_told_before_meshing(sweepmesh, shapes, tmp_path, options, word):
    done = sweepmesh(shapes / "brick.step", *options, "--size", 5)
    assert_one_sentence(done, tmp_path)
    assert word in done.stderr


def test_no_arguments_are_one_sentence(sweepmesh, tmp_path):
    assert_one_sentence(sweepmesh(), tmp_path)


def test_an_unreadable_object_name(sweepmesh, shapes, tmp_path):
    for name in ("Sketch", "Nobody"):
        done = sweepmesh(shapes / "no_solid.FCStd", "--object", name)
        assert_one_sentence(done, tmp_path)
        assert name in done.stderr


def test_the_report_of_a_failure_says_why(sweepmesh, shapes, tmp_path):
    done = sweepmesh(shapes / "brick.step", "--source", "Face9", "--report", "report.json")
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["error"]["text"] in done.stderr and report["error"]["entities"] == ["Face9"]


@pytest.mark.parametrize("name", ["mesh.vtu", "mesh.FCStd"])
@pytest.mark.parametrize("seconds, stop", [(0.8, signal.SIGINT), (2.5, signal.SIGINT), (1.5, signal.SIGTERM)])
def test_ctrl_c_stops_within_a_second_and_leaves_nothing(start, shapes, tmp_path, name, seconds, stop):
    process = start(shapes / "brick.step", "--size", 0.24, "--out", name)
    time.sleep(seconds)
    assert process.poll() is None, "the run is too short for this test"
    started = time.perf_counter()
    process.send_signal(stop)
    _, errors = process.communicate(timeout=30)
    assert time.perf_counter() - started < 1.0
    assert process.returncode == 1
    assert "Interrupted" in errors and "Traceback" not in errors
    assert os.listdir(tmp_path) == []


def test_a_reader_that_goes_away_is_no_traceback(start, shapes):
    process = start(shapes / "brick.step", "--size", 5)
    process.stdout.close()
    with process.stderr:
        assert "Traceback" not in process.stderr.read()
    process.wait()

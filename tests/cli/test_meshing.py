"""What the command line does when all is well: files, report, plan, exit status."""

import fcntl
import json
import os
import pty
import re
import select
import struct
import termios

import FreeCAD
import Part
import pytest

import sweepmesh as engine
from sweepmesh import Options

KEYS = {"verdict", "reasons", "scheme", "counts", "quality", "seconds", "peak_memory_mb", "version"}
STAGES = {"read", "assess", "imprint", "intervals", "surface", "place", "quality", "write", "total"}


@pytest.mark.parametrize("name", ["brick.step", "brick.stp", "brick.iges", "brick.brep", "brick.FCStd"])
def test_every_format_of_shapes_gives_a_mesh(sweepmesh, shapes, tmp_path, name):
    done = sweepmesh(shapes / name, "--size", 5, "--out", "brick.vtu")
    assert done.returncode == 0 and done.stderr == ""
    assert "480" in done.stdout and (tmp_path / "brick.vtu").stat().st_size > 480 * 32


def test_the_report_has_every_key(sweepmesh, shapes, tmp_path):
    done = sweepmesh(shapes / "brick.step", "--size", 5, "--report", "report.json")
    report = json.loads((tmp_path / "report.json").read_text())
    assert done.returncode == 0
    assert KEYS <= set(report)
    assert report["verdict"] == "sweepable" and report["reasons"] == []
    assert sorted(report["scheme"].values()) == ["linking"] * 4 + ["source", "target"]
    assert report["counts"]["hexa"] == 480 and report["counts"]["nodes"] == 13 * 9 * 6
    assert report["quality"]["n_inverted"] == 0
    assert report["quality"]["min_scaled_jacobian"] == pytest.approx(1)
    assert sum(report["quality"]["histogram"]) == 480
    assert STAGES == set(report["seconds"])
    assert report["seconds"]["total"] >= report["seconds"]["read"] > 0
    assert report["peak_memory_mb"] > 10 and re.fullmatch(r"\d+\.\d+\.\d+", report["version"])


def test_plan_quality_and_times_are_printed(sweepmesh, shapes):
    text = sweepmesh(shapes / "brick.step", "--size", 5, "--source", "Face6").stdout
    for word in ("source", "Face6", "target", "Face5", "linking", "Scaled Jacobian", "inverted 0", "total"):
        assert word in text
    assert "####" in text


def test_quiet_prints_nothing(sweepmesh, shapes):
    done = sweepmesh(shapes / "brick.step", "--size", 5, "--quiet")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize(
    "picks, source, target",
    [
        (["--source", "Face6"], "Face6", "Face5"),
        (["--target", "Face6"], "Face5", "Face6"),
        (["--source", "30,20,0", "--target", "30,20,25"], "Face5", "Face6"),
        (["--pair", "Face1=Face2"], "Face1", "Face2"),
        (["--pair", "0,20,12.5=60,20,12.5"], "Face1", "Face2"),
        (["--source", "-1e-9,20,12.5"], "Face1", "Face2"),
        (["--pair", "-1e-9,20,12.5=60,20,12.5"], "Face1", "Face2"),
    ],
)
def test_faces_are_picked_by_name_or_point(sweepmesh, shapes, tmp_path, picks, source, target):
    done = sweepmesh(shapes / "brick.step", "--assess", *picks, "--report", "report.json")
    scheme = json.loads((tmp_path / "report.json").read_text())["scheme"]
    assert (done.returncode, scheme[source], scheme[target]) == (0, "source", "target")


def test_layers_are_taken_over(sweepmesh, shapes, tmp_path):
    sweepmesh(shapes / "brick.step", "--size", 5, "--layers", 9, "--source", "Face6", "--report", "report.json")
    assert json.loads((tmp_path / "report.json").read_text())["counts"]["hexa"] == 12 * 8 * 9


def test_polyhedra_are_counted_and_written(sweepmesh, shapes, tmp_path):
    done = sweepmesh(
        *(shapes / "brick.step", "--size", 5, "--element", "polyhedron", "--source", "Face6"),
        *("--out", "brick.vtu", "--out", "brick.foam", "--report", "report.json"),
    )
    assert done.returncode == 0 and done.stderr == ""
    counts = json.loads((tmp_path / "report.json").read_text())["counts"]
    assert counts["polyhedron"] > 0 and counts["polyhedron"] % 5 == 0
    assert re.search(rf"polyhedron +{counts['polyhedron']}\n", done.stdout)
    n_cells = counts["hexa"] + counts["prism"] + counts["polyhedron"]
    assert f'NumberOfCells="{n_cells}"'.encode() in (tmp_path / "brick.vtu").read_bytes()
    owner = (tmp_path / "constant" / "polyMesh" / "owner").read_text()
    assert f"nCells: {n_cells} " in owner and (tmp_path / "brick.foam").exists()


def test_assess_writes_no_mesh(sweepmesh, shapes, tmp_path):
    done = sweepmesh(shapes / "brick.step", "--assess", "--out", "brick.vtu")
    assert done.returncode == 0 and "sweepable" in done.stdout
    assert not (tmp_path / "brick.vtu").exists()


@pytest.mark.parametrize("mode", [[], ["--assess"]])
def test_unsweepable_is_status_2_with_reasons(sweepmesh, shapes, tmp_path, mode):
    done = sweepmesh(shapes / "voids.step", *mode, "--report", "report.json", "--out", "voids.vtu")
    report = json.loads((tmp_path / "report.json").read_text())
    assert done.returncode == 2
    assert report["verdict"] == "unsweepable" and report["scheme"] == {}
    for reason in report["reasons"]:
        assert set(reason) == {"kind", "text", "entities"}
        assert reason["text"] in done.stdout
    assert report["reasons"] and not (tmp_path / "voids.vtu").exists()


def test_all_solids_are_meshed_or_the_chosen_one(sweepmesh, shapes, tmp_path):
    def hexahedra(*options):
        done = sweepmesh(shapes / "two.step", "--size", 5, "--report", "report.json", *options)
        assert done.returncode == 0, done.stderr
        return json.loads((tmp_path / "report.json").read_text())["counts"]["hexa"]

    assert hexahedra("--solid", 1) == 480
    assert hexahedra("--solid", 2) == 1
    assert hexahedra() == 481


def test_touching_solids_have_one_mesh(sweepmesh, shapes, tmp_path):
    done = sweepmesh(shapes / "touching.step", "--size", 5, "--report", "report.json")
    assert done.returncode == 0 and done.stderr == ""
    counts = json.loads((tmp_path / "report.json").read_text())["counts"]
    assert (counts["hexa"], counts["nodes"]) == (14 * 8 * 5, 15 * 9 * 6)


def test_solids_that_touch_in_part_are_told_of(sweepmesh, shapes):
    done = sweepmesh(shapes / "overlapping.step", "--size", 5)
    assert done.returncode == 0
    assert "lie on each other in part" in done.stderr and "BooleanFragments" in done.stderr


def test_a_cut_solid_is_meshed_in_one(sweepmesh, shapes, tmp_path):
    """The handle's feet stand on nodes of the disc below; the pieces are left in the file."""
    report, mesh = tmp_path / "report.json", tmp_path / "mesh.vtu"
    done = sweepmesh(
        shapes / "handle.step", "--size", 2.5, "--cut", "pieces.brep", "--out", "mesh.vtu", "--report", "report.json"
    )
    assert done.returncode == 0 and mesh.exists(), done.stderr
    said = json.loads(report.read_text())
    assert said["verdict"] == "sweepable" and said["suggested_cut"]["pieces"] == 2
    assert said["warnings"] == [done.stderr.split("warning: ", 1)[1].strip()] and "pieces.brep" in said["warnings"][0]
    pieces = Part.Shape()
    pieces.importBrep(str(tmp_path / "pieces.brep"))
    assert len(pieces.Solids) == 2 and len(said["scheme"]) == len(pieces.Faces)


def test_a_solid_that_needs_no_cut_is_left_whole(sweepmesh, shapes, tmp_path):
    done = sweepmesh(shapes / "brick.step", "--size", 5, "--cut", "pieces.brep")
    assert done.returncode == 0 and not (tmp_path / "pieces.brep").exists()
    assert sweepmesh(shapes / "brick.step", "--cut", "pieces.txt").returncode == 1


def test_the_result_of_a_document_is_taken_not_its_parts(sweepmesh, shapes):
    done = sweepmesh(shapes / "cut.FCStd", "--assess")
    assert done.stderr == "" and "Face7" in done.stdout + done.stderr


def test_an_object_of_a_document_can_be_named(sweepmesh, shapes):
    first = sweepmesh(shapes / "two.FCStd", "--size", 5)
    assert "First" in first.stderr and "Second" in first.stderr and "480" in first.stdout
    second = sweepmesh(shapes / "two.FCStd", "--size", 5, "--object", "Second")
    assert second.stderr == "" and second.returncode == 0


def test_force_lifts_the_limit(sweepmesh, shapes):
    """An unsweepable solid ends the run at once when the limit does not: no mesh of this size is made."""
    assert sweepmesh(shapes / "voids.step", "--size", 0.08).returncode == 1
    assert sweepmesh(shapes / "voids.step", "--size", 0.08, "--force").returncode == 2


def run_on_terminal(start, arguments):
    """Exit status and what the process writes to its standard error, a terminal."""
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
    with start(*arguments, stderr=slave) as process:
        os.close(slave)
        text = b""
        while process.poll() is None or select.select([master], [], [], 0)[0]:
            if select.select([master], [], [], 0.1)[0]:
                try:
                    text += os.read(master, 4096)
                except OSError:  # the other side was closed
                    break
    os.close(master)
    return process.returncode, text.decode()


def test_a_terminal_gets_a_bar_and_a_pipe_none(start, sweepmesh, shapes):
    arguments = [shapes / "brick.step", "--size", 0.8]
    status, text = run_on_terminal(start, arguments)
    assert status == 0 and "%" in text and "|" in text
    assert sweepmesh(*arguments).stderr == ""
    assert run_on_terminal(start, [*arguments, "--quiet"]) == (0, "")


@pytest.mark.parametrize("suffix", [".inp", ".unv", ".med"])
def test_freecad_reads_back_what_was_written(sweepmesh, shapes, tmp_path, suffix):
    import Fem

    path = tmp_path / f"brick{suffix}"
    assert sweepmesh(shapes / "brick.step", "--size", 5, "--out", path).returncode == 0
    mesh = Fem.read(str(path))
    assert (mesh.NodeCount, mesh.HexaCount) == (13 * 9 * 6, 480)
    xs = sorted({round(node.x, 6) for node in mesh.Nodes.values()})
    assert (xs[0], xs[-1], len(xs)) == (0, 60, 13)


def test_a_document_holds_shape_and_mesh(sweepmesh, shapes, tmp_path):
    path = tmp_path / "brick.FCStd"
    assert sweepmesh(shapes / "brick.step", "--size", 5, "--source", "Face6", "--out", path).returncode == 0
    document = FreeCAD.openDocument(str(path))
    try:
        meshes = [item for item in document.Objects if item.isDerivedFrom("Fem::FemMeshObject")]
        solids = [item for item in document.Objects if getattr(item, "Shape", None) and hasattr(item.Shape, "Solids")]
        assert [mesh.FemMesh.HexaCount for mesh in meshes] == [480]
        assert [round(item.Shape.Volume) for item in solids if item.isDerivedFrom("Part::Feature")] == [60000]
    finally:
        FreeCAD.closeDocument(document.Name)


def test_several_files_from_one_run(sweepmesh, shapes, tmp_path):
    outs = ["a.vtu", "b.inp", "c.unv"]
    done = sweepmesh(shapes / "brick.step", "--size", 10, *(f"--out={name}" for name in outs))
    assert done.returncode == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == outs


def test_the_command_line_and_the_macro_give_the_same_mesh(sweepmesh, shapes, tmp_path):
    assert sweepmesh(shapes / "brick.step", "--size", 5, "--source", "Face6", "--out", "cli.vtu").returncode == 0
    shape = Part.read(str(shapes / "brick.step"))
    result = engine.mesh(shape.exportBrepToString(), Options(size=5, sources=[6]))
    engine.write(result, tmp_path / "macro.vtu")
    assert (tmp_path / "cli.vtu").stat().st_size == (tmp_path / "macro.vtu").stat().st_size


def test_two_runs_write_the_same_bytes(sweepmesh, shapes, tmp_path):
    for name, threads in (("one.vtu", 1), ("two.vtu", 2)):
        sweepmesh(shapes / "brick.step", "--size", 3, "--threads", threads, "--out", name)
    assert (tmp_path / "one.vtu").read_bytes() == (tmp_path / "two.vtu").read_bytes()


def test_a_cut_is_suggested_on_asking(sweepmesh, shapes, tmp_path):
    """The ball with two voids is parted between them; a brick needs no cut."""
    done = sweepmesh(shapes / "voids.step", "--assess", "--report", "report.json")
    cut = json.loads((tmp_path / "report.json").read_text())["suggested_cut"]
    assert cut["pieces"] == 2 and cut["text"] in done.stdout
    assert abs(abs(cut["normal"][0]) - 1) < 1e-9 and abs(cut["point"][0]) < 1e-6
    sweepmesh(shapes / "brick.step", "--assess", "--report", "report.json")
    assert json.loads((tmp_path / "report.json").read_text())["suggested_cut"] is None

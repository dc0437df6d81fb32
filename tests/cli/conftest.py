"""The command line as its users run it, and files to run it on."""

import os
import pathlib
import subprocess
import sys

import FreeCAD
import Mesh
import Part
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND = [sys.executable, "-m", "sweepmesh"]
ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT / "Mod")}


@pytest.fixture
def start(tmp_path):
    """A function that starts the command line in an empty folder and returns the process."""

    def start(*arguments, stderr=subprocess.PIPE):
        return subprocess.Popen(
            [*COMMAND, *map(str, arguments)],
            cwd=tmp_path,
            env=ENVIRONMENT,
            stdout=subprocess.PIPE,
            stderr=stderr,
            text=True,
        )

    return start


@pytest.fixture
def sweepmesh(start):
    """A function that runs the command line to its end and returns status and output."""

    def run(*arguments):
        with start(*arguments) as process:
            stdout, stderr = process.communicate(timeout=120)
        return subprocess.CompletedProcess(arguments, process.returncode, stdout, stderr)

    return run


@pytest.fixture(scope="session")
def shapes(tmp_path_factory):
    """A folder with shapes good and bad."""
    folder = tmp_path_factory.mktemp("shapes")
    brick = Part.makeBox(60, 40, 25)
    brick.exportStep(str(folder / "brick.step"))
    brick.exportStep(str(folder / "brick.stp"))
    brick.exportIges(str(folder / "brick.iges"))
    brick.exportBrep(str(folder / "brick.brep"))
    _voids().exportStep(str(folder / "voids.step"))
    Part.Compound([brick, Part.makeBox(1, 1, 1, FreeCAD.Vector(100, 0, 0))]).exportStep(str(folder / "two.step"))
    beside = Part.makeBox(10, 40, 25, FreeCAD.Vector(60, 0, 0))
    Part.Compound([brick, beside]).exportStep(str(folder / "touching.step"))
    aside = Part.makeBox(10, 40, 25, FreeCAD.Vector(60, 20, 0))
    Part.Compound([brick, aside]).exportStep(str(folder / "overlapping.step"))
    _handle().exportStep(str(folder / "handle.step"))
    _write_bad(folder, brick)
    _write_documents(folder, brick)
    return folder


def _handle():
    """Half a ring with both feet on a disc: sweepable once it is cut off."""
    ring = Part.makeTorus(12, 3)
    ring.rotate(FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0), 90)
    upper = ring.common(Part.makeBox(60, 60, 30, FreeCAD.Vector(-30, -30, 0)))
    return Part.makeCylinder(25, 10, FreeCAD.Vector(0, 0, -10)).fuse(upper)


def _voids():
    """A ball with two voids cannot be swept."""
    void = Part.makeSphere(2, FreeCAD.Vector(4, 0, 0))
    return Part.makeSphere(10).cut(void).cut(void.mirror(FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0)))


def _write_bad(folder, brick):
    (folder / "empty.step").write_text("")
    (folder / "noise.step").write_bytes(bytes(range(256)) * 40)
    text = (folder / "brick.step").read_text()
    (folder / "truncated.step").write_text(text[: len(text) // 2])
    (folder / "empty.brep").write_text("")
    (folder / "noise.brep").write_text("CASCADE Topology V1\nLocations 99\n1 2 3\n")
    (folder / "empty.FCStd").write_text("")
    (folder / "noise.FCStd").write_bytes(b"PK\x03\x04" + bytes(range(256)))
    (folder / "notes.txt").write_text("no shape")
    (folder / "folder.step").mkdir()
    Part.Shell(brick.Faces[:5]).exportStep(str(folder / "open_shell.step"))
    Part.Solid(Part.Shell(brick.Faces[:5])).exportBrep(str(folder / "open_solid.brep"))
    Part.makePolygon([FreeCAD.Vector(*p) for p in ((0, 0), (1, 0), (0, 1), (0, 0))]).exportStep(str(folder / "wire.step"))
    Mesh.createBox(1, 1, 1).write(str(folder / "mesh.stl"))


def _write_documents(folder, brick):
    def save(name, fill):
        document = FreeCAD.newDocument()
        fill(document)
        document.recompute()
        document.saveAs(str(folder / name))
        FreeCAD.closeDocument(document.Name)

    def add_shape(document, name, shape):
        document.addObject("Part::Feature", name).Shape = shape

    def cut(document):
        document.addObject("Part::Box", "Box").Length = 30
        document.addObject("Part::Cylinder", "Cylinder")
        result = document.addObject("Part::Cut", "Cut")
        result.Base, result.Tool = document.Box, document.Cylinder

    def two(document):
        add_shape(document, "First", brick)
        add_shape(document, "Second", Part.makeBox(10, 10, 10))

    def no_solid(document):
        document.addObject("Sketcher::SketchObject", "Sketch")
        document.addObject("Mesh::Feature", "Mesh").Mesh = Mesh.createBox(1, 1, 1)

    save("brick.FCStd", lambda document: add_shape(document, "Brick", brick))
    save("cut.FCStd", cut)
    save("two.FCStd", two)
    save("no_solid.FCStd", no_solid)
    save("nothing.FCStd", lambda document: None)

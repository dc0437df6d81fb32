"""Writing results to files; the format follows from the suffix."""

import contextlib
import os
import pathlib
import tempfile

from sweepmesh.engine.errors import input_error
from sweepmesh.engine.writers import foam, inp, vtu
from sweepmesh.freecad import import_freecad


def write(result, path, document_object=None, options=None):
    """Writes a Result to `path` (.vtu, .inp, .foam, .unv, .med or .FCStd).

    .vtu, .inp and .foam need nothing else, the others go through FreeCAD. A .foam file is the empty one by which
    ParaView knows the folder of an OpenFOAM case; the mesh is in constant/polyMesh beside it. An .FCStd file becomes the document of
    `document_object` (the object with the meshed shape) with a mesh object made from `options` added, or
    a document with the mesh alone where none is given. The file appears whole or not at all. Raises
    InputError for another suffix or a file that cannot be written.
    """
    path = pathlib.Path(path)
    check_path(path, has_polyhedra=result.n_polyhedra > 0, order=result.order)
    try:
        with replacing(path) as temporary:
            _WRITERS[path.suffix.lower()](temporary, result, document_object, options)
    except OSError as error:
        raise input_error(f"{path} cannot be written: {error.strerror or error}.", "write") from error


def check_path(path, has_polyhedra=False, order=1):
    """Raises InputError unless `path` has a suffix that can be written and lies in a writable folder."""
    path = pathlib.Path(path)
    if path.suffix.lower() not in _WRITERS:
        known = ", ".join(FORMATS)
        raise input_error(f"{path} has no suffix of a known format ({known}).", "write")
    if has_polyhedra and path.suffix.lower() not in POLYHEDRAL_FORMATS:
        raise input_error(
            f"{path} cannot be written: {path.suffix} files hold no polyhedra. Write"
            f" {' or '.join(sorted(POLYHEDRAL_FORMATS, reverse=True))}, or mesh with hexahedra or prisms.",
            "write",
        )
    if order == 2 and path.suffix.lower() == ".foam":
        raise input_error(f"{path} cannot be written: OpenFOAM's meshes have no mid-side nodes; use order 1.", "write")
    check_folder(path)


def check_folder(path):
    """Raises InputError unless a file `path` can be made."""
    path = pathlib.Path(path)
    if not path.parent.is_dir():
        raise input_error(f"{path} cannot be written: there is no folder {path.parent}.", "write")
    if path.is_dir():
        raise input_error(f"{path} cannot be written: it is a folder.", "write")
    if not os.access(path.parent, os.W_OK):
        raise input_error(f"{path} cannot be written: the folder {path.parent} is read-only.", "write")


@contextlib.contextmanager
def replacing(path):
    """A temporary path of the same name; its file takes the place of `path` when the block ends well.

    The name is kept because FreeCAD writes it into some formats and looks for it there.
    """
    path = pathlib.Path(path)
    with tempfile.TemporaryDirectory(prefix=f".{path.name}.", dir=path.parent) as folder:
        temporary = pathlib.Path(folder) / path.name
        yield temporary
        os.replace(temporary, path)


def add_sweep_mesh(result, document_object, options, analysis=None):
    """Adds a sweep mesh object with this Result to the document of the object that was meshed."""
    from sweepmesh.app import remembered
    from sweepmesh.app.make import make_sweep_mesh
    from sweepmesh.app.shapes import brep_of

    remembered.remember(brep_of(document_object), options, result)
    return make_sweep_mesh(document_object, options, analysis)


def _write_vtu(path, result, _object, _options):
    vtu.write_result(path, result)


def _write_inp(path, result, _object, _options):
    inp.write_result(path, result)


def _write_foam(path, result, _object, _options):
    """Makes the marker `path`, which takes its place afterwards, and puts the mesh where it is to be."""
    path.touch()
    new, place = path.parent / "polyMesh", path.parent.parent / "constant" / "polyMesh"
    new.mkdir()
    foam.write_result(new, result)
    place.parent.mkdir(exist_ok=True)
    if place.exists():
        os.replace(place, path.parent / "old")
    os.replace(new, place)


def _write_freecad(path, result, _object, _options):
    _femmesh(result).write(str(path))


def _write_document(path, result, document_object, options):
    freecad = import_freecad()
    if document_object is None:
        document = freecad.newDocument("SweepMesh", hidden=True, temp=True)
        document.addObject("Fem::FemMeshObject", "SweepMesh").FemMesh = _femmesh(result)
    else:
        document = document_object.Document
        add_sweep_mesh(result, document_object, options)
    document.recompute()
    document.saveCopy(str(path))


def _femmesh(result):
    import_freecad()
    from sweepmesh.app.femmesh import to_femmesh

    return to_femmesh(result)


_WRITERS = {
    ".vtu": _write_vtu,
    ".inp": _write_inp,
    ".foam": _write_foam,
    ".unv": _write_freecad,
    ".med": _write_freecad,
    ".fcstd": _write_document,
}
FORMATS = [".vtu", ".inp", ".foam", ".unv", ".med", ".FCStd"]
"""Suffixes that `write` knows."""
OWN_FORMATS = {".vtu", ".inp", ".foam"}
"""Those that need no FreeCAD."""
POLYHEDRAL_FORMATS = {".vtu", ".foam"}
"""Those that hold polyhedra."""

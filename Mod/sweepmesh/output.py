"""Writing results to files; the format follows from the suffix."""

import contextlib
import os
import pathlib

from sweepmesh.engine.errors import input_error
from sweepmesh.engine.writers import vtu


def write(result, path, document_object=None, options=None):
    """Writes a Result to `path` (.vtu, .inp, .unv, .med or .FCStd).

    All but .vtu go through FreeCAD, which must be importable. An .FCStd file becomes the document of
    `document_object` (the object with the meshed shape) with a mesh object made from `options` added, or
    a document with the mesh alone where none is given. The file appears whole or not at all. Raises
    InputError for another suffix or a file that cannot be written.
    """
    path = pathlib.Path(path)
    check_path(path)
    try:
        with replacing(path) as temporary:
            _WRITERS[path.suffix.lower()](temporary, result, document_object, options)
    except OSError as error:
        raise input_error(f"{path} cannot be written: {error.strerror or error}.", "write") from error


def check_path(path):
    """Raises InputError unless `path` has a suffix that can be written and lies in a writable folder."""
    path = pathlib.Path(path)
    if path.suffix.lower() not in _WRITERS:
        known = ", ".join(FORMATS)
        raise input_error(f"{path} has no suffix of a known format ({known}).", "write")
    if not path.parent.is_dir():
        raise input_error(f"{path} cannot be written: there is no folder {path.parent}.", "write")
    if path.is_dir() or not os.access(path.parent, os.W_OK):
        raise input_error(f"{path} cannot be written there.", "write")


@contextlib.contextmanager
def replacing(path):
    """A temporary name beside `path` that takes its place when the block ends well, and else vanishes."""
    path = pathlib.Path(path)
    temporary = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
    try:
        yield temporary
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def _write_vtu(path, result, _object, _options):
    vtu.write_result(path, result)


def _write_inp(path, result, _object, _options):
    _femmesh(result).writeABAQUS(str(path), 1, True)


def _write_freecad(path, result, _object, _options):
    _femmesh(result).write(str(path))


def _write_document(path, result, document_object, options):
    from sweepmesh.freecad import import_freecad

    freecad = import_freecad()
    if document_object is None:
        document = freecad.newDocument("SweepMesh", hidden=True, temp=True)
        document.addObject("Fem::FemMeshObject", "SweepMesh").FemMesh = _femmesh(result)
    else:
        from sweepmesh.app.make import make_sweep_mesh

        document = document_object.Document
        make_sweep_mesh(document_object, options)
    document.recompute()
    document.saveCopy(str(path))


def _femmesh(result):
    from sweepmesh.freecad import import_freecad

    import_freecad()
    from sweepmesh.app.femmesh import to_femmesh

    return to_femmesh(result)


_WRITERS = {
    ".vtu": _write_vtu,
    ".inp": _write_inp,
    ".unv": _write_freecad,
    ".med": _write_freecad,
    ".fcstd": _write_document,
}
FORMATS = [".vtu", ".inp", ".unv", ".med", ".FCStd"]
"""Suffixes that `write` knows."""

"""Writing the files of --out.

FreeCAD's formats are written by a process of their own: FreeCAD's C++ does not look at signals, so only a
process can be ended at once when the user presses Ctrl-C.
"""

import dataclasses
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile

from sweepmesh import output
from sweepmesh.cli import shapes
from sweepmesh.engine import Options, Result, SweepMeshError


@dataclasses.dataclass
class Job:
    """What the writing process is told."""

    result: Result
    path: str
    shape: shapes.Source
    options: Options


def write_all(paths, result, shape, options, progress):
    """Writes the result to each path. Raises InputError or SweepMeshError; no file is left half-written."""
    for i, path in enumerate(paths):
        progress.update(i / len(paths), f"Writing {path}")
        if pathlib.Path(path).suffix.lower() in output.OWN_FORMATS:
            output.write(result, path)
        else:
            with output.replacing(path) as temporary:
                _write_in_process(Job(result, str(temporary), shape.source, options))


def _write_in_process(job):
    folder = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    with tempfile.NamedTemporaryFile(prefix="sweepmesh_", suffix=".pickle", dir=folder) as file:
        pickle.dump(job, file, protocol=5)
        file.flush()
        command = [sys.executable, "-m", "sweepmesh.cli.writing", file.name]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        try:
            _, errors = process.communicate()
        except BaseException:
            process.kill()
            process.wait()
            raise
    if process.returncode:
        lines = errors.strip().splitlines() or [f"Writing {job.path} failed with status {process.returncode}."]
        raise SweepMeshError(lines[-1])


def _work(path):
    """The writing process: does the job in the file `path`."""
    with open(path, "rb") as file:
        job = pickle.load(file)
    made = None
    if job.path.lower().endswith(".fcstd"):
        made = shapes.document_object(job.shape)
    output.write(job.result, job.path, made, job.options)


if __name__ == "__main__":
    try:
        _work(sys.argv[1])
    except SweepMeshError as error:
        print(error, file=sys.stderr)
        sys.exit(1)

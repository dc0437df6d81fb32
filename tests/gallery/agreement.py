"""Do verdict and mesher agree? One solid after the other is assessed, meshed and judged in processes of their own.

Each solid gives an outcome:

    meshed     called sweepable, and a valid mesh came out
    refused    called unsweepable, and no picks that suggest themselves mesh either
    folded     called sweepable, and then found to be geometrically not sweepable
    failed     called sweepable, and an error ended the run
    wrong      called sweepable, and what came out is not a valid mesh of the solid
    missed     called unsweepable, though some picks lead to a valid mesh
    unsound    refused on reading, with a sentence: an edge with three faces, say
    crashed    the process died
    hung       no answer in time
"""

import dataclasses
import json
import os
import pathlib
import queue
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(ROOT / "Mod"), str(HERE)]

AGREEING = ("meshed", "refused", "unsound")
FAILING = ("folded", "failed", "wrong", "crashed", "hung")
OUTCOMES = (*AGREEING, *FAILING, "missed")
SECONDS = 60.0
"""Processor time that a solid may take: assessing, meshing, judging, and the picks of a refused one. Five times of that
on the clock, as other work may be in the way."""


@dataclasses.dataclass
class Examined:
    """What came of one solid."""

    name: str
    """ "terraced 7", or the name of a solid of the gallery or of a file."""
    outcome: str
    detail: str = ""
    n_faces: int = 0
    n_elements: int = 0
    least: float = 0.0
    """Least scaled Jacobian."""
    assess_seconds: float = 0.0
    seconds: float = 0.0

    @property
    def agrees(self):
        """Did verdict and mesher say the same?"""
        return self.outcome in AGREEING


def run_all(jobs, n_processes=2, seconds=SECONDS, report=lambda examined: None):
    """[Examined] in the order of the jobs; each job is a list: ["random", family, seed] or ["file", path]."""
    waiting, done = queue.Queue(), [None] * len(jobs)
    for item in enumerate(jobs):
        waiting.put(item)

    def serve():
        worker = Worker()
        while True:
            try:
                place, job = waiting.get_nowait()
            except queue.Empty:
                return worker.stop()
            done[place] = worker.examine(job, seconds)
            report(done[place])

    threads = [threading.Thread(target=serve) for _ in range(n_processes)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return done


class Worker:
    """A process that examines solids; a new one takes its place where it dies or hangs."""

    def __init__(self):
        self._process = None

    def examine(self, job, seconds):
        """Examined, within about `seconds`."""
        if self._process is None:
            self._process = subprocess.Popen(
                [sys.executable, __file__], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL, text=True,
            )  # fmt: skip
        is_late, is_done = threading.Event(), threading.Event()
        process = self._process
        watch = threading.Thread(target=_kill_when_late, args=(process, seconds, is_late, is_done))
        watch.start()
        self._send(job)
        answer = process.stdout.readline()
        is_done.set()
        watch.join()
        if answer:
            return Examined(**json.loads(answer))
        process.wait()
        self._process = None
        name = name_of(job)
        return Examined(name, "hung" if is_late.is_set() else "crashed", f"exit status {process.returncode}")

    def _send(self, job):
        try:
            self._process.stdin.write(json.dumps(job) + "\n")
            self._process.stdin.flush()
        except BrokenPipeError:
            pass  # seen when the answer is missing

    def stop(self):
        """Ends the process."""
        if self._process is not None:
            self._process.stdin.close()
            self._process.wait()


def _kill_when_late(process, seconds, is_late, is_done):
    begun, begun_work = time.monotonic(), _processor_seconds(process.pid)
    while not is_done.wait(0.5):
        work = _processor_seconds(process.pid) - begun_work
        if work > seconds or time.monotonic() - begun > 5 * seconds:
            is_late.set()
            return process.kill()


def _processor_seconds(pid):
    """Of a process and its children that have ended; 0 for one that is gone."""
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    except OSError:
        return 0.0
    return sum(int(ticks) for ticks in fields[11:15]) / os.sysconf("SC_CLK_TCK")


def name_of(job):
    """ "terraced 7", or a file's name without its suffix."""
    return f"{job[1]} {job[2]}" if job[0] == "random" else pathlib.Path(job[1]).stem


# In the worker.


def serve_jobs():
    """Reads jobs from stdin, one a line, and answers each with one line."""
    from gallery import find_judge
    from sweepmesh.freecad import import_freecad

    import_freecad()
    judge = find_judge()
    for line in sys.stdin:
        examined = examine(json.loads(line), judge)
        sys.__stdout__.write(json.dumps(dataclasses.asdict(examined)) + "\n")
        sys.__stdout__.flush()


def examine(job, judge):
    """Examined of one job."""
    import sweepmesh

    with tempfile.TemporaryDirectory() as folder:
        path = job[1] if job[0] == "file" else made(job, pathlib.Path(folder) / "solid.brep")
        started = time.perf_counter()
        out = Examined(name_of(job), "refused")
        try:
            model = sweepmesh.read(path)
        except sweepmesh.InputError as error:
            return dataclasses.replace(out, outcome="unsound", detail=str(error))
        out.n_faces = len(model.faces)
        assess_started = time.perf_counter()
        verdict = sweepmesh.assess(model)
        out.assess_seconds = time.perf_counter() - assess_started
        if verdict.is_sweepable:
            out.outcome, out.detail = meshed(model, path, {}, judge, out)
        else:
            out.detail = f"{verdict.reasons[0].kind}: {verdict.reasons[0].text}"
            if picks := picks_that_mesh(model, path, judge):
                out.outcome, out.detail = "missed", f"meshes with {picks}; {out.detail}"
        out.seconds = time.perf_counter() - started
    return out


def made(job, path):
    """Writes the random solid of a job."""
    from random_solids import make

    make(job[1], job[2]).exportBrep(str(path))
    return path


def meshed(model, path, picks, judge, out=None):
    """(outcome, detail) of meshing a solid that was called sweepable."""
    import sweepmesh

    try:
        result = sweepmesh.mesh(model, sweepmesh.Options(**picks))
    except sweepmesh.SweepMeshError as error:
        return "failed", f"{type(error).__name__}, {error.stage}: {error}"
    if not result.assessment.is_sweepable:
        return "folded", result.assessment.reasons[0].text
    if out is not None:
        out.n_elements, out.least = result.n_elements, result.quality["min_scaled_jacobian"]
    wrong = faults(result, model, path, judge)
    return ("wrong", wrong) if wrong else ("meshed", "; ".join(result.warnings))


def faults(result, model, path, judge):
    """What is wrong with a mesh: the judge's failures, or where there is no judge the checker's."""
    import sweepmesh
    from checker import expect_valid_sweep

    if judge is None:
        try:
            expect_valid_sweep(result, model)
        except AssertionError as error:
            return str(error)
        return ""
    with tempfile.TemporaryDirectory() as folder:
        mesh_path = pathlib.Path(folder) / "mesh.vtu"
        sweepmesh.write(result, mesh_path)
        return "; ".join(map(str, judge(str(mesh_path), str(path))["failures"]))


def picks_that_mesh(model, path, judge):
    """The picks of a refused solid that lead to a valid mesh; None if none of those tried does."""
    for picks in suggested_picks(path):
        if meshed(model, path, picks, judge)[0] == "meshed":
            return picks
    return None


def suggested_picks(path):
    """For each direction of plane faces: those along it as sources, those against it as targets."""
    import Part

    shape = Part.Shape()
    shape.read(str(path))
    planes = [
        (number, face.normalAt(*face.Surface.parameter(face.CenterOfMass)))
        for number, face in enumerate(shape.Faces, 1)
        if isinstance(face.Surface, Part.Plane)
    ]
    directions = []
    for _, normal in planes:
        if all(abs(normal.dot(other)) < 0.9999 for other in directions):
            directions.append(normal)
    for direction in directions:
        along, against = (
            [number for number, normal in planes if sign * normal.dot(direction) > 0.9999] for sign in (1, -1)
        )
        if along and against:
            yield {"sources": along, "targets": against}


if __name__ == "__main__":
    serve_jobs()

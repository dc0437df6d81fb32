"""FreeCAD in an X server of its own, with settings of its own, running one macro."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
SCREEN = "1280x900x24"

_USER_CFG = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General">
 <FCText Name="AutoloadModule">PartWorkbench</FCText><FCBool Name="ShowSplasher" Value="0"/>
</FCParamGroup>
<FCParamGroup Name="Mod">
 <FCParamGroup Name="Start"><FCBool Name="ShowOnStartup" Value="0"/></FCParamGroup>
</FCParamGroup>
<FCParamGroup Name="Dialog"><FCBool Name="DontUseNativeFileDialog" Value="1"/></FCParamGroup>
<FCParamGroup Name="View"><FCBool Name="ShowNaviCube" Value="0"/></FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""


def missing_programs():
    return [name for name in ("freecad", "Xvfb", "import") if not shutil.which(name)]


def run(macro, folder, timeout=300, environment=None):
    """Run a macro of this folder; return what it wrote to results.json. The pictures are in `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in [*folder.glob("*.png"), *folder.glob("results.json")]:
        old.unlink()
    subprocess.run([ROOT / "scripts" / "translations.sh"], check=True)
    home = _home(folder)
    with _server() as display:
        log = folder / "freecad.log"
        with open(log, "w") as output:
            command = ["freecad", "-u", home / "user.cfg", "-s", home / "system.cfg", HERE / macro]
            process = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                env=_environment(home, folder, display, environment or {}),
            )
            status = _end_of(process, log, timeout)
    results, said = folder / "results.json", log.read_text(encoding="utf-8", errors="replace")
    assert results.exists(), f"FreeCAD ended with {status} and left no results:\n{said[-4000:]}"
    return {**json.loads(results.read_text(encoding="utf-8")), "tracebacks": _tracebacks(said)}


def _end_of(process, log, timeout):
    """Wait for FreeCAD to end; it is ended where it takes too long, or where it says that it cannot read the macro."""
    end = time.monotonic() + timeout
    while process.poll() is None:
        said = log.read_text(encoding="utf-8", errors="replace")
        if time.monotonic() > end or "Exception while processing file" in said:
            process.kill()
            process.wait()
        time.sleep(0.2)
    return process.returncode


def _tracebacks(text):
    """Errors in slots and observers end no macro: they only reach the log. Failed recomputes are logged there too."""
    parts = [part.strip() for part in text.split("Traceback (most recent call last):")[1:]]
    return [part[-600:] for part in parts if "in execute" not in part]


class _server:
    """An X server on a free display, which it names itself."""

    def __enter__(self):
        read, write = os.pipe()
        command = ["Xvfb", "-displayfd", str(write), "-screen", "0", SCREEN, "-dpi", "96", "-nolisten", "tcp"]
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        self._process = subprocess.Popen(command, pass_fds=[write], **quiet)
        os.close(write)
        with os.fdopen(read) as numbers:
            return f":{numbers.readline().strip()}"

    def __exit__(self, *_):
        self._process.terminate()
        self._process.wait(timeout=20)


def _home(folder):
    home = folder / "home"
    shutil.rmtree(home, ignore_errors=True)
    (home / "Mod").mkdir(parents=True)
    (home / "Mod" / "SweepMesh").symlink_to(ROOT)
    (home / "user.cfg").write_text(_USER_CFG)
    return home


def _environment(home, folder, display, extra):
    inherited = {name: value for name, value in os.environ.items() if name not in ("WAYLAND_DISPLAY", "PYTHONHOME")}
    runtime = home / "runtime"
    runtime.mkdir(mode=0o700, exist_ok=True)
    return {
        **inherited,
        "DISPLAY": display,
        "HOME": str(home),
        "FREECAD_USER_HOME": str(home),
        "XDG_RUNTIME_DIR": str(runtime),
        "QT_QPA_PLATFORM": "xcb",
        "QT_AUTO_SCREEN_SCALE_FACTOR": "0",
        "LIBGL_ALWAYS_SOFTWARE": "1",
        "SWEEPMESH_TEST_OUT": str(folder),
        "SWEEPMESH_TEST_CODE": str(HERE),
        **extra,
    }


if __name__ == "__main__":
    print(json.dumps(run(sys.argv[1], ROOT / "build" / "gui" / pathlib.Path(sys.argv[1]).stem[len("macro_") :]), indent=1))

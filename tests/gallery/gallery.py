"""The gallery as tests and tables use it: built once, cached in the build folder; and the judge, where there is one."""

import dataclasses
import hashlib
import importlib.util
import json
import os
import pathlib
import subprocess
import sys

from sweepmesh import Options, face_at, mesh, read
from sweepmesh.freecad import import_freecad

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
FOLDER = ROOT / "build" / "gallery"


@dataclasses.dataclass
class Case:
    """One solid with the picks of one of its schemes, or with none."""

    name: str
    entry: dict
    scheme: int = -1
    """Index in the manifest; -1 for no picks."""

    @property
    def path(self):
        return FOLDER / self.entry["file"]

    @property
    def size(self):
        return self.entry["element_size"]

    @property
    def genus(self):
        """Of each shell of the solids."""
        return self.entry["genus"]

    @property
    def label(self):
        return f"{self.name}-{'free' if self.scheme < 0 else f'scheme{self.scheme}'}"

    def picks(self, model):
        """The options sources, targets and pairs of the scheme, for a Model of the solid."""
        if self.scheme < 0:
            return {}
        chosen = self.entry["schemes"][self.scheme]
        sources, targets = ([face_at(model, point) for point in chosen[side]] for side in ("sources", "targets"))
        pairs = [(sources[i], targets[k]) for i, k in chosen.get("pairs", [])]
        return {"sources": sources, "targets": targets, "pairs": pairs}

    def mesh(self):
        """(Model, Result) at the manifest's element size."""
        model = read(self.path)
        return model, mesh(model, Options(size=self.size, **self.picks(model)))


def manifest():
    """The solids, {name: entry}; builds the gallery where its sources have changed."""
    sources = sorted([HERE / "build_gallery.py", *(HERE / "solids").glob("*.py")])
    stamp = hashlib.sha256(b"".join(path.read_bytes() for path in sources)).hexdigest()
    kept = FOLDER / "stamp"
    if not kept.is_file() or kept.read_text() != stamp:
        subprocess.run([sys.executable, sources[0], FOLDER], check=True, stdout=subprocess.DEVNULL)
        kept.write_text(stamp)
    entries = json.loads((FOLDER / "gallery.json").read_text())["solids"]
    return {entry["name"]: entry for entry in entries}


def cases(*kinds):
    """Each solid of the kinds without picks and with those of each of its schemes."""
    return [
        Case(name, entry, scheme)
        for name, entry in manifest().items()
        if entry["kind"] in kinds
        for scheme in range(-1, len(entry["schemes"]))
    ]


def find_judge():
    """The function judge(mesh path, shape path) of an independent checker beside the checkout; None without it."""
    shared = pathlib.Path(os.environ.get("SWEEPMESH_SHARED", ROOT.parent / "shared"))
    path = shared / "judge" / "judge_mesh.py"
    if not path.is_file():
        return None
    import_freecad()  # the judge needs it; its modules crash when another of them comes first
    spec = importlib.util.spec_from_file_location("judge_mesh", path)
    module = importlib.util.module_from_spec(spec)
    sys.modules["judge_mesh"] = module
    spec.loader.exec_module(module)
    return module.judge

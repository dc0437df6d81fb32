"""Preferences: defaults, and what they do to runs without a panel."""
import pathlib
import re

import FreeCAD
import pytest

from sweepmesh import app, engine
from sweepmesh.app import preferences

FORM = pathlib.Path(__file__).resolve().parents[3] / "Resources" / "ui" / "Preferences.ui"


@pytest.fixture
def group():
    """The group of preferences, empty before and after the test."""
    group = FreeCAD.ParamGet(preferences.GROUP)
    group.Clear()
    yield group
    group.Clear()


def test_defaults(group):
    assert preferences.wished_elements() == 3000 and preferences.order() == 1 and preferences.threads() == 0
    assert preferences.hide_solid() and preferences.colour_faces()


def test_every_entry_of_the_page_is_read_somewhere():
    entries = re.findall(r'prefEntry"[^>]*>\s*<cstring>(\w+)', FORM.read_text(encoding="utf-8"))
    code = pathlib.Path(preferences.__file__).read_text(encoding="utf-8")
    assert len(entries) == 5 and all(f'"{entry}"' in code for entry in entries)


def test_nonsense_is_put_right(group):
    group.SetInt("WishedElements", -5)
    group.SetInt("Threads", -1)
    assert preferences.wished_elements() == 1 and preferences.threads() == 0


def test_threads_reach_the_engine_and_change_no_mesh(group, box, monkeypatch):
    asked = []
    run = engine.mesh

    def spy(brep, options, progress=None):
        asked.append(options.threads)
        return run(brep, options, progress)

    monkeypatch.setattr(engine, "mesh", spy)
    group.SetInt("Threads", 1)
    mesh = app.make_sweep_mesh(box, size=1.0)
    group.SetInt("Threads", 2)
    mesh.touch()
    box.Document.recompute()
    assert asked == [1] and mesh.isValid()

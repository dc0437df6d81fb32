"""What's This: Shift+F1, then a click on a command or on a field of the panel.

FreeCAD shows no bubbles: it hands every What's This text, be it a page or a sentence, to its Help addon, or says that
this is not installed. Here a stand-in takes the addon's place.
"""
import os
import pathlib
import sys
import types

sys.path.insert(0, os.environ["SWEEPMESH_TEST_CODE"])
import FreeCAD
import FreeCADGui
from driver import (
    LEFT, NO_KEY, QtGui, QTest, check, go, is_panel_open, note, panel_button, press, reveal, rows, settle, show_all,
    tool_button, type_shortcut, wait_for, widget,
)

COMMAND = "Create sweep mesh"


def steps():
    asked = []
    sys.modules["Help"] = types.SimpleNamespace(show=asked.append)
    document = FreeCAD.newDocument("Part")
    brick = document.addObject("Part::Box", "Brick")
    document.recompute()
    show_all()
    FreeCADGui.Selection.addSelection(brick)
    wait_for(lambda: tool_button(COMMAND).isEnabled())
    a_command(asked)
    press(tool_button(COMMAND))
    check("the panel opens", lambda: rows("targets"))
    for name in ("propose", "pickSources", "showRoles", "layerCount"):
        a_field(name, asked)
    press(panel_button("Cancel"))
    check("the panel closes", lambda: not is_panel_open())


def a_command(asked):
    ask_about(tool_button(COMMAND))
    check("FreeCAD's help is asked for a page", lambda: len(asked) == 1)
    page = pathlib.Path(asked[0]).read_text(encoding="utf-8")
    check("which is there and says what the command does", COMMAND in page)
    check("the command does not run", not is_panel_open())


def a_field(name, asked):
    field, before = widget(name), settings()
    reveal(field)
    asked.clear()
    ask_about(field)
    check(f"help is asked for about {name}", lambda: asked)
    note(f"text of {name}", list(asked))
    check(f"with the text of {name}", len(asked) == 1 and asked[0] == field.whatsThis() != "")
    check(f"{name} is not pressed", settings() == before)


def ask_about(target):
    type_shortcut("Std_WhatsThis")
    check("Shift+F1 asks what to explain", lambda: QtGui.QWhatsThis.inWhatsThisMode())
    QTest.mouseClick(target, LEFT, NO_KEY)
    settle()


def settings():
    return widget("showRoles").isChecked(), widget("pickSources").isChecked(), rows("sources"), rows("targets")


go(steps)

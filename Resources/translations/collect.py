"""Collect the texts of the workbench into SweepMesh.ts, as Qt's lupdate would, which Debian's FreeCAD lacks."""
import ast
import pathlib
import xml.etree.ElementTree as ElementTree

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
CONTEXT = "SweepMesh"


def collect():
    """Return {context: [texts]}, sorted, without doubles."""
    found = {}
    for path in [ROOT / "InitGui.py", *(ROOT / "Mod" / "sweepmesh" / "app").rglob("*.py")]:
        _add_code(found, path)
    for path in (ROOT / "Mod" / "sweepmesh" / "gui").rglob("*.py"):
        _add_code(found, path)
    for path in (ROOT / "Resources" / "ui").glob("*.ui"):
        _add_form(found, path)
    return {context: sorted(texts) for context, texts in sorted(found.items())}


def _add_code(found, path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call):
            _add_call(found, getattr(node.func, "attr", getattr(node.func, "id", "")), node.args)


def _add_call(found, function, arguments):
    texts = [argument.value for argument in arguments if _is_text(argument)]
    if function in ("translate", "QT_TRANSLATE_NOOP") and len(texts) == 2:
        found.setdefault(texts[0], set()).add(texts[1])
    elif function == "tr" and texts:
        found.setdefault(CONTEXT, set()).add(texts[0])
    elif function == "Property" and len(texts) > 2:
        found.setdefault(CONTEXT, set()).add(texts[2])


def _is_text(argument):
    return isinstance(argument, ast.Constant) and isinstance(argument.value, str)


def _add_form(found, path):
    root = ElementTree.parse(path).getroot()
    context = root.findtext("class")
    for element in root.iter("string"):
        if element.get("notr") != "true" and element.text:
            found.setdefault(context, set()).add(element.text)


def translated(path):
    """Return {(context, text): translation} of a .ts file, finished ones only; empty where there is no file."""
    done = {}
    for entry in ElementTree.parse(path).getroot().iter("context") if path.exists() else ():
        for message in entry.iter("message"):
            translation = message.find("translation")
            if translation.get("type") is None and translation.text:
                done[entry.findtext("name"), message.findtext("source")] = translation.text
    return done


def as_ts(found, done=None, language=None):
    """Return the text of a .ts file with these texts, translated as far as `done` has them."""
    root = ElementTree.Element("TS", version="2.1", sourcelanguage="en")
    if language:
        root.set("language", language)
    for context, texts in found.items():
        entry = ElementTree.SubElement(root, "context")
        ElementTree.SubElement(entry, "name").text = context
        for text in texts:
            message = ElementTree.SubElement(entry, "message")
            ElementTree.SubElement(message, "source").text = text
            text = (done or {}).get((context, text))
            ElementTree.SubElement(message, "translation", {} if text else {"type": "unfinished"}).text = text
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n' + ElementTree.tostring(root, "unicode") + "\n"


def files():
    """Return {path: what it should hold}: the template, and every translation with what it has already."""
    found = collect()
    made = {HERE / "SweepMesh.ts": as_ts(found)}
    for path in HERE.glob("SweepMesh_*.ts"):
        made[path] = as_ts(found, translated(path), path.stem.partition("_")[2])
    return made


if __name__ == "__main__":
    for target, content in files().items():
        target.write_text(content, encoding="utf-8")

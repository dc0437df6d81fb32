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


def as_ts(found):
    """Return the text of a .ts file with these texts, none of them translated."""
    root = ElementTree.Element("TS", version="2.1", sourcelanguage="en")
    for context, texts in found.items():
        entry = ElementTree.SubElement(root, "context")
        ElementTree.SubElement(entry, "name").text = context
        for text in texts:
            message = ElementTree.SubElement(entry, "message")
            ElementTree.SubElement(message, "source").text = text
            ElementTree.SubElement(message, "translation", type="unfinished")
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n' + ElementTree.tostring(root, "unicode") + "\n"


if __name__ == "__main__":
    (HERE / "SweepMesh.ts").write_text(as_ts(collect()), encoding="utf-8")

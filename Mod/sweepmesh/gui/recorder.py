"""What panels do, as Python that a user can read in the console and keep as a macro."""
import FreeCAD
import FreeCADGui


def run(document, title, lines):
    """Run `lines` through FreeCAD's recorder as one step of undo; all or nothing."""
    document.openTransaction(title)
    try:
        FreeCADGui.addModule("sweepmesh.app")
        for line in lines:
            FreeCADGui.doCommand(line)
    except Exception:
        document.abortTransaction()
        raise
    document.commitTransaction()


def reference(obj):
    """Return the expression that names a document object: App.ActiveDocument.Body."""
    if obj.Document == FreeCAD.ActiveDocument:
        return f"App.ActiveDocument.{obj.Name}"
    return f'App.getDocument("{obj.Document.Name}").{obj.Name}'


def arguments(settings):
    """Return keyword arguments: ['size=2.0', 'sources=["Face5"]']."""
    return [f"{name}={_text(value)}" for name, value in settings.items()]


def _text(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_text(key)}: {_text(item)}" for key, item in value.items()) + "}"
    if isinstance(value, tuple):
        return "(" + ", ".join(_text(item) for item in value) + ")"
    if isinstance(value, list):
        return "[" + ", ".join(_text(item) for item in value) + "]"
    return f'"{value}"' if isinstance(value, str) else repr(value)


def active_analysis(document):
    """Return the active FEM analysis of `document`, or None."""
    import FemGui

    analysis = FemGui.getActiveAnalysis()
    return analysis if analysis is not None and analysis.Document == document else None

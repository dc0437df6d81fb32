"""Keep the divided caps and the imprinted curves of a sweep in a document."""
from sweepmesh.app.imprints import imprint

_CURVE_COLOR = (0.1, 0.2, 0.8)
_CURVE_WIDTH = 3.0


def make_imprint(source, name="Imprint", made=None, **settings):
    """Put the imprint of a document object's solid into its document: a group, returned, with two shapes.

    source    the object with the solid
    made      its `Imprint`, where there is one already
    settings  as for `mesh`: size=2.0, sources=["Face5"], ...; used where `made` is not given

    The group's first object has the divided caps, coloured by pair, with `Caps` (face of the solid), `Roles` and
    `Pairs` of each of its faces; the second the imprinted curves, with `Caps` of each of its wires. They are
    shapes like any other: they stay as they are when the solid changes.
    """
    made = made or imprint(source, **settings)
    document = source.Document
    group = document.addObject("App::DocumentObjectGroup", name)
    group.Label = f"Imprint of {source.Label}"
    group.addObject(_divided_caps(document, made))
    group.addObject(_curves(document, made))
    return group


def _divided_caps(document, made):
    parts = made.details.parts
    obj = document.addObject("Part::Feature", "DividedCaps")
    obj.Shape = made.caps
    _add(obj, "App::PropertyStringList", "Caps", "The face that each part belongs to", [p.cap for p in parts])
    _add(obj, "App::PropertyStringList", "Roles", "Whether that is a source or a target", [p.role for p in parts])
    _add(obj, "App::PropertyIntegerList", "Pairs", "Parts of one pair are swept to each other", made.pairs)
    view = getattr(obj, "ViewObject", None)
    if view is not None:
        view.DiffuseColor = [(*color, 0.0) for color in made.colors]
    return obj


def _curves(document, made):
    obj = document.addObject("Part::Feature", "ImprintedCurves")
    obj.Shape = made.curves
    _add(obj, "App::PropertyStringList", "Caps", "The face that each curve lies on", made.details.curve_caps)
    view = getattr(obj, "ViewObject", None)
    if view is not None:
        view.LineColor, view.LineWidth = _CURVE_COLOR, _CURVE_WIDTH
    return obj


def _add(obj, kind, name, text, value):
    obj.addProperty(kind, name, "Imprint", text, 1)  # 1: read-only
    setattr(obj, name, value)

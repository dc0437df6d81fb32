"""How objects are shown: the gui registers its view providers here, as app does not know the gui."""

_FACTORIES = {}


def register_view(kind, factory):
    """Let `factory(view_object)` dress the view of objects of `kind` ("Sweep")."""
    _FACTORIES[kind] = factory


def attach_view(kind, obj):
    """Dress the view of a document object; nothing happens where there is no window."""
    view_object = getattr(obj, "ViewObject", None)
    if view_object is not None and kind in _FACTORIES:
        _FACTORIES[kind](view_object)

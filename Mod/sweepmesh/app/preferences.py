"""The user's preferences: one typed getter and one default each.

The page Resources/ui/Preferences.ui edits them; the names here are those of its widgets' `prefEntry`.
"""
import FreeCAD

GROUP = "User parameter:BaseApp/Preferences/Mod/SweepMesh"

DEFAULT_ELEMENTS = 3000
DEFAULT_ORDER = 1
DEFAULT_THREADS = 0
DEFAULT_HIDE_SOLID = True
DEFAULT_COLOUR_FACES = True


def _group():
    return FreeCAD.ParamGet(GROUP)


def wished_elements():
    """How many elements the size that a panel starts with is to give."""
    return max(1, _group().GetInt("WishedElements", DEFAULT_ELEMENTS))


def order():
    """Order of the elements that a panel starts with: 1 or 2."""
    return 1 + _group().GetInt("Order", DEFAULT_ORDER - 1)


def threads():
    """How many threads mesh; 0: one a processor."""
    return max(0, _group().GetInt("Threads", DEFAULT_THREADS))


def hide_solid():
    """Is the solid hidden when its mesh is made?"""
    return _group().GetBool("HideSolid", DEFAULT_HIDE_SOLID)


def colour_faces():
    """Are faces coloured by their roles when a panel opens?"""
    return _group().GetBool("ColourFaces", DEFAULT_COLOUR_FACES)

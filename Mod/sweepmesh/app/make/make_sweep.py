"""Make a sweep mesh in a document, and change it."""
from sweepmesh.app import overrides
from sweepmesh.app.objects.sweep import ORDERS, Sweep
from sweepmesh.app.stages import options_for
from sweepmesh.app.views import attach_view

_PROPERTIES = {
    "size": "Size",
    "layers": "Layers",
    "element": "Element",
    "solid": "Solid",
    "max_elements": "MaxElements",
    "refuse_folds": "RefuseFolds",
    "imprint_tolerance": "ImprintTolerance",
}


def make_sweep_mesh(shape_object, options=None, analysis=None, name="SweepMesh", **settings):
    """Mesh the solid of a document object and return the mesh as a new object of its document.

    shape_object  the object with the solid
    options       an engine's Options, or nothing
    analysis      a FEM analysis that takes the mesh
    settings      as for `mesh`: size=2.0, sources=["Face5"], ...; used where no options are given

    The mesh object is computed at once. Where meshing fails it stays, with the reason in its `Message`.
    """
    options = options or options_for(shape_object, **settings)
    obj = shape_object.Document.addObject("Fem::FemMeshObjectPython", name)
    Sweep(obj)
    set_options(obj, shape_object, options)
    if analysis is not None:
        analysis.addObject(obj)
    attach_view("Sweep", obj)
    obj.Document.recompute([obj])
    return obj


def update_sweep_mesh(obj, **settings):
    """Change settings of a mesh object (those given, see `mesh`) and compute it."""
    options = options_for(obj.Shape, **settings)
    for name in settings:
        set_option(obj, name, getattr(options, name))
    obj.Document.recompute([obj])


def set_options(obj, shape_object, options):
    """Set the properties of a mesh object to `options` for the solid of `shape_object`."""
    obj.Shape = shape_object
    for name, value in vars(options).items():
        set_option(obj, name, value)


def set_option(obj, name, value):
    """Set the property for one of the engine's options. Threads are no property: they change no mesh."""
    if name in ("sources", "targets"):
        setattr(obj, name.capitalize(), (obj.Shape, [f"Face{number}" for number in value]))
    elif name == "pairs":
        obj.Pairs = [f"Face{source}=Face{target}" for source, target in value]
    elif name == "order":
        obj.Order = ORDERS[value - 1]
    elif name in overrides.PROPERTIES:
        setattr(obj, overrides.PROPERTIES[name], overrides.to_texts(value))
    elif name == "sweep_bias":
        obj.SweepBias, obj.SweepBiasBoth = value or (1.0, False)
    elif name != "threads":
        setattr(obj, _PROPERTIES[name], value or 0)

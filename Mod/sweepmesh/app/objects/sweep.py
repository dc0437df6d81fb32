"""The sweep mesh as a document object: settings, links to the shape and its faces, the mesh, the report."""
from sweepmesh import engine
from sweepmesh.app import overrides, preferences
from sweepmesh.app.elements import arrays_of_femmesh, arrays_of_result
from sweepmesh.app.femmesh import refuse_polyhedra, to_femmesh
from sweepmesh.app.kept_meshes import KeptMeshes
from sweepmesh.app.objects.base import EDITABLE, HIDDEN, READ_ONLY, Property, Proxy, in_group
from sweepmesh.app.progress import ProgressBar
from sweepmesh.app.remembered import fingerprint, take
from sweepmesh.app.shapes import brep_of
from sweepmesh.engine.errors import input_error

ELEMENTS = ("hex", "prism", "polyhedron")
ORDERS = ("1st", "2nd")
VERDICTS = ("unknown", "sweepable", "unsweepable")

TABLE = (
    *in_group(
        "Geometry",
        EDITABLE,
        Property("App::PropertyLink", "Shape", "The object whose solid is meshed"),
        Property("App::PropertyLinkSub", "Sources", "Faces that the mesh is swept from; empty: found"),
        Property("App::PropertyLinkSub", "Targets", "Faces that the sweep ends on; empty: found"),
        Property("App::PropertyStringList", "Pairs", "Which source is swept to which target: Face5=Face6"),
        Property(
            "App::PropertyIntegerConstraint",
            "Solid",
            "Which solid of the shape is meshed; 0: all of them",
            (0, 0, 2**31 - 1, 1),
        ),
        Property("App::PropertyStringList", "VertexTypes", "How linking faces turn at vertices: Face3:Vertex7=corner"),
        Property("App::PropertyLink", "Part", "The shape, under the name that older FreeCADs look for", mode=HIDDEN),
    ),
    *in_group(
        "Mesh",
        EDITABLE,
        Property("App::PropertyLength", "Size", "Wished edge length; 0: chosen from the volume"),
        Property("App::PropertyIntegerConstraint", "Layers", "Number of layers; 0: from the size", (0, 0, 100000, 1)),
        Property("App::PropertyStringList", "EdgeCounts", "Exact numbers of mesh edges on edges: Edge5=12"),
        Property("App::PropertyStringList", "EdgeSizes", "Wished edge lengths on edges: Edge5=0.8"),
        Property("App::PropertyStringList", "EdgeBiases", "How mesh edges grow along edges: Edge5=1.2, Edge5=1.2 both"),
        Property("App::PropertyFloat", "SweepBias", "How mesh edges grow along the sweep; 1: not at all", 1.0),
        Property("App::PropertyBool", "SweepBiasBoth", "They grow from both ends to the middle"),
        Property("App::PropertyLength", "ImprintTolerance", "Nearer curves of caps become one; 0: from the size"),
        Property("App::PropertyEnumeration", "Element", "What the mesh is made of", "hex", ELEMENTS),
        Property("App::PropertyEnumeration", "Order", "Order of the elements", "1st", ORDERS),
        Property(
            "App::PropertyIntegerConstraint",
            "MaxElements",
            "Larger meshes are refused; 0: the default limit",
            (0, 0, 2**31 - 1, 100000),
        ),
        Property("App::PropertyBool", "RefuseFolds", "Holes that wind too far to be meshed are refused at once", True),
    ),
    *in_group(
        "Report",
        READ_ONLY,
        Property("App::PropertyEnumeration", "Verdict", "Can the solid be swept?", "unknown", VERDICTS),
        Property("App::PropertyString", "Message", "Why the last run made no mesh; empty: it made one"),
        Property("App::PropertyStringList", "Reasons", "Why the solid cannot be swept"),
        Property("App::PropertyMap", "Roles", "What each face is: source, target or linking"),
        Property("App::PropertyInteger", "Nodes", "Number of nodes"),
        Property("App::PropertyInteger", "Hexahedra", "Number of hexahedra"),
        Property("App::PropertyInteger", "Prisms", "Number of prisms"),
        Property("App::PropertyLength", "UsedSize", "The edge length that was used"),
        Property("App::PropertyFloat", "MinScaledJacobian", "Quality of the worst element: 1 is a cube"),
        Property("App::PropertyFloat", "MeanScaledJacobian", "Mean quality of the elements"),
        Property("App::PropertyInteger", "Inverted", "Number of inverted elements"),
        Property("App::PropertyIntegerList", "Histogram", "Elements in each of 20 classes of quality, from -1 to 1"),
        Property("App::PropertyFloatList", "ScaledJacobians", "Quality of each element by its id", mode=HIDDEN),
        Property("App::PropertyStringList", "Warnings", "What the last run warned of"),
        Property("App::PropertyString", "Fingerprint", "Of the shape and settings of the mesh", mode=HIDDEN),
    ),
)


class Sweep(Proxy):
    """Proxy of a sweep mesh. A failed run leaves the old mesh in place and says why in `Message`."""

    Type = "SweepMesh::Sweep"
    table = TABLE

    def __init__(self, obj):
        self.loads(None)
        super().__init__(obj)

    def loads(self, state):
        self._kept = KeptMeshes()
        self._shown = ""  # the fingerprint of what FemMesh holds
        self._result = None, None  # the last one, with the fingerprint of what it was made of

    def onDocumentRestored(self, obj):
        super().onDocumentRestored(obj)
        self._shown = obj.Fingerprint if obj.Nodes == obj.FemMesh.NodeCount else ""

    def onChanged(self, obj, name):
        if name == "Shape" and "Part" in obj.PropertiesList and obj.Part != obj.Shape:
            obj.Part = obj.Shape
        if name == "Fingerprint" and obj.Fingerprint != self._shown:
            self._follow_undo(obj)

    def execute(self, obj):
        try:
            brep, options = brep_of(shape_object(obj)), options_of(obj)
            if options.element == "polyhedron":
                refuse_polyhedra()
            key = fingerprint(brep, options)
            if key != self._shown:
                self._store(obj, key, take(brep, options) or _run(obj, brep, options))
            obj.Message = ""
        except Exception as error:
            obj.Message = str(error)
            raise

    def _store(self, obj, key, result):
        store_verdict(obj, result.assessment)
        fem_mesh = to_femmesh(result)
        store_report(obj, result)
        obj.FemMesh = fem_mesh
        self._kept.keep(key, fem_mesh)
        self._result = key, result
        self._shown = obj.Fingerprint = key

    def element_arrays(self, obj):
        """Return what `Elements` takes: from the last result where that is the mesh, which is quicker."""
        key, result = self._result
        return arrays_of_result(result) if key == obj.Fingerprint else arrays_of_femmesh(obj.FemMesh)

    def _follow_undo(self, obj):
        fem_mesh = self._kept.get(obj.Fingerprint)
        if fem_mesh is not None:
            obj.FemMesh = fem_mesh
            self._shown = obj.Fingerprint


def shape_object(obj):
    """Return the object that is meshed; an InputError where there is none."""
    if obj.Shape is None:
        raise input_error("The mesh has no shape: set its property Shape to an object with a solid.")
    return obj.Shape


def options_of(obj):
    """Return the engine's Options for what the properties say."""
    options = engine.Options(element=obj.Element, order=ORDERS.index(obj.Order) + 1, threads=preferences.threads())
    options.size = obj.Size.Value or None
    options.layers = obj.Layers or None
    options.sources = face_numbers(obj, "Sources")
    options.targets = face_numbers(obj, "Targets")
    options.pairs = [_pair(text) for text in obj.Pairs]
    options.solid = obj.Solid or None
    for name, texts in overrides.PROPERTIES.items():
        setattr(options, name, overrides.from_texts(name, getattr(obj, texts)))
    if obj.SweepBias != 1.0:
        options.sweep_bias = obj.SweepBias, obj.SweepBiasBoth
    options.imprint_tolerance = obj.ImprintTolerance.Value or None
    if obj.MaxElements:
        options.max_elements = obj.MaxElements
    options.refuse_folds = obj.RefuseFolds
    return options


def face_numbers(obj, name):
    """Return the numbers of the faces in the link `name` ("Sources" or "Targets")."""
    link = getattr(obj, name)
    if not link or not link[1] or link[1] == ("",):
        return []
    if link[0] != obj.Shape:
        raise input_error(f"{name} are faces of {link[0].Label}, but the mesh is one of {obj.Shape.Label}.")
    return [_number(face) for face in link[1] if face]


def store_verdict(obj, assessment):
    """Put the verdict into the properties; an InputError with the reasons where there is no way to sweep."""
    obj.Verdict = assessment.verdict
    obj.Reasons = [reason.text for reason in assessment.reasons]
    obj.Roles = dict(assessment.roles)
    if assessment.verdict != "sweepable":
        raise input_error(" ".join(["The solid cannot be swept."] + obj.Reasons))


def store_report(obj, result):
    """Put counts, quality and warnings of a result into the properties."""
    obj.Nodes, obj.Hexahedra, obj.Prisms = len(result.points), len(result.hexahedra), len(result.prisms)
    obj.UsedSize = result.size
    _store_quality(obj, result.quality)
    obj.ScaledJacobians = result.scaled_jacobians.tolist()
    obj.Warnings = list(result.warnings)


def _store_quality(obj, quality):
    obj.MinScaledJacobian = quality["min_scaled_jacobian"]
    obj.MeanScaledJacobian = quality["mean_scaled_jacobian"]
    obj.Inverted = quality["n_inverted"]
    obj.Histogram = [int(count) for count in quality["histogram"]]


def _run(obj, brep, options):
    bar = ProgressBar(f"Meshing {obj.Shape.Label}")
    try:
        return engine.mesh(brep, options, bar)
    finally:
        bar.stop()


def _pair(text):
    names = [name.strip() for name in text.split("=")]
    if len(names) != 2:
        raise input_error(f"{text} is no pair of faces: Face5=Face6 would be one.")
    return tuple(_number(name) for name in names)


def _number(name):
    if not name.startswith("Face") or not name[4:].isdigit():
        raise input_error(f"{name} is no face: sources and targets are faces.")
    return int(name[4:])

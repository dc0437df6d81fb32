"""The stages of sweep meshing for macros: assess, plan, mesh.

Each takes a document object or a Part shape, and settings by keyword:

    size          wished edge length in mm; none given: chosen from the volume
    layers        number of layers from the lowest to the highest cap; none given: from the size
    element       "hex", "prism" or "polyhedron"
    order         1 or 2
    sources       faces from which the mesh is swept; none given: found
    targets       faces on which it ends; none given: found
    solid         which solid of several is meshed, from 1; none given: all
    pairs         [(source, target), ...]: this source is to be swept to this target
    vertex_types  {("Face3", "Vertex7"): "corner", ...}: "end", "side", "corner" or "reversal" at a vertex of a
                  linking face, names or numbers; others are found
    edge_count    {"Edge5": 12}: exactly 12 mesh edges on this edge; others follow where they must
    edge_size     {"Edge5": 0.8}: wished edge length on this edge
    edge_bias     {"Edge5": 1.2}: each mesh edge is 1.2 times as long as the one before, from the edge's start;
                  (1.2, True): from both ends
    sweep_bias    1.2 or (1.2, True): the same for all edges along the sweep, from targets to sources
    imprint_tolerance  curves of different caps nearer than this become one; none given: from the size
    threads       0: all processors
    max_elements  refuse meshes that would have more
    refuse_folds  False: holes that wind too far to be meshed are tried all the same

A face is a name ("Face7"), a number (7), a Part.Face, or a point on it: (x, y, z); an edge a name, a number or a
Part.Edge.
"""
from dataclasses import dataclass, field

from sweepmesh import engine
from sweepmesh.app import overrides
from sweepmesh.app.shapes import brep_of, face_number


@dataclass
class Plan:
    """What a mesh would be made of; `print` it, change its `options`, hand it to `mesh`."""

    brep: str = field(repr=False)
    options: object
    details: object = field(repr=False)
    """The engine's SweepPlan: vertex types (`corners`), `intervals`, `levels`, `edge_roles`, `size`, `n_layers`."""

    @property
    def assessment(self):
        return self.details.assessment

    @property
    def is_sweepable(self):
        return self.assessment.verdict == "sweepable"

    @property
    def roles(self):
        """{"Face1": "source", ...} as picked and found."""
        return self.assessment.roles

    @property
    def intervals(self):
        """{"Edge1": 12, ...}: mesh edges on each edge of the solid."""
        return self.details.intervals

    def faces(self, role):
        """Return the names of the faces with a role ("source", "target", "linking"), by number."""
        return faces_with(self.roles, role)

    def __str__(self):
        if not self.is_sweepable:
            return "\n".join(["Not sweepable."] + [f"  {reason.text}" for reason in self.assessment.reasons])
        lines = [f"{role:8} {' '.join(self.faces(role))}" for role in ("source", "target", "linking")]
        return "\n".join(lines + [f"size     {self.details.size:g}", f"layers   {self.details.n_layers}"])


def faces_with(roles, role):
    """Return the names of the faces that have `role` in {"Face1": role, ...}, by number."""
    return sorted((face for face, its in roles.items() if its == role), key=lambda name: int(name[4:]))


def options_for(source, **settings):
    """Return the engine's Options for `source` from keyword settings (see the module's text)."""
    for name in ("sources", "targets"):
        if name in settings:
            settings[name] = [face_number(source, face) for face in settings[name] or []]
    if "pairs" in settings:
        settings["pairs"] = [tuple(face_number(source, face) for face in pair) for pair in settings["pairs"] or []]
    for name in overrides.PROPERTIES:
        if name in settings:
            settings[name] = overrides.by_number(source, name, settings[name])
    if "sweep_bias" in settings:
        settings["sweep_bias"] = overrides.bias(settings["sweep_bias"])
    return engine.Options(**settings)


def assess(source, **settings):
    """Say whether a solid can be swept: `.verdict`, `.reasons`, `.roles` of the faces, other `.schemes`."""
    return engine.assess(brep_of(source), options_for(source, **settings))


def plan(source, **settings):
    """Return the `Plan` for a mesh: settings, sources and targets as picked or found, numbers of mesh edges."""
    brep, options = brep_of(source), options_for(source, **settings)
    details = engine.plan(brep, options)
    made = Plan(brep, options, details)
    if made.is_sweepable:
        options.sources = [int(name[4:]) for name in made.faces("source")]
        options.targets = [int(name[4:]) for name in made.faces("target")]
    return made


def mesh(source, progress=None, **settings):
    """Mesh a solid, a shape or a `Plan` and return the engine's `Result` (points, hexahedra, quality, ...).

    Raises the engine's `SweepMeshError`; a solid that cannot be swept is no error but a `Result` without
    elements whose `.assessment` says why. `to_femmesh(result)` makes a `Fem.FemMesh` of it.
    """
    if isinstance(source, Plan):
        return engine.mesh(source.brep, source.options, progress)
    return engine.mesh(brep_of(source), options_for(source, **settings), progress)

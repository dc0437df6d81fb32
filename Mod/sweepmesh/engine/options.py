"""What a run can be told. Every default is the one of the C++ core."""

import dataclasses
from typing import Dict, List, Mapping, Optional, Sequence, Tuple, Union

from sweepmesh.engine import _sweepmesh
from sweepmesh.engine.errors import input_error
from sweepmesh.engine.names import face_number, vertex_number

_DEFAULTS = _sweepmesh.SweepOptions()


@dataclasses.dataclass
class Options:
    """Options of `assess` and `mesh`. Faces are numbered as in FreeCAD: 7 means Face7."""

    size: Optional[float] = _DEFAULTS.size
    """Wished edge length in the unit of the shape (mm). None: chosen from the volume."""
    layers: Optional[int] = _DEFAULTS.layers
    """Layers from the lowest to the highest level, 1 or more. None: from the size."""
    element: str = _DEFAULTS.element.name
    """"hex", "prism" or "polyhedron"."""
    order: int = _DEFAULTS.order
    """1 for linear elements, 2 for quadratic ones."""
    threads: int = 0
    """Threads to use; 0 for as many as the machine has. The mesh does not depend on it."""
    max_elements: Optional[int] = None
    """A run that would make more elements is refused. None: the default limit."""
    refuse_folds: bool = _DEFAULTS.refuse_folds
    """Whether holes that wind too far to be meshed are refused before any mesh. False: `mesh` tries them all the same."""
    sources: List[int] = dataclasses.field(default_factory=list)
    """Source faces. Empty: found automatically."""
    targets: List[int] = dataclasses.field(default_factory=list)
    """Target faces. Empty: found automatically."""
    pairs: List[Tuple[int, int]] = dataclasses.field(default_factory=list)
    """(source, target): this source is to be swept to this target."""
    vertex_types: Union[Mapping[Tuple, str], Sequence[Tuple]] = dataclasses.field(default_factory=dict)
    """{("Face3", "Vertex7"): "corner"} or [("Face3", "Vertex7", "corner")], names or numbers: how many quads meet
    at that vertex of that linking face: "end" 1, "side" 2, "corner" 3, "reversal" 4. Others are found."""

    edge_count: Dict[int, int] = dataclasses.field(default_factory=dict)
    """{5: 12}: exactly 12 mesh edges on Edge5."""
    edge_size: Dict[int, float] = dataclasses.field(default_factory=dict)
    """{5: 0.8}: wished edge length on Edge5, instead of `size`."""
    edge_bias: Dict[int, Tuple[float, bool]] = dataclasses.field(default_factory=dict)
    """{5: (1.2, False)}: on Edge5 each mesh edge is 1.2 times as long as the one before, from the edge's start to its
    end; (1.2, True): from both ends to the middle. Edges without are divided evenly."""
    sweep_bias: Optional[Tuple[float, bool]] = None
    """The same for all edges along the sweep that have none of their own, from the lower to the higher layer."""
    imprint_tolerance: Optional[float] = None
    """Curves of different caps nearer than this length are brought together. None: from the size."""

    solid: Optional[int] = None
    """The solid to mesh, from 1, in a shape of several. None: all of them."""

    def to_core(self):
        """The same as the C++ module's SweepOptions."""
        core = _sweepmesh.SweepOptions()
        core.size = self.size
        core.layers = self.layers
        core.element = _element_kind(self.element)
        core.order = self.order
        if self.max_elements is not None:
            core.max_elements = self.max_elements
        core.refuse_folds = self.refuse_folds
        self._add_edges_to(core)
        if self.sweep_bias is not None:
            core.sweep_bias = _sweepmesh.Bias(*self.sweep_bias)
        core.imprint_tolerance = self.imprint_tolerance
        return core

    def _add_edges_to(self, core):
        for edge, count in self.edge_count.items():
            core.set_edge_count(edge - 1, count)
        for edge, size in self.edge_size.items():
            core.set_edge_size(edge - 1, size)
        for edge, bias in self.edge_bias.items():
            core.set_edge_bias(edge - 1, _sweepmesh.Bias(*bias))

    def type_triples(self):
        """`vertex_types` as a list of (face number, vertex number, name of the type), whatever form it has."""
        types = self.vertex_types
        try:
            items = [(*key, name) for key, name in types.items()] if isinstance(types, Mapping) else types
            triples = [(face, vertex, name) for face, vertex, name in items]
        except (TypeError, ValueError):
            raise input_error('Vertex types are given as {("Face3", "Vertex7"): "corner"}.') from None
        return [(face_number(face), vertex_number(vertex), _vertex_type(name).name) for face, vertex, name in triples]

    def picks(self, model):
        """The C++ module's Picks; InputError for a face or vertex that the Model does not have."""
        n_faces = model.n_faces
        triples = self.type_triples()
        chosen = [*self.sources, *self.targets, *(face for pair in self.pairs for face in pair)]
        chosen += [face for face, _, _ in triples]
        unknown = [face for face in chosen if not 1 <= face <= n_faces]
        if unknown:
            raise input_error(
                f"The shape has no Face{unknown[0]}: its faces are Face1 to Face{n_faces}.",
                "assess",
                [f"Face{unknown[0]}"],
            )
        return _sweepmesh.Picks(
            sources=[face - 1 for face in self.sources],
            targets=[face - 1 for face in self.targets],
            pairs=[(source - 1, target - 1) for source, target in self.pairs],
            types=[(face - 1, vertex - 1, _vertex_type(name)) for face, vertex, name in triples],
        )


def _element_kind(name):
    kinds = _sweepmesh.ElementKind.__members__
    if name not in kinds:
        raise input_error(f"There is no element kind '{name}': use one of {', '.join(kinds)}.", "read")
    return kinds[name]


def _vertex_type(name):
    kinds = _sweepmesh.VertexType.__members__
    if str(name).lower() not in kinds:
        raise input_error(f"There is no vertex type '{name}': use one of {', '.join(kinds)}.", "read")
    return kinds[str(name).lower()]

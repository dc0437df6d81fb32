"""What a run can be told. Every default is the one of the C++ core."""

import dataclasses
from typing import List, Mapping, Optional, Sequence, Tuple, Union

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
    sources: List[int] = dataclasses.field(default_factory=list)
    """Source faces. Empty: found automatically."""
    targets: List[int] = dataclasses.field(default_factory=list)
    """Target faces. Empty: found automatically."""
    pairs: List[Tuple[int, int]] = dataclasses.field(default_factory=list)
    """(source, target): this source is to be swept to this target."""
    vertex_types: Union[Mapping[Tuple, str], Sequence[Tuple]] = dataclasses.field(default_factory=dict)
    """{("Face3", "Vertex7"): "corner"} or [("Face3", "Vertex7", "corner")], names or numbers: how many quads meet
    at that vertex of that linking face: "end" 1, "side" 2, "corner" 3, "reversal" 4. Others are found."""

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
        return core

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

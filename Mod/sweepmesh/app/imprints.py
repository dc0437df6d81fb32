"""How the caps of a sweep are divided, as Part shapes: imprinted curves and paired parts. No mesh is needed."""
import colorsys
from dataclasses import dataclass, field

import Part

from sweepmesh import engine
from sweepmesh.app.shapes import brep_of
from sweepmesh.app.stages import Plan, options_for
from sweepmesh.engine.errors import input_error


@dataclass
class Imprint:
    """The divided caps. Parts of one pair are swept from one to the other."""

    details: object = field(repr=False)
    """The engine's Imprint: `parts` (cap, role and pair of each face of `caps`), `merges`, `n_pairs`, `size`."""
    caps: object
    """Part compound of faces: the parts of all sources and targets."""
    curves: object
    """Part compound of wires: the imprinted curves. Edges that the caps had before are none."""

    @property
    def pairs(self):
        """The number of the pair of each face of `caps`, from 1."""
        return [part.pair for part in self.details.parts]

    @property
    def colors(self):
        """(red, green, blue) of each face of `caps`: equal for the parts of one pair."""
        return [pair_color(number) for number in self.pairs]

    def curves_on(self, cap):
        """Return the imprinted curves (Part wires) on a cap ("Face7")."""
        return [wire for wire, on in zip(self.curves.Wires, self.details.curve_caps) if on == cap]

    def parts_of(self, pair):
        """Return the faces of `caps` of one pair, those of its target first."""
        both = zip(self.caps.Faces, self.details.parts)
        chosen = [(part.role == "source", face) for face, part in both if part.pair == pair]
        return [face for _, face in sorted(chosen, key=lambda item: item[0])]


def imprint(source, progress=None, **settings):
    """Return the `Imprint` of a solid, a shape or a `Plan`; settings are those of `mesh`.

    An InputError with the reasons where the solid cannot be swept.
    """
    if isinstance(source, Plan):
        return from_engine(engine.imprint(source.brep, source.options, progress))
    return from_engine(engine.imprint(brep_of(source), options_for(source, **settings), progress))


def from_engine(details):
    """Return the `Imprint` with the Part shapes of the engine's one."""
    if not details.assessment.is_sweepable:
        reasons = [reason.text for reason in details.assessment.reasons]
        raise input_error(" ".join(["The solid cannot be swept."] + reasons), "assess")
    return Imprint(details, _shape(details.caps), _shape(details.curves))


def pair_color(number):
    """Return (red, green, blue), 0 to 1, of a pair: neighbouring numbers differ well."""
    golden = 0.618033988749895
    bright = 0.95 if number % 2 else 0.75
    return colorsys.hsv_to_rgb((number * golden) % 1.0, 0.55, bright)


def _shape(brep):
    shape = Part.Shape()
    shape.importBrepFromString(brep)
    return shape

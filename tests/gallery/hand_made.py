"""A terraced solid cut by hand into pieces that are swept one to one and glued: what a sweep of the whole is compared to."""

import dataclasses
import math

import numpy
from solids.kit import planar, union, vec

from sweepmesh import Options, engine, mesh


@dataclasses.dataclass
class Terraces:
    """A slab over a plan (a wire at z = 0), with prisms over other plans on it and below it."""

    slab: object
    thickness: float
    above: list
    """(wire, height)"""
    below: list

    def whole(self):
        """The solid."""
        parts = [planar(self.slab).extrude(vec(0, 0, self.thickness))]
        parts += [_lifted(planar(w).extrude(vec(0, 0, h)), self.thickness) for w, h in self.above]
        parts += [planar(w).extrude(vec(0, 0, -h)) for w, h in self.below]
        return union(*parts)

    def pieces(self):
        """Prisms over the pieces into which all plans divide each other, cut at the slab's two faces as well."""
        flat = [planar(wire) for wire in [self.slab] + [w for w, _ in self.above + self.below]]
        out = []
        for face in flat[0].generalFuse(flat[1:])[0].Faces:
            up, point = vec(0, 0, 1), _inner_point(face)
            out.append(face.extrude(self.thickness * up))
            for wire, height in self.above:
                if planar(wire).isInside(point, 1e-6, True):
                    out.append(_lifted(face.extrude(height * up), self.thickness))
            for wire, height in self.below:
                if planar(wire).isInside(point, 1e-6, True):
                    out.append(_lifted(face.extrude(height * up), -height))
        return out


@dataclasses.dataclass
class Glued:
    """The mesh of all pieces with the nodes of common faces merged."""

    points: numpy.ndarray
    hexahedra: numpy.ndarray
    scaled_jacobians: numpy.ndarray


def _lifted(shape, z):
    moved = shape.copy()
    moved.translate(vec(0, 0, z))
    return moved


def _inner_point(face):
    points, triangles = face.tessellate(0.1)
    a, b, c = max(
        ([points[i] for i in t] for t in triangles), key=lambda t: (t[1] - t[0]).cross(t[2] - t[0]).Length
    )
    return (a + b + c) / 3


def glued(pieces, size):
    """Meshes every piece by itself, with even counts that depend on the edges' lengths alone, and merges nodes."""
    points, hexahedra, quality, shift = [], [], [], 0
    for piece in pieces:
        result = mesh(piece.exportBrepToString(), _options(piece, size))
        assert result.assessment.is_sweepable, [reason.text for reason in result.assessment.reasons]
        points.append(result.points)
        hexahedra.append(result.hexahedra + shift)
        quality.append(result.scaled_jacobians)
        shift += len(result.points)
    points, index = _merged(numpy.vstack(points), 1e-4 * size)
    return Glued(points, index[numpy.vstack(hexahedra)], numpy.concatenate(quality))


def _options(piece, size):
    counts, height = {}, piece.BoundBox.ZLength
    for number, edge in enumerate(piece.Edges, 1):
        is_level = edge.BoundBox.ZLength < 1e-6
        counts[number] = 2 * max(1, round(edge.Length / size / 2)) if is_level else max(1, round(height / size))
    slope = [face.normalAt(0, 0).z if face.Surface.TypeId == "Part::GeomPlane" else 0 for face in piece.Faces]
    source, target = slope.index(max(slope)) + 1, slope.index(min(slope)) + 1
    return Options(size=size, sources=[source], targets=[target], edge_count=counts)


def _merged(points, tolerance):
    """Points without doubles, and for each of the given ones its place among them."""
    cells = numpy.round(points / tolerance).astype(numpy.int64)
    order = numpy.lexsort(cells.T)
    index = numpy.empty(len(points), numpy.int64)
    kept = []
    places = {}
    for i in order:
        near = (tuple(cells[i] + step) for step in numpy.ndindex(3, 3, 3))
        found = next((places[key] for key in (tuple(numpy.subtract(n, 1)) for n in near) if key in places), None)
        if found is None:
            found = places[tuple(cells[i])] = len(kept)
            kept.append(points[i])
        index[i] = found
    return numpy.array(kept), index


def upwards(shape, size):
    """Options of a sweep of the whole along z."""
    slope = [face.normalAt(0, 0).z if face.Surface.TypeId == "Part::GeomPlane" else 0 for face in shape.Faces]
    return Options(
        size=size,
        sources=[n for n, z in enumerate(slope, 1) if z > 0.9],
        targets=[n for n, z in enumerate(slope, 1) if z < -0.9],
    )


def swept(shape, size):
    """(Model, Result) of the whole."""
    model = engine.Model.from_brep(shape.exportBrepToString(), 0)
    return model, mesh(model, upwards(shape, size))


def ring(radius, centre, count, turn=0.0):
    """Corners of a regular polygon by its circumscribed circle."""
    return [
        (centre[0] + radius * math.cos(turn + 2 * math.pi * k / count),
         centre[1] + radius * math.sin(turn + 2 * math.pi * k / count))
        for k in range(count)
    ]

"""The volume elements of a mesh as arrays, and the skin of some of them: for drawing."""
from itertools import chain

import numpy as np

from sweepmesh.engine.numbering import HEXAHEDRON_SIDES, PRISM_SIDES, TO_SMESH

# Sides of elements by number of corners, normals outwards in Abaqus' order of nodes; a triangle repeats its last node.
_SIDES = {
    8: np.array(HEXAHEDRON_SIDES)[:, ::-1],
    6: np.array([side if len(side) == 4 else (*side, side[2]) for side in PRISM_SIDES])[:, ::-1],
}
_CORNERS = {8: 8, 20: 8, 6: 6, 15: 6}
_SLOT_BITS = 4  # 16 slots a corner: in a grid of hexahedra a node is the least corner of three quads, each there twice
_SEED = 20  # of the numbers by which sides are told apart: the same on every run


class Elements:
    """Corners of the volume elements of a mesh: `points` (n, 3), `ids` and `centres` of the elements.

    Made once, in any thread, in a second for a million hexahedra, it tells in 0.03 what bounds any choice of elements.
    Memory: about 200 bytes a hexahedron.
    """

    def __init__(self, points, ids, blocks):
        """`blocks`: [(rows of elements, their corners as indices of points, in Abaqus' order)]."""
        self.points, self.ids = points, ids
        self.centres = np.empty((len(ids), 3))
        quads, owners = [], []
        for rows, corners in blocks:
            self.centres[rows] = sum(points[corners[:, c]] for c in range(corners.shape[1])) / corners.shape[1]
            sides = _SIDES[corners.shape[1]]
            quads.append(np.take(corners, sides, axis=1).reshape(-1, 4))
            owners.append(np.repeat(rows.astype(np.int32), len(sides)))
        self._quads, self._owners = _joined(quads, (0, 4)), _joined(owners, (0,))
        self._neighbours = _neighbours(self._quads, self._owners, len(points))

    @classmethod
    def of_result(cls, result):
        """Of an engine's Result."""
        return cls(*arrays_of_result(result))

    @classmethod
    def of_femmesh(cls, fem_mesh):
        """Of a `Fem.FemMesh`."""
        return cls(*arrays_of_femmesh(fem_mesh))

    def skin(self, chosen):
        """Return (quads (m, 4) of point indices, element row of each) that bound the elements `chosen` (bools).

        Quads between two chosen elements are left out.
        """
        # One more element, never chosen, is what lies beyond the sides that bound the mesh.
        padded = np.append(chosen, False)
        is_outer = padded[self._owners] & ~padded[self._neighbours]
        return self._quads[is_outer], self._owners[is_outer]


def arrays_of_result(result):
    """What `Elements` takes, of an engine's Result: hexahedra, then prisms, as `to_femmesh` numbers them."""
    blocks, first = [], 0
    for elements in (result.hexahedra, result.prisms):
        if len(elements):
            rows = np.arange(first, first + len(elements), dtype=np.int32)
            blocks.append((rows, elements[:, : _CORNERS[elements.shape[1]]]))
            first += len(elements)
    return result.points, np.arange(1, first + 1), blocks


def arrays_of_femmesh(fem_mesh):
    """The same of a `Fem.FemMesh`: 2.5 seconds for a million hexahedra, as it can only be asked element by element."""
    nodes = dict(sorted(fem_mesh.Nodes.items()))
    points = np.fromiter(chain.from_iterable(nodes.values()), float, 3 * len(nodes)).reshape(-1, 3)
    node_ids = np.fromiter(nodes, np.int64, len(nodes))
    index = np.zeros(node_ids[-1] + 1, dtype=np.int32)
    index[node_ids] = np.arange(len(node_ids))
    ids = sorted(fem_mesh.Volumes)
    of_elements = list(map(fem_mesh.getElementNodes, ids))
    sizes, blocks = np.fromiter(map(len, of_elements), int, len(ids)), []
    for size in np.unique(sizes):
        rows, count = np.flatnonzero(sizes == size), _CORNERS[size]
        of_size = of_elements if len(rows) == len(ids) else [of_elements[row] for row in rows]
        numbers = np.fromiter(chain.from_iterable(of_size), np.int64, size * len(rows)).reshape(-1, size)
        blocks.append((rows, index[numbers[:, :count]][:, TO_SMESH[count]]))  # the mirror image of the mirror image
    return points, np.array(ids), blocks


def _joined(parts, empty):
    if len(parts) == 1:
        return parts[0]
    return np.concatenate(parts) if parts else np.zeros(empty, np.int32)


def _neighbours(quads, owners, n_points):
    """The element on the other side of each quad; -1 where there is none.

    Quads with the same corners are found by the sum of random numbers of their corners: no sum of 2^64 is the same
    by chance. Most find each other in a table with some slots for each least corner; sorting finds the others.
    """
    keys = _keys(quads, n_points)
    slots = np.minimum(np.minimum(quads[:, 0], quads[:, 1]), np.minimum(quads[:, 2], quads[:, 3])).astype(np.intp)
    slots <<= _SLOT_BITS
    slots |= (keys >> np.uint64(64 - _SLOT_BITS)).astype(np.intp)
    table, rows = np.empty(n_points << _SLOT_BITS, np.int32), np.arange(len(quads), dtype=np.int32)
    table[slots] = rows  # of several the last stays, and is found by the others
    others = table[slots]
    first = np.flatnonzero((keys[others] == keys) & (others != rows))
    neighbours = np.full(len(quads), -1, np.int32)
    _join(neighbours, owners, first, others[first])
    alone = np.flatnonzero(neighbours < 0)
    order = alone[np.argsort(keys[alone])]
    pairs = np.flatnonzero(keys[order[1:]] == keys[order[:-1]])
    _join(neighbours, owners, order[pairs], order[pairs + 1])
    return neighbours


def _keys(quads, n_points):
    """A number for each quad: equal for equal corners in any order."""
    random = np.random.default_rng(_SEED).integers(0, 2**64, n_points, dtype=np.uint64)
    keys = random[quads[:, 0]]
    for column in range(1, 4):
        keys += random[quads[:, column]]
    triangles = np.flatnonzero(quads[:, 0] == quads[:, 1])
    keys[triangles] -= random[quads[triangles, 0]]
    return keys


def _join(neighbours, owners, first, second):
    neighbours[first], neighbours[second] = owners[second], owners[first]

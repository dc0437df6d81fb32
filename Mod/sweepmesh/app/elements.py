"""The volume elements of a mesh as arrays, and the skin of some of them: for drawing."""
import numpy as np

from sweepmesh.engine.numbering import HEXAHEDRON_SIDES, PRISM_SIDES, TO_SMESH

# Sides of elements by number of corners, normals outwards in Abaqus' order of nodes; a triangle repeats its last node.
_SIDES = {
    8: np.array(HEXAHEDRON_SIDES)[:, ::-1],
    6: np.array([side if len(side) == 4 else (*side, side[2]) for side in PRISM_SIDES])[:, ::-1],
}
_CORNERS = {8: 8, 20: 8, 6: 6, 15: 6}
_SEED = 20  # of the numbers by which sides are told apart: the same on every run


class Elements:
    """Corners of the volume elements of a mesh: `points` (n, 3), `ids` and `centres` of the elements.

    Made once, in 2 seconds for a million hexahedra, it tells in 0.03 what bounds any choice of elements.
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
        """From an engine's Result: hexahedra, then prisms, as `to_femmesh` numbers them."""
        blocks, first = [], 0
        for elements in (result.hexahedra, result.prisms):
            if len(elements):
                rows = np.arange(first, first + len(elements), dtype=np.int32)
                blocks.append((rows, elements[:, : _CORNERS[elements.shape[1]]]))
                first += len(elements)
        return cls(result.points, np.arange(1, first + 1), blocks)

    @classmethod
    def of_femmesh(cls, fem_mesh):
        """From a `Fem.FemMesh`: slow, as it can only be asked element by element."""
        node_ids, coordinates = zip(*sorted(fem_mesh.Nodes.items()))
        points = np.array([tuple(point) for point in coordinates])
        index = np.zeros(node_ids[-1] + 1, dtype=np.int32)
        index[list(node_ids)] = np.arange(len(node_ids))
        ids = np.array(sorted(fem_mesh.Volumes))
        nodes = [fem_mesh.getElementNodes(int(element)) for element in ids]
        sizes, blocks = np.array([len(of_one) for of_one in nodes]), []
        for size in np.unique(sizes):
            rows, count = np.flatnonzero(sizes == size), _CORNERS[size]
            corners = index[np.array([nodes[row][:count] for row in rows])]
            blocks.append((rows, corners[:, TO_SMESH[count]]))  # the mirror image of the mirror image
        return cls(points, ids, blocks)

    def skin(self, chosen):
        """Return (quads (m, 4) of point indices, element row of each) that bound the elements `chosen` (bools).

        Quads between two chosen elements are left out.
        """
        # One more element, never chosen, is what lies beyond the sides that bound the mesh.
        padded = np.append(chosen, False)
        is_outer = padded[self._owners] & ~padded[self._neighbours]
        return self._quads[is_outer], self._owners[is_outer]


def _joined(parts, empty):
    if len(parts) == 1:
        return parts[0]
    return np.concatenate(parts) if parts else np.zeros(empty, np.int32)


def _neighbours(quads, owners, n_points):
    """The element on the other side of each quad; -1 where there is none.

    Quads with the same corners are found by the sum of random numbers of their corners: no sum of 2^64 is the same
    by chance.
    """
    random = np.random.default_rng(_SEED).integers(0, 2**63, n_points, dtype=np.uint64)
    keys = random[quads[:, 0]] + random[quads[:, 1]] + random[quads[:, 2]] + random[quads[:, 3]]
    triangles = np.flatnonzero(quads[:, 0] == quads[:, 1])
    keys[triangles] -= random[quads[triangles, 0]]
    order = np.argsort(keys)
    keys = keys[order]
    pairs = np.flatnonzero(keys[1:] == keys[:-1])
    first, second = order[pairs], order[pairs + 1]
    neighbours = np.full(len(quads), -1, np.int32)
    neighbours[first], neighbours[second] = owners[second], owners[first]
    return neighbours

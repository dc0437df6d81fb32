"""The volume elements of a `Fem.FemMesh` as arrays, and the skin of some of them: for drawing."""
import numpy as np

# Faces of FreeCAD's elements by number of corners, in SMESH's order of nodes, normals outwards; a triangle
# repeats its last node.
_FACES = {
    8: np.array([[0, 1, 2, 3], [4, 7, 6, 5], [0, 4, 5, 1], [1, 5, 6, 2], [2, 6, 7, 3], [3, 7, 4, 0]]),
    6: np.array([[0, 1, 2, 2], [3, 5, 4, 4], [0, 3, 4, 1], [1, 4, 5, 2], [2, 5, 3, 0]]),
}
_CORNERS = {8: 8, 20: 8, 6: 6, 15: 6}


class Elements:
    """Corners of the volume elements of a mesh: `points` (n, 3), and for each element its nodes and quads."""

    def __init__(self, fem_mesh):
        ids, coordinates = zip(*sorted(fem_mesh.Nodes.items()))
        self.points = np.array([tuple(point) for point in coordinates])
        self._index = np.zeros(ids[-1] + 1, dtype=np.int64)
        self._index[list(ids)] = np.arange(len(ids))
        self.ids = np.array(sorted(fem_mesh.Volumes))
        self._blocks = list(self._rows_by_corners(fem_mesh))
        self.centres = np.empty((len(self.ids), 3))
        for rows, corners in self._blocks:
            self.centres[rows] = self.points[corners].mean(axis=1)

    def _rows_by_corners(self, fem_mesh):
        nodes = [fem_mesh.getElementNodes(int(element)) for element in self.ids]
        sizes = np.array([len(of_one) for of_one in nodes])
        for size in np.unique(sizes):
            rows = np.flatnonzero(sizes == size)
            yield rows, self._index[np.array([nodes[row][: _CORNERS[size]] for row in rows])]

    def skin(self, chosen):
        """Return (quads (m, 4) of point indices, element row of each) that bound the elements `chosen` (bools).

        Quads between two chosen elements are left out.
        """
        quads, owners = [np.zeros((0, 4), np.int64)], [np.zeros(0, np.int64)]
        for rows, corners in self._blocks:
            mine = chosen[rows]
            faces = _FACES[corners.shape[1]]
            quads.append(corners[mine][:, faces].reshape(-1, 4))
            owners.append(np.repeat(rows[mine], len(faces)))
        quads, owners = np.concatenate(quads), np.concatenate(owners)
        _, first, count = np.unique(np.sort(quads, axis=1), axis=0, return_index=True, return_counts=True)
        outer = np.sort(first[count == 1])
        return quads[outer], owners[outer]

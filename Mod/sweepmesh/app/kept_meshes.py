"""Meshes of earlier settings, for undo.

FreeCAD's undo does not reach the property FemMesh: setting it writes into the one mesh that the steps of undo
share. So an object keeps the meshes that it had, as long as they are few, and takes the right one out again
when undo brings back the settings that it was made from.
"""
MAX_NODES = 500_000  # of all kept meshes together; about 250 MB


class KeptMeshes:
    """Meshes by fingerprint; the oldest are let go when there are too many nodes."""

    def __init__(self, max_nodes=MAX_NODES):
        self._max_nodes = max_nodes
        self._meshes = {}

    def keep(self, key, fem_mesh):
        """Remember the mesh that was made from what `key` is the fingerprint of."""
        self._meshes.pop(key, None)
        self._meshes[key] = fem_mesh
        while sum(mesh.NodeCount for mesh in self._meshes.values()) > self._max_nodes:
            del self._meshes[next(iter(self._meshes))]

    def get(self, key):
        """Return the mesh that was kept for `key`, or None."""
        return self._meshes.get(key)

"""Raw .vtu files from numpy arrays: the fast way into `Fem.FemMesh`."""
import numpy as np

_HEADER = (
    '<?xml version="1.0"?>\n'
    '<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n'
    '<UnstructuredGrid><Piece NumberOfPoints="{points}" NumberOfCells="{cells}">\n'
    '<Points><DataArray type="Float64" NumberOfComponents="3" format="appended" offset="{o[0]}"/></Points>\n'
    "<Cells>\n"
    '<DataArray type="Int64" Name="connectivity" format="appended" offset="{o[1]}"/>\n'
    '<DataArray type="Int64" Name="offsets" format="appended" offset="{o[2]}"/>\n'
    '<DataArray type="UInt8" Name="types" format="appended" offset="{o[3]}"/>\n'
    "</Cells>\n"
    '</Piece></UnstructuredGrid>\n<AppendedData encoding="raw">_'
)
_FOOTER = "</AppendedData></VTKFile>\n"


def write_vtu(path, points, blocks):
    """Write `points` (n, 3) and `blocks` [(VTK cell type, (m, k) node indices), ...] in this order."""
    nodes = [np.asarray(cells).ravel() for _, cells in blocks]
    sizes = [np.full(len(cells), cells.shape[1]) for _, cells in blocks]
    types = [np.full(len(cells), cell_type) for cell_type, cells in blocks]
    arrays = [
        np.ascontiguousarray(points, dtype="<f8"),
        _joined(nodes, "<i8"),
        np.cumsum(_joined(sizes, "<i8"), dtype="<i8"),
        _joined(types, "u1"),
    ]
    starts = np.cumsum([0] + [8 + a.nbytes for a in arrays])
    with open(path, "wb") as file:
        file.write(_HEADER.format(points=len(points), cells=len(arrays[3]), o=starts).encode())
        for array in arrays:
            file.write(np.array([array.nbytes], dtype="<u8").tobytes())
            file.write(array.tobytes())
        file.write(_FOOTER.encode())


def _joined(arrays, dtype):
    return np.concatenate([np.zeros(0, dtype), *arrays]).astype(dtype, copy=False)

#!/usr/bin/python3
"""Writes verdict_reference.inc: random elements and what VTK's Verdict says of them.

    /usr/bin/python3 make_verdict_reference.py > verdict_reference.inc

VTK 9.1's vtkMeshQuality has no measure of wedges, so their scaled Jacobian is computed here with numpy from
Verdict's definition (least over the corners of the normalised determinant, over sqrt(3)/2).
"""
import numpy as np
import vtk


def quality(points, kind, filter_set):
    grid = vtk.vtkUnstructuredGrid()
    pts = vtk.vtkPoints()
    pts.SetDataTypeToDouble()
    for p in points:
        pts.InsertNextPoint(p)
    grid.SetPoints(pts)
    grid.InsertNextCell(kind, len(points), list(range(len(points))))
    q = vtk.vtkMeshQuality()
    q.SetInputData(grid)
    filter_set(q)
    q.Update()
    return q.GetOutput().GetCellData().GetArray("Quality").GetValue(0)


def hex_values(p):
    m = vtk.vtkMeshQuality
    sets = [m.SetHexQualityMeasureToScaledJacobian, m.SetHexQualityMeasureToEdgeRatio,
            m.SetHexQualityMeasureToSkew, m.SetHexQualityMeasureToVolume]
    return [quality(p, vtk.VTK_HEXAHEDRON, s) for s in sets]


def wedge_value(p):
    unit = lambda v: v / np.linalg.norm(v)
    corners = [(0, 1, 2, 3), (1, 2, 0, 4), (2, 0, 1, 5), (3, 5, 4, 0), (4, 3, 5, 1), (5, 4, 3, 2)]
    return min(np.linalg.det([unit(p[j] - p[c]) for j in js]) for c, *js in corners) * 2 / np.sqrt(3)


def rows(name, corners, amplitudes, values, rng):
    ideal = {8: [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))],
             6: [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (.5, np.sqrt(.75)))],
             4: [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)],
             3: [(0, 0, 0), (1, 0, 0), (.5, np.sqrt(.75), 0)]}[corners]
    print("const std::vector<std::vector<double>> %s = {" % name)
    for amplitude in amplitudes:
        p = np.array(ideal) * (2.0, 1.5, 0.7) + amplitude * rng.standard_normal((corners, 3))
        print("    {" + ", ".join(repr(float(x)) for x in list(p.ravel()) + list(values(p))) + "},")
    print("};")


def main():
    rng = np.random.default_rng(20)
    amplitudes = [0, 0.02, 0.05, 0.1, 0.1, 0.2, 0.2, 0.3, 0.5, 1.0] * 4
    m = vtk.vtkMeshQuality
    print("// Made by make_verdict_reference.py with VTK %s: coordinates of the corners, then values."
          % vtk.vtkVersion().GetVTKVersion())
    print("// clang-format off")
    rows("hexes", 8, amplitudes, hex_values, rng)
    rows("wedges", 6, amplitudes, lambda p: [wedge_value(p)], rng)
    rows("quads", 4, amplitudes,
         lambda p: [quality(p, vtk.VTK_QUAD, m.SetQuadQualityMeasureToScaledJacobian)], rng)
    rows("triangles", 3, amplitudes,
         lambda p: [quality(p, vtk.VTK_TRIANGLE, m.SetTriangleQualityMeasureToScaledJacobian)], rng)


main()

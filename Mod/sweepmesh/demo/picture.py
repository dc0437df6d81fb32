"""Draws a mesh: python -m sweepmesh.demo.picture MESH.vtu PICTURE.png

On the left the elements with their edges, part of them taken away, coloured by scaled Jacobian; on the right,
where the file has the point data Displacement and VonMises, the deformed part. Draws on a virtual display of
its own where there is none.
"""

import argparse
import contextlib
import os
import subprocess

import numpy

SIZE = (2000, 1000)
CUT_AWAY = 0.5
"""Fraction of the elements that are taken away on the left, those nearest to the viewer's upper right."""


@contextlib.contextmanager
def display():
    """Makes sure of an X display for the block."""
    if os.environ.get("DISPLAY"):
        yield
        return
    readable, writable = os.pipe()
    command = ["Xvfb", "-displayfd", str(writable), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=[writable], stderr=subprocess.DEVNULL)
    os.close(writable)
    try:
        with open(readable, encoding="ascii") as file:
            os.environ["DISPLAY"] = ":" + file.readline().strip()
        yield
    finally:
        os.environ.pop("DISPLAY", None)
        server.terminate()
        server.wait()


def draw(mesh_path, picture_path, view=(0.42, 0.62, 0.85), up=(0.0, 1.0, 0.0)):
    """Draws a .vtu file into a PNG; `view` is the direction from the part to the eye."""
    import vtk

    grid = _read(vtk, mesh_path)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    has_results = grid.GetPointData().GetArray("Displacement") is not None
    window.SetSize(SIZE[0] if has_results else SIZE[0] // 2, SIZE[1])
    split = 0.5 if has_results else 1.0
    _add_view(vtk, window, (0.0, split), _mesh_actors(vtk, grid, view), view, up)
    if has_results:
        _add_view(vtk, window, (split, 1.0), _result_actors(vtk, grid), view, up)
    window.Render()
    _save(vtk, window, picture_path)


def _read(vtk, path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def _mesh_actors(vtk, grid, view):
    """What is left of the elements, their edges, and the whole part as a ghost."""
    low, _ = grid.GetCellData().GetArray("ScaledJacobian").GetRange()
    colours = _colours(vtk, [(0.55, 0.12, 0.18), (0.93, 0.55, 0.26), (0.96, 0.86, 0.52), (0.42, 0.69, 0.62), (0.13, 0.42, 0.52)])
    colours.SetRange(min(0.5, max(0.0, numpy.floor(low * 10) / 10)), 1.0)
    kept = _kept_elements(vtk, grid, numpy.asarray(view))
    surface = _surface(vtk, kept)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("ScaledJacobian")
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()
    ghost = _plain_actor(vtk, _surface(vtk, grid), (0.45, 0.5, 0.55), opacity=0.10)
    return [_actor(vtk, mapper, 1.4), ghost], (colours, "Scaled Jacobian")


def _kept_elements(vtk, grid, view):
    from vtk.util.numpy_support import numpy_to_vtkIdTypeArray

    centres = vtk.vtkCellCenters()
    centres.SetInputData(grid)
    centres.Update()
    points = centres.GetOutput().GetPoints().GetData()
    from vtk.util.numpy_support import vtk_to_numpy

    towards = vtk_to_numpy(points) @ _cut_normal(grid, view)
    ids = numpy.flatnonzero(towards <= numpy.quantile(towards, 1 - CUT_AWAY))
    node = vtk.vtkSelectionNode()
    node.SetFieldType(vtk.vtkSelectionNode.CELL)
    node.SetContentType(vtk.vtkSelectionNode.INDICES)
    node.SetSelectionList(numpy_to_vtkIdTypeArray(ids.astype(numpy.int64), deep=True))
    selection = vtk.vtkSelection()
    selection.AddNode(node)
    extract = vtk.vtkExtractSelection()
    extract.SetInputData(0, grid)
    extract.SetInputData(1, selection)
    extract.Update()
    return extract.GetOutput()


def _cut_normal(grid, view):
    """The axis along which the part is cut: of the three, the one that faces the viewer most, in its sense."""
    extent = numpy.array(grid.GetBounds()).reshape(3, 2) @ [-1, 1]
    axis = int(numpy.argmin(extent))
    normal = numpy.zeros(3)
    normal[axis] = 1.0 if view[axis] >= 0 else -1.0
    return normal


def _result_actors(vtk, grid):
    """The deformed part, coloured by von Mises stress, and the outline of the undeformed one."""
    grid.GetPointData().SetActiveVectors("Displacement")
    stress = grid.GetPointData().GetArray("VonMises")
    from vtk.util.numpy_support import vtk_to_numpy

    largest = numpy.linalg.norm(vtk_to_numpy(grid.GetPointData().GetArray("Displacement")), axis=1).max()
    warp = vtk.vtkWarpVector()
    warp.SetInputData(grid)
    warp.SetScaleFactor(0.08 * grid.GetLength() / largest if largest > 0 else 0.0)
    warp.Update()
    surface = _surface(vtk, warp.GetOutput())
    colours = _colours(vtk, [(0.11, 0.21, 0.40), (0.18, 0.48, 0.60), (0.55, 0.76, 0.66), (0.97, 0.88, 0.60), (0.91, 0.49, 0.29), (0.66, 0.16, 0.20)])
    colours.SetRange(0.0, float(numpy.quantile(vtk_to_numpy(stress), 0.995)))
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("VonMises")
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    outline = _plain_actor(vtk, _surface(vtk, grid), (0.45, 0.5, 0.55), opacity=0.10)
    return [_actor(vtk, mapper, 0.7), outline], (colours, "von Mises stress, MPa")


def _colours(vtk, anchors):
    """A smooth table through colours at even distances."""
    function = vtk.vtkColorTransferFunction()
    function.SetColorSpaceToLab()
    for i, colour in enumerate(anchors):
        function.AddRGBPoint(i / (len(anchors) - 1), *colour)
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *function.GetColor(i / 255), 1.0)
    return table


def _surface(vtk, grid):
    surface = vtk.vtkGeometryFilter()
    surface.SetInputData(grid)
    surface.Update()
    return surface.GetOutput()


def _actor(vtk, mapper, edge_width):
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.12, 0.15, 0.19)
    actor.GetProperty().SetLineWidth(edge_width)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetAmbient(0.38)
    actor.GetProperty().SetDiffuse(0.72)
    actor.GetProperty().SetSpecular(0.08)
    return actor


def _plain_actor(vtk, surface, colour, opacity):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def _add_view(vtk, window, span, content, view, up):
    """A renderer over a part of the window's width with actors and a colour bar."""
    actors, (colours, title) = content
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(span[0], 0.0, span[1], 1.0)
    renderer.SetBackground(0.98, 0.98, 0.97)
    renderer.SetBackground2(0.86, 0.89, 0.92)
    renderer.GradientBackgroundOn()
    for actor in actors:
        renderer.AddActor(actor)
    renderer.AddActor2D(_bar(vtk, colours))
    renderer.AddActor2D(_title(vtk, title))
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*view)
    camera.SetViewUp(*up)
    camera.SetViewAngle(20)
    renderer.ResetCamera()
    camera.Zoom(1.13)
    camera.SetWindowCenter(0.0, -0.15)
    renderer.ResetCameraClippingRange()


def _bar(vtk, colours):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(colours)
    bar.SetOrientationToHorizontal()
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.3g")
    bar.SetTextPositionToPrecedeScalarBar()
    bar.SetPosition(0.25, 0.06)
    bar.SetWidth(0.5)
    bar.SetHeight(0.055)
    bar.SetUnconstrainedFontSize(True)
    _style(bar.GetLabelTextProperty(), 20)
    return bar


def _title(vtk, text):
    actor = vtk.vtkTextActor()
    actor.SetInput(text)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(0.5, 0.02)
    actor.GetTextProperty().SetJustificationToCentered()
    _style(actor.GetTextProperty(), 24)
    return actor


def _style(text, size):
    text.SetColor(0.15, 0.18, 0.22)
    text.SetFontFamilyToArial()
    text.ItalicOff()
    text.BoldOff()
    text.ShadowOff()
    text.SetFontSize(size)


def _save(vtk, window, path):
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh")
    parser.add_argument("picture")
    chosen = parser.parse_args()
    with display():
        draw(chosen.mesh, chosen.picture)

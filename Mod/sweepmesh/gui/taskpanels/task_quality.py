"""The panel that shows how good a mesh is, and where it is bad."""
import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin
from PySide import QtCore, QtGui

from sweepmesh.app.elements import Elements
from sweepmesh.gui.overlays.elements import ElementOverlay, colours_of
from sweepmesh.gui.resources import button, icon, let_go, load_form, tr
from sweepmesh.gui.runner import Runner
from sweepmesh.gui.taskpanels.histogram import Histogram

N_WORST = 20
_STEPS = 100  # of the slider of the section
_ZOOM = 8.0  # how many element sizes are in view around an element


class QualityPanel:
    """Counts, histogram, worst elements; elements below a threshold and sections in the 3D view, in colour.

    Nothing in the document changes; what is hidden meanwhile is shown again in the end.
    """

    def __init__(self, mesh):
        self._mesh, self._document_name = mesh, mesh.Document.Name
        self._quality = np.array(mesh.ScaledJacobians)
        self._arrays = mesh.Proxy.element_arrays(mesh)
        self._elements = None  # until they have been made, outside the GUI's thread
        self._overlay = ElementOverlay(mesh)
        self._was_visible = mesh.ViewObject.Visibility
        self.form = load_form("Quality")
        self.form.setWindowTitle(tr("Quality of the sweep mesh"))
        self.form.setWindowIcon(QtGui.QIcon(icon("Quality")))
        self._histogram = Histogram(mesh.Histogram)
        self.form.histogramBox.layout().addWidget(self._histogram)
        self._load()
        self._connect()
        FreeCAD.addDocumentObserver(self)
        self._maker = Runner()
        self._maker.succeeded.connect(self._take_elements)
        arrays = self._arrays
        self._maker.start(lambda progress: Elements(*arrays))

    def _take_elements(self, elements):
        self._elements, self._arrays = elements, None
        self.form.busy.setVisible(False)
        self._mesh.ViewObject.Visibility = False
        self.draw()

    def _load(self):
        mesh, form = self._mesh, self.form
        form.meshName.setText(mesh.Label)
        form.counts.setText(tr("{} nodes, {} hexahedra, {} prisms").format(mesh.Nodes, mesh.Hexahedra, mesh.Prisms))
        text = tr("Scaled Jacobian: least {:.3f}, mean {:.3f}; {} inverted")
        form.summary.setText(text.format(mesh.MinScaledJacobian, mesh.MeanScaledJacobian, mesh.Inverted))
        form.axis.addItems([tr("None"), tr("Across x"), tr("Across y"), tr("Across z")])
        form.position.setRange(0, _STEPS)
        form.position.setValue(_STEPS // 2)
        form.threshold.setValue(1.0)
        _, ids, _ = self._arrays
        for row in worst_of(self._quality, N_WORST):
            item = QtGui.QListWidgetItem(f"{self._quality[row]:.4f}   {ids[row]}")
            item.setData(QtCore.Qt.UserRole, int(row))
            form.worst.addItem(item)

    def _connect(self):
        form = self.form
        self._histogram.clicked.connect(form.threshold.setValue)
        form.threshold.valueChanged.connect(self.draw)
        form.axis.currentIndexChanged.connect(self.draw)
        form.position.valueChanged.connect(self.draw)
        form.worst.itemSelectionChanged.connect(self.draw)
        form.worst.itemDoubleClicked.connect(self._look_at)

    def shown(self):
        """Return which elements are to be drawn (bools)."""
        chosen = self._quality <= self.form.threshold.value()
        axis = self.form.axis.currentIndex() - 1
        if axis >= 0:
            along = self._elements.centres[:, axis]
            cut = along.min() + self.form.position.value() / _STEPS * np.ptp(along)
            chosen &= along <= cut
        marked = self._marked()
        if marked:
            chosen[:] = False
            chosen[marked] = True
        return chosen

    def draw(self, *_):
        """Draw what the form asks for, once the elements are there."""
        if self._elements is None:
            return
        quads, owners = self._elements.skin(self.shown())
        self._overlay.show(self._elements.points, quads, colours_of(self._quality[owners]))

    def _marked(self):
        return [item.data(QtCore.Qt.UserRole) for item in self.form.worst.selectedItems()]

    def _look_at(self, item):
        if self._elements is None:
            return
        centre = coin.SbVec3f(*self._elements.centres[item.data(QtCore.Qt.UserRole)])
        camera = FreeCADGui.ActiveDocument.ActiveView.getCameraNode()
        forwards = camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1))
        camera.position = centre - forwards * camera.focalDistance.getValue()
        if hasattr(camera, "height"):
            camera.height = _ZOOM * self._mesh.UsedSize.Value

    def getStandardButtons(self):
        return button("Close")

    def reject(self):
        self._close()
        return True

    def _close(self):
        FreeCAD.removeDocumentObserver(self)
        self._maker.close()
        self._overlay.remove()
        let_go([self.form])
        self._mesh.ViewObject.Visibility = self._was_visible
        QtCore.QTimer.singleShot(0, FreeCADGui.Control.closeDialog)

    def slotDeletedDocument(self, document):
        """FreeCAD calls this when a document is about to be closed."""
        if document.Name == self._document_name:
            self._close()

    def slotDeletedObject(self, obj):
        """FreeCAD calls this when an object is about to be deleted."""
        if obj == self._mesh:
            self._close()

    def slotChangedObject(self, obj, name):
        """FreeCAD calls this when a property changed: a new mesh makes the panel's figures old."""
        if obj == self._mesh and name == "FemMesh":
            self._close()


def worst_of(quality, count):
    """Return the rows of the `count` least values, the least first; of equal ones the first first."""
    limit = np.partition(quality, count - 1)[count - 1] if len(quality) > count else np.inf
    rows = np.flatnonzero(quality <= limit)
    return rows[np.argsort(quality[rows], kind="stable")][:count]

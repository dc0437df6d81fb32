"""A way out for solids that cannot be swept: a plane that cuts them into pieces that can."""
from PySide import QtCore

from sweepmesh import engine
from sweepmesh.gui.overlays.plane import PlaneOverlay
from sweepmesh.gui.runner import Runner


class CutOffer(QtCore.QObject):
    """Looks for a plane off the GUI's thread, draws it, and offers to cut there; `accepted` tells the engine's Cut."""

    accepted = QtCore.Signal(object)

    def __init__(self, form, obj):
        super().__init__()
        self._form, self._obj = form, obj
        self._cut = self._overlay = None
        self._runner = Runner()
        self._runner.succeeded.connect(self._show)
        form.makeCut.clicked.connect(self._accept)
        form.cutOffer.setVisible(False)

    def look(self, brep, options):
        """Start to look for a cut of this shape; nothing is shown where there is none."""
        self.withdraw()
        self._runner.start(lambda progress: engine.suggest_cut(brep, options, progress))

    def withdraw(self):
        """Offer nothing any more."""
        self._runner.close()
        self._cut = None
        if self._overlay:
            self._overlay.remove()
            self._overlay = None
        self._form.cutOffer.setVisible(False)

    def close(self):
        self._runner.close()
        if self._overlay:
            self._overlay.remove()

    def _show(self, cut):
        if cut is None:
            return
        self._cut, self._overlay = cut, PlaneOverlay(self._obj, cut.point, cut.normal)
        self._form.cutText.setText(cut.text)
        self._form.cutOffer.setVisible(True)

    def _accept(self):
        self.accepted.emit(self._cut)

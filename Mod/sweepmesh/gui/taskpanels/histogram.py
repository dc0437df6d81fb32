"""A histogram of quality as a widget."""
from PySide import QtCore, QtGui

from sweepmesh.gui.overlays.elements import colours_of
from sweepmesh.gui.resources import tr

_N_BINS = 10  # of scaled Jacobians from 0 to 1; one more bar holds all inverted elements


class Histogram(QtGui.QWidget):
    """Bars of how many elements have which scaled Jacobian; `clicked` tells the upper end of a bar."""

    clicked = QtCore.Signal(float)

    def __init__(self, counts):
        super().__init__()
        self.setObjectName("histogram")
        self.setMinimumHeight(110)
        self.setToolTip(tr("Number of elements by scaled Jacobian. A click on a bar shows the elements up to it."))
        negative, positive = counts[:-_N_BINS], counts[-_N_BINS:]
        self._counts = [sum(negative), *positive]

    def bar(self, index):
        """Return the rectangle that bar `index` may fill; 0 is that of inverted elements."""
        width = self.width() / len(self._counts)
        return QtCore.QRectF(index * width, 0, width, self.height() - self._text_height())

    def mousePressEvent(self, event):
        index = int(event.pos().x() * len(self._counts) / self.width())
        self.clicked.emit(max(0, min(index, _N_BINS)) / _N_BINS)

    def paintEvent(self, event):
        painter = QtGui.QPainter(self)
        highest = max(1, *self._counts)
        for index, count in enumerate(self._counts):
            self._paint_bar(painter, index, count / highest)
        self._paint_scale(painter)
        painter.end()

    def _text_height(self):
        return self.fontMetrics().height() + 2

    def _paint_bar(self, painter, index, fraction):
        bar = self.bar(index).adjusted(1, 0, -1, 0)
        if fraction > 0:
            bar.setTop(min(bar.bottom() - 2, bar.bottom() - fraction * (bar.height() - 2)))
            quality = -1.0 if index == 0 else (index - 0.5) / _N_BINS
            painter.fillRect(bar, QtGui.QColor.fromRgbF(*colours_of([quality])[0]))
        painter.drawLine(bar.bottomLeft(), bar.bottomRight())

    def _paint_scale(self, painter):
        texts = {0: "<0", 6: "0.5", _N_BINS: "1"}
        for index, text in texts.items():
            room = self.bar(index)
            room.setTop(room.bottom())
            room.setBottom(self.height())
            align = {0: QtCore.Qt.AlignHCenter, _N_BINS: QtCore.Qt.AlignRight}.get(index, QtCore.Qt.AlignLeft)
            painter.drawText(room, int(align | QtCore.Qt.AlignBottom), text)

"""Long work off the GUI's thread, with progress and cancel."""
import threading

from PySide import QtCore

from sweepmesh import engine

POLL_MILLISECONDS = 15
STOP_SECONDS = 1.0


class SharedProgress(engine.Progress):
    """Progress that the worker writes and the GUI reads."""

    def __init__(self):
        self.state = (0.0, "")
        self._cancelled = threading.Event()

    def update(self, fraction, message):
        self.state = (fraction, message)

    def is_cancelled(self):
        return self._cancelled.is_set()

    def cancel(self):
        self._cancelled.set()


class Runner(QtCore.QObject):
    """Runs one piece of work at a time: `start(work)` calls `work(progress)` in a thread.

    Exactly one of the signals `succeeded` (what it returned) and `failed` (what it raised) follows, in the
    GUI's thread, unless another `start` or a `close` comes first: then the old work is cancelled and its
    outcome dropped. `work` must not touch documents.
    """

    progressed = QtCore.Signal(float, str)
    succeeded = QtCore.Signal(object)
    failed = QtCore.Signal(object)

    def __init__(self):
        super().__init__()
        self._timer = QtCore.QTimer()
        self._timer.setInterval(POLL_MILLISECONDS)
        self._timer.timeout.connect(self._poll)
        self._worker = self._progress = self._outcome = None

    def start(self, work):
        self.close()
        self._progress, self._outcome = SharedProgress(), []
        self._worker = threading.Thread(target=_work, args=(work, self._progress, self._outcome), daemon=True)
        self._worker.start()
        self._timer.start()

    def cancel(self):
        """Ask the work to stop; it then fails with the engine's Cancelled."""
        if self._progress:
            self._progress.cancel()

    def close(self, wait=0.0):
        """Cancel, and drop the outcome. Waits at most `wait` seconds for the thread to end."""
        self._timer.stop()
        self.cancel()
        if self._worker and wait:
            self._worker.join(wait)
        self._worker = self._progress = self._outcome = None

    def is_running(self):
        return self._worker is not None

    def _poll(self):
        self.progressed.emit(*self._progress.state)
        if self._worker.is_alive():
            return
        kind, value = self._outcome[0]
        self._timer.stop()
        self._worker = self._progress = self._outcome = None
        (self.succeeded if kind == "value" else self.failed).emit(value)


def _work(work, progress, outcome):
    try:
        outcome.append(("value", work(progress)))
    except BaseException as error:  # handed over to the GUI's thread
        outcome.append(("error", error))

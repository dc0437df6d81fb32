"""Progress of a run in FreeCAD's own progress bar, for runs that a recompute starts."""
import FreeCAD
from FreeCAD import Qt


class ProgressBar:
    """The engine's `Progress` on FreeCAD's progress bar; Esc cancels. Without a GUI it only counts."""

    STEPS = 100

    def __init__(self, message):
        self._bar = FreeCAD.Base.ProgressIndicator()
        self._bar.start(message, self.STEPS)
        self._step = 0
        self._is_cancelled = False

    def update(self, fraction, message=""):
        wanted = min(self.STEPS, int(fraction * self.STEPS))
        while self._step < wanted and not self._is_cancelled:
            self._advance()

    def is_cancelled(self):
        return self._is_cancelled

    def stop(self):
        self._bar.stop()

    def _advance(self):
        self._step += 1
        try:
            self._bar.next(True)
        except Exception as error:  # FreeCAD's abort exception has no importable name
            if "abort" not in (str(error) + type(error).__name__).lower():
                raise
            FreeCAD.Console.PrintMessage(Qt.translate("SweepMesh", "The run was cancelled.") + "\n")
            self._is_cancelled = True

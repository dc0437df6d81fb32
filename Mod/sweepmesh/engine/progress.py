"""What a caller may pass to watch and to stop a run."""


class Progress:
    """Base class: override what is of use. Both methods are called in the caller's own thread."""

    def update(self, fraction, message):
        """`fraction` (0..1) of the stage that `message` names is done."""

    def is_cancelled(self):
        """True when the run is to stop; it then raises Cancelled."""
        return False

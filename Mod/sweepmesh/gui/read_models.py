"""Models of the shape of a panel, read once and used again and again."""
from sweepmesh.engine.model import as_model


class ReadModels:
    """Lends Models of one shape; one at a time to each thread, as a Model is not made for two at once."""

    def __init__(self):
        self._brep, self._idle = None, []

    def use(self, brep, work):
        """Return work(model) for the Model of a BREP text; may be called in any thread."""
        if brep != self._brep:
            self._brep, self._idle = brep, []
        idle = self._idle
        model = idle.pop() if idle else as_model(brep)
        try:
            return work(model)
        finally:
            idle.append(model)

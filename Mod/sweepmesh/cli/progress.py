"""A bar of progress on a terminal."""

import contextlib
import sys

from sweepmesh.engine import Progress


class Bar(Progress):
    """Shows the running stage and its fraction."""

    def __init__(self, bar):
        self._bar = bar

    def update(self, fraction, message):
        self._bar.set_description_str(message, refresh=False)
        self._bar.n = min(max(fraction, 0.0), 1.0)
        self._bar.refresh()


@contextlib.contextmanager
def progress_bar(is_wanted):
    """A Progress for the block: a bar where one is wanted and standard error is a terminal."""
    if not (is_wanted and sys.stderr.isatty()):
        yield Progress()
        return
    from tqdm import tqdm

    layout = "{desc:<28.28} {percentage:3.0f} % |{bar}| {elapsed}"
    with tqdm(total=1.0, bar_format=layout, desc="Reading", leave=False, file=sys.stderr) as bar:
        yield Bar(bar)

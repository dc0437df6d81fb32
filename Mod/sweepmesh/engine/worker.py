"""Runs work of the C++ core in a thread of its own, while the caller's thread watches."""

import threading

from sweepmesh.engine import _sweepmesh
from sweepmesh.engine.progress import Progress

POLL_SECONDS = 0.05
STOP_SECONDS = 0.7
"""How long an interrupted caller waits for the worker: it checks for cancellation every 0.2 seconds."""


def run(work, threads=0, progress=None):
    """Calls `work(context)` in a thread and returns or raises what it does.

    The calling thread polls, so that Ctrl-C and `progress` work. After KeyboardInterrupt the worker is
    told to stop and left alone if it does not in time.
    """
    context = _sweepmesh.Context(threads)
    outcome = {}

    def target():
        try:
            outcome["value"] = work(context)
        except BaseException as error:  # handed over to the thread that waits
            outcome["error"] = error

    worker = threading.Thread(target=target, name="sweepmesh", daemon=True)
    worker.start()
    try:
        _watch(worker, context, progress or Progress())
    except BaseException:
        context.cancel()
        worker.join(STOP_SECONDS)
        raise
    if "error" in outcome:
        raise outcome["error"]
    return outcome["value"]


def _watch(worker, context, progress):
    seen = None
    while worker.is_alive():
        worker.join(POLL_SECONDS)
        if progress.is_cancelled():
            context.cancel()
        state = (context.fraction, context.message)
        if state != seen:
            progress.update(*state)
            seen = state

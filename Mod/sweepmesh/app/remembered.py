"""Results that were made ahead of the document object that is to hold them.

A task panel meshes in a worker thread and then has the object made by recorded Python. When the object is
computed, its own run would be the same run again: the engine gives the same mesh for the same shape and
options. So it takes the remembered one, once.
"""
import hashlib

_results = {}


def fingerprint(brep, options):
    """Return a text that is equal for equal shapes and options. Threads do not count: they change no mesh."""
    settings = {name: value for name, value in vars(options).items() if name != "threads"}
    return hashlib.sha256(repr((brep, sorted(settings.items()))).encode()).hexdigest()


def remember(brep, options, result):
    """Keep `result` for the next `take`; what was kept before is let go."""
    _results.clear()
    _results[fingerprint(brep, options)] = result


def take(brep, options):
    """Return the remembered result for this shape and these options and forget it; None where there is none."""
    return _results.pop(fingerprint(brep, options), None)

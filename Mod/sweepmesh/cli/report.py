"""The JSON report and the text that people read."""

import resource

from sweepmesh.engine import __version__

BAR_WIDTH = 40
STAGES = ["read", "assess", "imprint", "intervals", "surface", "place", "quality", "write", "total"]


def make_report(assessment=None, result=None, seconds=None, warnings=(), error=None, cut=None):
    """The report as a plain dict; its keys are always the same.

    `error` is the SweepMeshError that ended the run, its sentence, stage and entities go in; the verdict is
    then None unless the assessment is known. `cut` is the engine's Cut that would help, if one was looked for.
    """
    times = {**(result.seconds if result else {}), **(seconds or {})}
    return {
        "version": __version__,
        "verdict": assessment.verdict if assessment else None,
        "reasons": [vars(reason) for reason in assessment.reasons] if assessment else [],
        "suggested_cut": cut.as_report() if cut else None,
        "scheme": assessment.roles if assessment else {},
        "size": result.size if result else None,
        "layers": result.n_layers if result else None,
        "counts": _counts(result),
        "quality": result.quality if result else {},
        "area_deviation": result.area_deviation if result else {},
        "seconds": {stage: round(times.get(stage, 0.0), 6) for stage in STAGES},
        "warnings": list(warnings),
        "error": _error(error),
        "peak_memory_mb": _peak_memory(),
    }


def _peak_memory():
    """Of this process and of those that it started, whichever had most."""
    who = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    return round(max(resource.getrusage(one).ru_maxrss for one in who) / 1024, 1)


def _counts(result):
    if not result:
        return {}
    return {
        "nodes": len(result.points),
        "hexa": len(result.hexahedra),
        "prism": len(result.prisms),
        "polyhedron": result.n_polyhedra,
        "boundary_faces": len(result.boundary_faces),
    }


def _error(error):
    if error is None:
        return None
    return {
        "text": str(error),
        "kind": type(error).__name__,
        "stage": getattr(error, "stage", ""),
        "entities": list(getattr(error, "entities", [])),
    }


def text_of(report):
    """The report for people: the plan, the mesh, a histogram and the times."""
    if report["verdict"] == "unsweepable":
        return "\n".join(["The solid cannot be swept:", *_indented(r["text"] for r in report["reasons"])])
    parts = [_plan(report)]
    if report["counts"]:
        parts += [_mesh(report), _quality(report["quality"]), _times(report["seconds"])]
    return "\n\n".join(part for part in parts if part)


def _plan(report):
    roles = {}
    for face, role in report["scheme"].items():
        roles.setdefault(role, []).append(face)
    lines = [f"{role:<8} {_shortened(roles[role])}" for role in sorted(roles, key=_ROLE_ORDER.index)]
    if report["size"]:
        lines.append(f"{'size':<8} {report['size']:.4g}, {report['layers']} layers")
    return "\n".join([f"The solid is {report['verdict']}.", "", "Plan", *_indented(lines)])


_ROLE_ORDER = ["source", "target", "linking", "divided"]


def _shortened(faces, limit=12):
    more = f" and {len(faces) - limit} more" if len(faces) > limit else ""
    return " ".join(faces[:limit]) + more


def _mesh(report):
    counts = report["counts"]
    lines = [f"{name.replace('_', ' '):<15}{n:>10}" for name, n in counts.items() if n]
    return "\n".join(["Mesh", *_indented(lines)])


def _quality(quality):
    """Scaled Jacobian: least, mean, and a histogram of the bins between the first and last used ones."""
    if not quality:
        return ""
    histogram = quality["histogram"]
    n_bins, total = len(histogram), max(1, sum(histogram))
    used = [i for i, count in enumerate(histogram) if count] or [n_bins - 1]
    lines = [
        f"least {quality['min_scaled_jacobian']:.4f}   mean {quality['mean_scaled_jacobian']:.4f}"
        f"   inverted {quality['n_inverted']}"
    ]
    for i in range(used[0], n_bins):
        low, high = (2 * i / n_bins - 1, 2 * (i + 1) / n_bins - 1)
        bar = "#" * round(BAR_WIDTH * histogram[i] / max(histogram))
        lines.append(f"{low:5.1f} ..{high:5.1f} {histogram[i]:>9} {100 * histogram[i] / total:5.1f} % {bar}")
    return "\n".join(["Scaled Jacobian", *_indented(lines)])


def _times(seconds):
    lines = [f"{stage:<10}{time:8.3f} s" for stage, time in seconds.items() if time > 0]
    return "\n".join(["Times", *_indented(lines)])


def _indented(lines):
    return ["  " + line.rstrip() for line in lines]

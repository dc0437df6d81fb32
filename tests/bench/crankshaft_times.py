"""Time of the whole pipeline on the crankshaft against the number of hexahedra, stage by stage.

    /usr/bin/python3 tests/bench/crankshaft_times.py [COUNT ...]

Without arguments 10 thousand, 100 thousand and 1 million. Columns of stages are seconds by the clock; `cpu` is what
all threads and the programs that were started took together, and the ratio is that of cpu time for each element to the
first row's.
"""

import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "Mod"), str(ROOT / "tests" / "gallery")]

from gallery import Case, manifest  # noqa: E402

from sweepmesh import Options, mesh, read  # noqa: E402

STAGES = ["assess", "imprint", "intervals", "surface", "place", "quality"]


def cpu_seconds():
    """Of this process and of those that it has waited for."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


def main(counts):
    case = Case("crankshaft", manifest()["crankshaft"], 0)
    model = read(case.path)
    picks = case.picks(model)
    first = None
    print(f"{'hexahedra':>10} {'size':>6}" + "".join(f"{stage:>10}" for stage in STAGES) + f"{'total':>10}{'cpu':>10} {'ratio':>6}")
    for count in counts:
        size = (model.volume / count) ** (1 / 3)
        before = cpu_seconds()
        result = mesh(model, Options(size=size, max_elements=10 * count, **picks))
        seconds = [result.seconds.get(stage, 0.0) for stage in STAGES]
        total, cpu = result.seconds["total"], cpu_seconds() - before
        first = first or cpu / result.n_elements
        print(
            f"{result.n_elements:10} {result.size:6.2f}"
            + "".join(f"{s:10.2f}" for s in seconds)
            + f"{total:10.2f}{cpu:10.2f} {cpu / result.n_elements / first:6.2f}",
            flush=True,
        )


if __name__ == "__main__":
    main([int(float(text)) for text in sys.argv[1:]] or [10_000, 100_000, 1_000_000])

"""Calibrates the bound on folding: fold_calibration.py [--solids 12] [--first SEED] [--family NAME] [--results FILE]

Random prisms with moving walls (tests/gallery/fold_families.py) are measured (how far their holes wind) and meshed, whatever
the bound says of them. Printed are the outcomes by winding, and what each limit would do: how many solids that can be
meshed it would refuse, and how many of those that fold it would predict. With --results, outcomes are added to that file,
one JSON object a line, and solids that are in it already are not meshed again. The exit status is 1 where a solid that
can be meshed is refused.
"""

import argparse
import json
import multiprocessing
import pathlib
import resource
import statistics
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "Mod"), str(ROOT / "tests" / "gallery")]

from sweepmesh.freecad import import_freecad  # noqa: E402

import_freecad()

import fold_families  # noqa: E402
import sweepmesh  # noqa: E402
from sweepmesh.engine import hole_winding  # noqa: E402

BINS = (0, 60, 100, 140, 180, 200, 1000)
"""Degrees."""
LIMITS = (120, 140, 160, 180, 190, 200, 220)
SECONDS = 240
"""Processor time for one solid."""


def examined(family, seed):
    """What came of one solid, as a dict."""
    solid = fold_families.make(family, seed)
    options = sweepmesh.Options(sources=solid.sources, targets=solid.targets, threads=1, refuse_folds=False)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "solid.brep"
        solid.shape.exportBrep(str(path))
        model = sweepmesh.read(str(path))
    out = {"family": family, "seed": seed, "numbers": solid.numbers, "least": None}
    out["winding"] = hole_winding(model, options).degrees
    refused = sweepmesh.assess(model, options)
    out["is_refused"] = any(" turn the layers between must fold" in reason.text for reason in refused.reasons)
    return {**out, **outcome(model, options)}


def outcome(model, options):
    """meshed, folded (elements or cells of a cap stay inverted), refused by another reason, or failed."""
    try:
        result = sweepmesh.mesh(model, options)
    except sweepmesh.SweepMeshError as error:
        is_folded = "stay inverted" in str(error)
        return {"outcome": "folded" if is_folded else "failed", "detail": f"{error.stage}: {error}"}
    if result.assessment.is_sweepable:
        return {"outcome": "meshed", "least": result.quality["min_scaled_jacobian"], "detail": ""}
    reason = result.assessment.reasons[0].text
    return {"outcome": "folded" if "stay inverted" in reason else "refused", "detail": reason}


def serve(connection, family, seed):
    """In a process of its own, which ends when its time is up."""
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    connection.send(examined(family, seed))


def examined_apart(family, seed):
    """As examined(); the outcome of a process that ends early is `out of time`."""
    here, there = multiprocessing.Pipe()
    process = multiprocessing.Process(target=serve, args=(there, family, seed))
    process.start()
    there.close()
    try:
        return here.recv()
    except EOFError:
        return {"family": family, "seed": seed, "outcome": "out of time", "least": None}
    finally:
        process.join()


def known(path):
    """The results that a file has, by (family, seed)."""
    if path is None or not path.exists():
        return {}
    results = map(json.loads, path.read_text().splitlines())
    return {(one["family"], one["seed"]): one for one in results}


def all_of(families, seeds, path):
    """The results of all solids, in order."""
    done = known(path)
    for seed in seeds:
        for family in families:
            if (family, seed) in done:
                continue
            done[family, seed] = one = examined_apart(family, seed)
            if path is not None:
                with path.open("a") as file:
                    file.write(json.dumps(one) + "\n")
    return [done[family, seed] for seed in seeds for family in families]


def print_by_winding(results):
    """Outcomes and quality in each range of winding."""
    print(f"{'degrees':>12}{'solids':>8}{'meshed':>8}{'folded':>8}{'other':>8}   least scaled Jacobian: median, best")
    for low, high in zip(BINS, BINS[1:]):
        here = [one for one in results if low <= one["winding"] < high]
        meshed = [one["least"] for one in here if one["outcome"] == "meshed"]
        folded = sum(one["outcome"] == "folded" for one in here)
        quality = f"{statistics.median(meshed):.2f} {max(meshed):.2f}" if meshed else ""
        other = len(here) - len(meshed) - folded
        print(f"{low:>5} ..{high:>5}{len(here):>8}{len(meshed):>8}{folded:>8}{other:>8}   {quality}")


def print_by_limit(results):
    """What each limit would do."""
    meshed = [one for one in results if one["outcome"] == "meshed"]
    folded = [one for one in results if one["outcome"] == "folded"]
    for limit in LIMITS:
        wrong = sum(one["winding"] > limit for one in meshed)
        right = sum(one["winding"] > limit for one in folded)
        print(f"limit {limit}: {wrong} of {len(meshed)} meshed are refused, {right} of {len(folded)} folds are predicted")


def main():
    """Prints both tables, and the solids that the bound refuses though they can be meshed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--solids", type=int, default=12, help="of each family (default: 12)")
    parser.add_argument("--first", type=int, default=0, help="the first seed (default: 0)")
    parser.add_argument("--family", action="append", choices=fold_families.FAMILIES, help="repeatable (default: all)")
    parser.add_argument("--results", type=pathlib.Path, help="where outcomes are kept")
    chosen = parser.parse_args()
    seeds = range(chosen.first, chosen.first + chosen.solids)
    results = all_of(chosen.family or list(fold_families.FAMILIES), seeds, chosen.results)
    in_time = [one for one in results if one["outcome"] != "out of time"]
    print(f"{len(in_time)} solids, {len(results) - len(in_time)} more out of time")
    print_by_winding(in_time)
    print_by_limit(in_time)
    wrong = [one for one in in_time if one["outcome"] == "meshed" and one["is_refused"]]
    for one in wrong:
        print(f"refused, but can be meshed: {one['family']} {one['seed']}, {one['winding']:.0f} degrees")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

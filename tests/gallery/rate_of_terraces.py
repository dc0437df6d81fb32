"""Meshes random terraced solids and prints the rate: how many of them are meshed, and why the others are not.

    /usr/bin/python3 tests/gallery/rate_of_terraces.py [FIRST [COUNT]]

Seeds FIRST to FIRST + COUNT - 1, from 0 and 100 without arguments. The exit status is 1 when a mesh is invalid or a
failure is no typed error with entities.
"""

import dataclasses
import pathlib
import random
import sys
import time
from typing import List

HERE = pathlib.Path(__file__).resolve().parent
for folder in (HERE, HERE.parents[1] / "Mod"):
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))

from sweepmesh.freecad import import_freecad  # noqa: E402

FreeCAD = import_freecad()
from checker import expect_valid_sweep  # noqa: E402
from solids.random_terraces import caps_of, random_terraced  # noqa: E402

from sweepmesh import Options, SweepMeshError, engine, mesh  # noqa: E402

N_ELEMENTS = 2000
"""What the element size aims at."""


@dataclasses.dataclass
class Outcome:
    """What became of a solid."""

    seed: int
    n_elements: int = 0
    """0: it was not meshed."""
    n_nodes: int = 0
    n_layers: int = 0
    quality: float = 0.0
    """Least scaled Jacobian."""
    refusal: str = ""
    entities: List[str] = dataclasses.field(default_factory=list)
    seconds: float = 0.0

    def __str__(self):
        if self.n_elements:
            return f"{self.seed:5} {self.n_elements:6} elements {self.quality:6.3f}  {self.seconds:5.1f} s"
        return f"{self.seed:5} {self.refusal} {' '.join(self.entities)}  {self.seconds:5.1f} s"


def shape_of(seed, scale=1.0):
    """The solid of a seed; with a scale it is turned too, about an axis and by an angle of the seed's own."""
    shape = random_terraced(seed)
    if scale != 1.0:
        chance = random.Random(seed)
        axis = FreeCAD.Vector(*(chance.uniform(-1, 1) for _ in range(3)))
        shape.rotate(FreeCAD.Vector(0, 0, 0), axis, chance.uniform(20, 340))
        shape.scale(scale)
    return shape


def attempt(seed, scale=1.0, check=True):
    """Meshes the solid of a seed; an invalid mesh is an AssertionError, a failure without entities too."""
    upright, shape = random_terraced(seed), shape_of(seed, scale)
    sources, targets = caps_of(upright)  # faces keep their numbers when a solid is turned
    size = scale * (upright.Volume / N_ELEMENTS) ** (1 / 3)
    model = engine.Model.from_brep(shape.exportBrepToString(), 0)
    start = time.monotonic()
    try:
        result = mesh(model, Options(size=size, sources=sources, targets=targets))
    except SweepMeshError as error:
        assert error.stage and error.entities and str(error).endswith("."), f"{seed}: {type(error)} {error}"
        text = f"{type(error).__name__}: {error}"
        return Outcome(seed, refusal=text, entities=error.entities, seconds=time.monotonic() - start)
    seconds = time.monotonic() - start
    if not result.assessment.is_sweepable:
        reason = result.assessment.reasons[0]
        assert reason.entities, f"{seed}: {reason.text}"
        return Outcome(seed, refusal=f"{reason.kind}: {reason.text}", entities=reason.entities, seconds=seconds)
    if check:
        expect_valid_sweep(result, model)
    least = result.quality["min_scaled_jacobian"]
    return Outcome(seed, result.n_elements, len(result.points), result.n_layers, least, seconds=seconds)


def table(seeds):
    """Attempts all seeds, prints a line each and the rate; returns the outcomes."""
    outcomes = []
    for seed in seeds:
        outcomes.append(attempt(seed))
        print(outcomes[-1], flush=True)
    meshed = [outcome for outcome in outcomes if outcome.n_elements]
    print(f"{len(meshed)} of {len(outcomes)} meshed: {100 * len(meshed) / len(outcomes):.0f} %")
    if meshed:
        worst = sorted(outcome.quality for outcome in meshed)
        print(f"least scaled Jacobian: median {worst[len(worst) // 2]:.2f}, lowest {worst[0]:.2f}")
    return outcomes


def main(arguments):
    first, count = [int(text) for text in arguments] + [0, 100][len(arguments):]
    try:
        table(range(first, first + count))
    except AssertionError as error:
        sys.exit(f"wrong: {error}")


if __name__ == "__main__":
    main(sys.argv[1:])

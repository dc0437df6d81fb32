"""Cuts random solids into two to four fragments, meshes them and prints how many have one mesh, and why others do not.

    /usr/bin/python3 tests/gallery/rate_of_fragments.py [FAMILY [FIRST [COUNT]]]

Families: prisms (upright, over polygons with holes) and terraces (random_terraces.py). The planes lie across the sweep,
along it, or both. The exit status is 1 when a mesh is invalid, or not one without a warning that says so.
"""

import dataclasses
import math
import pathlib
import random
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
for folder in (HERE, HERE.parents[1] / "Mod"):
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))

from sweepmesh.freecad import import_freecad  # noqa: E402

import_freecad()
import touching  # noqa: E402
from solids.kit import rod, vec  # noqa: E402
from solids.random_terraces import random_terraced  # noqa: E402

from sweepmesh import Options, SweepMeshError, engine, mesh  # noqa: E402

N_ELEMENTS = 2000
"""What the element size aims at."""


@dataclasses.dataclass
class Outcome:
    """What became of the fragments of a seed."""

    seed: int
    n_solids: int
    n_elements: int = 0
    """0: they were not meshed."""
    quality: float = 0.0
    """Least scaled Jacobian."""
    is_one: bool = False
    """One mesh on all common faces."""
    said: str = ""
    """The first warning, or why there is no mesh."""
    seconds: float = 0.0

    def __str__(self):
        kind = "one mesh" if self.is_one else "in parts" if self.n_elements else "no mesh "
        return (
            f"{self.seed:5} {self.n_solids} solids {kind} {self.n_elements:6} elements {self.quality:6.3f} "
            f"{self.seconds:5.1f} s {self.said}"
        )


def random_prism(chance):
    """Over a star-shaped polygon of four to eight corners, with up to two holes."""
    count = chance.randint(4, 8)
    corners = []
    for i in range(count):
        angle, radius = 2 * math.pi * (i + chance.uniform(-0.25, 0.25)) / count, chance.uniform(20, 32)
        corners.append((radius * math.cos(angle), radius * math.sin(angle)))
    height = chance.uniform(8, 40)
    shape = touching.prism(corners, 0, height)
    for side in chance.sample((-1, 1), chance.randint(0, 2)):
        shape = shape.cut(rod(chance.uniform(2, 4), vec(6 * side, chance.uniform(-4, 4)), height))
    return shape.Solids[0]


def random_planes(chance, shape):
    """One or two planes through the middle half of the solid."""
    box, planes = shape.BoundBox, []
    for kind in chance.sample(("across", "along", "along"), chance.randint(1, 2)):
        share = [chance.uniform(0.3, 0.7) for _ in range(3)]
        point = (
            box.XMin + share[0] * box.XLength,
            box.YMin + share[1] * box.YLength,
            box.ZMin + share[2] * box.ZLength,
        )
        angle = chance.choice((0, math.pi / 2, chance.uniform(0, math.pi)))
        normal = (0, 0, 1) if kind == "across" else (math.cos(angle), math.sin(angle), 0)
        planes.append((point, normal))
    return planes


def fragments_of(family, seed):
    """A compound of two to four solids with common faces."""
    chance = random.Random(f"fragments {family} {seed}")
    whole = random_prism(chance) if family == "prisms" else random_terraced(seed)
    while True:
        shape = touching.cut_by(whole, *random_planes(chance, whole))
        if 2 <= len(shape.Solids) <= 4 and all(solid.isValid() for solid in shape.Solids):
            return shape


def attempt(family, seed):
    """Meshes the fragments of a seed; an invalid mesh is an AssertionError, one that is in parts and says nothing too."""
    shape = fragments_of(family, seed)
    model = engine.Model.from_brep(shape.exportBrepToString(), 0)
    outcome = Outcome(seed, len(shape.Solids))
    start = time.monotonic()
    try:
        result = mesh(model, Options(size=(shape.Volume / N_ELEMENTS) ** (1 / 3)))
    except SweepMeshError as error:
        outcome.said = f"{type(error).__name__}: {error}"
        assert error.stage and error.entities, f"{seed}: {outcome.said}"
    else:
        check(result, model, shape, outcome)
    outcome.seconds = time.monotonic() - start
    return outcome


def check(result, model, shape, outcome):
    """Fills in what became of it."""
    if not result.assessment.is_sweepable:
        outcome.said = result.assessment.reasons[0].text
        return
    outcome.n_elements = result.n_elements
    outcome.quality = result.quality["min_scaled_jacobian"]
    outcome.said = result.warnings[0] if result.warnings else ""
    outcome.is_one = not any("share no nodes" in warning for warning in result.warnings)
    if outcome.is_one:
        touching.expect_glued(result, model, shape, *touching.contact_faces(shape))


def table(family, seeds):
    """Attempts all seeds, prints a line each and the rate; returns the outcomes."""
    outcomes = []
    for seed in seeds:
        outcomes.append(attempt(family, seed))
        print(outcomes[-1], flush=True)
    n_one = sum(outcome.is_one for outcome in outcomes)
    n_meshed = sum(outcome.n_elements > 0 for outcome in outcomes)
    print(f"{family}: {n_one} of {len(outcomes)} have one mesh, {n_meshed} a mesh: {100 * n_one / len(outcomes):.0f} %")
    if n_one:
        worst = sorted(outcome.quality for outcome in outcomes if outcome.is_one)
        print(f"least scaled Jacobian: median {worst[len(worst) // 2]:.2f}, lowest {worst[0]:.2f}")
    return outcomes


def main(arguments):
    family, first, count = arguments + ["prisms", "0", "40"][len(arguments) :]
    try:
        table(family, range(int(first), int(first) + int(count)))
    except AssertionError as error:
        sys.exit(f"wrong: {error}")


if __name__ == "__main__":
    main(sys.argv[1:])

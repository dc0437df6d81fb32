"""Meshes random terraced solids as they stand, and turned and scaled, and prints how many have the same counts each time.

    /usr/bin/python3 tests/gallery/rate_of_turned.py [FIRST [COUNT]]

Seeds FIRST to FIRST + COUNT - 1, from 100 and 20 without arguments. A line is printed for each solid whose counts differ,
or that no way of lying lets mesh. The exit status is 1 when counts differ.
"""

import sys

from rate_of_terraces import attempt

SCALES = (1.0, 1e-3, 1e3)
"""Of which the first leaves a solid as it stands."""


def counts_of(seed, scale):
    """Numbers of elements, nodes and layers; the reason where there are none."""
    outcome = attempt(seed, scale, check=False)
    return outcome.n_elements, outcome.n_nodes, outcome.n_layers, outcome.refusal.split(":")[0]


def unlike(seeds):
    """The seeds whose counts hang on how the solid lies or on its size; prints them, and the rate."""
    out = []
    for seed in seeds:
        counts = [counts_of(seed, scale) for scale in SCALES]
        if len(set(counts)) > 1:
            out.append(seed)
        if len(set(counts)) > 1 or not counts[0][0]:
            print(seed, *counts, flush=True)
    print(f"{len(seeds) - len(out)} of {len(seeds)} have the same counts however they lie", flush=True)
    return out


def main(arguments):
    first, count = [int(text) for text in arguments] + [100, 20][len(arguments):]
    sys.exit(1 if unlike(range(first, first + count)) else 0)


if __name__ == "__main__":
    main(sys.argv[1:])

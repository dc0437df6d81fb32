"""docs/placement_table.md, quick form: no other method of placement has a greater least or mean scaled Jacobian."""

import importlib.util

import pytest
from gallery import FOLDER, ROOT, manifest

PROGRAM = ROOT / "build" / "tests" / "bench" / "sweepmesh_bench_methods"


def table():
    """The module tests/bench/placement_table.py."""
    spec = importlib.util.spec_from_file_location("placement_table", ROOT / "tests" / "bench" / "placement_table.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


TABLE = table()


@pytest.mark.parametrize("name", [name for name, solid in manifest().items() if TABLE.is_in_table(solid)])
def test_no_method_beats_ours(name):
    rows = TABLE.run(PROGRAM, FOLDER, manifest()[name], is_quick=True)
    assert len(rows) >= 10, rows
    assert not TABLE.beats(rows)


def test_a_better_method_is_noticed():
    ours, other = ["harmonic_residual", "8", "0", "0.5", "0.9"], ["knupp_affine", "8", "0", "0.5", "0.9"]
    assert not TABLE.beats([ours, other])
    assert TABLE.beats([ours, [*other[:3], "0.6", "0.9"]])
    assert TABLE.beats([ours, [*other[:4], "0.91"]])
    assert TABLE.beats([[*ours[:2], "1", *ours[3:]], other])
    assert TABLE.beats([other])

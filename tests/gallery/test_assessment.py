"""The verdict on every solid of the gallery, with the picks of each of its schemes and without any."""

import time

import pytest
import sweepmesh
from gallery import cases
from sweepmesh import Options

KINDS = ("1-1", "M-1", "M-N", "radial", "submap", "unsweepable")

# What each refused solid's first reason has to be.
REASONS = {
    "sphere_two_voids": "topological",
    "sphere_three_voids": "topological",
    "genus3_cross_drilled": "topological",
    "curved_through_hole": "geometric",
    "prescribed_mismatch": "prescribed",
}


def chosen_scheme(case):
    """The manifest's scheme that the case picks; empty without picks."""
    return case.entry["schemes"][case.scheme] if case.scheme >= 0 else {}


def verdict(case):
    """What the manifest says of a case: a solid that can be swept may be unsweepable as picked, and the other way round."""
    if "feasible" in chosen_scheme(case):
        return "sweepable" if chosen_scheme(case)["feasible"] else "unsweepable"
    if case.name == "prescribed_mismatch":
        return "sweepable"  # only its pairs are impossible
    return case.entry["expected"]["verdict"]


def single_solids(*kinds):
    """Cases of one solid each."""
    return [case for case in cases(*kinds) if case.entry["solids"] == 1]


@pytest.mark.parametrize("case", single_solids(*KINDS), ids=lambda case: case.label)
def test_verdict_is_the_manifests(case):
    model = sweepmesh.read(case.path)
    asked = Options(**case.picks(model))
    start = time.monotonic()
    found = sweepmesh.assess(model, asked)
    assert time.monotonic() - start < 10
    assert found.verdict == verdict(case), [reason.text for reason in found.reasons]
    if found.is_sweepable:
        for faces, role in ((asked.sources, "source"), (asked.targets, "target")):
            assert all(found.roles[f"Face{face}"] == role for face in faces)
    else:
        first = found.reasons[0]
        assert first.kind == REASONS[case.name] and first.text.endswith(".") and first.entities


@pytest.mark.parametrize(
    "case", [case for case in single_solids("M-1", "M-N") if case.scheme >= 0], ids=lambda case: case.label
)
def test_sources_alone_lead_to_the_same_targets(case):
    """Half of the picks is enough: the other half is found."""
    model = sweepmesh.read(case.path)
    both = Options(**case.picks(model))
    found = sweepmesh.assess(model, Options(sources=both.sources))
    assert found.is_sweepable, [reason.text for reason in found.reasons]
    assert all(found.roles[f"Face{face}"] == "source" for face in both.sources)

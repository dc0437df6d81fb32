"""Every solid of the gallery, meshed with the picks of each of its schemes and without any."""

import pytest
from checker import expect_valid_sweep
from gallery import cases, find_judge

import sweepmesh

JUDGE = find_judge()


@pytest.mark.parametrize("case", cases("1-1", "M-1"), ids=lambda case: case.label)
def test_is_meshed(case, tmp_path):
    model, result = case.mesh()
    assert result.assessment.is_sweepable, [reason.text for reason in result.assessment.reasons]
    expect_valid_sweep(result, model, case.genus)
    if JUDGE:
        sweepmesh.write(result, tmp_path / "mesh.vtu")
        verdict = JUDGE(str(tmp_path / "mesh.vtu"), str(case.path))
        assert verdict["failures"] == []


@pytest.mark.parametrize("case", cases("unsweepable"), ids=lambda case: case.label)
def test_what_cannot_be_swept_is_refused_with_a_reason_or_an_error(case):
    """A one-to-one sweeper may refuse for another reason than the manifest's; it must not return a bad mesh."""
    try:
        model, result = case.mesh()
    except sweepmesh.SweepMeshError as error:
        assert str(error).endswith(".")
        return
    if result.assessment.is_sweepable:
        expect_valid_sweep(result, model, case.genus)
    else:
        assert result.assessment.reasons


@pytest.mark.parametrize("case", cases("M-N", "radial", "submap"), ids=lambda case: case.label)
def test_other_solids_are_served_rightly_or_refused_in_a_sentence(case):
    try:
        model, result = case.mesh()
    except sweepmesh.SweepMeshError as error:
        assert str(error).endswith(".") and error.stage
        return
    if result.assessment.is_sweepable:
        expect_valid_sweep(result, model, case.genus)
    else:
        assert all(reason.text.endswith(".") for reason in result.assessment.reasons)

"""Every solid of the gallery, meshed with the picks of each of its schemes and without any."""

import pytest
from checker import expect_valid_sweep
from gallery import cases, find_judge

import sweepmesh

JUDGE = find_judge()


@pytest.mark.parametrize(
    "case", cases("1-1", "M-1", "M-N", "submap", "radial"), ids=lambda case: case.label
)
def test_is_meshed(case, tmp_path):
    model, result = case.mesh()
    assert result.assessment.is_sweepable, [reason.text for reason in result.assessment.reasons]
    expect_valid_sweep(result, model, case.genus)
    if JUDGE:
        sweepmesh.write(result, tmp_path / "mesh.vtu")
        verdict = JUDGE(str(tmp_path / "mesh.vtu"), str(case.path))
        assert verdict["failures"] == []


@pytest.mark.parametrize("case", cases("unsweepable"), ids=lambda case: case.label)
def test_what_cannot_be_swept_gives_reasons_or_a_valid_mesh(case):
    """With other picks than the manifest's some can be swept: whatever comes out must be right."""
    model, result = case.mesh()
    if result.assessment.is_sweepable:
        expect_valid_sweep(result, model, case.genus)
    else:
        assert all(reason.text.endswith(".") for reason in result.assessment.reasons)
        assert result.assessment.reasons

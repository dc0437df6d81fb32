"""Every solid of the gallery that one source and one target serve, with its picks and without any."""

import pytest
from checker import expect_valid_sweep
from gallery import cases, find_judge

import sweepmesh
from sweepmesh import Options

JUDGE = find_judge()


def mesh(case):
    """The model and the mesh of a case."""
    model = sweepmesh.read(case.path)
    sources, targets = ([sweepmesh.face_at(model, point) for point in points] for points in case.picks())
    return model, sweepmesh.mesh(model, Options(size=case.size, sources=sources, targets=targets))


@pytest.mark.parametrize("case", cases("1-1"), ids=lambda case: case.label)
def test_one_to_one(case, tmp_path):
    model, result = mesh(case)
    assert result.assessment.is_sweepable, [reason.text for reason in result.assessment.reasons]
    expect_valid_sweep(result, model, case.genus)
    if JUDGE:
        sweepmesh.write(result, tmp_path / "mesh.vtu")
        verdict = JUDGE(str(tmp_path / "mesh.vtu"), str(case.path))
        assert verdict["failures"] == []


@pytest.mark.parametrize("case", cases("1-1"), ids=lambda case: case.label)
def test_one_to_one_is_assessed_as_in_the_manifest(case):
    model = sweepmesh.read(case.path)
    sources, targets = ([sweepmesh.face_at(model, point) for point in points] for points in case.picks())
    found = sweepmesh.assess(model, Options(sources=sources, targets=targets))
    assert found.verdict == case.entry["expected"]["verdict"]
    for faces, role in ((sources, "source"), (targets, "target")):
        assert all(found.roles[f"Face{face}"] == role for face in faces)


@pytest.mark.parametrize("case", cases("unsweepable"), ids=lambda case: case.label)
def test_what_cannot_be_swept_is_refused_with_a_reason_or_an_error(case):
    """A one-to-one sweeper may refuse for another reason than the manifest's; it must not return a bad mesh."""
    try:
        model, result = mesh(case)
    except sweepmesh.SweepMeshError as error:
        assert str(error).endswith(".")
        return
    if result.assessment.is_sweepable:
        expect_valid_sweep(result, model, case.genus)
    else:
        assert result.assessment.reasons


@pytest.mark.parametrize("case", cases("M-1", "M-N", "radial", "submap"), ids=lambda case: case.label)
def test_other_solids_are_served_rightly_or_refused_in_a_sentence(case):
    try:
        model, result = mesh(case)
    except sweepmesh.SweepMeshError as error:
        assert str(error).endswith(".") and error.stage
        return
    if result.assessment.is_sweepable:
        expect_valid_sweep(result, model, case.genus)
    else:
        assert all(reason.text.endswith(".") for reason in result.assessment.reasons)

"""Every text that users see is in the file that translators get."""
import pathlib
import runpy

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "Resources" / "translations"


def test_the_file_for_translators_is_up_to_date():
    collect = runpy.run_path(str(FOLDER / "collect.py"))
    expected = collect["as_ts"](collect["collect"]())
    assert (FOLDER / "SweepMesh.ts").read_text(encoding="utf-8") == expected, "run Resources/translations/collect.py"


def test_texts_of_panels_properties_commands_and_forms_are_in_it():
    text = (FOLDER / "SweepMesh.ts").read_text(encoding="utf-8")
    for sentence in (
        "The solid can be swept.",
        "Wished edge length; 0: chosen from the volume",
        "Create sweep mesh",
        "Vertex types",
    ):
        assert f"<source>{sentence}</source>" in text

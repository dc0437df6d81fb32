"""Every text that users see is in the file that translators get."""
import pathlib
import re
import runpy

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "Resources" / "translations"


def test_the_files_for_translators_are_up_to_date():
    for path, expected in runpy.run_path(str(FOLDER / "collect.py"))["files"]().items():
        assert path.read_text(encoding="utf-8") == expected, "run Resources/translations/collect.py"


def test_the_translations_are_whole_and_keep_the_places_for_values():
    collect = runpy.run_path(str(FOLDER / "collect.py"))
    wanted = {(context, text) for context, texts in collect["collect"]().items() for text in texts}
    for path in FOLDER.glob("SweepMesh_*.ts"):
        done = collect["translated"](path)
        assert set(done) == wanted, sorted(wanted - set(done))[:5]
        for (_, text), translation in done.items():
            assert sorted(re.findall(r"{[^}]*}", text)) == sorted(re.findall(r"{[^}]*}", translation)), text


def test_texts_of_panels_properties_commands_and_forms_are_in_it():
    text = (FOLDER / "SweepMesh.ts").read_text(encoding="utf-8")
    for sentence in (
        "The solid can be swept.",
        "Wished edge length; 0: chosen from the volume",
        "Create sweep mesh",
        "Vertex types",
    ):
        assert f"<source>{sentence}</source>" in text

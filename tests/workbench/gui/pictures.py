"""Make the pictures of the documentation: run the macros and copy what they saw to docs/pictures."""
import shutil

from session import ROOT, run

PICTURES = {
    "create_mesh": {"02_proposal": "create_mesh_proposal", "05_mesh": "create_mesh_mesh"},
    "previews": {"02_types": "previews_types", "03_intervals": "previews_intervals"},
    "solve": {"01_ends": "solve_ends", "03_results": "solve_results"},
    "quality": {"03_section": "quality_section"},
}

if __name__ == "__main__":
    target = ROOT / "docs" / "pictures"
    target.mkdir(parents=True, exist_ok=True)
    for macro, names in PICTURES.items():
        folder = ROOT / "build" / "gui" / macro
        run(f"macro_{macro}.py", folder)
        for source, name in names.items():
            shutil.copy(folder / f"{source}.png", target / f"{name}.png")

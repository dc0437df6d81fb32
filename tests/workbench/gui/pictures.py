"""Make the pictures of the documentation: run the macros and copy what they saw to docs/pictures.

    /usr/bin/python3 pictures.py           runs them
    /usr/bin/python3 pictures.py --made    takes what the tests have left in build/gui
"""
import subprocess
import sys

from session import ROOT, run

TARGET = ROOT / "docs" / "pictures"
PICTURES = {
    "create_mesh": {
        "02_proposal": "create_mesh_proposal",
        "04_picking": "create_mesh_picking",
        "05_mesh": "create_mesh_mesh",
    },
    "completeness": {"01_preferences": "preferences"},
    "previews": {
        "02_types": "previews_types",
        "03_intervals": "previews_intervals",
        "06_levels": "previews_levels",
        "07_pairs": "previews_pairs",
    },
    "overrides": {"01_count": "override_count", "03_growth": "override_growth", "07_types": "override_type"},
    "cut": {"01_offer": "create_mesh_cut"},
    "solve": {"03_results": "solve_results"},
    "quality": {
        "01_quality": "quality_whole",
        "02_threshold": "quality_threshold",
        "03_section": "quality_section",
        "04_worst": "quality_worst",
    },
    "tutorial": {
        "01_through_the_wall": "tutorial_through_the_wall",
        "02_along_the_pipe": "tutorial_along_the_pipe",
        "03_levels": "tutorial_levels",
        "04_pairs": "tutorial_pairs",
        "05_override": "tutorial_override",
        "06_mesh": "tutorial_mesh",
        "07_quality": "tutorial_quality",
        "08_stresses": "tutorial_stresses",
    },
}


def made_by(macro):
    """Where the pictures of a macro are left, and where they go: [(path, path)]."""
    folder = ROOT / "build" / "gui" / macro
    return [(folder / f"{source}.png", TARGET / f"{name}.png") for source, name in PICTURES[macro].items()]


def publish(macro):
    """Copy the pictures of a macro to the documentation, smaller and with fewer colours."""
    TARGET.mkdir(parents=True, exist_ok=True)
    for source, target in made_by(macro):
        subprocess.run(["convert", source, "-resize", "75%", "+dither", "-colors", "96", "-strip", target], check=True)


if __name__ == "__main__":
    for name in PICTURES:
        if "--made" not in sys.argv:
            run(f"macro_{name}.py", ROOT / "build" / "gui" / name)
        publish(name)

"""The pictures of the documentation are those that the tests make, and look like them still."""
import re

import pytest
from pictures import PICTURES, TARGET, made_by
from PySide2 import QtCore, QtGui
from session import ROOT

# A picture of 40 x 28 pixels does not depend on fonts; another panel or another view differs by more.
SMALL, MAX_DIFFERENCE = (40, 28), 20.0
PAGES = ("workbench", "create_mesh", "show_quality", "tutorial")


def small(path):
    """The picture's colours, very coarse, as bytes."""
    ratio, smooth = QtCore.Qt.IgnoreAspectRatio, QtCore.Qt.SmoothTransformation
    image = QtGui.QImage(str(path)).scaled(*SMALL, ratio, smooth)
    return bytes(image.convertToFormat(QtGui.QImage.Format_RGB888).bits())[: 3 * SMALL[0] * SMALL[1]]


def difference(a, b):
    """Mean difference of two pictures' colours, 0 to 255."""
    one, other = small(a), small(b)
    return sum(abs(x - y) for x, y in zip(one, other)) / len(one)


def test_every_picture_on_the_pages_is_made_by_a_test():
    shown = set()
    for page in PAGES:
        shown.update(re.findall(r"pictures/(\w+)\.png", (ROOT / "docs" / f"{page}.md").read_text(encoding="utf-8")))
    assert shown == {name for names in PICTURES.values() for name in names.values()}
    assert all((TARGET / f"{name}.png").is_file() for name in shown)


def test_every_command_has_a_page():
    index = (ROOT / "docs" / "workbench.md").read_text(encoding="utf-8")
    for code in (ROOT / "Mod" / "sweepmesh" / "gui" / "commands").glob("cmd_*.py"):
        name = re.search(r'"MenuText": QT_TRANSLATE_NOOP\("\w+", "([^"]+)"', code.read_text(encoding="utf-8"))[1]
        page = re.search(rf"\[{re.escape(name)}\]\((\w+\.md)\)", index)
        assert page and (ROOT / "docs" / page[1]).is_file(), name


@pytest.mark.parametrize("macro", PICTURES)
def test_pictures_are_not_stale(macro):
    if not all(source.is_file() for source, _ in made_by(macro)):
        pytest.skip("the macro has not been run here")
    for source, target in made_by(macro):
        assert difference(source, target) < MAX_DIFFERENCE, f"{target.name}: run tests/workbench/gui/pictures.py"

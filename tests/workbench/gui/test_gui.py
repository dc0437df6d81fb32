"""Each macro of this folder is one test: FreeCAD under Xvfb, driven by the mouse."""
import pytest
from session import HERE, ROOT, missing_programs, run

MACROS = sorted(path.name for path in HERE.glob("macro_*.py"))

pytestmark = pytest.mark.skipif(bool(missing_programs()), reason=f"not installed: {missing_programs()}")


@pytest.mark.parametrize("macro", MACROS)
def test_macro(macro):
    results = run(macro, ROOT / "build" / "gui" / macro[len("macro_") : -len(".py")])
    assert "error" not in results, results["error"]
    failed = [name for name, truth in results["checks"].items() if not truth]
    assert not results["unmet"], f"waited for in vain at {results['unmet']}"
    assert not failed and results["checks"], (failed, results["values"])
    assert not results["tracebacks"]

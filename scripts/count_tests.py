"""Sums the JUnit files that the runners left: count_tests.py FOLDER SUITE...

Fails when a suite left no file, has no tests or has failures. The last line is "N passed, N failed".
"""

import pathlib
import sys
import xml.etree.ElementTree


def count(path):
    """(passed, failed, skipped) of a JUnit file; a file that a crashed runner left out is one failure."""
    if not path.is_file():
        return 0, 1, 0
    passed = failed = skipped = 0
    for case in xml.etree.ElementTree.parse(path).iter("testcase"):
        outcomes = {child.tag for child in case}
        if outcomes & {"failure", "error"} or case.get("status") == "fail":
            failed += 1
        elif "skipped" in outcomes:
            skipped += 1
        else:
            passed += 1
    return (passed, failed, skipped) if passed + failed + skipped else (0, 1, 0)


def main(folder, suites):
    """Prints a line a suite and the sum; returns the exit status."""
    totals = [0, 0, 0]
    for suite in suites:
        counts = count(pathlib.Path(folder) / f"{suite}.xml")
        totals = [a + b for a, b in zip(totals, counts)]
        print(f"{suite:<10} {counts[0]:>5} passed {counts[1]:>5} failed {counts[2]:>5} skipped")
    print(f"{totals[0]} passed, {totals[1]} failed")
    return 1 if totals[1] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Names the tests that were skipped, and says why: python3 left_out.py RESULTS, which CTest wrote with --output-junit."""

import sys
import xml.etree.ElementTree


def reason(output):
    """The line that GoogleTest prints after "Skipped", or else the last one."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    after = [lines[i + 1] for i, line in enumerate(lines[:-1]) if line.endswith(": Skipped")]
    return (after or lines or ["no reason is given"])[-1]


def left_out(results):
    cases = xml.etree.ElementTree.parse(results).iter("testcase")
    return [(case.get("name"), reason(case.findtext("system-out", ""))) for case in cases if case.find("skipped") is not None]


if __name__ == "__main__":
    found = left_out(sys.argv[1])
    print(("1 test was" if len(found) == 1 else f"{len(found)} tests were") + " left out" + (":" if found else "."))
    for name, why in found:
        print(f"  {name}: {why}")

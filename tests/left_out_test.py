#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gives left_out.py results as CTest writes them, and looks at what it prints."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(__file__).with_name("left_out.py")
RAN = '<testcase name="Equirect.RoundTrips" status="run"><system-out>[       OK ] Equirect.RoundTrips</system-out></testcase>'
SKIPPED = """<testcase name="Mujoco.RendersAScene" status="notrun">
  <skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/>
  <system-out>[ RUN      ] Mujoco.RendersAScene
/src/mujoco_test.cpp:20: Skipped
MuJoCo is not installed.

[  SKIPPED ] Mujoco.RendersAScene (0 ms)
</system-out></testcase>"""
SKIPPED_OTHERWISE = """<testcase name="Ros.ReadsTheBag" status="notrun"><skipped message="x"/>
  <system-out>Looking for rosbag.
rosbag was not found.
</system-out></testcase>"""
SILENT = '<testcase name="Silent.SaysNothing" status="notrun"><skipped message="x"/></testcase>'


class LeftOut(unittest.TestCase):
    def printed(self, *cases):
        with tempfile.NamedTemporaryFile("w", suffix=".xml") as file:
            file.write('<?xml version="1.0" encoding="UTF-8"?><testsuite name="tests">' + "".join(cases) + "</testsuite>")
            file.flush()
            return subprocess.run([sys.executable, "-B", PROGRAM, file.name], check=True, capture_output=True, text=True).stdout

    def test_names_a_skipped_test_and_its_reason(self):
        self.assertEqual(self.printed(RAN, SKIPPED), "1 test was left out:\n  Mujoco.RendersAScene: MuJoCo is not installed.\n")

    def test_takes_the_last_line_of_other_programs(self):
        self.assertIn("Ros.ReadsTheBag: rosbag was not found.", self.printed(SKIPPED_OTHERWISE, RAN))

    def test_says_that_no_reason_is_given(self):
        self.assertIn("Silent.SaysNothing: no reason is given", self.printed(SILENT))

    def test_says_that_nothing_was_left_out(self):
        self.assertEqual(self.printed(RAN), "0 tests were left out.\n")


if __name__ == "__main__":
    unittest.main()

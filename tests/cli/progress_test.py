# SPDX-License-Identifier: BSD-3-Clause
"""The line on a terminal that shows how far a long task is."""
import os
import pty
import re
import subprocess
import unittest

from trivet_test import SOURCE, TRIVET, InTemporaryFolder


class Progress(InTemporaryFolder):
    def on_terminal(self, *words):
        """Standard error of a run whose standard error is a terminal."""
        ours, theirs = pty.openpty()
        run = subprocess.Popen([TRIVET, *words], stdout=subprocess.DEVNULL, stderr=theirs)
        os.close(theirs)
        text = b""
        while True:
            try:
                piece = os.read(ours, 4096)
            except OSError:  # the other end is closed
                break
            if not piece:
                break
            text += piece
        os.close(ours)
        self.assertEqual(run.wait(), 0)
        return text.decode()

    def test_a_long_map_shows_its_share_and_the_time_left(self):
        text = self.on_terminal("map", str(SOURCE / "examples/paper/map.toml"), "--points", "1000")
        shares = [int(share) for share in re.findall(r"designs (\d+) %", text)]
        self.assertGreater(len(shares), 10)
        self.assertEqual(shares, sorted(shares))
        self.assertRegex(text, r"designs \d+ %, about \d+ (s|min) left")
        self.assertTrue(text.endswith("\r\x1b[K"), text[-40:])

    def test_a_quick_command_leaves_nothing(self):
        text = self.on_terminal("peaks", str(SOURCE / "examples/paper/corrected.toml"))
        self.assertEqual(re.sub(r"\r\x1b\[K[a-z ]* \d+ %|\r\x1b\[K", "", text), "")


if __name__ == "__main__":
    unittest.main()

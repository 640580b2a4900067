# SPDX-License-Identifier: BSD-3-Clause
"""Searches over designs that take long, and searches that end early."""
import json
import signal
import subprocess
import time
import unittest

from trivet_test import SOURCE, TRIVET, InTemporaryFolder, result_of, trivet

SNUBBER = SOURCE / "examples/snubber/genset.toml"
POWERTRAIN = SOURCE / "examples/powertrain/decoupled.toml"


def least_margin(judged):
    """Of the base model; JSON has null for ∞."""
    return min(r["margin"] for r in judged["cases"][0]["requirements"] if r["margin"] is not None)


class LongSearch(InTemporaryFolder):
    def test_one_number_of_steady_motion_against_verdicts(self):
        found = result_of("optimize", SNUBBER)
        self.assertEqual(len(found["parameters"]), 1)
        best = found["parameters"][0]["optimum"]
        slip = "element_types.snubber.laws.z.friction.slip"
        for other in (0.9 * best, 0.97 * best, 1.03 * best, 1.1 * best):
            judged = result_of("verdict", SNUBBER, "--set", f"{slip}={other}")
            self.assertGreater(found["after"], least_margin(judged))
        judged = result_of("verdict", SNUBBER, "--set", f"{slip}={best:.12g}")
        self.assertAlmostEqual(found["after"] / least_margin(judged), 1, 9)
        self.assertLess(found["designs"], 100)

    def long(self, *more):
        return [TRIVET, "optimize", str(POWERTRAIN), "--set", "analyses.optimize.starts=1000", "--json", *more]

    def test_a_time_limit_keeps_the_best_design_so_far(self):
        start = time.monotonic()
        done = subprocess.run(self.long("--time-limit", "1 s"), capture_output=True, text=True, timeout=60)
        self.assertLess(time.monotonic() - start, 30)
        self.assertEqual(done.returncode, 1, done.stderr)
        found = json.loads(done.stdout)
        self.assertTrue(found["cut_short"])
        self.assertTrue(any("ended before it was complete" in str(w) for w in found["warnings"]))

    def test_an_unfinished_search_states_nothing_of_an_optimum(self):
        command = [one for one in self.long("--time-limit", "1 s") if one != "--json"]
        text = subprocess.run(command, capture_output=True, text=True, timeout=60).stdout
        for words in ("Residual", "reached this", "contradict", "requirement that limits the optimum"):
            self.assertNotIn(words, text)
        self.assertRegex(text, r"\d+ of 1\d\d\d starts finished")

    def interrupted_in_the_search(self):
        """A search after its first SIGINT, and what it wrote to stderr then. A signal before the search begins ends the
        program, so such a run is repeated with a later signal."""
        wait, words = 1.5, ""
        while wait < 30:
            run = subprocess.Popen(self.long(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, bufsize=1)
            self.addCleanup(lambda one=run: (one.kill(), one.wait(), one.stdout.close(), one.stderr.close()))
            time.sleep(wait)
            run.send_signal(signal.SIGINT)
            words = ""
            for line in run.stderr:
                words += line
                if "best design so far" in line:
                    return run, words
            self.assertIn(run.wait(60), (130, -signal.SIGINT), words)
            wait *= 2
        self.fail("the search did not begin: " + words)

    def test_an_interrupt_keeps_the_best_design_so_far(self):
        run, _ = self.interrupted_in_the_search()
        output, more = run.communicate(timeout=120)
        self.assertEqual(run.returncode, 1, more)
        self.assertTrue(json.loads(output)["cut_short"])

    def test_a_second_interrupt_ends_at_once(self):
        run, _ = self.interrupted_in_the_search()
        run.send_signal(signal.SIGINT)
        output, more = run.communicate(timeout=120)
        self.assertIn(run.returncode, (1, 130), more)  # 1: the search had ended with its best design before
        if run.returncode == 1:
            self.assertTrue(json.loads(output)["cut_short"])
        else:
            self.assertEqual(output, "")

    def test_wrong_time_limits(self):
        for limit, words in (("10 kg", "--time-limit"), ("-1", "above 0"), ("soon", "give seconds")):
            refused = trivet("optimize", POWERTRAIN, f"--time-limit={limit}")
            self.assertEqual(refused.returncode, 2)
            self.assertIn(words, refused.stderr)


if __name__ == "__main__":
    unittest.main()

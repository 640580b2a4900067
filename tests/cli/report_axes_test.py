# SPDX-License-Identifier: BSD-3-Clause
"""Logarithmic axes of amplitudes: the program's decisions agree with the rule in docs/analyses.md, computed from the printed responses."""
import json
import math
import re
import subprocess
import unittest

from report_page_test import SOURCE, TRIVET, Folder

from trivet_test import HANGS_AFTER


def least_that_matters(at, heights, round_off, dips):
    """What the curve exceeds outside its dips."""
    pieces = [(max(a, b), end - begin) for a, b, begin, end in zip(heights, heights[1:], at, at[1:])]
    pieces = sorted(piece for piece in pieces if piece[0] >= round_off)
    total, passed = sum(width for _, width in pieces), 0
    for height, width in pieces:
        passed += width
        if passed >= dips * total:
            return height
    return math.inf


def is_wide(at, curves, rule):
    largest = max(map(max, curves))
    counted = [c for c in curves if max(c) > rule["negligible"] * largest]
    least = min(least_that_matters(at, c, rule["round_off"] * largest, rule["dips"]) for c in counted)
    return largest > rule["range"] * least


class Axes(Folder):
    def decisions(self, example):
        """Of each row of charts in the report, by its rule and as stated: {(group, row): (rule, stated)}."""
        project = SOURCE / "examples" / example
        run = [TRIVET, "run", str(project), "-o", str(self.folder / "out")]
        subprocess.run(run, check=True, capture_output=True, timeout=HANGS_AFTER)
        page = (self.folder / "out/report.html").read_text()
        drawing = json.loads(re.search(r'id="drawing">(.*?)</script>', page, re.DOTALL)[1])
        done = subprocess.run(
            [TRIVET, "response", str(project), "--json"], check=True, capture_output=True, timeout=HANGS_AFTER
        )
        response = json.loads(done.stdout)
        heights = [[math.hypot(*z) for z in result["complex"]] for result in response["results"]]
        return {
            (group["name"], i): (
                is_wide(
                    response["angular_frequency"],
                    [heights[member["curve"]] for member in row],
                    drawing["amplitude_rule"],
                ),
                group["logarithmic"][i],
            )
            for group in drawing["groups"][0]
            for i, row in enumerate(group["rows"])
            if row
        }

    def test_a_chart_is_logarithmic_if_its_amplitudes_span_more_than_two_decades(self):
        seen = set()
        for example in (
            "fan/fan.toml",
            "genset/genset.toml",
            "bogie/loaded_frame.toml",
            "compressor/requirements.toml",
        ):
            found = self.decisions(example)
            self.assertEqual([place for place, (rule, stated) in found.items() if rule != stated], [], example)
            seen |= {stated for _, stated in found.values()}
        self.assertEqual(seen, {True, False})

    def test_figures_have_the_axes_of_the_charts(self):
        found = self.decisions("fan/fan.toml")
        self.assertEqual(set(stated for _, stated in found.values()), {True, False})
        figure = next((self.folder / "out/00-base").glob("01-*.svg")).read_text()
        axes = re.findall(r">((?:displacement|rotation|angle)[^<]*\[[^<]*)<", figure)
        self.assertEqual([", log" in axis for axis in axes], [stated for _, stated in found.values()], axes)


if __name__ == "__main__":
    unittest.main()

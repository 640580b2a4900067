# SPDX-License-Identifier: BSD-3-Clause
"""Sentences state lengths and forces with prefixes, as tables do; a zero has no phase; what the file says of an engine is in
the report."""
import html
import json
import re
import unittest

from trivet_test import SOURCE, InTemporaryFolder, trivet

MACHINE = """trivet = 1
[bodies.machine]
mass = 40
free = ["z"]
[elements.mount]
type = "bushing"
on = "machine"
at = [0, 0, 0]
translation = ["100 N/mm", "100 N/mm", "100 N/mm"]
damping = {loss_factor = 0.1}
"""


def words_of(page):
    """The words of a report without its scripts."""
    text = re.sub(r"<(script|style)\b.*?</\1>", "", page.read_text(), flags=re.DOTALL)
    return html.unescape(re.sub(r"\s+", " ", re.sub(r"<[^>]+>", " ", text)))


class Prefixes(InTemporaryFolder):
    def report(self, example):
        trivet("run", SOURCE / f"examples/{example}.toml", "-o", self.folder / "results")
        return words_of(self.folder / "results/report.html")

    def test_a_warning_of_a_catalogue_states_millimetres(self):
        done = trivet("check", SOURCE / "examples/pump_set/pump.toml")
        self.assertIn("deflects the mount by 10.53 mm; its limit is 10 mm", done.stdout + done.stderr)

    def test_facts_of_a_mount_in_the_report_have_prefixes(self):
        page = self.report("compressor/requirements")
        self.assertTrue("static deflection limit 2.5 mm" in page)

    def test_levels_of_a_random_excitation_have_prefixes(self):
        page = self.report("microscope/microscope")
        self.assertIsNone(re.search(r"rms \d(\.\d+)?e-\d+ m", page))

    def test_verdicts_on_a_map_have_the_prefix_of_the_limit(self):
        text = MACHINE + '[excitations.push]\ntype = "harmonic"\non = "machine"\nat = [0, 0, 0]\nforce = [0, 0, 100]\n'
        text += '[analyses.map]\nlimits = {"machine.z" = "2 mm"}\n'
        text += 'x = {parameter = "bodies.machine.mass", from = 30, to = 60}\n'
        text += 'y = {parameter = "elements.mount.scale", from = 0.5, to = 2}\n'
        done = trivet("map", self.file(text), "--points", "5", "--full")
        self.assertRegex(done.stdout, r"machine.z reaches [\d.]+ mm 0-p at [\d.]+ Hz, allowed 2 mm 0-p")

    def test_a_zero_has_no_phase(self):
        """A case in which the machine is pushed along x alone does not move along z but for round-off."""
        text = MACHINE.replace('["z"]', '["x", "z"]')
        text += '[excitations.push]\ntype = "harmonic"\non = "machine"\nat = [0, 0, 0]\nforce = [100, 0, 1e-20]\n'
        text += '[analyses]\nresponse = {band = ["1 Hz", "4 Hz"], spacing = "linear", points = 4}\n'
        rows = trivet("response", self.file(text), "--full").stdout.split("Amplitude and phase")[-1]
        self.assertRegex(rows, r"\n +1[.0]* .*\b0 +–")
        self.assertNotRegex(rows, r" 0 +-?\d+\.\d°")


class Words(InTemporaryFolder):
    def test_the_report_documents_the_engine(self):
        trivet("run", SOURCE / "examples/genset/genset.toml", "-o", self.folder / "results")
        page = words_of(self.folder / "results/report.html")
        for fact in (
            "layout inline",
            "cylinders 6",
            "spacing of the cylinders 160 mm",
            "crank radius 72 mm",
            "rod length 260 mm",
            "oscillating mass of a cylinder 3.4 kg",
            "gas torque of a cylinder 520 N m at -1.2 rad in order 1.5; ",
        ):
            self.assertTrue(fact in page, fact)

    def test_data_of_a_verdict_state_the_level_of_the_bound(self):
        text = MACHINE + '[excitations.rotor]\ntype = "unbalance"\non = "machine"\nat = [0, 0, 0]\naxis = "x"\n'
        text += "mass_eccentricity = 1e-4\n"
        text += '[requirements.limits]\n"machine.z" = {limit = "4.5 mm/s rms", band = ["10 Hz", "20 Hz"]}\n'
        path = self.file(text)
        (row,) = json.loads(trivet("verdict", path, "--json").stdout)["cases"][0]["requirements"]
        self.assertEqual(row["requirement"], "machine.z ≤ 6.364 mm/s 0-p in 10 … 20 Hz")
        self.assertIn("6.364 mm/s 0-p", trivet("verdict", path, "--csv").stdout)

    def test_a_limit_at_a_speed_names_the_table_for_it(self):
        orders = '[excitations.crank]\ntype = "orders"\non = "machine"\nat = [0, 0, 0]\n'
        orders += "table = [{order = 2, force = [0, 0, 10]}]\n"
        for key in ('at = ["980 rpm"]', 'speed = "980 rpm"'):
            limit = f'[requirements.limits]\n"machine.z" = {{limit = "4.5 mm/s rms", {key}}}\n'
            done = trivet("check", self.file(MACHINE + orders + limit))
            self.assertEqual(done.returncode, 2)
            self.assertIn("is in [operation.limits]", done.stderr)
        done = trivet("check", self.file(MACHINE + orders + '[requirements.limits]\n"machine.z" = "4.5 mm/s rms"\n'))
        self.assertIn("write the limits below [operation.limits]", done.stderr)

    def test_a_decimal_comma_in_a_limit_is_named(self):
        for table in ("requirements.limits", "operation.limits"):
            text = MACHINE + '[excitations.push]\ntype = "harmonic"\non = "machine"\nat = [0, 0, 0]\n'
            text += f'force = [0, 0, 100]\n[operation]\nspeeds = ["980 rpm"]\n[{table}]\n"machine.z" = "4,5 mm/s rms"\n'
            self.assertIn("write a decimal point, not a comma", trivet("check", self.file(text)).stderr)

    def test_the_inertia_of_a_part_is_about_its_own_centre(self):
        found = []
        for about in ("", 'about = "center_of_mass", ', 'about = "pole", '):
            text = MACHINE.replace(
                "mass = 40",
                "solids = [{box = [1, 1, 1], mass = 40}]\nparts = [{mass = 5, at = [1, 0, 0], inertia = {"
                + about
                + "xx = 20, yy = 20, zz = 20}}]",
            )
            text = text.replace('["z"]', '["ry"]').replace("at = [0, 0, 0]", "at = [1, 0, 0]")
            done = trivet("modes", self.file(text), "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            found.append(json.loads(done.stdout))
        self.assertEqual(found[0]["modes"], found[1]["modes"])
        self.assertNotEqual(found[0]["modes"], found[2]["modes"])


if __name__ == "__main__":
    unittest.main()

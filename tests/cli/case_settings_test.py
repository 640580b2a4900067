# SPDX-License-Identifier: BSD-3-Clause
"""Numbers of cases in --set, and new cases in the text: compared with the same changes made in the file by hand."""
import json
import tomllib
import unittest

from serving import Served
from trivet_test import SOURCE, InTemporaryFolder, result_of, trivet

COMPRESSOR = SOURCE / "examples/compressor/requirements.toml"
COLD = "element_types.foot.scale = 1.4"


def modes(file, case, *words):
    return result_of("modes", file, *(["--case", case] if case else []), *words)["modes"]


class Settings(InTemporaryFolder):
    def by_hand(self, old, new):
        text = COMPRESSOR.read_text()
        self.assertEqual(text.count(old), 1)
        return self.file(text.replace(old, new))

    def test_a_setting_changes_one_case_alone(self):
        setting = ["--set", "cases.cold.element_types.foot.scale=1.7"]
        file = self.by_hand(COLD, "element_types.foot.scale = 1.7")
        for case in ("", "cold", "stiffer"):
            self.assertEqual(modes(COMPRESSOR, case, *setting), modes(file, case), case)
        self.assertNotEqual(modes(file, "cold"), modes(COMPRESSOR, "cold"))
        self.assertEqual(modes(file, ""), modes(COMPRESSOR, ""))

    def test_a_number_that_the_case_does_not_have_yet(self):
        file = self.by_hand(COLD, COLD + '\nbodies.compressor.mass = "300 kg"')
        setting = ["--set", "cases.cold.bodies.compressor.mass=300 kg"]
        self.assertEqual(modes(COMPRESSOR, "cold", *setting), modes(file, "cold"))
        self.assertEqual(modes(COMPRESSOR, "", *setting), modes(COMPRESSOR, ""))

    def test_a_component_of_a_vector_of_a_case(self):
        tilted = self.by_hand(COLD, COLD + '\ngravity = ["1 g", 0, "-1 g"]')
        found = result_of("static", tilted, "--case", "cold", "--set", "cases.cold.gravity.x=2 g")
        edited = self.by_hand(COLD, COLD + '\ngravity = ["2 g", 0, "-1 g"]')
        self.assertEqual(found, result_of("static", edited, "--case", "cold"))

    def test_together_with_a_setting_of_all_cases(self):
        settings = ["--set", "cases.cold.element_types.foot.scale=1.7", "--set", "bodies.compressor.mass=300 kg"]
        file = self.by_hand(COLD, "element_types.foot.scale = 1.7")
        self.assertEqual(modes(COMPRESSOR, "cold", *settings), modes(file, "cold", *settings[2:]))

    def test_a_setting_of_a_case_over_one_of_all(self):
        base, own = "element_types.foot.scale=1.2", "cases.cold.element_types.foot.scale=1.4"
        self.assertIn('also replaces that of case "cold"', trivet("check", COMPRESSOR, "--set", base).stderr)
        for settings in (["--set", base, "--set", own], ["--set", own, "--set", base]):
            self.assertEqual(modes(COMPRESSOR, "cold", *settings), modes(COMPRESSOR, "cold"))
            self.assertEqual(modes(COMPRESSOR, "", *settings), modes(COMPRESSOR, "", "--set", base))
            self.assertNotIn("also replaces", trivet("check", COMPRESSOR, *settings).stderr)

    def test_what_is_no_number_of_a_case(self):
        for setting, words in (
            ("cases.hot.element_types.foot.scale=2", "cases.hot: no such case"),
            ("cases.cool.element_types.foot.scale=2", "known: cold, stiffer"),
            ("cases.cold=2", "cases.cold: cannot be changed as a whole"),
            ("cases=2", "cases: cannot be changed as a whole"),
            ("cases.cold.elements.nobody.scale=2", "the model has no such key or part"),
            ("cases.cold.cases.cold.gravity=2", "cannot be changed"),
        ):
            done = trivet("modes", COMPRESSOR, "--set", setting)
            self.assertEqual(done.returncode, 2, setting)
            self.assertIn(words, done.stderr)
            self.assertEqual(done.stderr.count("error:"), 1, done.stderr)
        twice = ["--set", "cases.cold.element_types.foot.scale=2", "--set", "cases.cold.element_types.foot.scale=3"]
        self.assertIn("two settings of one number", trivet("modes", COMPRESSOR, *twice).stderr)


class Texts(Served):
    def test_a_setting_of_a_case_is_written_where_it_is(self):
        server = self.serve(COMPRESSOR)
        settings = ["cases.cold.element_types.foot.scale = 1.7"]
        text = server.data("POST", "/text", {"settings": settings})["text"]
        self.assertEqual(text, COMPRESSOR.read_text().replace(COLD, "element_types.foot.scale = 1.7"))
        settings = ["cases.cold.bodies.compressor.mass = 300"]
        text = server.data("POST", "/text", {"settings": settings})["text"]
        self.assertEqual(text, COMPRESSOR.read_text().replace(COLD, COLD + "\nbodies.compressor.mass = 300"))
        # A setting of the base model that a case replaces cannot be written, one of the case can.
        server.data("POST", "/text", {"settings": ["element_types.foot.scale = 2"]}, status=422)

    def test_a_new_case_has_the_changes_of_another_and_of_the_settings(self):
        server = self.serve(COMPRESSOR)
        before = COMPRESSOR.read_text()
        settings = ['bodies.compressor.mass = "300 kg"', "element_types.foot.scale = 1.5"]
        question = {"settings": settings, "case": "cold", "new_case": "cold and \"heavy\""}
        text = server.data("POST", "/text", question)["text"]
        self.assertTrue(text.startswith(before))
        cases = tomllib.loads(text)["cases"]
        self.assertEqual(
            cases.pop('cold and "heavy"'),
            {"element_types": {"foot": {"scale": 1.5}}, "bodies": {"compressor": {"mass": "300 kg"}}},
        )
        self.assertEqual(cases, tomllib.loads(before)["cases"])
        file = self.file(text)
        words = ["--set", settings[0], "--set", settings[1]]
        self.assertEqual(modes(file, 'cold and "heavy"'), modes(COMPRESSOR, "cold", *words))
        self.assertEqual(modes(file, "cold"), modes(COMPRESSOR, "cold"))

    def test_new_cases_of_other_files(self):
        for name, like in (
            ("genset/genset.toml", ""),  # has no cases
            ("genset/load_cases.toml", "list, trim and torque"),
            ("hydromount/engine.toml", "rough road"),  # a table with a header of its own
            ("microscope/microscope.toml", "on rubber feet"),  # a table in braces
            ("frame/frame.toml", "thin profile"),
        ):
            source = SOURCE / "examples" / name
            server = self.serve(source)
            text = server.data("POST", "/text", {"case": like, "new_case": "copy"})["text"]
            cases = tomllib.loads(text)["cases"]
            self.assertEqual(cases["copy"], cases.get(like, {}), name)
            found = server.data("POST", "/ask", {"text": text, "case": "copy", "wants": [{"command": "modes"}]})
            known = server.data("POST", "/ask", {"case": like, "wants": [{"command": "modes"}]})
            self.assertEqual(found["results"][0]["json"]["modes"], known["results"][0]["json"]["modes"], name)
        self.assertIn(
            "damping = {loss_factor = 0.1}", server_text(self, "microscope/microscope.toml", "on rubber feet")
        )

    def test_a_line_end_of_windows_stays(self):
        text = COMPRESSOR.read_text().replace("\n", "\r\n")
        server = self.serve(COMPRESSOR)
        added = server.data("POST", "/text", {"text": text, "case": "cold", "new_case": "x"})["text"]
        self.assertEqual(added, text + "\r\n[cases.x]\r\nelement_types.foot.scale = 1.4\r\n")

    def test_what_gives_no_new_case(self):
        server = self.serve(COMPRESSOR)
        in_braces = COMPRESSOR.read_text().split("[cases.cold]")[0]
        in_braces = in_braces.replace("trivet = 1\n", "trivet = 1\ncases = {cold = {gravity = [0, 0, 0]}}\n", 1)
        for question, words in (
            ({"new_case": "cold"}, "a new case needs a name"),
            ({"new_case": ""}, "a new case needs a name"),
            ({"new_case": "x", "case": "cool"}, "no such case"),
            ({"new_case": "x", "settings": ["cases.cool.gravity = 1"]}, "no such case"),
            ({"new_case": "x", "text": "trivet = "}, "value"),
            ({"new_case": "x", "text": in_braces}, "the case cannot be written"),
        ):
            found = server.data("POST", "/text", question, status=422)
            self.assertIn(words, json.dumps(found["problems"]), question)
        server.data("POST", "/text", {"new_case": 1}, status=400)


def server_text(test, name, like):
    server = test.serve(SOURCE / "examples" / name)
    return server.data("POST", "/text", {"case": like, "new_case": "copy"})["text"]


if __name__ == "__main__":
    unittest.main()

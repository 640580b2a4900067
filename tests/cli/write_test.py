# SPDX-License-Identifier: BSD-3-Clause
"""--write of `trivet optimize` and `trivet select`: the project file again with other numbers."""
import difflib
import json
import os
import re
import shutil
import tomllib
import unittest

from trivet_test import SOURCE, InTemporaryFolder, trivet

# Fifteen digits are written.
WRITTEN = 1e-14
# Of the largest eigenvalue: six coordinates, differences of stiffnesses.
SAME = 1e-12

HEAD = """trivet = 1   # format
gravity = [0, 0, -9.80665]

# The machine, weighed on 3 May.
[bodies.m]
mass = 40  # kg
free = ["z"]
"""
SAG = 'requirements = {static = {"m.z" = "5 mm"}, natural_frequencies = {avoid = [["12 Hz", "80 Hz"]]}}\n'
SPRING = """[elements.s]
type = "bushing"
on = "m"
at = [0, 0, 0]
translation = [1, 1, 1e5]   # rig, 2019
"""
SCALE = '[parameters.p]\npath = "elements.s.scale"\nfrom = 0.2\nto = 4\n'
OPTIMIZE = "[analyses.optimize]\nstarts = 2\n"


def inserted(text, key):
    return key + "\n" + text


class Write(InTemporaryFolder):
    def written(self, text, *more):
        """The text after --write; its system is that of the optimum."""
        project, target = self.file(text), self.folder / "best.toml"
        done = trivet("optimize", project, "--write", target, "--json", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["best.toml", "project.toml"])
        self.same_system(project, target, json.loads(done.stdout)["parameters"], *more)
        return target.read_text()

    def same_system(self, project, target, parameters, *more):
        for p in parameters:
            for place in p["places"]:
                value = repr(p["optimum"] * place["factor"])
                more += (
                    "--set",
                    f'{place["path"]} = ' + (f'"{value} {p["unit"]}"' if p["unit"] not in ("", "1") else value),
                )
        of_settings, of_file = trivet("modes", project, "--json", *more), trivet("modes", target, "--json")
        self.assertEqual((of_settings.returncode, of_file.returncode), (0, 0), of_settings.stderr + of_file.stderr)
        one, other = ([m["eigenvalue_squared"] for m in json.loads(o.stdout)["modes"]] for o in (of_settings, of_file))
        self.assertEqual(len(one), len(other))
        for a, b in zip(one, other):
            self.assertLessEqual(abs(a - b), SAME * max(one))

    def changes(self, before, after):
        lines = difflib.ndiff(before.splitlines(), after.splitlines())
        return [line for line in lines if line[:2] in ("- ", "+ ")]

    def test_number_with_a_unit_keeps_its_unit_and_its_comment(self):
        text = HEAD + SPRING.replace("1e5]", '"100  N/mm"]') + OPTIMIZE
        text = inserted(text, SAG).replace(
            "[analyses", '[parameters.p]\npath = "elements.s.translation.z"\nfrom = 2e4\nto = 3e5\n[analyses'
        )
        before, after = self.changes(text, self.written(text))
        self.assertRegex(after, r'^\+ translation = \[1, 1, "[\d.]+  N/mm"\]   # rig, 2019$')
        self.assertIn("100  N/mm", before)

    def test_missing_scale_is_added_to_its_element(self):
        text = inserted(HEAD + SPRING + "\n# parameters\n" + SCALE + OPTIMIZE, SAG)
        after = self.written(text)
        [added] = self.changes(text, after)
        self.assertRegex(added, r"^\+ scale = [\d.]+$")
        self.assertIn("# rig, 2019\nscale = ", after)

    def test_windows_line_ends_and_no_last_line_end_stay(self):
        text = inserted(HEAD + SCALE + OPTIMIZE + SPRING.rstrip("\n"), SAG).replace("\n", "\r\n")
        project, target = self.folder / "project.toml", self.folder / "best.toml"
        project.write_bytes(text.encode())
        self.assertEqual(trivet("optimize", project, "--write", target).returncode, 0)
        after = target.read_bytes().decode()
        self.assertRegex(after, r"# rig, 2019\r\nscale = [\d.]+\r\n$")
        self.assertTrue(after.startswith(text))

    def test_every_form_of_a_table(self):
        row = '{name = "s", type = "bushing", on = "m", at.x = 0, at.y = 0, at.z = 0, translation = [1, 1, 1e5] }'
        plain = [line for line in SPRING.splitlines() if " = " in line]
        for name, element, added in (
            ("inline", "[elements]\ns = {" + ", ".join(l.split("   #")[0] for l in plain) + "}\n", ", scale = "),
            ("row", f"[tables.elements]\nrows = [\n  {row},  # the only one\n]\n", "1e5], scale = "),
            (
                "repeated",
                '[[tables.elements.rows]]\nname = "s"\n' + "\n".join(plain) + "\n[[tables.elements.rows]]\n"
                'name = "t"\ntype = "bushing"\non = "m"\nat = [0, 0, 0]\ntranslation = [1, 1, 1]\n',
                "2019\nscale = ",
            ),
            ("dotted", "[elements]\n" + "\n".join("  s." + line for line in plain) + "\n", "2019\n  s.scale = "),
            ("dotted header", "[ elements . \"s\" ]\n" + "\n".join(plain) + "\n", "2019\nscale = "),
        ):
            with self.subTest(form=name):
                text = inserted(HEAD + element + SCALE + OPTIMIZE, SAG)
                after = self.written(text)
                self.assertIn(added, after)
                self.assertEqual(re.sub(r"(, |\n( *s\.)?)scale = [\d.]+", "", after), text)

    def test_type_of_elements_and_changed_default(self):
        text = HEAD + "[element_types.t]\ntype = \"bushing\"\ntranslation = [1, 1, 1e5]\n"
        text += '[elements.s]\ntype = "t"\non = "m"\nat = [0, 0, 0]\n'
        after = self.written(inserted(text + SCALE.replace("elements.s", "element_types.t") + OPTIMIZE, SAG))
        self.assertRegex(after, r"1e5\]\nscale = [\d.]+\n\[elements")
        factor = SCALE.replace("scale", "stiffness_factor.z")
        after = self.written(inserted(text + factor + OPTIMIZE, SAG))
        self.assertRegex(after, r"at = \[0, 0, 0\]\nstiffness_factor\.z = [\d.]+\n\[param")
        given = text + "stiffness_factor = {x = 2}\n"
        self.assertRegex(self.written(inserted(given + factor + OPTIMIZE, SAG)), r"\{x = 2, z = [\d.]+\}")
        given = text + "stiffness_factor.x = 2\n"
        self.assertRegex(
            self.written(inserted(given + factor + OPTIMIZE, SAG)), r"x = 2\nstiffness_factor.z = [\d.]+\n"
        )
        given = text + "[elements.s.stiffness_factor] # x only\nx = 2\n"
        self.assertRegex(self.written(inserted(given + factor + OPTIMIZE, SAG)), r"x only\nx = 2\nz = [\d.]+\n")

    def test_places_with_factors(self):
        text = HEAD.replace('free = ["z"]', 'free = ["z", "rx"]\ninertia = {about = "pole", xx = 3, yy = 3, zz = 3}')
        foot = '[elements.{0}]\ntype = "bushing"\non = "m"\nat = [0, {1}, 0]\ntranslation = [1, 1, 5e4]\n'
        text += foot.format("left", '"200 mm"') + foot.format('"right one"', -0.2)
        text += "[parameters.spread]\npath = {'elements.left.at.y' = 1, 'elements.\"right one\".at.y' = -1}\n"
        text += 'from = "400 mm"\nto = "600 mm"\n[requirements]\nnatural_frequencies = {separation = 1.2}\n'
        after = self.written(text + OPTIMIZE)
        found = tomllib.loads(after)["elements"]
        self.assertEqual(found["left"]["at"][1], "600 mm")
        self.assertAlmostEqual(found["right one"]["at"][1], -0.6, delta=WRITTEN)
        self.assertEqual(len(self.changes(text + OPTIMIZE, after)), 4)

    def test_place_that_is_zero_by_default(self):
        text = HEAD + SPRING + '[parameters.p]\npath = "bodies.m.center_of_mass.z"\nfrom = "1 mm"\nto = "2 mm"\n'
        after = self.written(inserted(text + OPTIMIZE, SAG))
        self.assertRegex(after, r'free = \["z"\]\ncenter_of_mass = \[0, 0, "[\d.]+ mm"\]\n')

    def test_settings_are_written_too(self):
        text = inserted(HEAD + SPRING + SCALE + OPTIMIZE, SAG)
        after = self.written(text, "--set", "bodies.m.mass=35 kg", "--set", "elements.s.at=[0,0,0.1]")
        self.assertIn("mass = 35  # kg\n", after)
        self.assertIn("at = [0, 0, 0.1]\n", after)
        # A case that sets the same number would override it.
        project = self.file(text + "[cases.heavy]\nbodies.m.mass = 80\n")
        done = trivet("optimize", project, "--set", "bodies.m.mass=35", "--write", self.folder / "b.toml")
        self.assertEqual(done.returncode, 2)
        self.assertIn("cases.heavy", done.stderr)
        self.assertFalse((self.folder / "b.toml").exists())

    def test_number_in_another_file_is_refused(self):
        (self.folder / "mounts.csv").write_text("name,type,on,at.x,at.y,at.z,scale\ns,t,m,0,0,0,1\n")
        text = HEAD + '[element_types.t]\ntype = "bushing"\ntranslation = [1, 1, 1e5]\n'
        text += '[tables.elements]\nfile = "mounts.csv"\n'
        project = self.file(inserted(text + SCALE + OPTIMIZE, SAG))
        done = trivet("optimize", project, "--write", self.folder / "best.toml")
        self.assertEqual(done.returncode, 2)
        self.assertIn("mounts.csv:2: error: elements.s.scale", done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertFalse((self.folder / "best.toml").exists())
        # A number of the project file is written, and its table is still found only from the same folder.
        project = self.file(inserted(text + SCALE.replace("elements.s", "element_types.t") + OPTIMIZE, SAG))
        self.assertEqual(trivet("optimize", project, "--write", self.folder / "best.toml").returncode, 0)
        self.assertEqual(trivet("check", self.folder / "best.toml").returncode, 0)
        (self.folder / "other").mkdir()
        done = trivet("optimize", project, "--write", self.folder / "other/best.toml")
        self.assertEqual(done.returncode, 2)
        self.assertIn('tables.elements.file: "mounts.csv"', done.stderr)
        self.assertEqual(os.listdir(self.folder / "other"), [])

    def test_only_project_files_are_replaced(self):
        project = self.file(inserted(HEAD + SPRING + SCALE + OPTIMIZE, SAG))
        notes = self.file("years of work", "notes.toml")
        (self.folder / "link.toml").symlink_to(notes)
        for target, words in (
            (notes, "is not a project file"),
            (self.folder / "link.toml", "symbolic link"),
            (self.folder, "this is a folder"),
            (self.folder / "none/best.toml", "there is no folder"),
        ):
            done = trivet("optimize", project, "--write", target)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(words, done.stderr)
        self.assertEqual(notes.read_text(), "years of work")
        self.assertEqual(trivet("optimize", project, "--write", "").returncode, 2)
        # The project itself, if it is named; a second search then starts from the optimum.
        before = project.read_text()
        done = trivet("optimize", project, "--write", project)
        self.assertEqual(done.returncode, 0)
        self.assertIn(f"Written: {project}", done.stdout)
        after = project.read_text()
        self.assertRegex("".join(self.changes(before, after)), r"^\+ scale = [\d.]+$")
        self.assertEqual(trivet("optimize", project, "--write", self.folder / "again.toml").returncode, 0)
        self.assertEqual(trivet("optimize", project, "--write", self.folder / "again.toml").returncode, 0)

    def test_all_examples_with_a_parameter(self):
        """A parameter for one number of every element and body of every example."""
        checked, unchecked = 0, []
        shutil.copytree(SOURCE / "examples", self.folder / "examples")
        for example in sorted((self.folder / "examples").glob("*/*.toml")):
            text = example.read_text()
            model = tomllib.loads(text)
            if "parameters" in model or "requirements" in model or "optimize" in model.get("analyses", {}):
                continue
            paths = [f'elements."{name}".scale' for name in list(model.get("elements", {}))[:2]]
            paths += [f'bodies."{name}".center_of_mass.y' for name in list(model.get("bodies", {}))[:1]]
            with self.subTest(example=example.name):
                more = "\n"
                for i, path in enumerate(paths):
                    low, high = ("1.25", "1.5") if path.endswith("scale") else ('"1 mm"', '"2 mm"')
                    more += f"[parameters.p{i}]\npath = '{path}'\nfrom = {low}\nto = {high}\n"
                more += "[requirements]\nnatural_frequencies = {avoid = [[1, 2]]}\n[analyses.optimize]\nstarts = 1\n"
                project, target = example.with_name("given.toml"), example.with_name("best.toml")
                target.unlink(True)
                project.write_text(text + more)
                done = trivet("optimize", project, "--write", target, "--json")
                if done.returncode:
                    self.assertIn("error", done.stderr)
                    self.assertNotIn("cannot be written into its text", done.stderr)
                    self.assertFalse(target.exists())
                    unchecked.append(example.name + ": " + done.stderr.splitlines()[-1])
                    continue
                checked += 1
                self.same_system(project, target, json.loads(done.stdout)["parameters"])
                for line in self.changes(project.read_text(), target.read_text()):
                    self.assertRegex(line, r"^[-+] .*(scale|center_of_mass)")
        self.assertGreaterEqual(checked, 10, unchecked)


class WriteMounts(InTemporaryFolder):
    def test_first_choice_is_written(self):
        shutil.copytree(SOURCE / "examples/genset", self.folder / "genset")
        example, target = self.folder / "genset/mounts.toml", self.folder / "genset/best.toml"
        done = trivet("select", example, "--write", target)
        self.assertEqual(done.returncode, 0, done.stderr)
        best = json.loads(trivet("select", example, "--json").stdout)["best"][0]
        model, given = tomllib.loads(target.read_text()), tomllib.loads(example.read_text())
        for name, mount in best["mounts"].items():
            paths = given["parameters"][name]["path"]
            for path in [paths] if isinstance(paths, str) else paths:
                table, part, _ = re.match(r'(\w+)\."?([^".]+)"?\.(type)', path).groups()
                self.assertEqual(model[table][part]["type"], "catalogue:" + mount)
        again = json.loads(trivet("select", target, "--json").stdout)["given"]
        self.assertAlmostEqual(again["margin"], best["margin"], delta=1e-12)
        self.assertEqual(again["governing"], best["governing"])


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: BSD-3-Clause
"""Generated pages of the site: the page of keys has every key of the schema, with its unit and default; the page of facts
finds the tests."""
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
sys.path.insert(0, str(SOURCE / "docs/site"))
import facts  # noqa: E402
import keys  # noqa: E402
import python_reference  # noqa: E402

SCHEMA = json.loads(subprocess.run([os.environ["TRIVET"], "schema"], capture_output=True, text=True, check=True).stdout)


def names_of(value):
    """Every key that a schema has anywhere; `false` forbids a key."""
    if isinstance(value, list):
        return set().union(*map(names_of, value))
    if not isinstance(value, dict):
        return set()
    properties = value.get("properties")
    own = {name for name, one in properties.items() if one is not False} if isinstance(properties, dict) else set()
    return own.union(*(names_of(one) for one in value.values()))


def undescribed(value, place=""):
    """Places of keys that say nothing of their own. A key whose value is fixed, such as a type, needs none."""
    if isinstance(value, list):
        return [found for i, one in enumerate(value) for found in undescribed(one, f"{place}[{i}]")]
    if not isinstance(value, dict):
        return []
    properties = value.get("properties")
    missing = []
    for key, one in (properties if isinstance(properties, dict) else {}).items():
        if one is False or key == "accept" or "const" in one or "pattern" in one:
            continue
        reference = one.get("$ref", "")
        own = one if reference == "#/$defs/number" else keys.Keys(SCHEMA).resolved(one)
        if not own.get("description"):
            missing.append(f"{place}.{key}")
    return missing + [found for key, one in value.items() for found in undescribed(one, f"{place}.{key}")]


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = keys.page(SCHEMA)
        cls.rows = [re.split(r"(?<!\\) ?\| ?", line)[1:-1] for line in cls.page.splitlines() if line.startswith("| `")]

    def test_every_key_of_the_schema_has_a_row(self):
        shown = {part for row in self.rows for part in re.split(r"[.\[\]…]+", row[0].strip("`"))}
        shown |= {part for line in self.page.splitlines() if line.startswith("#") for part in re.findall(r"\w+", line)}
        without_laws = {key: value for key, value in SCHEMA.items() if key != "$defs"}
        used = {key: value for key, value in SCHEMA["$defs"].items() if key != "shared_keys"}
        self.assertEqual(names_of([without_laws, used]) - shown - {"accept"}, set())

    def test_every_key_is_described(self):
        self.assertEqual(undescribed(SCHEMA), [])
        self.assertEqual([row for row in self.rows if not row[-1].strip(" |")], [])

    def test_rows_have_units_and_defaults(self):
        for expected in (
            ["`mass`", "number", "kg"],
            ["`gravity`", "three numbers", "m/s²"],
            ["`translation`", "three numbers", "N/m", "required"],
            ["`exponent`", "number", "", "1.4"],
            ["`track.inertance`", "number", "Pa s²/m³", "required"],
            ["`form`", "`full`, `short`", "", "full"],
        ):
            found = [row for row in self.rows if row[: len(expected)] == expected]
            self.assertTrue(found, f"{expected}: {[row for row in self.rows if row[0] == expected[0]]}")

    def test_links_to_sections_of_the_page_exist(self):
        sections = set(re.findall(r"\{#([\w-]+)\}", self.page))
        self.assertEqual({one for one in re.findall(r"\]\(#([\w-]+)\)", self.page)} - sections, set())

    def test_facts_are_sentences(self):
        self.assertEqual(facts.sentence("CoilSpring", "IsSoftAlongAB"), "coil spring is soft along AB")
        page, places = facts.page(SOURCE / "tests")
        self.assertEqual(places["agreement/peaks_test"], "agreement-peaks_test")
        self.assertGreater(page.count("\n- "), 500)

    def test_python_reference_has_methods_with_their_text(self):
        page = python_reference.page(SOURCE / "bindings/python/trivet", SCHEMA)
        self.assertRegex(page, r"\| `response\(of=….*\) → Result` \| Keys: ")
        self.assertIn("| `mass → float` | [kg] |", page)
        self.assertRegex(page, r"\| `changed\(changes: .*\) → Project` \| \w+")


if __name__ == "__main__":
    unittest.main()

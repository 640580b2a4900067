# SPDX-License-Identifier: BSD-3-Clause
"""The page of facts that the tests of validation and agreement check: names of tests are sentences."""

import re

KINDS = {
    "validation": "compared with closed forms, publications and other programs",
    "agreement": "compared with a second, independent method of our own",
}
HEAD = """# What the tests check

Each test states one fact; these are their names, by file. References and tolerances: [validation.md](validation.md).
"""


def anchor(kind, stem):
    return f"{kind}-{stem}"


def sentence(suite, name):
    """The words of a test: CoilSpring, IsSoftAlongItsAxis → coil spring is soft along its axis."""
    words = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", f"{suite} {name}").split()
    lower = [word if len(word) > 1 and word.isupper() else word.lower() for word in words]
    return " ".join(lower)


def page(tests):
    """The page in Markdown, and the anchor of each file by its name. @param tests  the folder of the tests"""
    lines, places = [HEAD], {}
    for kind, about in KINDS.items():
        lines += [f"## {kind.capitalize()}: {about}", ""]
        for path in sorted((tests / kind).glob("*_test.cpp")):
            found = re.findall(
                r"^(?:TEST|TEST_P|TEST_F|RC_GTEST_PROP)\((\w+),\s*(\w+)", path.read_text("utf-8"), re.MULTILINE
            )
            if not found:
                continue
            places[path.stem] = places[f"{kind}/{path.stem}"] = anchor(kind, path.stem)
            lines += [f"### {path.stem} {{#{anchor(kind, path.stem)}}}", ""]
            lines += [f"- {sentence(suite, name)}" for suite, name in found] + [""]
    return "\n".join(lines), places

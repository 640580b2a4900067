# SPDX-License-Identifier: BSD-3-Clause
"""Hook of MkDocs (mkdocs.yml): adds the generated pages and the documents outside docs/, and directs links to them."""

import json
import logging
import os
import pathlib
import posixpath
import re
import subprocess
import sys

from mkdocs.structure.files import File

sys.path.insert(0, os.path.dirname(__file__))
import facts  # noqa: E402
import keys  # noqa: E402
import python_reference  # noqa: E402

log = logging.getLogger("mkdocs.hooks.pages")
ROOT = pathlib.Path(__file__).resolve().parents[2]
OUTSIDE = {  # documents that are not in docs/, or have another name here: place in the tree and on the site
    "README.md": "index.md",
    "docs/README.md": "documents.md",
    "ARCHITECTURE.md": "architecture.md",
    "CONTRIBUTING.md": "contributing.md",
    "CHANGELOG.md": "changelog.md",
    "benchmarks/README.md": "benchmarks.md",
}
LANGUAGES = {".toml": "toml", ".csv": "csv", ".py": "python", ".cpp": "cpp", ".txt": "cmake"}
pages = {}  # of each place in the tree, its place on the site


def trivet(*arguments):
    """What the program prints."""
    program = os.environ.get("TRIVET", ROOT / "build/release/apps/cli/trivet")
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=True, timeout=60).stdout


def command_line():
    """The help of every command."""
    lines = [
        "# Commands",
        "",
        "What `trivet help` prints. Which analysis for which question: [table](commands.md).",
        "",
    ]
    lines += ["```text", trivet("--help").rstrip(), "```", ""]
    for name in re.findall(r"(?m)^  (\w+) {2,}\S", lines[-3]):
        text = re.sub(r"Usage: \S*trivet ", "Usage: trivet ", trivet(name, "--help"))
        lines += [f"## trivet {name} {{#{name}}}", "", "```text", text.strip(), "```", ""]
    return "\n".join(re.sub(r"^Usage: \S*trivet ", "Usage: trivet ", line, flags=re.MULTILINE) for line in lines)


def examples():
    """Each example with its files, as a page."""
    for folder in sorted(path for path in (ROOT / "examples").iterdir() if path.is_dir()):
        lines = [f"# {folder.name}", ""]
        for path in sorted(path for path in folder.rglob("*") if path.suffix in LANGUAGES):
            name = path.relative_to(ROOT).as_posix()
            pages[name] = f"examples/{folder.name}.md"
            shown = path.read_text(encoding="utf-8").splitlines()
            rest = [f"… {len(shown) - 400} further lines"] if len(shown) > 400 else []
            lines += [f"## {name}", "", f"````{LANGUAGES[path.suffix]}", *shown[:400], *rest, "````", ""]
        yield f"examples/{folder.name}.md", "\n".join(lines)


def on_config(config):
    """Puts all decisions into the menu."""
    developers = next(group["Developers"] for group in config.nav if "Developers" in group)
    decisions = next(entry for entry in developers if isinstance(entry, dict) and "Decisions" in entry)
    decisions["Decisions"] = sorted(f"decisions/{path.name}" for path in (ROOT / "docs/decisions").glob("*.md"))
    return config


def on_files(files, config):
    """Adds what is generated, and documents of other folders."""
    pages.clear()
    for file in list(files.documentation_pages()):
        pages[f"docs/{file.src_uri}"] = file.src_uri
    schema = json.loads(trivet("schema"))
    tests, pages["tests"] = facts.page(ROOT / "tests")
    generated = {
        "keys.md": keys.page(schema),
        "command-line.md": command_line(),
        "python-reference.md": python_reference.page(ROOT / "bindings/python/trivet", schema),
        "tests.md": tests,
        **dict(examples()),
    }
    for place, text in generated.items():
        files.append(File.generated(config, place, content=text))
    for place, name in OUTSIDE.items():
        if old := files.get_file_from_path(place.removeprefix("docs/")):
            files.remove(old)
        files.append(File.generated(config, name, content=(ROOT / place).read_text(encoding="utf-8")))
        pages[place] = name
    return files


def on_page_markdown(markdown, page, config, files):
    """Directs links to the pages of the site, and links examples and tests."""
    place = next((tree for tree, name in pages.items() if name == page.file.src_uri), f"docs/{page.file.src_uri}")
    parts = re.split(r"(?ms)^(`{3,}.*?^`{3,}[ ]*$)", markdown)
    parts[::2] = [prose(text, place, page.file.src_uri) for text in parts[::2]]
    return "".join(parts)


def prose(text, place, name):
    """Markdown outside blocks of code, as MkDocs reads it. @param place  of its document in the tree; name  on the site"""
    folder = posixpath.dirname(name)

    def to(target, anchor=""):
        return posixpath.relpath(target, folder or ".") + anchor

    def link(found):
        target, mark, anchor = found[1].partition("#")
        if not target or ":" in target:
            return found[0]
        there = posixpath.normpath(posixpath.join(posixpath.dirname(place), target))
        if there in pages:
            return f"]({to(pages[there], mark + anchor)})"
        if there.startswith("docs/"):
            return f"]({to(there.removeprefix('docs/'), mark + anchor)})"
        log.warning(f"{place}: {target} is no page of the site")
        return found[0]

    def example(found):
        there = pages.get(found[1])
        return f"[{found[0]}]({to(there, '#' + slug(found[1]))})" if there else found[0]

    def test(found):
        return (
            f"[{found[0]}]({to('tests.md', '#' + pages['tests'][found[1]])})"
            if found[1] in pages["tests"]
            else found[0]
        )

    text = re.sub(r'@ref trivet::(\w+) "\w+"', r"`\1`", text)  # of Doxygen, docs/api.md
    text = re.sub(r"\]\(([^)\s]+)\)", link, text)
    if not name.startswith("examples/"):
        text = re.sub(r"(?<!\[)`(examples/[\w/.]+\.\w+)`", example, text)
    if name == "validation.md":
        text = re.sub(r"`((?:validation/|agreement/)?\w+_test)`", test, text)
    # A list directly below a paragraph, and lists in lists by two or three blanks, as on other readers of Markdown.
    text = re.sub(r"(?m)^(?!\s*(?:[-*]|\d+\.) |\||#|\s)(.+)\n(?=(?:[-*]|\d+\.) )", r"\1\n\n", text)
    return re.sub(r"(?m)^ {2,3}(?=[-*] )", "    ", text)


def slug(text):
    """The anchor of a heading: as those who host Markdown make it, so that links are the same there and here."""
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


def slugify(text, separator):
    """The same, for MkDocs."""
    return slug(text)

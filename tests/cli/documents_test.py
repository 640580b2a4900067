# SPDX-License-Identifier: BSD-3-Clause
"""The commands, project files, options and links in README, docs and the other documents are right: commands are run as
printed, project files are checked, and what tutorials print is compared with the program. Each failure names the document
and the line.

    documents_test.py --update    writes what the program prints now into tutorials and recipes (document_steps.py)"""
import dataclasses
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest

import document_steps
from document_fragments import BASES, COARSER, FILES, NOT_A_PROJECT, OUTPUTS, STARTER

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
SOURCE = pathlib.Path(os.environ["TRIVET_SOURCE"])
DOCUMENTS = [SOURCE / name for name in ("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "benchmarks/README.md")]
DOCUMENTS += sorted(path for folder in ("docs", "examples") for path in (SOURCE / folder).rglob("*.md"))
STEPWISE = [path for path in DOCUMENTS if path.parent.name == "tutorials" or path.name == "recipes.md"]
STEPWISE += [SOURCE / "README.md"]
EXAMPLES = sorted((SOURCE / "examples").glob("*/*.toml"))
LANGUAGES = {
    "sh": "commands",
    "toml": "project file or part of one",
    "csv": "data",
    "text": "output",
    "python": "run by tests/python/test_documents.py",
}

# Commands of the documents that this test cannot run: why not, the file in which CI runs them, and the words there.
BUILDS = "it builds for minutes or hours"
BUILT = "it needs a build of its own"
IDLE = "it needs benchmarks and an idle machine; CI compiles them"
COMPILED = "cmake --workflow --preset benchmark"
FUZZER = "build/fuzz/tests/fuzz/project_fuzzer -max_total_time=1800"
LONG_CAMPAIGN = "python3 tests/campaign/campaign.py --each 2000"
RANDOM_MACHINES = "TRIVET_LONG_TESTS=1 build/release/tests/agreement_tests --gtest_filter='RelativeCoordinates.*'"
ELSEWHERE = {
    "scripts/start": ("it installs packages and builds", ".ci/run", "scripts/start"),
    "pip install .": ("it compiles for minutes", ".ci/run", "scripts/python"),
    'pip install ".[plots,tables,units]"': ("it compiles for minutes", ".ci/run", "scripts/python"),
    'pip install ".[notebook]"': ("it compiles for minutes", ".ci/run", "scripts/python"),
    "pip install FILE.whl": ("it installs into the system", ".ci/run", "scripts/release"),
    "trivet serve pump.toml": ("it serves until it is interrupted", "tests/cli/help_examples_test.py", "serve"),
    "mpirun -n 64 trivet optimize machine.toml -o study": (
        "it needs MPI",
        "tests/cli/shared_work_test.py",
        "PMI_RANK",
    ),
    "mpirun -n 64 trivet sample machine.toml -o study": (
        "it needs MPI",
        "tests/cli/study_folder_test.py",
        "OMPI_COMM_WORLD_RANK",
    ),
    "sbatch examples/paper/robust.slurm": ("it needs Slurm", "tests/cli/study_folder_test.py", "SLURM_PROCID"),
    "scripts/web": ("it installs packages and needs Node", "scripts/page", "scripts/web --check"),
    "scripts/web --check": ("it installs packages and needs Node", "scripts/page", "scripts/web --check"),
    "scripts/test": ("it installs packages, builds and runs this test", ".ci/run", "scripts/test"),
    ".ci/run": ("it runs this test", ".ci/run", "scripts/test"),
    ".ci/run long": ("it takes hours", ".ci/run", "long_stages; exit"),
    "cmake --workflow --preset sanitize": (BUILDS, ".ci/run", "cmake --workflow --preset sanitize"),
    "cmake --workflow --preset fuzz": (BUILDS, ".ci/run", "cmake --workflow --preset fuzz"),
    "build/fuzz/tests/fuzz/project_fuzzer -dict=tests/fuzz/project.dict NEW tests/fuzz/corpus": (
        "it does not end",
        ".ci/run",
        FUZZER,
    ),
    RANDOM_MACHINES: (BUILT, ".ci/run", RANDOM_MACHINES),
    "export TRIVET=$PWD/build/release/apps/cli/trivet TRIVET_SOURCE=$PWD": (
        "for the next command",
        ".ci/run",
        "TRIVET=$PWD/build/release/apps/cli/trivet TRIVET_SOURCE=$PWD",
    ),
    "TRIVET=$PWD/build/release/apps/cli/trivet python3 tests/campaign/steady_machines.py": (
        "it takes minutes and needs SciPy",
        ".ci/run",
        "python3 tests/campaign/steady_machines.py",
    ),
    LONG_CAMPAIGN + " --keep /tmp/failed": ("it takes a quarter of an hour", ".ci/run", LONG_CAMPAIGN),
    "scripts/benchmark": (IDLE, ".ci/run", "scripts/benchmark"),
    "scripts/benchmark --write": (IDLE, ".ci/run", "scripts/benchmark"),
    "scripts/benchmark QUESTION": (IDLE, ".ci/run", "scripts/benchmark"),
    "build/release/benchmarks/many_bodies": (IDLE, ".ci/run", COMPILED),
    "build/release/benchmarks/coil_spring": (IDLE, ".ci/run", COMPILED),
    "build/release/benchmarks/rubber_mount": (IDLE, ".ci/run", COMPILED),
    "build/release/benchmarks/transient": (IDLE, ".ci/run", COMPILED),
    "build/release/benchmarks/random_response": (IDLE, ".ci/run", COMPILED),
    "build/release/benchmarks/solid_condensation": (IDLE, ".ci/run", COMPILED),
    "build/release/benchmarks/python_calls": (IDLE, ".ci/run", COMPILED),
}
COMMAND_ELSEWHERE = re.compile(r"(scripts/|pip install |\.ci/|cmake |python3 |build/\w+/(tests|benchmarks)/)")


@dataclasses.dataclass
class Block:
    document: str
    line: int  # of its first line of text
    heading: str
    language: str
    text: str

    @property
    def place(self):
        return f"{self.document}:{self.line}"


def blocks_and_prose(path):
    """Fenced blocks of a document, and its text with empty lines in place of the blocks."""
    blocks, prose, heading, fence = [], [], "", None
    for number, line in enumerate(path.read_text().splitlines(), 1):
        mark = re.match(r"(```+)(.*)$", line)
        if fence is None and mark:
            fence, block = mark[1], Block(str(path.relative_to(SOURCE)), number + 1, heading, mark[2], "")
            blocks.append(block)
        elif fence is not None and line.strip() == fence:
            fence = None
        elif fence is not None:
            block.text += line + "\n"
        else:
            title = re.match(r"#+ (.*)", line)
            heading = title[1] if title else heading
            prose.append(line)
            continue
        prose.append("")
    assert fence is None, f"{path}: a code block does not end"
    return blocks, "\n".join(prose)


READ = {path: blocks_and_prose(path) for path in DOCUMENTS}
BLOCKS = [block for blocks, _ in READ.values() for block in blocks]
STEPWISE_NAMES = {str(path.relative_to(SOURCE)) for path in STEPWISE}
SINGLE = [block for block in BLOCKS if block.document not in STEPWISE_NAMES]  # each for itself


def spans(path):
    """Inline code of a document: line, text, and the whole line for what it is about."""
    prose = READ[path][1]
    lines = prose.splitlines()
    for found in re.finditer(r"`((?:(?!\n\s*\n)[^`])+)`", prose):
        line = prose.count("\n", 0, found.start()) + 1
        yield line, " ".join(found[1].split()), lines[line - 1]


def commands_of(block):
    """Line, command and remark of each command of a block of commands."""
    for offset, line in enumerate(block.text.splitlines()):
        command, _, remark = re.sub(r"\s+#\s", "\0", line, count=1).partition("\0")
        if command.strip():
            yield block.line + offset, command.strip(), remark


def toml(value):
    """A value as TOML on one line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{toml(key)} = {toml(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value, ensure_ascii=False)


def completed(base, part, path=()):
    """A part of a project file on its base. Elements and excitations of the part replace those of the base."""
    result = dict(base)
    for key, value in part.items():
        replaced = path in (("elements",), ("excitations",)) or not isinstance(value, dict)
        result[key] = value if replaced else completed(result.get(key, {}), value, (*path, key))
    return result


class Documents(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "bin").mkdir()
        (self.folder / "bin/trivet").symlink_to(pathlib.Path(TRIVET).resolve())
        self.environment = {**os.environ, "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}"}
        self.environment.pop("COLUMNS", None)  # of the terminal of whoever runs this test

    def shell(self, command, folder):
        return subprocess.run(
            ["bash", "-c", command],
            cwd=folder,
            env=self.environment,
            capture_output=True,
            text=True,
            timeout=HANGS_AFTER,
        )

    def work_folder(self, name):
        """A folder with copies of the examples, as at the top of the source tree."""
        folder = self.folder / "work" / name.replace("/", "_")
        if not folder.exists():
            shutil.copytree(SOURCE / "examples", folder / "examples")
        return folder

    def expect_exit_code(self, place, command, remark, folder):
        stated = re.search(r"exit code (\d+)", remark)
        with self.subTest(place=place, command=command):
            done = self.shell(command, folder)
            self.assertEqual(done.returncode, int(stated[1]) if stated else 0, f"{place}: {command}\n{done.stderr}")

    def test_every_block_names_its_language(self):
        for block in BLOCKS:
            with self.subTest(place=block.place):
                self.assertIn(block.language, LANGUAGES, f"{block.place}: write one of {LANGUAGES} behind ```")
                if block.language in ("csv", "text"):
                    self.assertNotRegex(block.text, r"(?m)^\W*trivet \w", f"{block.place}: make it a block of sh")

    def followed(self, path):
        """The steps of a document with what their commands print; checks their exit codes."""
        folder = self.work_folder(str(path.relative_to(SOURCE)))
        done = document_steps.steps(READ[path][0], commands_of)
        for step in done:
            if not isinstance(step, document_steps.Step):
                self.assertTrue(document_steps.file_of(step), f"{step.place}: the first line is not `# NAME.toml`")
                document_steps.write(step, folder)
                continue
            for line, command, remark in step.commands:
                place = f"{path.relative_to(SOURCE)}:{line}"
                if command in ELSEWHERE or not command.startswith("trivet "):
                    self.assertIn(command, ELSEWHERE, f"{place}: neither of trivet nor in ELSEWHERE")
                    continue
                ran = self.shell(command, folder)
                stated = re.search(r"exit code (\d+)", remark)
                self.assertEqual(
                    ran.returncode, int(stated[1]) if stated else 0, f"{place}: {command}\n{ran.stdout}{ran.stderr}"
                )
                step.printed += ran.stderr + ran.stdout
        return [step for step in done if isinstance(step, document_steps.Step)]

    def test_tutorials_print_what_they_show(self):
        for path in STEPWISE:
            with self.subTest(document=str(path.relative_to(SOURCE))):
                for step in self.followed(path):
                    if step.output:
                        found = document_steps.difference(step.output.text, step.printed)
                        self.assertIsNone(found, f"{step.output.place}: {found}; documents_test.py --update")

    def test_outputs_of_tutorials_follow_commands(self):
        for path in STEPWISE:
            steps = document_steps.steps(READ[path][0], commands_of)
            shown = [step.output.place for step in steps if isinstance(step, document_steps.Step) and step.output]
            texts = [block.place for block in READ[path][0] if block.language == "text"]
            self.assertEqual(texts, shown, f"{path}: a block of text that follows no commands")

    def test_commands_in_blocks_run(self):
        for block in SINGLE:
            for line, command, remark in commands_of(block) if block.language == "sh" else ():
                if command.startswith("trivet "):
                    folder = self.work_folder(block.document)
                    self.expect_exit_code(f"{block.document}:{line}", command, remark, folder)
                else:
                    self.assertIn(command, ELSEWHERE, f"{block.document}:{line}: neither of trivet nor in ELSEWHERE")

    def test_commands_in_comments_of_examples_run(self):
        for example in EXAMPLES:
            for line, text in enumerate(example.read_text().splitlines(), 1):
                if command := re.match(r"#\s+(trivet .*)", text):
                    place = f"{example.relative_to(SOURCE)}:{line}"
                    self.expect_exit_code(place, command[1], "", self.work_folder("examples"))

    def test_commands_elsewhere_are_run_by_ci(self):
        for command, (reason, file, words) in ELSEWHERE.items():
            with self.subTest(command=command):
                self.assertTrue(reason)
                self.assertIn(words, (SOURCE / file).read_text(), f"{file} no longer runs {command}")

    def test_every_listed_command_is_in_a_document(self):
        written = {command for block in BLOCKS if block.language == "sh" for _, command, _ in commands_of(block)}
        written |= {text for path in DOCUMENTS for _, text, _ in spans(path)}
        self.assertEqual(set(ELSEWHERE) - written, set())

    def test_commands_and_options_in_sentences_exist(self):
        names = re.findall(r"(?m)^  (\w+) {2,}", self.shell("trivet --help", self.folder).stdout)
        self.assertGreater(len(names), 20)
        helps = {name: self.shell(f"trivet {name} --help", self.folder).stdout for name in names}
        options = {name: set(re.findall(r"(?<![\w-])--?[a-z][\w-]*", text)) for name, text in helps.items()}
        for path in DOCUMENTS:
            title = re.search(r"(?m)^# .*`trivet (\w+)", READ[path][1])
            for line, text, context in spans(path):
                place = f"{path.relative_to(SOURCE)}:{line}"
                if COMMAND_ELSEWHERE.match(text) and not (SOURCE / text).is_file() or text in ELSEWHERE:
                    self.assertIn(text, ELSEWHERE, f"{place}: `{text}` is not listed in ELSEWHERE")
                if not re.match(r"trivet \w|--?[a-z]", text) or text.startswith("trivet ="):
                    continue
                with self.subTest(place=place, command=text):
                    words = shlex.split(text)
                    if words[0] == "trivet":
                        self.assertIn(words[1], names, f"{place}: `{text}`: no such command")
                        about = words[1]
                    else:  # an option alone: of the command in its line, in the title, or of any
                        row = re.search(r"`trivet (\w+)", context)
                        about = row[1] if row else title[1] if title else None
                    known = options[about] if about in names else set().union(*options.values())
                    for option in (word for word in words if re.match(r"--?[a-z]", word)):
                        self.assertIn(option.partition("=")[0], known, f"{place}: `{text}`: no such option")
                if any(word.endswith(".toml") and (SOURCE / word).is_file() for word in words):
                    self.expect_exit_code(place, text, "", self.work_folder(str(path.relative_to(SOURCE))))

    def project(self, block):
        """Writes the project of a block, complete or on its base, with its files, and returns its path."""
        folder = self.folder / block.place.replace("/", "_")
        folder.mkdir()
        where = (block.document, block.heading)
        part = tomllib.loads(block.text.replace(*COARSER[where]) if where in COARSER else block.text)
        project = folder / "project.toml"
        if "trivet" in part:
            project.write_text(block.text)
            return project
        self.assertTrue(
            where in BASES, f"{block.place}: a part of a project file needs a base in document_fragments.py"
        )
        base = tomllib.loads(self.shell("trivet new", folder).stdout if BASES[where] is STARTER else BASES[where])
        if where in NOT_A_PROJECT:
            (folder / NOT_A_PROJECT[where]).write_text(block.text)
            part = {}
        for name, content in FILES.get(where, {}).items():
            (folder / name).parent.mkdir(exist_ok=True)
            (folder / name).write_text(content.read_text() if isinstance(content, pathlib.Path) else content)
        for other in BLOCKS:
            if other.language == "csv" and (other.document, other.heading) == where:
                (folder / re.search(r'file = "(.*?\.csv)"', block.text)[1]).write_text(other.text)
        lines = [f"{key} = {toml(value)}\n" for key, value in completed(base, part).items()]
        project.write_text("".join(lines))
        return project

    def test_project_files_pass_their_check(self):
        for block in SINGLE:
            if block.language == "toml":
                with self.subTest(place=block.place):
                    done = self.shell("trivet check project.toml", self.project(block).parent)
                    self.assertEqual(done.returncode, 0, f"{block.place}\n{done.stderr}")

    def test_every_base_belongs_to_a_block(self):
        written = {(block.document, block.heading) for block in BLOCKS if block.language == "toml"}
        self.assertEqual((set(BASES) | set(COARSER) | set(FILES) | set(NOT_A_PROJECT)) - written, set())

    def test_printed_output_is_that_of_the_program(self):
        for block in SINGLE:
            if block.language == "text":
                with self.subTest(place=block.place):
                    where = (block.document, block.heading)
                    self.assertIn(where, OUTPUTS, f"{block.place}: add the command that prints this")
                    command, old, new = OUTPUTS[where]
                    starter = self.shell("trivet new", self.folder).stdout
                    self.assertIn(old, starter)
                    (self.folder / "machine.toml").write_text(starter.replace(old, new))
                    done = self.shell(command, self.folder)
                    pieces = [" ".join(piece.split()) for piece in block.text.split("…")]
                    pattern = ".*".join(re.escape(piece) for piece in pieces)
                    self.assertRegex(" ".join((done.stdout + done.stderr).split()), pattern, block.place)

    def test_links_lead_to_files_and_headings(self):
        for path in [*DOCUMENTS, SOURCE / "CHANGELOG.md"]:
            text = path.read_text()
            for found in re.finditer(r"\]\(([^)\s]+)\)", text):
                place = f"{path.relative_to(SOURCE)}:{text.count(chr(10), 0, found.start()) + 1}"
                file, _, anchor = found[1].partition("#")
                if "://" in found[1]:
                    continue
                target = (path.parent / file).resolve() if file else path
                self.assertTrue(target.exists(), f"{place}: no file {file}")
                if anchor:
                    titles = re.findall(r"(?m)^#+ (.*)", target.read_text())
                    anchors = {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}
                    self.assertIn(anchor, anchors, f"{place}: {target.name} has no heading for #{anchor}")

    def test_examples_named_in_documents_exist(self):
        for path in DOCUMENTS:
            for line, text, _ in spans(path):
                if re.fullmatch(r"examples/[\w./]+", text):
                    self.assertTrue((SOURCE / text).exists(), f"{path.relative_to(SOURCE)}:{line}: no {text}")


def update():
    """Writes the output of the program of today into the documents. Returns 1 if a shown line has no counterpart."""
    case, result = Documents(), 0
    case.setUp()
    for path in STEPWISE:
        changes = []
        for step in case.followed(path):
            if step.output and document_steps.difference(step.output.text, step.printed):
                text, lost = document_steps.updated(step.output.text, step.printed)
                changes.append((step.output, text))
                for line in lost:
                    result = 1
                    print(f"{step.output.place}: nothing printed is like {line!r}; removed", file=sys.stderr)
        document_steps.rewrite(path, changes)
        print(f"{path.relative_to(SOURCE)}: {len(changes)} outputs written")
    case.doCleanups()
    return result


if __name__ == "__main__":
    sys.exit(update()) if sys.argv[1:] == ["--update"] else unittest.main()

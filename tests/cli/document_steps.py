# SPDX-License-Identifier: BSD-3-Clause
"""Documents that are followed step by step in one folder: tutorials and recipes.

A block of TOML or CSV whose first line is `# NAME.toml` (or .csv) is the file NAME; `# NAME.toml: add` is added at its end. The
commands of a block of sh run after it. A block of text that follows is what they print: line by line, except that a
line `…` stands for any lines, and a … inside a line for anything."""
import dataclasses
import difflib
import itertools
import re

FILE = re.compile(r"# ([\w.-]+\.(?:toml|csv))(: add)?\n")
OMITTED = "…"


@dataclasses.dataclass
class Step:
    """Commands and the block of what they print, if the document shows it."""

    commands: list  # (line, command, remark)
    output: object = None
    printed: str = ""


def file_of(block):
    """Name of the file that a block is, and whether it is added at its end; None if it is no file."""
    found = FILE.match(block.text) if block.language in ("toml", "csv") else None
    return (found[1], bool(found[2])) if found else None


def steps(blocks, commands_of):
    """Files and steps of a document in their order."""
    found = []
    for block in blocks:
        if block.language in ("toml", "csv"):
            found.append(block)
        elif block.language == "sh":
            found.append(Step(list(commands_of(block))))
        elif block.language == "text" and found and isinstance(found[-1], Step) and found[-1].output is None:
            found[-1].output = block
    return found


def write(block, folder):
    name, added = file_of(block)
    path = folder / name
    before = path.read_text() + "\n" if added else ""
    path.write_text(before + block.text)


def lines_of(text):
    return [line.rstrip() for line in text.strip("\n").splitlines()]


def _equal(shown, printed):
    """Whether a printed line is the shown one, which may have … inside."""
    pattern = ".*".join(re.escape(piece) for piece in shown.split(OMITTED))
    return re.fullmatch(pattern, printed) is not None


def difference(shown, printed):
    """What of the shown lines is not in the printed ones; None if all of them are, in their order."""
    shown, printed = lines_of(shown), lines_of(printed)
    at, free = 0, False  # free: lines may be left out here
    for line in shown:
        if line.strip() == OMITTED:
            free = True
            continue
        next_one = next(
            (i for i in range(at, len(printed) if free else min(at + 1, len(printed))) if _equal(line, printed[i])),
            None,
        )
        if next_one is None:
            return f"not printed here: {line!r}; printed: {printed[at:at + 3]}"
        at, free = next_one + 1, False
    return None if free or at == len(printed) else f"also printed: {printed[at:at + 3]}; write {OMITTED}"


def _form(line):
    """A line without its numbers and blanks."""
    return " ".join(re.sub(r"[\d.]+", "0", line).split())


def updated(shown, printed):
    """The shown lines as they are printed now, and the lines that have no counterpart. Lines left out remain left out: the
    others are recognised by their words."""
    shown, printed = lines_of(shown), lines_of(printed)
    if not any(line.strip() == OMITTED for line in shown):
        return "\n".join(printed) + "\n", []
    result, lost, at = [], [], 0
    for line in shown:
        if line.strip() == OMITTED:
            result.append(line)
            continue
        likeness = [
            (difflib.SequenceMatcher(None, _form(line), _form(other)).ratio(), -i)
            for i, other in enumerate(printed[at:], at)
        ]
        best, place = max(likeness, default=(0, 0))
        if best < 0.6:
            lost.append(line)
            continue
        if result and -place > at and result[-1].strip() != OMITTED:
            result.append(OMITTED)
        result.append(line if _equal(line, printed[-place]) else printed[-place])
        at = 1 - place
    if at < len(printed) and (not result or result[-1].strip() != OMITTED):
        result.append(OMITTED)
    return "\n".join(line for line, _ in itertools.groupby(result)) + "\n", lost


def rewrite(path, changes):
    """Writes changed blocks of output into a document: (block, new text), the last one first."""
    lines = path.read_text().splitlines(keepends=True)
    for block, text in sorted(changes, key=lambda change: -change[0].line):
        count = block.text.count("\n")
        lines[block.line - 1 : block.line - 1 + count] = [text]
    path.write_text("".join(lines))

# SPDX-License-Identifier: BSD-3-Clause
"""Writes _analyses.py: a method for each command, with its keys, their units and defaults as the engine states them in
its help and in the schema of the project file.

usage: analysis_methods.py FOLDER-OF-_core TARGET
"""

import json
import keyword
import pathlib
import re
import sys
import textwrap

folder, target = sys.argv[1:]
sys.path.insert(0, folder)
import _core  # noqa: E402

schema = json.loads(_core.schema())
analyses = schema["properties"]["analyses"]["properties"]
in_project = set(re.findall(r"    def (\w+)\(", (pathlib.Path(__file__).parent / "trivet/_project.py").read_text()))

HEAD = '''# SPDX-License-Identifier: BSD-3-Clause
"""A method for each command of the engine; written by the build."""

from __future__ import annotations

from typing import Any, Literal, Never

from trivet._progress import Progress
from trivet._result import Result


class _AsInTheFile:
    """Stands for a key that is not given: the value of the project file counts, or else the default of the program."""

    def __repr__(self) -> str:
        return "as in the file"


_file: Any = _AsInTheFile()


class Analyses:
    """Analyses of a project."""

    def _ask(
        self,
        command: str,
        own: dict[str, Any],
        keys: dict[str, Any],
        case: str,
        threads: int,
        progress: Progress | bool | None,
    ) -> Result:
        raise NotImplementedError
'''

METHOD = '''
    def {name}(
        self,
        *,
{arguments}{case}        threads: int = 0,
        progress: Progress | bool | None = None,
        **unknown: Never,
    ) -> Result:
        """{about}

{documentation}
        """
        own: dict[str, Any] = {{{own}}}
        keys: dict[str, Any] = {{{keys}}}
        return self._ask("{name}", own, keys | unknown, {case_given}, threads, progress)
'''


def argument(key: str) -> str:
    """The word of Python for a key: "from_" for "from"."""
    word = key.replace("-", "_")
    return word + "_" if keyword.iskeyword(word) else word


def type_of(command: str, key: str) -> str:
    """The type of a key in the schema, where it is plain; other values may be numbers, texts with units, lists, arrays."""
    tables = analyses if _core.file_table(command) != command else schema["properties"]
    value = tables.get(command, {}).get("properties", {}).get(key, {})
    if "$ref" in value:
        value = schema["$defs"][value["$ref"].rpartition("/")[2]]
    if "enum" in value and all(isinstance(one, str) for one in value["enum"]):
        return "Literal[" + ", ".join(json.dumps(one) for one in value["enum"]) + "]"
    return {"boolean": "bool", "integer": "int", "string": "str"}.get(value.get("type", ""), "Any")


def paragraph(key: str, about: str) -> str:
    """'key: about', wrapped for help()."""
    words = f"{argument(key)}: {about}" if about else argument(key)
    return textwrap.fill(words, 88, initial_indent=" " * 12, subsequent_indent=" " * 16)


def method(name: str, about: str, of_one_case: bool, own: list[tuple[str, str]]) -> str:
    file_keys = re.findall(r"^  (\w+)[ \t]*(.*)$", _core.file_keys(name), re.MULTILINE)
    parts = []
    if own:
        parts.append("        Keys:\n" + "\n".join(paragraph(*key) for key in own))
    if file_keys:
        head = f"        Keys of [{_core.file_table(name)}], which replace those of the file:\n"
        parts.append(head + "\n".join(paragraph(*key) for key in file_keys))
    which = "case: a case of the project instead of the base model.\n        " if of_one_case else ""
    parts.append(
        f"        {which}threads: at most so many, 0: all of the machine. progress: a function of (done, total, task), or True.\n"
        "        Raises InputError, NotComputable."
    )
    all_keys = [key for key, _ in [*own, *file_keys]]
    return METHOD.format(
        name=name,
        about=(about[0].upper() + about[1:]).rstrip(".?") + ("?" if about.endswith("?") else "."),
        arguments="".join(f"        {argument(key)}: {type_of(name, key)} = _file,\n" for key in all_keys),
        documentation="\n\n".join(parts).replace("\\", "\\\\"),
        case='        case: str = "",\n' if of_one_case else "",
        case_given="case" if of_one_case else '""',
        own=", ".join(f'"{key}": {argument(key)}' for key, _ in own),
        keys=", ".join(f'"{key}": {argument(key)}' for key, _ in file_keys),
    )


commands = [command for command in _core.commands() if command[0] not in in_project]
pathlib.Path(target).write_text(HEAD + "".join(method(*command) for command in commands), encoding="utf-8")

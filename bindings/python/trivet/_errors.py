# SPDX-License-Identifier: BSD-3-Clause
"""Errors and warnings. Their texts are those of the command line."""

from __future__ import annotations

import difflib
import warnings
from collections.abc import Iterable
from typing import Any

from trivet import _core


class InputError(ValueError):
    """The input is wrong. `problems` lists everything that is: place, finding, rule and remedy."""

    problems: tuple[_core.Problem, ...]

    def __init__(self, problems: Iterable[_core.Problem] | str) -> None:
        if isinstance(problems, str):
            problems = (_core.Problem("", problems, "", ""),)
        self.problems = tuple(problems)
        super().__init__(_core.message_list(list(self.problems)).strip())

    def __str__(self) -> str:
        return str(self.args[0])

    def __reduce__(self) -> tuple[type[InputError], tuple[list[_core.Problem]]]:
        return type(self), (list(self.problems),)


class UnknownName(InputError, KeyError):
    """There is nothing of this name; the message has the nearest ones."""


class WrongType(InputError, TypeError):
    """An argument is of the wrong type."""


class MissingFile(InputError, FileNotFoundError):
    """The project file does not exist."""


class NotComputable(RuntimeError):
    """A result does not exist, with the reason."""


class ModelWarning(UserWarning):
    """Something in the model or in a result that needs attention."""


def problem(path: str, value: object, rule: str, remedy: str) -> _core.Problem:
    """One problem of an argument: where, the value found, the rule, what to do."""
    return _core.Problem(path, f"{value!r}" if not isinstance(value, str) else value, rule, remedy)


def unknown_name(subject: str, name: object, what: str, known: Iterable[str]) -> UnknownName:
    """`what` of this name does not exist: with the nearest names, or all of them."""
    names = list(known)
    near = difflib.get_close_matches(str(name), names, 3)
    if near:
        remedy = "did you mean " + " or ".join(f'"{one}"' for one in near) + "?"
    else:
        remedy = "known: " + ", ".join(names[:12]) + (", …" if len(names) > 12 else "")
    return UnknownName([problem(subject, f'"{name}"', f"there is no such {what}", remedy if names else "")])


def answered(
    project: _core.Project, command: str, case: str, keys: dict[str, Any], threads: int = 0, progress: Any = None
) -> _core.Result:
    """What the program answers; its message on a case or an element that the project does not have is an UnknownName."""
    try:
        return project.ask(command, case, keys, threads, progress)
    except InputError as wrong:
        if (case and case not in project.cases) or (command == "element" and keys["name"] not in project.parts[1]):
            raise UnknownName(wrong.problems) from None
        raise


def wrong_type(name: str, value: object, rule: str, remedy: str) -> WrongType:
    return WrongType([problem(name, type(value).__name__, rule, remedy)])


def warn(problems: Iterable[_core.Problem], warned: set[str]) -> None:
    """Each warning that is new as a Python warning at the line that called the package. warned: those that are not."""
    for words in map(str, problems):
        if words not in warned:
            warnings.warn(words, ModelWarning, stacklevel=_depth_of_caller())
            warned.add(words)  # unless it was raised as an error


def _depth_of_caller() -> int:
    """Number of frames from `warn` to the first one outside this package."""
    import sys

    depth, frame = 1, sys._getframe(1)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == "trivet":
        depth, frame = depth + 1, frame.f_back
    return depth

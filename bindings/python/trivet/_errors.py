# SPDX-License-Identifier: BSD-3-Clause
"""Errors and warnings. Their texts are those of the command line."""

from __future__ import annotations

import warnings
from collections.abc import Iterable

from trivet import _core


class InputError(ValueError):
    """The input is wrong. `problems` lists everything that is: place, finding, rule and remedy."""

    problems: tuple[_core.Problem, ...]

    def __init__(self, problems: Iterable[_core.Problem] | str) -> None:
        if isinstance(problems, str):
            problems = (_core.Problem("", problems, "", ""),)
        self.problems = tuple(problems)
        super().__init__(_core.message_list(list(self.problems)).strip())

    def __reduce__(self) -> tuple[type[InputError], tuple[list[_core.Problem]]]:
        return InputError, (list(self.problems),)


class NotComputable(RuntimeError):
    """A result does not exist, with the reason."""


class ModelWarning(UserWarning):
    """Something in the model or in a result that needs attention."""


def problem(path: str, value: object, rule: str, remedy: str) -> _core.Problem:
    """One problem of an argument: where, the value found, the rule, what to do."""
    return _core.Problem(path, f"{value!r}" if not isinstance(value, str) else value, rule, remedy)


def warn(problems: Iterable[_core.Problem]) -> None:
    """Each warning as a Python warning at the line that called the package."""
    for one in problems:
        warnings.warn(str(one), ModelWarning, stacklevel=_depth_of_caller())


def _depth_of_caller() -> int:
    """Number of frames from `warn` to the first one outside this package."""
    import sys

    depth, frame = 1, sys._getframe(1)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == "trivet":
        depth, frame = depth + 1, frame.f_back
    return depth

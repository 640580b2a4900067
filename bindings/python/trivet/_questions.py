# SPDX-License-Identifier: BSD-3-Clause
"""A method for every row of the table of questions. Their signatures are in _questions.pyi, which the build writes."""

from __future__ import annotations

from typing import Any

from trivet import _core
from trivet._progress import Progress


class Questions:
    """Questions about a project."""

    def _ask(
        self, question: str, keys: dict[str, Any], case: str, threads: int, progress: Progress | bool | None
    ) -> Any:
        raise NotImplementedError


def _method(question: str, about: str) -> Any:
    def ask(
        self: Questions, *, case: str = "", threads: int = 0, progress: Progress | bool | None = None, **keys: Any
    ) -> Any:
        return self._ask(question, keys, case, threads, progress)

    ask.__name__ = question
    ask.__qualname__ = f"Project.{question}"
    ask.__doc__ = f"""{about[0].upper()}{about[1:]}.

        case: a case of the project instead of the base model. Other keywords are keys of [analyses.{question}] and
        replace those of the file. threads: at most so many. progress: a function of (done, total, task), or True.
        Raises InputError, NotComputable."""
    return ask


for _name, _about in _core.questions():
    setattr(Questions, _name, _method(_name, _about))

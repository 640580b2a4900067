# SPDX-License-Identifier: BSD-3-Clause
"""A method for every command of the engine; those that need arguments of their own are in _project.py. Their signatures are in _analyses.pyi, which the build writes."""

from __future__ import annotations

from typing import Any

from trivet import _core
from trivet._progress import Progress


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
    ) -> Any:
        raise NotImplementedError


def _method(command: str, about: str, of_one_case: bool, own_keys: list[str]) -> Any:
    def ask(
        self: Analyses, *, case: str = "", threads: int = 0, progress: Progress | bool | None = None, **keys: Any
    ) -> Any:
        own = {key: keys.pop(key) for key in own_keys if key in keys}
        return self._ask(command, own, keys, case, threads, progress)

    which = "case: a case of the project instead of the base model. " if of_one_case else ""
    own = f"{', '.join(own_keys)}: as on the command line. " if own_keys else ""
    ask.__name__ = command
    ask.__qualname__ = f"Project.{command}"
    ask.__doc__ = f"""{about[0].upper()}{about[1:]}.

        {which}{own}Other keywords are keys of [analyses.{command}] and
        replace those of the file. threads: at most so many. progress: a function of (done, total, task), or True.
        Raises InputError, NotComputable."""
    return ask


for _name, _about, _of_one_case, _keys in _core.commands():
    setattr(Analyses, _name, _method(_name, _about, _of_one_case, _keys))

# SPDX-License-Identifier: BSD-3-Clause
"""Progress of long computations."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from trivet._errors import InputError, problem

#: Called with (done, total, task): a share of the whole, 1.0, and what is being computed.
Progress = Callable[[float, float, str], Any]


@contextmanager
def shown(progress: Progress | bool | None) -> Iterator[Progress | None]:
    """The callback of a call. True shows a bar of tqdm."""
    if progress is None or progress is False:
        yield None
    elif progress is True:
        with _bar() as bar:
            yield bar
    elif callable(progress):
        yield progress
    else:
        raise InputError(
            [
                problem(
                    "progress",
                    type(progress).__name__,
                    "progress is a function of (done, total, task), or True",
                    "write progress=True for a bar",
                )
            ]
        )


@contextmanager
def _bar() -> Iterator[Progress]:
    try:
        from tqdm.auto import tqdm
    except ImportError as missing:
        raise InputError(
            [problem("progress", True, "a bar needs the package tqdm", "install tqdm, or give a function")]
        ) from missing
    with tqdm(total=100, unit="%", leave=False) as bar:

        def show(done: float, total: float, task: str) -> None:
            bar.set_description(task)
            bar.n = round(100 * done / total)
            bar.refresh()

        yield show

# SPDX-License-Identifier: BSD-3-Clause
"""The tables of a result as columns with units."""

from __future__ import annotations

import csv
import dataclasses
import io
from typing import TYPE_CHECKING

from trivet import _core
from trivet._errors import InputError, problem

if TYPE_CHECKING:
    from trivet._result import Result

Value = float | int | str | None


@dataclasses.dataclass(frozen=True)
class Column:
    """A column: numbers, with None where there is none, or texts."""

    name: str
    unit: str
    values: list[Value]

    @property
    def heading(self) -> str:
        return f"{self.name} [{self.unit}]" if self.unit else self.name


def columns(result: Result, table: str) -> list[Column]:
    """The columns of a table in the units that `Result.to` chose."""
    if result._core.tables_convert:
        return [Column(*column) for column in result._core.columns(table, result._shown)]
    if result._converted is not None:
        rule = "its tables are not converted to other units"
        raise InputError([problem(result.analysis, table, rule, "take them without .to(…)")])
    heads, *rows = csv.reader(io.StringIO(result._core.table(table)))
    return [Column(head, "", _typed([row[i] for row in rows])) for i, head in enumerate(heads)]


def _typed(fields: list[str]) -> list[Value]:
    try:
        return [None if not field else int(field) if field.isdecimal() else float(field) for field in fields]
    except ValueError:
        return list(fields)


def with_level(unit: str, si_unit: str, units: _core.DisplayUnits) -> tuple[str, float]:
    """The unit of a harmonic quantity with the level that it has, "mil p-p", and the factor of the level. Ratios have
    no level."""
    if si_unit in ("1", ""):
        return unit, 1.0
    return unit + {"peak_to_peak": " p-p", "rms": " rms"}.get(units.level, ""), units.level_factor

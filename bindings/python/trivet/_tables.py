# SPDX-License-Identifier: BSD-3-Clause
"""The tables of a result as columns with units."""

from __future__ import annotations

import csv
import dataclasses
import io
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from trivet import _core
from trivet._errors import InputError, problem, unknown_name

if TYPE_CHECKING:
    import pandas

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


@dataclasses.dataclass(frozen=True)
class Table:
    """A table with its columns. The rows have names, if its first column of texts is one of names."""

    name: str
    columns: list[Column]

    @property
    def names(self) -> list[str]:
        """Names of the rows; one may occur several times."""
        for column in self.columns:
            if column.values and all(isinstance(value, str) for value in column.values):
                return [str(value) for value in column.values]
        return []

    @property
    def rows(self) -> list[dict[str, Value]]:
        """Each row, by the names of the columns."""
        count = len(self.columns[0].values) if self.columns else 0
        return [{column.name: column.values[i] for column in self.columns} for i in range(count)]

    def __getitem__(self, name: str) -> Table:
        """The rows of this name."""
        names = self.names
        if name not in names:
            raise unknown_name(self.name, name, "row", dict.fromkeys(names))
        chosen = [i for i, one in enumerate(names) if one == name]
        rows = [dataclasses.replace(column, values=[column.values[i] for i in chosen]) for column in self.columns]
        return Table(self.name, rows)

    def column(self, name: str) -> npt.NDArray[Any]:
        """A column by its name: numbers, NaN where there is none, or texts."""
        values = self._column(name).values
        if all(value is None or isinstance(value, (int, float)) for value in values):
            return np.array([np.nan if value is None else value for value in values], dtype=float)
        return np.array([str(value) for value in values], dtype=np.str_)

    def unit(self, name: str) -> str:
        """Unit of a column; "" for texts and columns whose rows have units of their own."""
        return self._column(name).unit

    def _column(self, name: str) -> Column:
        for column in self.columns:
            if name in (column.name, column.heading):
                return column
        raise unknown_name(self.name, name, "column", [column.name for column in self.columns])

    def __len__(self) -> int:
        return len(self.columns[0].values) if self.columns else 0

    def to_dataframe(self) -> pandas.DataFrame:
        """The same as a table of pandas."""
        import pandas

        return pandas.DataFrame({column.heading: column.values for column in self.columns})


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

# SPDX-License-Identifier: BSD-3-Clause
"""The CSV tables of the core as columns with units."""

from __future__ import annotations

import csv
import dataclasses
import io
import re

from trivet import _core

_heading = re.compile(r"(?P<name>.*) \[(?P<unit>[^\[\]]+)\]")


@dataclasses.dataclass(frozen=True)
class Column:
    """A column: numbers, with None where there is none, or texts."""

    name: str
    unit: str
    values: list[float | int | None] | list[str]

    @property
    def heading(self) -> str:
        return f"{self.name} [{self.unit}]" if self.unit else self.name


def columns(text: str) -> list[Column]:
    """The columns of a CSV table; one is of numbers if every field is a number or empty."""
    rows = list(csv.reader(io.StringIO(text)))
    if not rows:
        return []
    found = []
    for i, heading in enumerate(rows[0]):
        fields = [row[i] if i < len(row) else "" for row in rows[1:]]
        match = _heading.fullmatch(heading)
        name, unit = (match["name"], match["unit"]) if match else (heading, "")
        found.append(Column(name, unit, _typed(fields)))
    return found


def _typed(fields: list[str]) -> list[float | int | None] | list[str]:
    if not any(fields):
        return fields
    try:
        return [None if not field else int(field) if field.isdecimal() else float(field) for field in fields]
    except ValueError:
        return fields


def shown(table: list[Column], units: _core.ShownUnits) -> list[Column]:
    """The same columns in the units and the level in which numbers are shown. Where units are in a column of their own,
    each row is converted."""
    by_row = next((column.values for column in table if column.name == "unit"), None)
    harmonic = any(column.name.endswith("amplitude") for column in table)
    return [_shown_column(column, by_row, units, harmonic) for column in table]


def with_level(unit: str, si_unit: str, units: _core.ShownUnits) -> tuple[str, float]:
    """The unit of a harmonic quantity with the level that it has, "mil p-p", and the factor of the level. Ratios have
    no level."""
    if si_unit in ("1", ""):
        return unit, 1.0
    return unit + {"peak_to_peak": " p-p", "rms": " rms"}.get(units.level, ""), units.level_factor


def _shown_column(
    column: Column, by_row: list[float | int | None] | list[str] | None, units: _core.ShownUnits, harmonic: bool
) -> Column:
    if column.name == "unit" and not column.unit:
        words = [(units.unit(str(unit))[0], str(unit)) for unit in column.values]
        return Column("unit", "", [with_level(*unit, units)[0] if harmonic else unit[0] for unit in words])
    if all(isinstance(value, str) for value in column.values):
        return column
    unit, factor = column.unit, 1.0
    if column.unit == "rad/s" and (column.name.startswith("angular_frequency") or column.name == "speed"):
        unit, factor = units.axis()
    elif column.unit:
        unit, factor = units.unit(column.unit)
    level = 1.0
    if column.unit and column.name.endswith((" re", " im", "amplitude")):
        unit, level = with_level(unit, column.unit, units)
    factors = [factor * level] * len(column.values)
    if by_row and _is_of_row(column):
        of_rows = [str(one) for one in by_row]
        factors = [units.unit(one)[1] * (with_level("", one, units)[1] if harmonic else 1.0) for one in of_rows]
    values = [_times(value, one) for value, one in zip(column.values, factors, strict=True)]
    return Column(column.name, unit, values)


def _is_of_row(column: Column) -> bool:
    """Columns whose unit is that of their row."""
    return not column.unit and column.name in (
        "amplitude",
        "prominence",
        "value",
        "rms",
        "three_sigma",
        "limit",
        "largest",
        "amplitude_uncertainty",
    )


def _times(value: float | int | str | None, factor: float) -> float | int | None:
    if value is None or isinstance(value, str):
        return None
    return value if factor == 1 else value * factor

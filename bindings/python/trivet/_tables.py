# SPDX-License-Identifier: BSD-3-Clause
"""The CSV tables of the core as columns with units."""

from __future__ import annotations

import csv
import dataclasses
import io
import math
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


#: Columns of words, also where a word looks like a number: a case of the name "1".
_words = frozenset(
    ("name", "unit", "case", "in case", "kind", "subject", "requirement", "reason", "met", "method", "parameter",
     "limit line", "level", "kept", "measurement", "result", "source", "element", "excitation", "place", "body", "purest",
     "quantity", "change")
)  # fmt: skip


def columns(text: str) -> list[Column]:
    """The columns of a CSV table: words, or numbers and empty fields."""
    rows = list(csv.reader(io.StringIO(text)))
    if not rows:
        return []
    found = []
    for i, heading in enumerate(rows[0]):
        fields = [row[i] if i < len(row) else "" for row in rows[1:]]
        match = _heading.fullmatch(heading)
        name, unit = (match["name"], match["unit"]) if match else (heading, "")
        found.append(Column(name, unit, fields if name in _words and not unit else _typed(fields)))
    return found


def _typed(fields: list[str]) -> list[float | int | None] | list[str]:
    try:
        return [None if not field else int(field) if field.isdecimal() else float(field) for field in fields]
    except ValueError:
        return fields


def shown(table: list[Column], units: _core.DisplayUnits) -> list[Column]:
    """The same columns in the units and the level in which numbers are shown. Where units are in a column of their own,
    each row is converted."""
    by_name = {column.name: column.values for column in table}
    if not any(_is_of_row(column) for column in table):
        by_name.pop("unit", None)  # such as parameters, whose units are those of the file
    units_of_rows = [str(unit) for unit in by_name.get("unit", [])]
    kinds = by_name["kind"] if "allowed" in by_name else [""] * len(units_of_rows)
    amplitudes = _has_amplitudes(table)
    rows = [
        _Row(unit, amplitudes or kind in _harmonic_kinds, kind == "avoided_frequencies")
        for unit, kind in zip(units_of_rows, kinds, strict=True)
    ]
    found = [_shown_column(column, rows, units) for column in table]
    found = [_with_bounds(column, table, found) if column.name == "requirement" else column for column in found]
    return list({column.heading: column for column in found}.values())  # speeds in rad/s and rpm may be the same now


def _with_bounds(requirement: Column, table: list[Column], shown_table: list[Column]) -> Column:
    """The words of requirements, "machine.z ≤ 0.5 mm", with the bound as the other columns show it."""
    before = {column.name: column.values for column in table}
    after = {column.name: column.values for column in shown_table}
    words = []
    for i, text in enumerate(requirement.values):
        changed = before["unit"][i] != after["unit"][i] and " ≤ " in str(text)
        bound = f"{after['allowed'][i]:.4g} {after['unit'][i]}"
        words.append(f"{str(text).rpartition(' ≤ ')[0]} ≤ {bound}" if changed else str(text))
    return Column("requirement", "", words)


@dataclasses.dataclass(frozen=True)
class _Row:
    """Unit of the values of a row, and whether they are amplitudes of harmonic quantities, or frequencies."""

    unit: str
    harmonic: bool
    frequency: bool

    def shown(self, units: _core.DisplayUnits) -> tuple[str, float]:
        if self.frequency:
            return units.axis()
        unit, factor = units.unit(self.unit)
        if not self.harmonic:
            return unit, factor
        unit, level = with_level(unit, self.unit, units)
        return unit, factor * level


#: Requirements on amplitudes of harmonic quantities; values of the others have no level.
_harmonic_kinds = ("amplitude", "mount_dynamic_deflection")


def _has_amplitudes(table: list[Column]) -> bool:
    return any(column.name.endswith(("amplitude", "measured re")) for column in table)


def with_level(unit: str, si_unit: str, units: _core.DisplayUnits) -> tuple[str, float]:
    """The unit of a harmonic quantity with the level that it has, "mil p-p", and the factor of the level. Ratios have
    no level."""
    if si_unit in ("1", ""):
        return unit, 1.0
    return unit + {"peak_to_peak": " p-p", "rms": " rms"}.get(units.level, ""), units.level_factor


def _shown_column(column: Column, rows: list[_Row], units: _core.DisplayUnits) -> Column:
    if column.name == "unit" and rows:
        return Column("unit", "", [row.shown(units)[0] for row in rows])
    if all(isinstance(value, str) for value in column.values):
        return column
    if rows and _is_of_row(column):
        factors = [row.shown(units)[1] for row in rows]
        return Column(
            column.name, column.unit, [_times(value, one) for value, one in zip(column.values, factors, strict=True)]
        )
    unit, factor = _unit_of_column(column, units)
    if column.unit and column.name.endswith((" re", " im", "amplitude")):
        unit, level = with_level(unit, column.unit, units)
        factor *= level
    return Column(column.name, unit, [_times(value, factor) for value in column.values])


def _unit_of_column(column: Column, units: _core.DisplayUnits) -> tuple[str, float]:
    """Unit and factor. A number in rad/s is a frequency unless its column is a result, "machine.rx re"."""
    if column.unit == "rad/s" and "." not in column.name:
        return units.axis()
    if column.unit == "Hz" and units.frequency:
        unit, per_rad_s = units.axis()
        return unit, 2 * math.pi * per_rad_s
    return units.unit(column.unit) if column.unit else ("", 1.0)


#: Columns whose unit is that of their row, or that per second ("unit/s"), if the table has a column "unit".
_of_row = frozenset(
    ("amplitude", "prominence", "value", "allowed", "limit", "largest", "smallest", "rms", "three_sigma",
     "rms_of_derivative", "weighted_rms", "amplitude_uncertainty", "measured amplitude", "computed amplitude",
     "measured re", "measured im", "computed re", "computed im", "cqc", "srss")
)  # fmt: skip


def _is_of_row(column: Column) -> bool:
    return column.unit in ("", "unit/s") and column.name in _of_row


def _times(value: float | int | str | None, factor: float) -> float | int | None:
    if value is None or isinstance(value, str):
        return None
    return value if factor == 1 else value * factor

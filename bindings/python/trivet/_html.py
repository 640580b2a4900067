# SPDX-License-Identifier: BSD-3-Clause
"""How projects and results show themselves in notebooks."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from typing import TYPE_CHECKING

from trivet import _tables

if TYPE_CHECKING:
    from trivet._result import Result
    from trivet._project import Project

_most_rows, _most_columns = 20, 14


def result(of: Result) -> str:
    """Warnings on top, then the first table, or the text of the command."""
    case = f" · case {escape(of.case)}" if of.case else ""
    head = f"<p><b>{escape(of.analysis)}</b>{case} · {escape(of.project.title)}</p>"
    notices = notice(of.warnings, "#b00020") + notice(of.failures, "#b00020") + notice(of.notes, "#0072b2")
    if not of.tables:
        return head + notices + f"<pre>{escape(of._core.text(of._converted))}</pre>"
    si_only = of._converted is not None and not of._core.tables_convert
    units = notice(["In SI units: this table is not converted to others."], "#0072b2") if si_only else ""
    return head + notices + units + table(_tables.columns(of._si() if si_only else of, of.tables[0]))


def project(of: Project) -> str:
    """Title, source and parts."""
    rows = [("bodies", of.bodies), ("elements", of.elements), ("excitations", of.excitations), ("cases", of.cases)]
    cells = "".join(
        f"<tr><th style='text-align:left'>{name}</th><td style='text-align:left'>{escape(', '.join(names) or '–')}</td></tr>"
        for name, names in rows
    )
    return f"<p><b>{escape(of.title or 'Project')}</b> · {escape(of.source)}</p><table>{cells}</table>"


def notice(lines: Iterable[object], colour: str) -> str:
    """Lines with a coloured bar at their left."""
    style = f"border-left:4px solid {colour};padding:2px 8px;margin:4px 0"
    return "".join(f"<div style='{style}'>{escape(str(line))}</div>" for line in lines)


def table(columns: list[_tables.Column]) -> str:
    """The first rows and columns, and how many there are."""
    left_out = len(columns) - _most_columns
    rows = max((len(column.values) for column in columns), default=0)
    shown = columns[:_most_columns]
    head = "".join(
        f"<th>{escape(column.name)}{'<br>[' + escape(column.unit) + ']' if column.unit else ''}</th>"
        for column in shown
    )
    body = "".join(
        "<tr>" + "".join(f"<td>{_cell(column.values[i])}</td>" for column in shown) + "</tr>"
        for i in range(min(rows, _most_rows))
    )
    rest = []
    if rows > _most_rows:
        rest.append(f"{_most_rows} of {rows} rows")
    if left_out > 0:
        rest.append(f"{_most_columns} of {len(columns)} columns")
    note = f"<p>{' and '.join(rest)}; to_dataframe() has all</p>" if rest else ""
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{note}"


def _cell(value: float | int | str | None) -> str:
    if value is None:
        return "–"
    return escape(f"{value:.6g}" if isinstance(value, float) else str(value))

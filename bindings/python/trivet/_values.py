# SPDX-License-Identifier: BSD-3-Clause
"""Python values as values of the project file: numbers, texts with units, lists, tables, and quantities of pint."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from trivet import _core
from trivet._errors import InputError, problem, wrong_type

_bare_key = re.compile(r"[A-Za-z0-9_-]+")
_key = r"""(?:[A-Za-z0-9_-]+|"(?:[^"\\]|\\.)*"|'[^']*')"""
_path = re.compile(rf"{_key}(?:\s*\.\s*{_key})*")


def key_text(key: str) -> str:
    """A key, in quotes unless it has only letters, digits, _ and -."""
    return key if _bare_key.fullmatch(key) else json.dumps(key, ensure_ascii=False)


def plain(value: Any, path: str, wrong: list[_core.Problem]) -> Any:
    """Numbers, texts, lists and dicts in place of NumPy's arrays, tuples and quantities of pint."""
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        return _of_quantity(value, path, wrong)
    if isinstance(value, Mapping):
        for key in value:
            if not isinstance(key, str):
                wrong.append(problem(path, key, "keys are texts", "write the key in quotes"))
        start = f"{path}." if path else ""
        return {str(key): plain(item, start + key_text(str(key)), wrong) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return plain(value.tolist(), path, wrong)
    if isinstance(value, np.generic):
        return plain(value.item(), path, wrong)
    if isinstance(value, (bool, int, float)):
        return value
    if isinstance(value, str):
        return _text(value, path, wrong)
    if isinstance(value, complex):
        wrong.append(problem(path, value, "a real number is wanted here", "give its real part, or amplitude and phase"))
        return 0
    if isinstance(value, Iterable) and not isinstance(value, (bytes, bytearray, set, frozenset)):
        return [plain(item, f"{path}[{i}]", wrong) for i, item in enumerate(value)]
    wrong.append(
        problem(
            path,
            type(value).__name__,
            "a value is a number, a text, true or false, a list or a table",
            'write for instance 1.5, "3 kN/m", [0, 0, 1] or {"loss_factor": 0.1}',
        )
    )
    return 0


def _text(value: str, path: str, wrong: list[_core.Problem]) -> str:
    """A text that UTF-8 can hold."""
    try:
        value.encode()
    except UnicodeEncodeError:
        wrong.append(problem(path, ascii(value), "a text consists of Unicode characters", "correct the text"))
        return ""
    return value


def _of_quantity(value: Any, path: str, wrong: list[_core.Problem]) -> Any:
    """A quantity of pint as a text with its unit, or a list of them."""
    magnitude = np.asarray(value.magnitude)
    if magnitude.dtype.kind not in "iuf":
        wrong.append(problem(path, value, "a real number is wanted here", "give a real magnitude"))
        return 0
    if "standard_gravity" in f"{value.units:C}":
        value = value.to_base_units()
    unit = f"{value.units:~C}".replace("**", "^").replace("Δ", "").replace("delta_", "")
    unit = re.sub(r"(?<![A-Za-z_])g(?![A-Za-z_])", "gram", unit)  # never the acceleration of gravity
    if unit in ("", "dimensionless"):
        return magnitude.tolist()
    if magnitude.ndim == 0:
        return f"{float(magnitude)!r} {unit}"
    return [_of_quantity(one, path, wrong) for one in value]


def toml_value(value: Any) -> str:
    """A plain value as TOML on one line."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, list):
        return "[" + ", ".join(toml_value(item) for item in value) + "]"
    return "{" + ", ".join(f"{key_text(key)} = {toml_value(item)}" for key, item in value.items()) + "}"


def toml_text(tables: Mapping[str, Any]) -> str:
    """Plain tables as a project file: a header for each table and each part in it, a line for each value."""
    text = "".join(f"{key_text(key)} = {toml_value(value)}\n" for key, value in tables.items() if not _is_table(value))
    for key, table in tables.items():
        if not _is_table(table):
            continue
        parts = {name: part for name, part in table.items() if _is_table(part)}
        values = {name: value for name, value in table.items() if name not in parts}
        if values or not parts:
            text += f"\n[{key_text(key)}]\n" + _lines(values)
        for name, part in parts.items():
            text += f"\n[{key_text(key)}.{key_text(name)}]\n" + _lines(part)
    return text


def _is_table(value: Any) -> bool:
    return isinstance(value, dict)


def _lines(values: Mapping[str, Any]) -> str:
    return "".join(f"{key_text(key)} = {toml_value(value)}\n" for key, value in values.items())


def settings_of(changes: Mapping[str, Any]) -> list[tuple[str, str]]:
    """(path, value as TOML) of each change; a table is changed key by key."""
    if not isinstance(changes, Mapping):
        rule, remedy = "changes are a dict from paths to values", 'write {"elements.mount.scale": 1.5}'
        raise wrong_type("changes", changes, rule, remedy)
    wrong: list[_core.Problem] = []
    settings = []
    for path, value in changes.items():
        if not isinstance(path, str) or not _path.fullmatch(path.strip()):
            remedy = (
                'write it as in "elements.mount.scale", and names with blanks in quotes: elements."front left".scale'
            )
            wrong.append(problem("changes", path, "a path is a text: keys with points between them", remedy))
            continue
        one_form = ".".join(key_text(key) for key in _core.path_keys(path.strip())) or path.strip()
        settings.append((one_form, toml_value(plain(value, path, wrong))))
    if wrong:
        raise InputError(wrong)
    return settings

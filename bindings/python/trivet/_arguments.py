# SPDX-License-Identifier: BSD-3-Clause
"""Arguments of methods: their kinds, before the core takes them."""

from __future__ import annotations

import operator
from collections.abc import Iterable, Mapping
from typing import Any

from trivet import _core
from trivet._errors import InputError, WrongType, problem, wrong_type
from trivet._values import plain


def require_text(name: str, value: object) -> None:
    if not isinstance(value, str):
        raise wrong_type(name, value, "it must be a text", f'write {name}="…"')
    try:
        value.encode()
    except UnicodeEncodeError as wrong:
        rule = "a text consists of Unicode characters"
        raise InputError([problem(name, ascii(value), rule, "correct the text")]) from wrong


def require_case_and_threads(case: object, threads: object) -> None:
    require_text("case", case)
    whole_number("threads", threads)


def whole_number(name: str, value: object) -> int:
    """An integer of Python or NumPy."""
    try:
        if isinstance(value, bool):
            raise TypeError
        number = operator.index(value)  # type: ignore[arg-type]
    except TypeError as wrong:
        raise WrongType([problem(name, value, "it must be a whole number", f"write {name}=4")]) from wrong
    if not -(2**31) <= number < 2**31:
        raise InputError([problem(name, value, "the number is too large", "give a smaller one")])
    return number


def items(name: str, values: object) -> list[Any]:
    if isinstance(values, (str, bytes, Mapping)) or not isinstance(values, Iterable):
        raise WrongType([problem(name, values, "it must be a list", f"write {name}=[…]")])
    return list(values)


def text_list(name: str, values: object) -> list[str]:
    """One text, or several."""
    texts = [values] if isinstance(values, str) else items(name, values)
    for text in texts:
        require_text(name, text)
    return texts


def swept_values(values: object) -> tuple[list[str], list[list[float | str]]]:
    """Paths of numbers, and the values of each: numbers in SI, or texts with units."""
    if not isinstance(values, Mapping):
        remedy = 'write {"elements.mount.scale": [0.5, 1, 2]}'
        raise wrong_type("values", values, "values are a dict from paths to lists", remedy)
    wrong: list[_core.Problem] = []
    lists: list[list[float | str]] = []
    for path, numbers in values.items():
        require_text("values", path)
        listed = plain(numbers, path, wrong)
        if not isinstance(listed, list) or not all(_is_value(one) for one in listed):
            remedy = 'give a 1-D array, texts as in ["90 lb", "100 lb"], or a quantity of pint'
            wrong.append(problem(path, type(numbers).__name__, "a list of numbers is wanted", remedy))
            continue
        lists.append([one if isinstance(one, str) else float(one) for one in listed])
    if wrong:
        raise InputError(wrong)
    return list(values), lists


def _is_value(value: object) -> bool:
    return isinstance(value, (int, float, str)) and not isinstance(value, bool)


def frequency(value: object) -> float:
    """[rad/s]"""
    wrong: list[_core.Problem] = []
    given = plain(value, "frequency", wrong)
    if wrong or isinstance(given, bool) or not isinstance(given, (int, float, str)):
        raise InputError(wrong or [problem("frequency", value, "it is a number in rad/s, or a text", 'write "25 Hz"')])
    return _core.angular_frequency(given) if isinstance(given, str) else float(given)

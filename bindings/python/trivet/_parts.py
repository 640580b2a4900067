# SPDX-License-Identifier: BSD-3-Clause
"""A read-only view of a project: its bodies and mounts, and values of its file."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Iterable, Iterator, Mapping
from html import escape
from typing import TYPE_CHECKING, Any, Generic, SupportsIndex, TypeVar, overload

from trivet import _core
from trivet._errors import unknown_name
from trivet._values import key_text

if TYPE_CHECKING:
    import pandas

Vector = tuple[float, float, float]


@dataclasses.dataclass(frozen=True)
class Body:
    """A rigid body, SI. Its axes and its pole are those of the project file."""

    name: str
    mass: float  #: [kg]
    center_of_mass: Vector  #: [m], axes of the body
    principal_moments: Vector  #: [kg m²], about the centre of mass
    position: Vector  #: [m], of the pole on the ground
    rotation: tuple[Vector, ...]  #: rows: from the axes of the body to those of the ground
    points: dict[str, Vector]  #: [m], axes of the body
    free: tuple[str, ...]  #: coordinates that can move

    def in_ground(self, at: Vector) -> Vector:
        """A place of the body in the axes of the ground [m]."""
        return _vector(
            p + sum(r * x for r, x in zip(row, at, strict=True))
            for p, row in zip(self.position, self.rotation, strict=True)
        )


@dataclasses.dataclass(frozen=True)
class Mount:
    """An elastic element, SI."""

    name: str
    type: str
    body: str  #: at its end K
    base: str  #: at its end N: "ground", a body or a node
    place: Vector  #: [m], of end K on the ground
    stiffness: Vector  #: [N/m], along its own axes, other displacements zero; with its scale
    scale: float
    damping: str  #: in words


Part = TypeVar("Part", Body, Mount)


class Parts(list[str], Generic[Part]):
    """Names of parts in the order of the file, and each part by its name."""

    def __init__(self, names: Iterable[str], parts: Iterable[Part]) -> None:
        super().__init__(names)
        self._parts: dict[str, Part] = {part.name: part for part in parts}

    @overload
    def __getitem__(self, key: str) -> Part:
        ...

    @overload
    def __getitem__(self, key: SupportsIndex) -> str:
        ...

    @overload
    def __getitem__(self, key: slice) -> list[str]:
        ...

    def __getitem__(self, key: str | SupportsIndex | slice) -> Part | str | list[str]:
        if not isinstance(key, str):
            return super().__getitem__(key)
        if key not in self._parts:
            raise unknown_name("project", key, "part", self._parts)
        return self._parts[key]

    def rows(self) -> Iterator[Part]:
        return iter(self._parts.values())

    def to_dataframe(self) -> pandas.DataFrame:
        """A row for each part, vectors as three columns."""
        import pandas

        return pandas.DataFrame([_flat(part) for part in self.rows()])

    def _repr_html_(self) -> str:
        rows = [_flat(part) for part in self.rows()]
        head = "".join(f"<th>{escape(name)}</th>" for name in (rows[0] if rows else ()))
        cells = "".join("<tr>" + "".join(f"<td>{_shown(x)}</td>" for x in row.values()) + "</tr>" for row in rows)
        return f"<table><tr>{head}</tr>{cells}</table>"

    def __reduce__(self) -> Any:
        return Parts, (list(self), list(self.rows()))


def _shown(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else escape(str(value))


_units = {"mass": "kg", "center_of_mass": "m", "principal_moments": "kg m²", "place": "m", "stiffness": "N/m"}
_of_pictures = ("rotation", "points", "free", "position")  # not columns


def _flat(part: Body | Mount) -> dict[str, Any]:
    row: dict[str, Any] = {}
    for field in dataclasses.fields(part):
        value, unit = getattr(part, field.name), _units.get(field.name)
        words = f" [{unit}]" if unit else ""
        if field.name in _of_pictures:
            continue
        if isinstance(value, tuple):
            axes = "123" if field.name == "principal_moments" else "xyz"
            row |= {f"{field.name} {axis}{words}": one for axis, one in zip(axes, value, strict=True)}
        else:
            row[field.name + words] = value
    return row


def _vector(numbers: Iterable[float]) -> Vector:
    x, y, z = (float(one) for one in numbers)
    return x, y, z


def bodies(names: list[str], model: str) -> Parts[Body]:
    """names: with the nodes, which have no mass."""
    found = [
        Body(
            one["name"],
            one["mass"],
            _vector(one["center_of_mass"]),
            _vector(one["principal_moments"]),
            _vector(one["position"]),
            tuple(_vector(row) for row in one["rotation"]),
            {name: _vector(at) for name, at in one["points"].items()},
            tuple(one["free"]),
        )
        for one in json.loads(model)["bodies"]
    ]
    return Parts(names, found)


def mounts(model: str) -> Parts[Mount]:
    found = [
        Mount(
            one["name"],
            one["type"],
            one["k"]["on"],
            one["n"]["on"],
            _vector(one["k"]["in_ground"]),
            _vector(one["stiffness"][i][i] for i in range(6, 9)),
            one["scale"],
            one["damping"],
        )
        for one in json.loads(model)["elements"]
    ]
    return Parts([one.name for one in found], found)


def value_at(path: str, tables: Mapping[str, Any]) -> Any:
    """A value of the project file by its path."""
    value: Any = tables
    passed: list[str] = []
    for key in _core.path_keys(path.strip()) or [path]:
        if not isinstance(value, Mapping) or key not in value:
            start = "".join(key_text(one) + "." for one in passed)
            known = [start + key_text(one) for one in value] if isinstance(value, Mapping) else []
            raise unknown_name("project", path, "value in the project file", known)
        value = value[key]
        passed.append(key)
    return value

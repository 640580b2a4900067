# SPDX-License-Identifier: BSD-3-Clause
"""What a command found: its numbers as arrays, tables, text, JSON and pictures."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from trivet import _core, _html, _tables
from trivet._errors import InputError, UnknownName, problem, unknown_name
from trivet._tables import Table

if TYPE_CHECKING:
    import pandas
    import xarray

    from trivet._project import Project

Numbers = npt.NDArray[Any]


class Curve:
    """One result over an axis, such as the amplitude of a coordinate over frequency. Numbers are SI unless the result
    was changed by `Result.to`."""

    def __init__(
        self,
        name: str,
        unit: str,
        values: Numbers,
        axis: str,
        places: Numbers,
        shown: _core.DisplayUnits,
        harmonic: bool,
        phase: Numbers | None = None,
        frequency: tuple[str, float] = ("", 1.0),
    ) -> None:
        self._name = name
        self._frequency = frequency
        self._phase = phase
        self.axis = axis  #: name of the axis: "angular_frequency" [rad/s], "time" [s], …
        self._si = unit, values, places
        self._shown = shown
        self._unit, self._factor = shown.unit(unit)
        self._harmonic = harmonic
        if harmonic:
            self._unit, level = _tables.with_level(self._unit, unit, shown)
            self._factor *= level

    @property
    def name(self) -> str:
        """Name of the result."""
        return self._name

    @property
    def unit(self) -> str:
        """Unit of the values."""
        return self._unit

    @property
    def harmonic(self) -> bool:
        """Are the values amplitudes of a harmonic quantity, which have a level?"""
        return self._harmonic

    @property
    def values(self) -> Numbers:
        """The numbers: a read-only view of the result if they are SI."""
        values = self._si[1]
        return values if self._factor == 1 else values * self._factor

    @property
    def places(self) -> Numbers:
        """Coordinates along the axis, SI."""
        return self._si[2]

    @property
    def complex(self) -> Numbers:
        """Complex amplitudes: the result is Re(value · e^{iωt}). With a level that `Result.to` chose, the magnitude is
        peak-to-peak or rms instead, as the unit says."""
        if not np.iscomplexobj(self._si[1]):
            raise InputError([problem(self._name, "real numbers", "only harmonic results are complex", "take .values")])
        return self.values

    @property
    def amplitude(self) -> Numbers:
        """Magnitudes, in the level that `Result.to` chose; of real numbers their absolute values."""
        return np.abs(self.values)

    @property
    def phase(self) -> Numbers:
        """Phases [rad] in (−π, π], or continuous if the response requests that (phase = "continuous")."""
        if self._phase is not None:
            return self._phase
        phase = np.angle(self.complex)
        return np.where(phase == -np.pi, np.pi, phase)

    @property
    def frequency(self) -> Numbers:
        """Frequencies in `frequency_unit`."""
        return self._along("angular_frequency") * self._frequency[1]

    @property
    def frequency_unit(self) -> str:
        """Unit in which the model, or `Result.to`, shows frequencies."""
        return self._frequency[0]

    @property
    def angular_frequency(self) -> Numbers:
        """[rad/s]"""
        return self._along("angular_frequency")

    @property
    def frequency_hz(self) -> Numbers:
        """[Hz]"""
        return self._along("angular_frequency") / (2 * np.pi)

    @property
    def time(self) -> Numbers:
        """[s]"""
        return self._along("time")

    def _along(self, axis: str) -> Numbers:
        if self.axis != axis:
            raise InputError([problem(self._name, f"a curve over {self.axis}", f"it has no {axis}", "take .places")])
        return self.places

    def plot(self, ax: Any = None) -> Any:
        """A picture of the curve with Matplotlib: amplitude and phase. ax: axes to draw into, two for the phase too."""
        from trivet import _plots

        return _plots.curve(self, ax)

    def __len__(self) -> int:
        return len(self._si[1])

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Numbers:
        return np.array(self.values, dtype=dtype) if copy else np.asarray(self.values, dtype=dtype)

    def __repr__(self) -> str:
        return f"<trivet.Curve {self.name} [{self.unit}]: {len(self)} values over {self.axis}>"


class Result:
    """What one command found. `result["machine.z"]` is a curve or an array; `print(result)` shows what the command line
    shows."""

    def __init__(self, core: _core.Result, project: Project, shown: _core.DisplayUnits | None = None) -> None:
        self._core = core
        self._project = project
        self._shown = shown or _core.DisplayUnits()
        self._converted: _core.DisplayUnits | None = None  # by `to`; the text otherwise has the units of [display]
        self._arrays = {name: (unit, axes, values) for name, unit, axes, values in core.arrays()}
        self._harmonic = frozenset(core.harmonic)

    @property
    def analysis(self) -> str:
        """Name of the command."""
        return self._core.analysis

    @property
    def question(self) -> str:
        """The older name of `analysis`."""
        return self.analysis

    @property
    def case(self) -> str:
        """Name of the case; "" for the base model."""
        return self._core.case

    @property
    def project(self) -> Project:
        """The project that was analysed."""
        return self._project

    @property
    def warnings(self) -> list[_core.Problem]:
        return self._core.warnings

    @property
    def notes(self) -> list[str]:
        return self._core.notes

    @property
    def failures(self) -> list[str]:
        """Parts that could not be computed, with the reason."""
        return self._core.failures

    @property
    def names(self) -> list[str]:
        """Names of all arrays."""
        return list(self._arrays)

    @property
    def curves(self) -> dict[str, Curve]:
        """All results over an axis with coordinates, such as frequency or time. An array with one more axis gives a
        curve for each of its rows: "primary jolt"."""
        found = {}
        for name in self._arrays:
            if self._is_curve(name):
                found[name] = self._curve(name)
            else:
                found.update(self._rows_as_curves(name))
        return found

    def curve(self, name: str) -> Curve:
        """One of the curves, with the units of both axes. Raises UnknownName, which is a KeyError."""
        curves = self.curves
        if name not in curves:
            raise unknown_name(self.analysis, name, "curve", curves)
        return curves[name]

    def _rows_as_curves(self, name: str) -> dict[str, Curve]:
        unit, axes, values = self._arrays[name]
        if len(axes) != 2 or axes[1] not in _plotted_axes or axes[0] not in self._arrays or isinstance(values, list):
            return {}
        rows, places = self._arrays[axes[0]][2], self._arrays[axes[1]][2]
        names = [f"{name} {row}" for row in rows]
        harmonic = name in self._harmonic
        axis = self._frequency_axis()
        return {
            one: Curve(one, unit, values[i], axes[1], places, self._shown, harmonic, None, axis)
            for i, one in enumerate(names)
        }

    @property
    def angular_frequency(self) -> Numbers:
        """[rad/s]: the axis of the curves, or a column of the table."""
        return self.array("angular_frequency")

    @property
    def frequency_hz(self) -> Numbers:
        """[Hz]"""
        return self.array("angular_frequency") / (2 * np.pi)

    @property
    def best(self) -> Project:
        """The project with the best design that `optimize` or `select` found."""
        if not self._core.changes:
            raise InputError([problem(self.analysis, "no best design", "only optimize and select find one", "")])
        changes = [tuple(change.split(" = ", 1)) for change in self._core.changes]
        return self._project._with_settings([(path, value) for path, value in changes])

    @property
    def changes(self) -> dict[str, str]:
        """The best design as settings: paths, and values as the project file has them."""
        return dict(change.split(" = ", 1) for change in self._core.changes)

    def unit(self, name: str) -> str:
        """SI unit of an array."""
        return self._found(name)[0]

    def axes(self, name: str) -> tuple[str, ...]:
        """Names of the axes of an array."""
        return self._found(name)[1]

    def array(self, name: str) -> Numbers:
        """The numbers of an array, SI: a read-only view. Texts become an array of texts."""
        values = self._found(name)[2]
        return np.array(values, dtype=np.str_) if isinstance(values, list) else values

    def __getitem__(self, name: str) -> Curve | Numbers | Table:
        """A curve, an array, or the rows of this name in the first table."""
        if name not in self._arrays and self.tables and name in (table := self.table()).names:
            return table[name]
        self._found(name)
        return self._curve(name) if self._is_curve(name) else self.array(name)

    def __contains__(self, name: object) -> bool:
        return name in self._arrays

    def table(self, name: str | None = None) -> Table:
        """A table, by default the first: `result.table()["machine.z"]` has the rows of this name,
        `.column("amplitude")` the numbers of a column."""
        found = self._table_name(name)
        return Table(found.removesuffix(".csv"), _tables.columns(self, found))

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def to(self, **units: str) -> Result:
        """The same result in other units: length="in", force="lbf", angle="deg", mass="lb", frequency="rpm",
        level="peak_to_peak" or "rms". They apply to curves (not to their axis), tables of pandas, notebooks, pictures and
        print; arrays, CSV, JSON and xarray stay SI."""
        changed = copy.copy(self)
        changed._shown = self._shown.changed([(key, str(value)) for key, value in units.items()])
        changed._converted = changed._shown
        return changed

    def _si(self) -> Result:
        return Result(self._core, self._project)

    @property
    def tables(self) -> list[str]:
        """Names of the tables."""
        return self._core.tables

    def to_csv(self, table: str | None = None) -> str:
        """A table as the command line writes it, SI; by default the first."""
        return self._core.table(self._table_name(table))

    def to_dataframe(self, table: str | None = None) -> pandas.DataFrame:
        """A table of pandas, columns with their units; by default the first table."""
        import pandas

        columns = _tables.columns(self, self._table_name(table))
        return pandas.DataFrame({column.heading: column.values for column in columns})

    def to_xarray(self) -> xarray.Dataset:
        """All arrays with their axes and units, SI."""
        import xarray

        coordinates: dict[str, Any] = {}
        variables: dict[str, Any] = {}
        for name, (unit, axes, _) in self._arrays.items():
            variable = (axes, self.array(name), {"units": unit} if unit else {})
            (coordinates if axes == (name,) else variables)[name] = variable
        about = {"question": self.analysis, "case": self.case, "title": self._core.title}
        return xarray.Dataset(variables, coordinates, about)

    def to_html(self) -> str:
        """Tables and sentences as the report has them, as a part of a page; in the units that `Result.to` chose, else those of the
        file."""
        html = self._core.html(self._converted)
        if not html:
            rule = "this command has no tables for a page"
            raise InputError([problem(self.analysis, "no HTML", rule, "take print, .to_dataframe() or .to_dict()")])
        return html

    def to_json(self) -> str:
        """JSON as docs/json.md describes it, SI."""
        return self._core.json()

    def to_dict(self) -> dict[str, Any]:
        """The JSON as Python objects."""
        found: dict[str, Any] = json.loads(self._core.json())
        return found

    def plot(self, *names: str, ax: Any = None, backend: str = "matplotlib") -> Any:
        """A picture of all curves, or of those named: with "matplotlib" a figure, with "plotly" a figure of Plotly.
        ax: axes of Matplotlib to draw into, one for the first part of the picture or a list for all of them."""
        from trivet import _plots

        curves = self.curves
        for name in names:
            if name not in curves and name not in self._results():
                self._found(name)
        return _plots.picture(self, names, backend, ax)

    def svg(self, figure: str | None = None) -> str:
        """A picture of the report, if the command has one: a map, a front, an element, bands, a box."""
        figures = self._core.figures
        if not figures:
            raise InputError(
                [problem(self.analysis, "no picture", "map, optimize, element, sample and box have one", "use .plot()")]
            )
        if figure is not None and figure not in figures:
            raise unknown_name(self.analysis, figure, "picture", figures)
        return self._core.figure(figure or figures[0])

    def __str__(self) -> str:
        if self._converted is not None and not self._core.text_converts:
            rule = "its text is not converted to other units"
            raise InputError([problem(self.analysis, "print", rule, "print the result without .to(…)")])
        return self._core.text(self._converted)

    def __repr__(self) -> str:
        case = f" of case {self.case}" if self.case else ""
        return f"<trivet.Result {self.analysis}{case}: {self._core.title}>"

    def _repr_html_(self) -> str:
        return _html.result(self)

    def _found(self, name: str) -> tuple[str, tuple[str, ...], Any]:
        if name in self._arrays:
            return self._arrays[name]
        if not self._arrays:
            remedy = "take .to_dict() or .to_dataframe()"
            raise UnknownName([problem(self.analysis, f'"{name}"', "there is no such result", remedy)])
        raise unknown_name(self.analysis, name, "result", self._arrays)

    def _results(self) -> list[str]:
        """Names in the rows of the result, such as those of peaks."""
        names = self._arrays.get("name", ("", (), []))[2]
        return names if isinstance(names, list) else []

    def _is_curve(self, name: str) -> bool:
        _, axes, values = self._arrays[name]
        if len(axes) != 1 or axes[0] == name or axes[0] not in self._arrays or isinstance(values, list):
            return False
        is_phase = name.endswith(" phase") and name.removesuffix(" phase") in self._arrays
        return _kind_of_axis(axes[0]) in _plotted_axes and not is_phase

    def _curve(self, name: str) -> Curve:
        unit, axes, values = self._arrays[name]
        phase = self._arrays.get(f"{name} phase", (None, None, None))[2]
        axis, places, harmonic = _kind_of_axis(axes[0]), self._arrays[axes[0]][2], name in self._harmonic
        return Curve(name, unit, values, axis, places, self._shown, harmonic, phase, self._frequency_axis())

    def _frequency_axis(self) -> tuple[str, float]:
        """Unit of frequencies that `to` or the model chose, and its factor from rad/s."""
        return (self._converted or self._core.display).axis()

    def _table_name(self, table: str | None) -> str:
        tables = self.tables
        if not tables:
            raise InputError([problem(self.analysis, "no table", "this command has no table", "take .to_dict()")])
        if table is None:
            return tables[0]
        for name in tables:
            if table in (name, name.removesuffix(".csv")):
                return name
        raise unknown_name(self.analysis, table, "table", tables)


#: Axes over which results are curves; other axes number the rows of a table.
_plotted_axes = ("angular_frequency", "frequency", "time", "speed", "natural_frequency", "period")


def _kind_of_axis(axis: str) -> str:
    """The last word: measured functions have an axis each, "rig flange.z angular_frequency"."""
    return axis.rpartition(" ")[2]

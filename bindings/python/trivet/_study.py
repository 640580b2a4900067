# SPDX-License-Identifier: BSD-3-Clause
"""Results that are not results of a command: a whole run, matrices, a sweep over designs."""

from __future__ import annotations

import dataclasses
import pathlib
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from trivet import _core, _html
from trivet._arguments import frequency
from trivet._errors import unknown_name

if TYPE_CHECKING:
    import pandas
    import xarray

    from trivet._result import Result

Real = npt.NDArray[np.float64]


@dataclasses.dataclass(frozen=True)
class Run:
    """A result folder, and the results of each case ("" is the base model)."""

    folder: pathlib.Path
    cases: dict[str, Result]

    @property
    def report(self) -> pathlib.Path:
        return self.folder / "report.html"

    def __str__(self) -> str:
        return "\n".join(str(result) for result in self.cases.values())

    def _repr_html_(self) -> str:
        notices = "".join(
            _html.notice(result.warnings, "#b00020") + _html.notice(result.failures, "#b00020")
            for result in self.cases.values()
        )
        return f"<p>Report: {self.report}</p>{notices}"


class _Arrays:
    """Named arrays of the core, and warnings about them."""

    def __init__(self, arrays: list[tuple[str, str, tuple[str, ...], Any]], warnings: list[_core.Problem]) -> None:
        self._given = arrays
        self._warnings = warnings
        self._arrays = {name: values for name, _, _, values in arrays}
        self._units = {name: unit for name, unit, _, _ in arrays}
        self._axes = {name: axes for name, _, axes, _ in arrays}

    @property
    def warnings(self) -> list[_core.Problem]:
        return list(self._warnings)

    def unit(self, name: str) -> str:
        """Unit of an array."""
        self.array(name)
        return self._units[name]

    def array(self, name: str) -> npt.NDArray[Any]:
        """An array by its name; read-only."""
        if name not in self._arrays:
            raise unknown_name(type(self).__name__, name, "array", self._arrays)
        values = self._arrays[name]
        return np.array(values, dtype=np.str_) if isinstance(values, list) else values

    @property
    def arrays(self) -> list[str]:
        return list(self._arrays)

    def _texts(self, name: str) -> list[str]:
        return list(self._arrays[name])


class Matrices(_Arrays):
    """A q̈ + B q̇ + (K + i K_loss) q = h of the whole system, SI."""

    @property
    def A(self) -> Real:
        """Mass matrix, n × n."""
        return self.array("A")

    @property
    def B(self) -> Real:
        """Damping matrix, n × n."""
        return self.array("B")

    @property
    def K(self) -> Real:
        """Stiffness matrix, n × n."""
        return self.array("K")

    @property
    def K_loss(self) -> Real:
        """Imaginary part of the stiffness for ω > 0, n × n; zero without loss factors."""
        return self.array("K_loss")

    @property
    def coordinates(self) -> list[str]:
        """Names of the rows."""
        return self._texts("coordinate")

    @property
    def units(self) -> list[str]:
        """Unit of each coordinate."""
        return self._texts("coordinate_unit")

    @property
    def exact(self) -> bool:
        """False if elements depend on frequency: then B and K are of their nearest linear system."""
        return bool(self.array("exact"))

    def load(self, angular_frequency: float | str) -> npt.NDArray[np.complex128]:
        """Right side h of all harmonic excitations together at ω > 0 [rad/s, or a text with a unit], motions of
        the ground included."""
        s = 1j * frequency(angular_frequency)
        powers, delays = self.array("load_power"), self.array("load_delay")
        terms = self.array("load")
        total = np.zeros(len(self.coordinates), dtype=np.complex128)
        for power, delay, term in zip(powers, delays, terms, strict=True):
            total += s**power * np.exp(-s * delay) * term
        return total

    def dynamic_stiffness(self, angular_frequency: float | str) -> npt.NDArray[np.complex128]:
        """K + i K_loss + iωB − ω²A."""
        w = frequency(angular_frequency)
        stiffness: npt.NDArray[np.complex128] = self.K + 1j * self.K_loss + 1j * w * self.B - w * w * self.A
        return stiffness

    def to_dataframe(self, name: str = "K") -> pandas.DataFrame:
        """One matrix (A, B, K or K_loss) with the names of its rows and columns, SI."""
        import pandas

        if name not in ("A", "B", "K", "K_loss"):
            raise unknown_name("Matrices", name, "matrix", ("A", "B", "K", "K_loss"))
        return pandas.DataFrame(self.array(name), index=self.coordinates, columns=self.coordinates)

    def _repr_html_(self) -> str:
        names = escape(", ".join(self.coordinates[:12])) + (" …" if len(self.coordinates) > 12 else "")
        return f"<p>{escape(repr(self).strip('<>'))}: {names}</p>{_html.notice(self.warnings, '#b00020')}"

    def __repr__(self) -> str:
        return f"<trivet.Matrices of {len(self.coordinates)} coordinates>"


class StateSpace(tuple[Real, Real, Real, Real]):
    """x' = A x + B u, y = C x + D u, SI: the tuple (A, B, C, D) that SciPy and python-control take, with names."""

    _named: _Arrays

    def __new__(cls, arrays: list[tuple[str, str, tuple[str, ...], Any]], warnings: list[_core.Problem]) -> StateSpace:
        named = _Arrays(arrays, warnings)
        self = super().__new__(cls, (named.array("A"), named.array("B"), named.array("C"), named.array("D")))
        self._named = named
        return self

    def __getnewargs__(self) -> tuple[list[tuple[str, str, tuple[str, ...], Any]], list[_core.Problem]]:
        return self._named._given, self._named._warnings

    @property
    def warnings(self) -> list[_core.Problem]:
        return self._named.warnings

    @property
    def A(self) -> Real:
        return self[0]

    @property
    def B(self) -> Real:
        return self[1]

    @property
    def C(self) -> Real:
        return self[2]

    @property
    def D(self) -> Real:
        return self[3]

    def array(self, name: str) -> npt.NDArray[Any]:
        """An array by its name; read-only."""
        return self._named.array(name)

    @property
    def arrays(self) -> list[str]:
        return self._named.arrays

    @property
    def states(self) -> list[str]:
        return self._named._texts("state")

    @property
    def inputs(self) -> list[str]:
        """Names of the inputs: excitations, and their derivatives where a moving ground needs them."""
        return self._named._texts("input")

    @property
    def outputs(self) -> list[str]:
        return self._named._texts("output")

    def __repr__(self) -> str:
        return f"<trivet.StateSpace: {len(self.states)} states, {len(self.inputs)} inputs, {len(self.outputs)} outputs>"


class Sweep(_Arrays):
    """Largest amplitudes of results over all combinations of some numbers."""

    def __init__(
        self, arrays: list[tuple[str, str, tuple[str, ...], Any]], warnings: list[_core.Problem], title: str
    ) -> None:
        super().__init__(arrays, warnings)
        self._title = title

    @property
    def parameters(self) -> list[str]:
        return list(self._axes["amplitude"][:-1])

    @property
    def results(self) -> list[str]:
        return self._texts("result")

    @property
    def amplitude(self) -> Real:
        """Largest amplitude of each result [its unit], one axis per parameter and then the results; infinite at an
        undamped resonance, NaN where there is no valid model."""
        return self.array("amplitude")

    @property
    def counts(self) -> dict[str, int]:
        """How many designs were computed by which method."""
        return {name: int(self.array(name)) for name in ("in_kernels", "one_by_one", "without_model")}

    def to_xarray(self) -> xarray.DataArray:
        """The amplitudes with their axes."""
        import xarray

        axes = self._axes["amplitude"]
        coordinates: dict[str, Any] = {
            name: (name, self._arrays[name], _attributes(self._units[name])) for name in axes
        }
        coordinates["unit"] = ("result", self._arrays["unit"])
        return xarray.DataArray(self.amplitude, coordinates, axes, "amplitude", {"title": self._title})

    def __getitem__(self, result: str) -> Real:
        """Amplitudes of one result."""
        if result not in self.results:
            raise unknown_name("sweep", result, "result", self.results)
        amplitudes: Real = self.amplitude[..., self.results.index(result)]
        return amplitudes

    def plot(self, *names: str, ax: Any = None) -> Any:
        """Amplitudes of the results over the first number, a line for each of the values of the others; a figure of
        Matplotlib. ax: axes to draw into; several results of different units need as many."""
        from trivet import _plots

        return _plots.sweep(self, [self._checked(name) for name in names] or self.results, ax)

    def _checked(self, result: str) -> str:
        self[result]
        return result

    def to_dataframe(self) -> pandas.DataFrame:
        """A row for each design: its numbers, then the amplitudes of the results."""
        import pandas

        axes = [self.array(name) for name in self.parameters]
        grids = np.meshgrid(*axes, indexing="ij")
        columns = {
            _heading(name, self._units[name]): grid.ravel() for name, grid in zip(self.parameters, grids, strict=True)
        }
        for i, (result, unit) in enumerate(zip(self.results, self._texts("unit"), strict=True)):
            columns[_heading(result, unit)] = self.amplitude[..., i].ravel()
        return pandas.DataFrame(columns)

    def _repr_html_(self) -> str:
        ranges = "".join(
            f"<li>{escape(_heading(name, self._units[name]))}: {len(axis)} values, {axis.min():.6g} to {axis.max():.6g}</li>"
            for name, axis in ((name, self.array(name)) for name in self.parameters)
        )
        return f"<p>{escape(repr(self).strip('<>'))}</p><ul>{ranges}</ul>{_html.notice(self.warnings, '#b00020')}"

    def __repr__(self) -> str:
        shape = " × ".join(str(n) for n in self.amplitude.shape[:-1])
        return f"<trivet.Sweep: {shape} designs, {len(self.results)} results>"


def _heading(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit not in ("", "1") else name


def _attributes(unit: str) -> dict[str, str]:
    return {"units": unit} if unit else {}

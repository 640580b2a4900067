# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of results: what is drawn (panels of lines), and two ways to draw it."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np

from trivet import _core, _tables
from trivet._errors import InputError, problem, wrong_type

if TYPE_CHECKING:
    from trivet._project import Project
    from trivet._result import Result, Curve, Numbers
    from trivet._study import Sweep

#: Colours of the report; people with any colour vision tell them apart.
_colours = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#000000", "#E69F00")
_dashes = ("solid", "dashed", "dotted", "dashdot")
_plotly_dashes = ("solid", "dash", "dot", "dashdot")
_level_words = {"amplitude": "amplitude", "peak_to_peak": "peak to peak", "rms": "rms"}
_quantity_words = {
    "m": "displacement", "rad": "rotation", "m/s": "velocity", "rad/s": "angular velocity", "m/s²": "acceleration",
    "rad/s²": "angular acceleration", "N": "force", "N m": "moment", "W": "power", "1": "ratio",
}  # fmt: skip
_shown_decades = 1e-8  # of the highest value of a panel: smaller ones are symmetry or round-off
_axis_words = {"angular_frequency": "frequency", "time": "time", "speed": "shaft speed"}


@dataclasses.dataclass(frozen=True)
class Line:
    name: str
    x: Numbers
    y: Numbers


@dataclasses.dataclass(frozen=True)
class Panel:
    """Lines with common axes. marks: only points, with a stem to the axis; phase: of the panel above, with its colours."""

    x_label: str
    y_label: str
    lines: list[Line]
    log_x: bool = False
    log_y: bool = False
    marks: bool = False
    phase: bool = False


def picture(result: Result, names: tuple[str, ...], backend: str, ax: Any = None) -> Any:
    """A figure of the backend."""
    if backend not in ("matplotlib", "plotly"):
        rule = 'known are "matplotlib" and "plotly"'
        raise InputError([problem("backend", f'"{backend}"', rule, "choose one of them")])
    panels = _panels(result, names)
    if not panels:
        remedy = "use .svg()" if result._core.figures else "use .to_dataframe() or print it"
        raise InputError([problem(result.analysis, "nothing to plot", "the result has no curves", remedy)])
    title = result.project.title + (f" · {result.case}" if result.case else "")
    if backend == "matplotlib":
        return _with_matplotlib(panels, title, ax)
    if ax is not None:
        raise InputError([problem("ax", "axes", "Plotly draws into its own figure", 'take backend="matplotlib"')])
    return _with_plotly(panels, title)


def curve(shown: Curve, ax: Any) -> Any:
    """A picture of one curve."""
    return _with_matplotlib(_curve_panels([shown], shown._shown), "", ax)


def sweep(of: Sweep, names: list[str], ax: Any) -> Any:
    """Amplitudes over the first parameter: a panel for each unit, a line for each value of the others."""
    first, *others = of.parameters
    x, units = of.array(first), dict(zip(of.results, of._texts("unit"), strict=True))
    panels = []
    for unit in dict.fromkeys(units[name] for name in names):
        lines = []
        for name in (one for one in names if units[one] == unit):
            amplitudes = of[name].reshape(len(x), -1)
            grids = np.meshgrid(*(of.array(one) for one in others), indexing="ij")
            for i in range(amplitudes.shape[1]):
                at = ", ".join(f"{one} {grid.ravel()[i]:.6g}" for one, grid in zip(others, grids, strict=True))
                lines.append(Line(f"{name}, {at}" if at else name, x, np.asarray(amplitudes[:, i])))
        panels.append(
            Panel(f"{first} [{of.unit(first) or '–'}]", _label(_quantity_words.get(unit, "amplitude"), unit), lines)
        )
    return _with_matplotlib(panels, of._title, ax)


#: Axes of the ground, to the right and up.
_views = {"front": (0, 2), "side": (1, 2), "top": (0, 1)}


def project(shown: Project, view: str, ax: Any) -> Any:
    """Bodies (centre of mass, points) and mounts of a project, seen along one axis of the ground."""
    if view not in _views:
        raise InputError([problem("view", f'"{view}"', "known are " + ", ".join(_views), "choose one of them")])
    right, up = _views[view]
    axes, figure = _axes_of(1, [5.0], ax)
    drawn = axes[0]
    for i, body in enumerate(shown.bodies.rows()):
        colour, centre = _colours[i % len(_colours)], body.in_ground(body.center_of_mass)
        for mount in shown.mounts.rows():
            if body.name in (mount.body, mount.base):
                line = (centre[right], mount.place[right]), (centre[up], mount.place[up])
                drawn.plot(*line, color=colour, linewidth=0.8, alpha=0.5)
        drawn.plot(centre[right], centre[up], "o", markersize=9, color=colour, label=body.name)
        for name, at in body.points.items():
            place = body.in_ground(at)
            drawn.plot(place[right], place[up], "x", color=colour)
            drawn.annotate(name, (place[right], place[up]), fontsize=8, xytext=(4, 4), textcoords="offset points")
    places = np.array([mount.place for mount in shown.mounts.rows()]).reshape(-1, 3)
    drawn.plot(places[:, right], places[:, up], "s", color="#555555", markersize=6, label="mounts")
    drawn.set_xlabel(f"{'xyz'[right]} [m]")
    drawn.set_ylabel(f"{'xyz'[up]} [m]")
    drawn.set_aspect("equal", adjustable="datalim")
    drawn.grid(True, color="#e4e4e4", linewidth=0.8)
    drawn.legend(fontsize=8, frameon=False)
    if ax is None:
        figure.suptitle(shown.title, fontsize=11)
    return figure


def _axes_of(count: int, heights: list[float], ax: Any) -> tuple[list[Any], Any]:
    """(axes of each panel, their figure): new ones, or those given; panels without axes are left out."""
    if ax is not None:
        given = list(np.atleast_1d(np.asarray(ax, dtype=object)).ravel())
        if not given or not all(hasattr(one, "get_figure") for one in given):
            rule = "it must be axes of Matplotlib, or a list of them"
            raise wrong_type("ax", ax, rule, "write figure, axes = plt.subplots()")
        return given[:count], given[0].get_figure()
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.6, sum(heights) + 0.7), layout="constrained")
    return list(figure.subplots(count, 1, squeeze=False, gridspec_kw={"height_ratios": heights})[:, 0]), figure


def _panels(result: Result, names: tuple[str, ...]) -> list[Panel]:
    if result.analysis == "modes":
        return _mode_panels(result)
    if result.analysis == "peaks":
        return _peak_panels(result, names)
    if result.analysis == "measurements":
        return _measurement_panels(result, names)
    curves = result.curves
    shown = names or [name for name in curves if result.analysis != "orders" or name.endswith(" rms")]
    chosen = [curves[name] for name in shown if name in curves]
    return _curve_panels(chosen, result._shown)


def _curve_panels(curves: list[Curve], shown: _core.DisplayUnits) -> list[Panel]:
    groups: dict[tuple[str, str], list[Curve]] = {}
    for curve in curves:
        groups.setdefault((curve.axis, curve.unit), []).append(curve)
    panels = []
    for (axis, unit), group in groups.items():
        panels.append(_amplitude_panel(axis, unit, group, shown))
        if all(np.iscomplexobj(curve.values) for curve in group):
            panels.append(_phase_panel(panels[-1], group))
    return panels


def _phase_panel(above: Panel, curves: list[Curve]) -> Panel:
    lines = [
        _without_jumps(Line(line.name, line.x, np.degrees(curve.phase)))
        for line, curve in zip(above.lines, curves, strict=True)
    ]
    return Panel(above.x_label, "phase [°]", lines, above.log_x, phase=True)


def _without_jumps(line: Line) -> Line:
    """The line with a gap where its angle passes ±180°."""
    jumps = np.flatnonzero(np.abs(np.diff(line.y)) > 180) + 1
    return Line(line.name, np.insert(line.x, jumps, np.nan), np.insert(line.y, jumps, np.nan))


def _angles(panel: Panel) -> tuple[float, float, list[int]]:
    """Range of a phase axis and its ticks: ±180°, or as far as a continuous phase goes, in half turns."""
    angles = np.concatenate([line.y[np.isfinite(line.y)] for line in panel.lines] or [np.zeros(1)])
    low = min(-180, 180 * int(np.floor((angles.min(initial=0) + 1e-6) / 180)))
    high = max(180, 180 * int(np.ceil((angles.max(initial=0) - 1e-6) / 180)))
    step = 90 if high - low <= 720 else 180 * -((low - high) // 1440)
    return low - 10, high + 10, list(range(low, high + 1, step))


def _amplitude_panel(axis: str, unit: str, curves: list[Curve], shown: _core.DisplayUnits) -> Panel:
    x_label, factor = _axis(axis, shown)
    harmonic = any(curve.harmonic for curve in curves)
    word = _level_words[shown.level] if harmonic and unit != "1" else _quantity_words.get(unit, "value")
    unit = unit.removesuffix(" p-p").removesuffix(" rms")  # the word says it
    per_axis, words = 1.0, unit
    if unit.endswith("/(rad/s)") and shown.frequency != "rad/s":  # a density is per hertz
        per_axis, word, words = 2 * np.pi, "density", unit.removesuffix("(rad/s)") + "Hz"
    positive = axis != "time" and all(np.all((y := _heights(curve))[np.isfinite(y)] >= 0) for curve in curves)
    lines = [Line(curve.name, curve.places * factor, _heights(curve) * per_axis) for curve in curves]
    return Panel(x_label, _label(word, words), lines, _spans_decades(lines[0].x), positive and axis != "speed")


def _label(word: str, unit: str) -> str:
    return f"{word} [{'–' if unit == '1' else unit}]"


def _heights(curve: Curve) -> Numbers:
    return curve.amplitude if np.iscomplexobj(curve.values) else curve.values


def _spans_decades(x: Numbers) -> bool:
    positive = x[x > 0]
    return len(positive) == len(x) > 1 and positive.max() / positive.min() > 50


def _axis(axis: str, shown: _core.DisplayUnits) -> tuple[str, float]:
    """Label of an axis, and the factor from SI. Frequencies are in Hz and speeds in rpm, as in the report, unless a
    unit was chosen."""
    if axis in ("angular_frequency", "speed"):
        unit = shown.frequency or ("Hz" if axis == "angular_frequency" else "rpm")
        return f"{_axis_words[axis]} [{unit}]", _core.in_unit(1.0, "rad/s", unit)
    return f"{_axis_words.get(axis, axis)} [{'s' if axis == 'time' else 'SI'}]", 1.0


def _mode_panels(result: Result) -> list[Panel]:
    x_label, factor = _axis("angular_frequency", result._shown)
    frequencies = result.array("angular_frequency") * factor
    numbers = np.arange(1, len(frequencies) + 1)
    return [Panel("mode", x_label, [Line("natural frequency", numbers, frequencies)], marks=True)]


def _peak_panels(result: Result, names: tuple[str, ...]) -> list[Panel]:
    table = {column.name: column.values for column in _tables.columns(result, result.tables[0])}
    x_label, factor = _axis("angular_frequency", result._shown)
    places = np.asarray(result.array("angular_frequency"), dtype=float) * factor
    panels = []
    for unit in dict.fromkeys(table["unit"]):
        lines = []
        for name in dict.fromkeys(table["name"]):
            rows = [
                i
                for i, (one, of) in enumerate(zip(table["name"], table["unit"], strict=True))
                if (one, of) == (name, unit)
            ]
            if rows and (not names or name in names):
                lines.append(
                    Line(str(name), places[rows], np.array([table["amplitude"][i] for i in rows], dtype=float))
                )
        if lines:
            plain = str(unit).removesuffix(" p-p").removesuffix(" rms")
            panels.append(
                Panel(x_label, _label(_level_words[result._shown.level], plain), lines, log_y=True, marks=True)
            )
    return panels


def _measurement_panels(result: Result, names: tuple[str, ...]) -> list[Panel]:
    """For each measured function its amplitude and phase, and the computed ones."""
    curves = result.curves
    panels = []
    for channel in result.array("channel"):
        pair = [curves[f"{channel} measured"], curves[f"{channel} computed"]]
        if not names or any(curve.name in names for curve in pair):
            panels += _curve_panels(pair, result._shown)
    return panels


def _with_matplotlib(panels: list[Panel], title: str, ax: Any = None) -> Any:
    all_axes, figure = _axes_of(len(panels), [2.6 if not panel.phase else 1.7 for panel in panels], ax)
    panels = panels[: len(all_axes)]
    if ax is None:
        figure.suptitle(title, fontsize=11)
    for axes, panel, following in zip(all_axes, panels, [*panels[1:], None], strict=True):
        for i, line in enumerate(panel.lines):
            style = {"color": _colours[i % len(_colours)], "label": line.name}
            if panel.marks:
                axes.plot(line.x, line.y, "o", markersize=5, **style)
                axes.vlines(line.x, *_stems(panel, line), color=style["color"], linewidth=1, alpha=0.6)
            else:
                axes.plot(line.x, line.y, linewidth=1.4, linestyle=_dashes[i // len(_colours) % 4], **style)
        axes.set_ylabel(panel.y_label)
        if following and following.phase:
            axes.tick_params(labelbottom=False)
        else:
            axes.set_xlabel(panel.x_label)
        if panel.log_x:
            axes.set_xscale("log")
        if panel.log_y:
            axes.set_yscale("log")
            if not panel.marks:
                axes.set_ylim(*_log_range(panel))
        if panel.phase:
            low, high, ticks = _angles(panel)
            axes.set_ylim(low, high)
            axes.set_yticks(ticks)
        if panel.marks and panel.x_label == "mode":
            axes.set_xticks(panel.lines[0].x)
        axes.grid(True, color="#e4e4e4", linewidth=0.8)
        axes.set_axisbelow(True)
        if not panel.phase and panel.x_label != "mode":
            axes.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)
    return figure


def _log_range(panel: Panel) -> tuple[float | None, float | None]:
    """Decades of a logarithmic axis: those of the values, at most eight."""
    heights = np.concatenate([line.y for line in panel.lines])
    heights = heights[np.isfinite(heights) & (heights > 0)]
    if len(heights) == 0:
        return None, None
    return max(heights.min(), _shown_decades * heights.max()) / 1.5, heights.max() * 1.5


def _stems(panel: Panel, line: Line) -> tuple[Any, Any]:
    """Ends of the vertical lines: from below the lowest mark of the panel."""
    lowest = min((float(np.nanmin(one.y)) for one in panel.lines if len(one.y)), default=0.0)
    return (np.full_like(line.y, lowest / 3) if panel.log_y else np.zeros_like(line.y)), line.y


def _with_plotly(panels: list[Panel], title: str) -> Any:
    from plotly.subplots import make_subplots

    figure = make_subplots(rows=len(panels), cols=1, vertical_spacing=0.32 / max(len(panels), 2))
    for row, panel in enumerate(panels, 1):
        with_phase = row < len(panels) and panels[row].phase
        for i, line in enumerate(panel.lines):
            figure.add_scatter(
                x=line.x, y=line.y, name=line.name, legendgroup=line.name, showlegend=not panel.phase,
                mode="markers" if panel.marks else "lines",
                line={"color": _colours[i % len(_colours)], "dash": _plotly_dashes[i // len(_colours) % 4], "simplify": False},
                marker={"color": _colours[i % len(_colours)]},
                row=row, col=1,
            )  # fmt: skip
        figure.update_xaxes(
            title=None if with_phase else panel.x_label, type="log" if panel.log_x else "linear", row=row, col=1
        )
        figure.update_yaxes(
            title=panel.y_label, type="log" if panel.log_y else "linear", exponentformat="power", row=row, col=1
        )
        low, high = _log_range(panel) if panel.log_y and not panel.marks else (None, None)
        if low is not None and high is not None:
            figure.update_yaxes(range=[np.log10(low), np.log10(high)], row=row, col=1)
        if panel.phase:
            low, high, ticks = _angles(panel)
            figure.update_yaxes(range=[low, high], tickvals=ticks, row=row, col=1)
    figure.update_layout(title=title, template="plotly_white", height=240 * len(panels) + 160)
    return figure

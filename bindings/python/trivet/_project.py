# SPDX-License-Identifier: BSD-3-Clause
"""A machine on its springs, checked, with its analyses."""

from __future__ import annotations

import errno
import os
import pathlib
import tomllib
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Literal

from trivet import _core, _errors, _html
from trivet._result import Result
from trivet._errors import InputError, MissingFile, WrongType, problem
from trivet._parts import Body, Mount, Parts, bodies, mounts, value_at
from trivet._progress import Progress, shown
from trivet._analyses import Analyses, _file
from trivet._study import Matrices, Run, StateSpace, Sweep
from trivet._arguments import (
    frequency,
    items,
    require_case_and_threads,
    require_text,
    swept_values,
    text_list,
    whole_number,
)
from trivet._values import key_text, plain, settings_of, toml_text
from trivet._whole_file import replace_file

if TYPE_CHECKING:
    from trivet._widget import Widget


class Project(Analyses):
    """A checked project. It does not change: `changed` gives another one. Two projects are equal if their content is.

    Project(bodies={"machine": {"mass": 12.5, …}}, elements={…}, …) takes the tables of the project file; `open` reads
    one.
    """

    _inner: _core.Project
    _folder: str  # absolute; names of files are relative to it
    _warned: set[str]  # warnings of this project and of those that it was changed from or to

    def __init__(self, /, **tables: Any) -> None:
        wrong: list[_core.Problem] = []
        document = plain({"trivet": 1, **tables}, "", wrong)
        if wrong:
            raise InputError(wrong)
        self._folder, self._warned = _folder_of(""), set()
        self._inner = _core.read(toml_text(document), "", [])  # lines of this text would mean nothing to its reader

    @classmethod
    def from_toml(cls, text: str, source: str = "project") -> Project:
        """The project of a text. Files that it names are relative to the folder of `source`."""
        require_text("text", text)
        require_text("source", source)
        return cls._read(text, source, [], _folder_of(source))

    @classmethod
    def _read(
        cls, text: str, source: str, settings: list[str], folder: str, progress: Progress | bool | None = None
    ) -> Project:
        """folder: to which names of files are relative, whatever the current folder is."""
        self = cls.__new__(cls)
        self._folder, self._warned = folder, set()
        with shown(progress) as callback:
            elsewhere = "" if folder == _folder_of(source) else folder
            self._inner = _core.read(text, source, settings, elsewhere, callback)
        return self

    @property
    def title(self) -> str:
        return self._inner.title

    @property
    def source(self) -> str:
        """Name of the project file; empty for a project from tables."""
        return self._inner.source

    @property
    def cases(self) -> list[str]:
        """Names of the cases, without the base model."""
        return self._inner.cases

    @property
    def bodies(self) -> Parts[Body]:
        """Names of the bodies; `project.bodies["machine"]` has their numbers."""
        return bodies(self._inner.parts[0], self._inner.model())

    @property
    def mounts(self) -> Parts[Mount]:
        """The elements as a table: name, type, the bodies that they join, place, stiffness along their axes."""
        return mounts(self._inner.model())

    def __getitem__(self, path: str) -> Any:
        """A value of the project file with its changes, as it stands there: a number in SI, a text with a unit, a list,
        a table. Paths are those of `changed`: project["bodies.machine.mass"]. Raises UnknownName."""
        require_text("path", path)
        return value_at(path, self._tables())

    def _tables(self) -> dict[str, Any]:
        return tomllib.loads(self._inner.to_toml())

    @property
    def elements(self) -> list[str]:
        return self._inner.parts[1]

    @property
    def excitations(self) -> list[str]:
        return self._inner.parts[2]

    def changed(self, changes: Mapping[str, Any]) -> Project:
        """The project with other values: {"elements.mount.scale": 1.5, "bodies.engine.mass": "412 kg"}. Paths are those
        of --set; a later change of a value replaces an earlier one. Raises InputError."""
        return self._with_settings(settings_of(changes))

    def _with_settings(self, new: Iterable[tuple[str, str]]) -> Project:
        of_text, settings = self, dict(setting.split(" = ", 1) for setting in self._inner.settings)
        for path, value in new:
            if any(path.startswith(earlier + ".") for earlier in settings):
                text = of_text._changed(settings).to_toml()
                of_text, settings = Project._read(text, self.source, [], self._folder), {}
                of_text._warned = self._warned
            settings = {one: old for one, old in settings.items() if one != path and not one.startswith(path + ".")}
            settings[path] = value
        return of_text._changed(settings)

    def _changed(self, settings: Mapping[str, str]) -> Project:
        """The project of the text with these settings in place of its own."""
        lines = [f"{path} = {value}" for path, value in settings.items()]
        if _folder_of(self.source) != self._folder:  # the current folder has changed since the project was read
            changed = Project._read(self._inner.text, self.source, lines, self._folder)
            changed._warned = self._warned
            return changed
        changed = type(self).__new__(type(self))
        changed._folder, changed._warned = self._folder, self._warned
        changed._inner = self._inner.changed(lines)
        return changed

    def to_toml(self) -> str:
        """The project file again, with the changes; its comments, order and format stay. Raises InputError for a change
        that its text cannot hold, such as a number in a table file."""
        return self._inner.to_toml()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the project file, the whole or nothing. Raises InputError if the project names files relative to
        another folder."""
        target, here = os.path.abspath(path), self
        if _folder_of(self.source) != self._folder:  # the current folder has changed since the project was read
            here = Project._read(self._inner.text, self.source, self._inner.settings, self._folder)
        replace_file(target, here._inner.to_toml(target))

    def _ask(
        self,
        command: str,
        own: dict[str, Any],
        keys: dict[str, Any],
        case: str,
        threads: int,
        progress: Progress | bool | None,
    ) -> Result:
        require_case_and_threads(case, threads)
        changed = self._with_keys(command, _given(keys))
        with shown(progress) as callback:
            return changed._result(_errors.answered(changed._inner, command, case, _given(own), threads, callback))

    def _with_keys(self, analysis: str, keys: dict[str, Any]) -> Project:
        """The project with other keys of one analysis."""
        if not keys:
            return self
        return self.changed({f"{_core.file_table(analysis)}.{key_text(key)}": value for key, value in keys.items()})

    def _result(self, core: _core.Result) -> Result:
        _errors.warn(core.warnings, self._warned)
        return Result(core, self)

    def map(
        self,
        *,
        points: int | tuple[int, int] | None = None,
        case: str = "",
        threads: int = 0,
        progress: Progress | bool | None = None,
        **keys: Any,
    ) -> Result:
        """Map of the requirements over two parameters: [analyses.map]. points: designs along both axes instead of those
        of the file. Other keywords replace its keys."""
        require_case_and_threads(case, threads)
        size = {} if points is None else {"points": _points(points)}
        changed = self._with_keys("map", keys)
        with shown(progress) as callback:
            return changed._result(_errors.answered(changed._inner, "map", case, size, threads, callback))

    def select(
        self, *, most: int = 10, by: str = "margin", threads: int = 0, progress: Progress | bool | None = None
    ) -> Result:
        """The mounts of a catalogue with the largest least margin, or of those that meet every requirement the first by
        "price", "mass" or "isolation"; `best` is the project with them."""
        require_case_and_threads("", threads)
        most = whole_number("most", most)
        with shown(progress) as callback:
            return self._result(
                _errors.answered(self._inner, "select", "", {"most": most, "by": by}, threads, callback)
            )

    def verdict(self, *, case: str = "", threads: int = 0, progress: Progress | bool | None = None) -> Result:
        """Is every requirement met in every case, which one governs, and by what margin? `case` judges this case alone."""
        require_case_and_threads(case, threads)
        with shown(progress) as callback:
            return self._result(_errors.answered(self._inner, "verdict", case, {}, threads, callback))

    def check(
        self, *, deep: bool = False, case: str = "", threads: int = 0, progress: Progress | bool | None = None
    ) -> Result:
        """All checks of the data, or of one case alone; with `deep` two independent solvers are compared."""
        require_case_and_threads(case, threads)
        with shown(progress) as callback:
            return self._result(_errors.answered(self._inner, "check", case, {"deep": bool(deep)}, threads, callback))

    def explain(
        self,
        of: str | Iterable[str] = (),
        *,
        most: int = 10,
        case: str = "",
        threads: int = 0,
        progress: Progress | bool | None = None,
    ) -> Result:
        """Causes of each resonance peak, and the parameters that change it. of: results; by default those of `peaks`."""
        require_case_and_threads(case, threads)
        names, most = text_list("of", of), whole_number("most", most)
        with shown(progress) as callback:
            return self._result(
                _errors.answered(self._inner, "explain", case, {"of": names, "most": most}, threads, callback)
            )

    def suspension(
        self,
        *,
        torques: Iterable[Iterable[float]] = (),
        excitations: Iterable[float | str] = (),
        case: str = "",
        progress: Progress | bool | None = None,
    ) -> Result:
        """Elastic centre, roll axes, decoupling and frequency separation. torques: moments, body axes. excitations:
        frequencies to compare with the natural ones, in rad/s or with units."""
        require_case_and_threads(case, 0)
        keys = {
            "torque": _torques(torques),
            "excitation": [frequency(f) for f in items("excitations", excitations)],
        }
        with shown(progress) as callback:
            return self._result(_errors.answered(self._inner, "suspension", case, keys, 0, callback))

    def element(
        self,
        name: str,
        *,
        all: bool = False,
        case: str = "",
        threads: int = 0,
        progress: Progress | bool | None = None,
    ) -> Result:
        """One element: its 12×12, checks, energy, and a comparison with three springs in its place."""
        require_case_and_threads(case, threads)
        require_text("name", name)
        with shown(progress) as callback:
            return self._result(
                _errors.answered(self._inner, "element", case, {"name": name, "all": bool(all)}, threads, callback)
            )

    def run(self, folder: str | os.PathLike[str], *, threads: int = 0, progress: Progress | bool | None = None) -> Run:
        """All analyses of the file in all cases: tables, pictures, results.json and report.html in a folder."""
        require_case_and_threads("", threads)
        with shown(progress) as callback:
            core = _errors.answered(self._inner, "run", "", {"output": os.fspath(folder)}, threads, callback)
        return Run(pathlib.Path(folder), {one.case: self._result(one) for one in core.cases})

    def export(
        self,
        path: str | os.PathLike[str],
        to: str | None = None,
        *,
        what: Iterable[str] = (),
        case: str = "",
        threads: int = 0,
        progress: Progress | bool | None = None,
    ) -> list[str]:
        """Writes matrices and results in a file of another program, and returns what that format loses.

        to: one of "matlab", "universal", "universal_binary", "nastran", "numpy", "hdf5", "excel", "fmu", "fmu3",
        "matrix_market", "csv"; by default by the ending of the path. what: "matrices" and names of analyses; by default
        what the format and the file have."""
        target = os.fspath(path)
        format_name = to or _formats_by_ending.get(pathlib.Path(target).suffix.lower(), "")
        if not format_name:
            known = ", ".join(name for name, _ in _core.formats())
            raise InputError([problem("to", target, "no format has this ending", f"name one: {known}")])
        require_case_and_threads(case, threads)
        keys = {"to": format_name, "output": target, "what": text_list("what", what)}
        with shown(progress) as callback:
            return _errors.answered(self._inner, "export", case, keys, threads, callback).remarks

    def matrices(self, *, case: str = "", progress: Progress | bool | None = None) -> Matrices:
        """A, B, K, the loads, and the names of the rows."""
        require_case_and_threads(case, 0)
        with shown(progress) as callback:
            core = _errors.answered(self._inner, "matrices", case, {}, 0, callback)
        _errors.warn(core.warnings, self._warned)
        return Matrices(core.arrays(), core.warnings)

    def state_space(
        self,
        of: str | Iterable[str] = "coordinates",
        *,
        quantity: str = "displacement",
        nearest: bool = False,
        case: str = "",
        progress: Progress | bool | None = None,
    ) -> StateSpace:
        """x' = A x + B u, y = C x + D u with inputs at the excitations and the results `of` as outputs.

        Inputs are forces and moments in the directions of the excitations [N, N m], and motions of the ground with
        their derivatives. Loss factors and frequency-dependent elements raise NotComputable; with `nearest` the nearest
        linear system takes the place of the latter."""
        require_case_and_threads(case, 0)
        require_text("quantity", quantity)
        with shown(progress) as callback:
            keys = {"of": text_list("of", of), "quantity": quantity, "nearest": bool(nearest)}
            core = _errors.answered(self._inner, "state_space", case, keys, 0, callback)
        _errors.warn(core.warnings, self._warned)
        return StateSpace(core.arrays(), core.warnings)

    def sweep(
        self,
        values: Mapping[str, Any],
        *,
        of: str | Iterable[str] = (),
        excitations: str | Iterable[str] = (),
        band: tuple[float | str, float | str] | None = None,
        quantity: str = "displacement",
        case: str = "",
        threads: int = 0,
        progress: Progress | bool | None = None,
    ) -> Sweep:
        """Largest amplitudes over all combinations of values of some numbers, without a loop in Python.

        values: {"elements.mount.scale": array, …}: numbers in SI, texts with units, or quantities of pint. of:
        results, excitations: those that act; by default those of `peaks`. band: frequencies in which amplitudes are
        sought, by default all."""
        require_case_and_threads(case, threads)
        require_text("quantity", quantity)
        names, arrays = swept_values(values)
        keys = {
            "paths": names,
            "values": arrays,
            "of": text_list("of", of),
            "excitations": text_list("excitations", excitations),
            "band": [] if band is None else [frequency(f) for f in items("band", band)],
            "quantity": quantity,
        }
        with shown(progress) as callback:
            core = _errors.answered(self._inner, "sweep", case, keys, threads, callback)
        _errors.warn(core.warnings, self._warned)
        return Sweep(core.arrays(), core.warnings, self.title)

    def plot(self, *, view: Literal["front", "side", "top"] = "front", ax: Any = None) -> Any:
        """Places of bodies, their points and the mounts, seen from the front (x, z), the side (y, z) or the top (x, y):
        a figure of Matplotlib. ax: axes to draw into."""
        from trivet import _plots

        return _plots.project(self, view, ax)

    def show(self, *, sliders: str | Iterable[str] = (), case: str = "") -> Widget:
        """The machine, its motions and its results in a notebook, with sliders. Needs the extra `trivet[notebook]`.

        sliders: paths of numbers of the file that get a slider from half to twice their value, besides those of
        [parameters]; without both, masses and stiffnesses get one. case: the case that is shown first. Raises
        UnknownName, InputError, and ModuleNotFoundError without anywidget."""
        try:
            from trivet._widget import Widget
        except ModuleNotFoundError as missing:
            remedy = 'project.show() needs anywidget: pip install "trivet[notebook]", or pip install anywidget'
            raise ModuleNotFoundError(remedy, name=missing.name) from missing
        return Widget(self, text_list("sliders", sliders), case)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Project) and self._inner.content == other._inner.content

    def __hash__(self) -> int:
        return hash(self._inner.content)

    def __reduce__(self) -> tuple[Any, tuple[str, str, list[str], str]]:
        return _unpickled, (self._inner.text, self.source, self._inner.settings, self._folder)

    def __copy__(self) -> Project:
        return self

    def __deepcopy__(self, memo: object) -> Project:
        return self

    def __repr__(self) -> str:
        changes = f", {len(self._inner.settings)} changed" if self._inner.settings else ""
        return f"<trivet.Project {self.title or self.source!r}: {len(self.bodies)} bodies, {len(self.elements)} elements{changes}>"

    def _repr_html_(self) -> str:
        return _html.project(self)


_formats_by_ending = {
    ".mat": "matlab", ".uff": "universal", ".unv": "universal", ".bdf": "nastran", ".nas": "nastran", ".npz": "numpy",
    ".h5": "hdf5", ".hdf5": "hdf5", ".xlsx": "excel", ".fmu": "fmu",
}  # fmt: skip


def open(
    path: str | os.PathLike[str],
    changes: Mapping[str, Any] | None = None,
    *,
    progress: Progress | bool | None = None,
) -> Project:
    """Reads and checks a project file. changes: as `Project.changed`. Raises InputError with all problems, MissingFile
    (which is a FileNotFoundError, too), OSError."""
    source = os.fspath(path)
    if isinstance(source, bytes):
        source = os.fsdecode(source)
    try:
        text = _core.read_text(source)
    except InputError as wrong:
        if os.path.exists(source):
            raise
        missing = MissingFile(wrong.problems)
        missing.errno, missing.filename = errno.ENOENT, source
        raise missing from None
    project = Project._read(text, source, [], _folder_of(source), progress)
    return project.changed(changes) if changes else project


def _unpickled(text: str, source: str, settings: list[str], folder: str) -> Project:
    return Project._read(text, source, settings, folder)


def _given(keys: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in keys.items() if value is not _file}


def _folder_of(source: str) -> str:
    """The absolute folder of a file; empty if the current folder does not exist any more."""
    try:
        return os.path.abspath(os.path.dirname(source))
    except OSError:
        return ""


def _points(points: int | tuple[int, int]) -> tuple[int, int]:
    pair = items("points", points) if isinstance(points, (tuple, list)) else [points, points]
    if len(pair) != 2:
        raise InputError([problem("points", points, "a map has two axes", "give one number, or two: (60, 40)")])
    nx, ny = whole_number("points", pair[0]), whole_number("points", pair[1])
    if nx < 2 or ny < 2:
        raise InputError([problem("points", points, "a map has 2 or more along each axis", "take more")])
    return nx, ny


def _torques(torques: Iterable[Iterable[float]]) -> list[list[float]]:
    try:
        return [[float(x) for x in torque] for torque in torques]
    except (TypeError, ValueError) as wrong:
        rule = "torques are moments of three numbers each"
        raise WrongType([problem("torques", type(torques).__name__, rule, "write [(0.9, 0, 0.1)]")]) from wrong

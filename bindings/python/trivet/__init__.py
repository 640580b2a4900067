# SPDX-License-Identifier: BSD-3-Clause
"""Vibration of bodies on real elastic elements.

    project = trivet.open("machine.toml")
    stiffer = project.changed({"elements.mount.scale": 1.5})
    peaks = stiffer.peaks().to_dataframe()
    stiffer.response(band=("0 Hz", "40 Hz")).plot()

Numbers are SI. Names, keys and messages are those of the project file and the command line.
"""

from trivet import _start
from trivet._result import Curve, Result
from trivet._core import Problem, schema, starter, version as __version__
from trivet._errors import InputError, MissingFile, ModelWarning, NotComputable, UnknownName, WrongType
from trivet._parts import Body, Mount, Parts
from trivet._project import Project, open
from trivet._study import Matrices, Run, StateSpace, Sweep
from trivet._tables import Table

Answer = Result  # its older name

__all__ = [
    "Answer",
    "Body",
    "Curve",
    "InputError",
    "Matrices",
    "MissingFile",
    "ModelWarning",
    "Mount",
    "NotComputable",
    "Parts",
    "Problem",
    "Project",
    "Result",
    "Run",
    "StateSpace",
    "Sweep",
    "Table",
    "UnknownName",
    "WrongType",
    "__version__",
    "open",
    "schema",
    "starter",
]

del _start

# SPDX-License-Identifier: BSD-3-Clause
"""Every function with wrong types, shapes, strides, numbers and deleted owners: an exception, never a crash."""

import gc
import math
import random
import warnings

import numpy as np
import pytest
from conftest import MACHINE

import trivet

SEED = 20261125
ROUNDS = 600

ODD = [
    None, True, False, 0, -1, 1, 2**31, 2**63, 2**200, -(2**70), 0.0, -0.0, 1e-320, 1e308, math.inf, -math.inf, math.nan,
    1j, "", "x", "12 Hz", "12 kg", "\0", "a\nb", "é", "\ud800", "machine.z", "machine", "a" * 100_000, b"bytes",
    [], [1], [1, 2, 3], [[1, 2], [3]], (), (0, 1), {}, {"a": 1}, {1: 2}, {"machine": {}}, set(), range(3), object(), int,
    np.float32(3), np.int8(-1), np.zeros(0), np.zeros((0, 3)), np.arange(12)[::-2], np.zeros((2, 2)).T, np.array("x"),
    np.array([1, "a"], dtype=object), np.array([np.nan, 1]), np.zeros(3, dtype=complex), np.zeros(3, ">f4"),
    np.array([], dtype="M8[s]"), iter([1, 2]), lambda *_: None, ...,
]  # fmt: skip

#: What a user may see.
ALLOWED = (trivet.InputError, trivet.NotComputable, TypeError, ValueError, OSError, OverflowError, AttributeError,
           KeyError, IndexError, RecursionError, ZeroDivisionError)  # fmt: skip


def callables(project: trivet.Project) -> list:
    analyses = [getattr(project, name) for name, _ in trivet._core.analyses()]
    others = [
        project.map, project.select, project.optimize, project.verdict, project.check, project.explain,
        project.suspension, project.element, project.matrices, project.state_space, project.sweep, project.changed,
        trivet.Project.from_toml, trivet.Project, trivet.open, project.response().to, project.response().array,
        project.response().__getitem__, project.response().plot, project.response().to_csv,
        project.response().to_dataframe, project.response().svg, project.matrices().load, project.matrices().array,
    ]  # fmt: skip
    return analyses + others


KEYS = ["case", "threads", "progress", "of", "band", "at", "quantity", "most", "deep", "all", "excitations", "torques",
        "values", "name", "bodies", "elements", "title", "length", "level", "backend", "source", "text"]  # fmt: skip


@pytest.mark.filterwarnings("ignore")
def test_odd_arguments_never_crash(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    choose = random.Random(SEED)
    project = trivet.Project(**MACHINE)
    functions = callables(project)
    raised = 0
    for _ in range(ROUNDS):
        function = choose.choice(functions)
        arguments = [choose.choice(ODD) for _ in range(choose.randrange(3))]
        keys = {key: choose.choice(ODD) for key in choose.sample(KEYS, choose.randrange(3))}
        keys.pop("threads", None) if choose.random() < 0.5 else None
        try:
            function(*arguments, **keys)
        except ALLOWED:
            raised += 1
    assert raised > ROUNDS / 2


@pytest.mark.filterwarnings("ignore")
def test_odd_values_never_crash():
    choose = random.Random(SEED)
    project = trivet.Project(**MACHINE)
    paths = [
        "bodies.machine.mass", "bodies.machine.inertia", "bodies.machine.inertia.xx", "elements.a.scale",
        "elements.a.damping", "elements.a.at", "elements.a.at.x", "excitations.force.force", "analyses.response.band",
        "gravity", "bodies", "elements", "title", "limits", "cases", "trivet", "analyses.map", "requirements",
    ]  # fmt: skip
    refused = 0
    for _ in range(ROUNDS):
        try:
            project.changed({path: choose.choice(ODD) for path in choose.sample(paths, choose.randrange(1, 3))})
        except (trivet.InputError, TypeError, ValueError, OverflowError):
            refused += 1
    assert refused > ROUNDS / 3


def test_core_refuses_wrong_types():
    core = trivet.Project(**MACHINE)._inner
    for odd in ODD:
        for call in (
            lambda odd=odd: core.ask(odd),
            lambda odd=odd: core.ask("response", odd),
            lambda odd=odd: core.ask("sweep", "", dict.fromkeys(("paths", "values", "of", "excitations", "band"), odd)),
            lambda odd=odd: core.ask("sweep", "", {"paths": ["bodies.machine.mass"], "values": [[1.0]], "band": odd}),
            lambda odd=odd: core.ask(odd, odd, odd, odd),
            lambda odd=odd: trivet._core.read(odd, "x", []),
            lambda odd=odd: trivet._core.read("", "x", odd),
            lambda odd=odd: trivet._core.in_unit(1.0, "m", odd),
        ):
            try:
                call()
            except ALLOWED + (RuntimeError,):
                pass


def test_sweep_with_paths_without_values():
    core = trivet.Project(**MACHINE)._inner
    with pytest.raises(trivet.InputError, match="a list of values for each path"):
        core.ask("sweep", "", {"paths": ["bodies.machine.mass", "elements.a.scale"], "values": [[1.0]]})


def test_deleted_owners():
    arrays = []
    for _ in range(50):
        result = trivet.Project(**MACHINE).response(at=[5.0, 10.0])
        arrays.append((result.array("machine.z"), result.array("machine.z").copy()))
        sweep = trivet.Project(**MACHINE).sweep({"bodies.machine.mass": [100.0, 120.0]})
        arrays.append((sweep.amplitude, sweep.amplitude.copy()))
        matrices = trivet.Project(**MACHINE).matrices()
        arrays.append((matrices.K, matrices.K.copy()))
        del result, sweep, matrices
    gc.collect()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for view, copy in arrays:
            np.testing.assert_array_equal(view, copy)

# SPDX-License-Identifier: BSD-3-Clause
"""Projects: from files, texts and tables; changes; content; pickles."""

import concurrent.futures
import copy
import os
import pickle
import threading

import numpy as np
import pint
import pytest
from conftest import MACHINE, example

import trivet


def frequencies(project: trivet.Project) -> np.ndarray:
    return project.modes().array("angular_frequency")


def test_tables_are_those_of_the_file(machine):
    read = trivet.Project.from_toml(machine.to_toml())
    assert read == machine
    assert hash(read) == hash(machine)
    assert machine.bodies == ["machine"]
    assert machine.elements == ["a", "b", "c", "d"]
    assert machine.excitations == ["force"]


def test_file_is_kept_as_it_is():
    path = example("genset/genset.toml")
    project = trivet.open(path)
    with open(path, encoding="utf-8") as file:
        assert project.to_toml() == file.read()


def test_changes_keep_comments_and_order():
    project = trivet.open(example("paper/map.toml")).changed({"bodies.aggregate.mass": 204.5})
    given = trivet.open(example("paper/map.toml")).to_toml().splitlines()
    changed = project.to_toml().splitlines()
    assert [line for line in changed if line not in given] == ["mass = 204.5"]
    assert trivet.Project.from_toml("\n".join(changed)) == project


def test_changes_do_not_change_the_project(machine):
    before = frequencies(machine).copy()
    stiffer = machine.changed({f"elements.{name}.scale": 4.0 for name in machine.elements})
    assert stiffer != machine
    np.testing.assert_array_equal(frequencies(machine), before)
    # all stiffnesses times four, and the same masses: all frequencies times two
    np.testing.assert_allclose(frequencies(stiffer), 2 * before, rtol=1e-12)


def test_later_changes_replace_earlier_ones(machine):
    once = machine.changed({"elements.a.scale": 3.0})
    twice = once.changed({"elements.a.scale": 2.0})
    assert twice == machine.changed({"elements.a.scale": 2.0})
    table = machine.changed({"elements.a.damping": {"loss_factor": 0.1}})
    component = table.changed({"elements.a.damping.loss_factor": 0.2})
    assert component == machine.changed({"elements.a.damping": {"loss_factor": 0.2}})


def test_quantities_and_texts_with_units(machine):
    units = pint.UnitRegistry()
    wanted = machine.changed({"bodies.machine.mass": 130.0, "elements.a.translation": [5e4, 5e4, 5e4]})
    assert machine.changed({"bodies.machine.mass": "130 kg", "elements.a.translation": [5e4] * 3}) == wanted.changed(
        {"bodies.machine.mass": "130 kg"}
    )
    given = machine.changed(
        {
            "bodies.machine.mass": units.Quantity(0.13, "tonne"),
            "elements.a.translation": units.Quantity(np.array([50.0, 50.0, 50.0]), "N/mm"),
        }
    )
    np.testing.assert_allclose(frequencies(given), frequencies(wanted), rtol=1e-14)
    response = machine.response(band=(0 * units.Hz, units.Quantity(40, "Hz")))
    assert response.frequency_hz[-1] == pytest.approx(40, rel=1e-15)


def test_copies_and_pickles_are_equal(machine, tmp_path):
    changed = machine.changed({"elements.a.scale": 1 / 3})
    for again in (copy.copy(changed), copy.deepcopy(changed), pickle.loads(pickle.dumps(changed))):
        assert again == changed
    np.testing.assert_array_equal(frequencies(pickle.loads(pickle.dumps(changed))), frequencies(changed))


def test_pickles_find_files_from_another_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(os.path.dirname(example("optical_table/table.toml")))
    pickled = pickle.dumps(trivet.open("table.toml"))
    monkeypatch.chdir(tmp_path)
    assert pickle.loads(pickled) == trivet.open(example("optical_table/table.toml"))


def test_process_pools(machine):
    projects = [machine.changed({"elements.a.scale": scale}) for scale in (0.5, 1.0, 2.0)]
    with concurrent.futures.ProcessPoolExecutor(2) as pool:
        for project, found in zip(projects, pool.map(frequencies, projects), strict=True):
            np.testing.assert_array_equal(found, frequencies(project))


def test_threads_share_a_project(machine):
    wanted, found, failures = machine.response().array("machine.z"), [], []

    def ask() -> None:
        try:
            found.extend(machine.response().array("machine.z") for _ in range(20))
        except Exception as error:  # noqa: BLE001
            failures.append(error)

    threads = [threading.Thread(target=ask) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures
    for curve in found:
        np.testing.assert_array_equal(curve, wanted)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork on this system")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")  # of fork in a process with threads, from Python 3.12 on
def test_fork(machine):
    before = machine.response().to_json()
    child = os.fork()
    if child == 0:
        same = False
        try:
            same = machine.response().to_json() == before
        finally:
            os._exit(0 if same else 1)
    assert os.waitpid(child, 0)[1] == 0


def test_save(machine, tmp_path):
    machine.save(tmp_path / "machine.toml")
    assert trivet.open(tmp_path / "machine.toml") == machine


def with_table(folder) -> trivet.Project:
    """A project whose mount has its stiffness in a file of the folder."""
    (folder / "force.csv").write_text("time,value\n0,0\n0.1,50\n1,0\n")
    push = {"type": "time", "on": "machine", "at": [0.05, 0, 0], "force": [0, 0, 1.0]}
    push["history"] = {"file": "force.csv"}
    return trivet.Project(**MACHINE | {"excitations": {"push": push}})


def test_tables_keep_their_folder(tmp_path, monkeypatch):
    (tmp_path / "a").mkdir()
    monkeypatch.chdir(tmp_path / "a")
    project = with_table(tmp_path / "a")
    pickled = pickle.dumps(project)
    monkeypatch.chdir(tmp_path)
    again = pickle.loads(pickled)
    assert again == project
    assert again.source == ""
    assert project.changed({"elements.a.scale": 2.0}) == again.changed({"elements.a.scale": 2.0})


def test_files_belong_to_the_content(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    project = with_table(tmp_path)
    assert with_table(tmp_path) == project
    pickled = pickle.dumps(project)
    (tmp_path / "force.csv").write_text("time,value\n0,0\n0.1,60\n1,0\n")
    assert pickle.loads(pickled) != project
    assert hash(pickle.loads(pickled)) != hash(project)


def test_save_does_not_lose_files(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    project = with_table(tmp_path)
    (tmp_path / "other").mkdir()
    with pytest.raises(trivet.InputError, match="write it to a file in the folder of the project"):
        project.save(tmp_path / "other" / "machine.toml")
    monkeypatch.chdir(tmp_path / "other")
    with pytest.raises(trivet.InputError, match=f"write it to a file in {tmp_path}"):
        project.save("machine.toml")
    assert list((tmp_path / "other").iterdir()) == []
    project.save(tmp_path / "machine.toml")
    assert trivet.open(tmp_path / "machine.toml") == project


def test_save_replaces_the_whole_file(machine, tmp_path, monkeypatch):
    target = tmp_path / "machine.toml"
    target.write_text("before")

    def full(*_: object) -> None:
        raise OSError("no space")

    with monkeypatch.context() as patched:
        patched.setattr(os, "replace", full)
        with pytest.raises(OSError, match="no space"):
            machine.save(target)
    assert [file.name for file in tmp_path.iterdir()] == ["machine.toml"]
    assert target.read_text() == "before"
    target.chmod(0o640)
    machine.save(target)
    assert target.stat().st_mode & 0o777 == 0o640


def test_quotes_of_paths_do_not_matter(machine):
    twice = machine.changed({'elements."a".scale': 2.0}).changed({"elements.a.scale": 3.0})
    assert twice == machine.changed({"elements . 'a' . scale": 3.0})


def test_memory_of_open_and_close_is_flat():
    import gc

    def resident() -> int:
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def cycle(count: int) -> None:
        for _ in range(count):
            trivet.Project(**MACHINE).peaks()

    cycle(300)
    gc.collect()
    before = resident()
    cycle(1000)
    gc.collect()
    assert resident() - before < 2e6  # 2 kB a cycle; a project has more


def test_a_gram_of_pint_is_no_acceleration(machine):
    units = pint.UnitRegistry()
    with pytest.raises(trivet.InputError, match="gravity"):
        machine.changed({"gravity": np.array([0, 0, -1.0]) * units.gram})
    falling = machine.changed({"gravity": np.array([0, 0, -1.0]) * units.standard_gravity})
    assert falling == machine.changed({"gravity": [0, 0, "-9.80665 m/s^2"]}) or "9.80665" in falling.to_toml()
    light = machine.changed({"bodies.machine.mass": 1e5 * units.gram})
    assert light.matrices().A[0, 0] == pytest.approx(100, rel=1e-14)

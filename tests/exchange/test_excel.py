# SPDX-License-Identifier: BSD-3-Clause
"""Excel workbooks, read back by openpyxl and converted by LibreOffice."""

import pathlib
import subprocess

import openpyxl
import pytest
from conftest import ROOT, Program


def columns(sheet) -> dict[str, list]:
    rows = list(sheet.iter_rows(values_only=True))
    return {heading: [row[i] for row in rows[1:]] for i, heading in enumerate(rows[0])}


def test_sheets(program, tmp_path):
    program.export("excel", tmp_path / "machine.xlsx")
    book = openpyxl.load_workbook(tmp_path / "machine.xlsx")
    assert book.sheetnames[0] == "input"
    table = columns(book["input"])
    assert table["value"][table["key"].index('bodies."pump 1".mass')] == "180"
    modes = columns(book["modes"])
    expected = [mode["angular_frequency"] for mode in program.json("modes")["modes"]]
    assert modes["angular_frequency [rad/s]"] == pytest.approx(expected, rel=1e-15)
    assert [heading for heading in modes if heading.startswith("frequency")] == ["frequency [Hz]"]
    peaks = columns(book["peaks"])
    found = program.json("peaks")["peaks"]
    assert [amplitude for amplitude in peaks["amplitude [unit of the row]"] if amplitude is not None] == pytest.approx(
        [peak["amplitude"] for peak in found], rel=1e-14
    )
    response = columns(book["response"])
    given = program.json("response")
    assert response["frequency [Hz]"][-1] == pytest.approx(30, rel=1e-14)
    assert len(response["raft.z amplitude [m]"]) == len(given["angular_frequency"])
    charts = book["charts"]._charts
    assert len(charts) == 4  # m, rad, N, N m
    assert all(len(chart.series) > 0 for chart in charts)


@pytest.mark.parametrize("case", [0, 1])
def test_requirements(tmp_path, case):
    program = Program(ROOT / "examples" / "genset" / "load_cases.toml")
    judged = program.json("verdict")["cases"][case]
    arguments = ("--case", judged["case"]) if case else ()
    program.export("excel", tmp_path / "genset.xlsx", "--what", "static", *arguments)
    table = columns(openpyxl.load_workbook(tmp_path / "genset.xlsx")["requirements"])
    given = judged["requirements"]
    assert [words.removesuffix(" 0-p") for words in table["requirement"]] == [
        row["requirement"].removesuffix(" 0-p") for row in given
    ]
    assert len(table["margin"]) == len(given) > 0
    assert {"met": True, "VIOLATED": False}[table["verdict"][0]] == given[0]["met"]


def test_a_requirement_that_is_not_judged(with_text, tmp_path, program):
    lossy = program.path.read_text().replace("proportional = 5e-7", "loss_factor = 0.1")
    step = '[excitations.s]\ntype = "time"\non = "raft"\nat = [0, 0, 0]\nforce = [0, 0, 1]\nhistory = {step = {amplitude = 50}}\n'
    request = with_text(lossy + step + '[requirements]\nlargest = {"raft.z" = "1 mm"}\n')
    request.export("excel", tmp_path / "out.xlsx", "--what", "modes")
    table = columns(openpyxl.load_workbook(tmp_path / "out.xlsx")["requirements"])
    assert table["verdict"] == ["NOT JUDGED"] and table["reason"][0]
    assert table["margin"] == [None]


def test_power_over_frequency_in_columns_by_name(program, tmp_path):
    program.export("excel", tmp_path / "out.xlsx", "--what", "power")
    book = openpyxl.load_workbook(tmp_path / "out.xlsx")
    table = columns(book["power"])
    given = program.json("power")
    for element in given["elements"]:
        assert table[f"dissipated {element['name']} [W]"] == pytest.approx(element["dissipated"], rel=1e-14)
    for mount in given["mounts"]:
        assert table[f"into_ground {mount['name']} [W]"] == pytest.approx(mount["into_ground"], rel=1e-14)


def test_values_without_an_axis(program, tmp_path):
    program.export("excel", tmp_path / "out.xlsx", "--what", "peaks")
    table = columns(openpyxl.load_workbook(tmp_path / "out.xlsx")["peaks values"])
    assert table["name"] == ["searched_from", "searched_to"]
    assert table["value"] == [0, "infinite"]
    assert table["unit"] == ["rad/s", "rad/s"]


def test_libreoffice(program, tmp_path):
    program.export("excel", tmp_path / "machine.xlsx")
    subprocess.run(["soffice", "--headless", "--convert-to", "csv:Text - txt - csv (StarCalc):44,34,76,1,,0,false,true,"
                    "false,false,false,-1", "machine.xlsx"], cwd=tmp_path, check=True, capture_output=True)  # fmt: skip
    written = sorted(pathlib.Path(tmp_path).glob("machine-*.csv"))
    assert len(written) == len(openpyxl.load_workbook(tmp_path / "machine.xlsx").sheetnames)


def test_units_and_levels_of_the_display(with_text, program, tmp_path):
    """Amplitudes have a level, roots and modes have none, and every frequency has the unit of frequencies."""
    shown = '\n[display]\nlength = "in"\nangle = "deg"\nfrequency = "rpm"\nlevel = "peak_to_peak"\n'
    request = with_text(program.path.read_text() + shown + '[analyses.shapes]\nat = ["8 Hz"]\n')
    request.export("excel", tmp_path / "out.xlsx", "--what", "peaks,roots,shapes")
    book = openpyxl.load_workbook(tmp_path / "out.xlsx")
    inch = 0.0254
    values = columns(book["peaks values"])
    assert values["unit"] == ["rpm", "rpm"]
    assert {unit for unit in columns(book["peaks"])["unit"] if unit} <= {"in p-p", "deg p-p", "N p-p", "N in p-p"}
    found = request.json("shapes")["shapes"][0]
    shape = columns(book["shapes"])
    assert shape["largest_excursion [in p-p]"][0] == pytest.approx(2 * found["largest_excursion"] / inch)
    assert not any("p-p" in heading for heading in columns(book["roots"]))


def test_shapes_have_the_units_of_their_columns(program, tmp_path):
    program.export("excel", tmp_path / "out.xlsx", "--what", "modes,roots,peaks")
    book = openpyxl.load_workbook(tmp_path / "out.xlsx")
    assert "shape raft.x [1/√kg]" in columns(book["modes"])
    assert "shape raft.rx amplitude [rad/m]" in columns(book["roots"])
    assert "amplitude [unit of the row]" in columns(book["peaks"])

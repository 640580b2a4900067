# SPDX-License-Identifier: BSD-3-Clause
"""Excel workbooks, read back by openpyxl and converted by LibreOffice."""

import pathlib
import shutil
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


def test_requirements(tmp_path):
    program = Program(ROOT / "examples" / "genset" / "load_cases.toml")
    program.export("excel", tmp_path / "genset.xlsx", "--what", "static")
    table = columns(openpyxl.load_workbook(tmp_path / "genset.xlsx")["requirements"])
    given = [row for case in program.json("verdict")["cases"] for row in case["requirements"]]
    assert table["requirement"] == [row["requirement"] for row in given]
    assert len(table["margin"]) == len(given) > 0


@pytest.mark.skipif(shutil.which("soffice") is None, reason="LibreOffice is not installed")
def test_libreoffice(program, tmp_path):
    program.export("excel", tmp_path / "machine.xlsx")
    subprocess.run(["soffice", "--headless", "--convert-to", "csv:Text - txt - csv (StarCalc):44,34,76,1,,0,false,true,"
                    "false,false,false,-1", "machine.xlsx"], cwd=tmp_path, check=True, capture_output=True)  # fmt: skip
    written = sorted(pathlib.Path(tmp_path).glob("machine-*.csv"))
    assert len(written) == len(openpyxl.load_workbook(tmp_path / "machine.xlsx").sheetnames)

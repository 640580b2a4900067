# SPDX-License-Identifier: BSD-3-Clause
"""Numbers of results: views without a copy, tables, units, pictures of themselves."""

import gc
import json

import numpy as np
import pytest
from conftest import MACHINE, example

import trivet


def address(array: np.ndarray) -> int:
    return array.__array_interface__["data"][0]


def test_curves_are_views_of_the_core(machine):
    result = machine.response()
    first, again = result._core.arrays(), result._core.arrays()
    for (name, _, _, one), (_, _, _, other) in zip(first, again, strict=True):
        if isinstance(one, np.ndarray):
            assert address(one) == address(other), name
            assert not one.flags.writeable
            assert not one.flags.owndata
    assert address(result["machine.z"].complex) == address(result.array("machine.z"))
    with pytest.raises(ValueError, match="read-only"):
        result.array("machine.z")[0] = 0


def test_views_outlive_the_project():
    curve = trivet.Project(**MACHINE).response()["machine.z"]
    values = curve.complex.copy()
    gc.collect()
    trivet.Project(**MACHINE).response()
    np.testing.assert_array_equal(curve.complex, values)


def test_curve(machine):
    curve = machine.response(band=(1.0, 200.0))["machine.z"]
    assert curve.unit == "m"
    np.testing.assert_array_equal(curve.amplitude, abs(curve.complex))
    np.testing.assert_array_equal(curve.frequency_hz, curve.angular_frequency / (2 * np.pi))
    assert np.all((curve.phase > -np.pi) & (curve.phase <= np.pi))
    np.testing.assert_allclose(curve.amplitude * np.exp(1j * curve.phase), curve.complex, rtol=1e-14)
    np.testing.assert_array_equal(np.asarray(curve), curve.complex)
    with pytest.raises(trivet.InputError, match="curve over angular_frequency"):
        _ = curve.time


def test_tables_have_all_digits(machine):
    result = machine.response(at=[10.0, 37.1])
    table = result.to_dataframe()
    np.testing.assert_array_equal(table["machine.z re [m]"], result.array("machine.z").real)
    peaks = machine.peaks()
    np.testing.assert_array_equal(peaks.to_dataframe()["amplitude"], peaks.array("amplitude"))


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
@pytest.mark.parametrize(
    ("path", "analysis"),
    [
        ("paper/corrected.toml", "modes"),
        ("paper/corrected.toml", "roots"),
        ("paper/corrected.toml", "response"),
        ("paper/corrected.toml", "peaks"),
        ("genset/load_cases.toml", "static"),
        ("track/bogie.toml", "random"),
        ("transport_shock/device.toml", "transient"),
        ("transport_shock/device.toml", "shock_spectrum"),
        ("genset/genset.toml", "orders"),
        ("genset/genset.toml", "power"),
        ("genset/genset.toml", "shapes"),
        ("optical_table/table.toml", "transmissibility"),
        ("genset/genset.toml", "limit_lines"),
        ("measured_response/machine.toml", "measurements"),
        ("paper/map.toml", "map"),
        ("powertrain/decoupled.toml", "optimize"),
    ],
)
def test_xarray_has_every_array_with_axes_and_units(path, analysis):
    result = getattr(trivet.open(example(path)), analysis)()
    data = result.to_xarray()
    assert len(result.names) > 0
    for name in result.names:
        variable = data[name]
        assert variable.dims == result.axes(name)
        if variable.dtype.kind in "fc":
            assert variable.attrs["units"] == result.unit(name)
            np.testing.assert_array_equal(variable.values, result.array(name))
    assert not result.to_dataframe().empty
    assert result._repr_html_().count("<table") == 1
    assert repr(result).startswith(f"<trivet.Result {analysis}")
    assert len(str(result)) > 40


def test_other_units(machine):
    result = machine.response(band=(1.0, 200.0))
    shown = result.to(frequency="rpm", length="in", force="lbf", level="peak_to_peak")
    inch = 0.0254
    curve, si = shown["machine.z"], result["machine.z"]
    assert curve.unit == "in p-p"
    np.testing.assert_allclose(curve.amplitude, 2 * si.amplitude / inch, rtol=1e-15)
    np.testing.assert_allclose(curve.complex, 2 * si.complex / inch, rtol=1e-15)
    assert "|machine.z| [in p-p]" in str(shown) and "in p-p" not in str(result)
    table = shown.to_dataframe()
    np.testing.assert_allclose(table["frequency [rpm]"], result.angular_frequency * 30 / np.pi, rtol=1e-15)
    np.testing.assert_allclose(table["machine.z amplitude [in p-p]"], curve.amplitude, rtol=1e-15)
    np.testing.assert_allclose(table["machine.z re [in p-p]"], curve.complex.real, rtol=1e-15)
    np.testing.assert_array_equal(shown.array("machine.z"), result.array("machine.z"))  # arrays stay SI
    assert shown.to_json() == result.to_json()
    peaks = machine.peaks()
    rms = peaks.to(length="mm", level="rms", frequency="rpm").to_dataframe().query("unit == 'mm rms'")
    metres = peaks.to_dataframe().query("unit == 'm'")
    for name in ("amplitude", "prominence"):
        np.testing.assert_allclose(rms[name], metres[name] * 1000 / np.sqrt(2), rtol=1e-14)
    uncertainty = "angular_frequency_uncertainty"
    if f"{uncertainty} [rad/s]" in metres:
        np.testing.assert_allclose(rms["frequency_uncertainty [rpm]"], metres[f"{uncertainty} [rad/s]"] * 30 / np.pi)
    with pytest.raises(trivet.InputError, match="unit of length") as wrong:
        result.to(length="s", level="peak", colour="red")
    assert len(wrong.value.problems) == 3


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
def test_units_of_columns_that_name_no_unit_themselves():
    verdict = trivet.open(example("genset/load_cases.toml")).verdict()
    si, shown = verdict.to_dataframe(), verdict.to(length="in", force="lbf", level="peak_to_peak").to_dataframe()
    factor = {"m": 1 / 0.0254, "m/s": 1 / 0.0254, "N": 1 / 4.4482216152605}
    for unit, kind, allowed, value, new, new_allowed, new_value in zip(
        si["unit"], si["kind"], si["allowed"], si["value"], shown["unit"], shown["allowed"], shown["value"], strict=True
    ):
        level = 2 if kind in ("amplitude", "mount_dynamic_deflection") else 1
        assert new.endswith(" p-p") == (level == 2)
        assert new_allowed == pytest.approx(level * factor.get(unit, 1) * allowed, rel=1e-12)
        assert value is None or new_value == pytest.approx(level * factor.get(unit, 1) * value, rel=1e-12)
    assert {"m", "N"} & set(si["unit"])
    measured = trivet.open(example("measured_response/machine.toml")).measurements()
    peaks, rpm = measured.to_dataframe("measured_peaks.csv"), measured.to(frequency="rpm", length="mm")
    rpm = rpm.to_dataframe("measured_peaks.csv")
    turns = 30 / np.pi
    np.testing.assert_allclose(rpm["measured at [rpm]"], peaks["measured at [rad/s]"] * turns, rtol=1e-14)
    assert list(rpm["unit"]) != list(peaks["unit"])
    scale = rpm["measured amplitude"] / peaks["measured amplitude"]
    np.testing.assert_allclose(scale, [1000 if unit.startswith("m") else 1 for unit in peaks["unit"]], rtol=1e-12)
    np.testing.assert_allclose(rpm["computed amplitude"] / peaks["computed amplitude"], scale, rtol=1e-12)


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
def test_frequencies_of_all_columns_have_the_unit_of_the_axis():
    project = trivet.open(example("frame/frame.toml"))
    roots, modes = project.roots().to(frequency="Hz"), project.modes().to(frequency="rpm")
    table, si = roots.to_dataframe(), project.roots().to_dataframe()
    np.testing.assert_allclose(table["imaginary [Hz]"], si["imaginary [rad/s]"] / (2 * np.pi), rtol=1e-14)
    assert "frequency [rpm]" in modes.to_dataframe() and "frequency [Hz]" not in modes.to_dataframe()
    assert list(modes.to_dataframe()).count("frequency [rpm]") == 1
    assert not any("angular_frequency [" in name for name in (*modes.to_dataframe(), *table))
    assert "angular_frequency_squared [rad2/s2]" in project.modes().to_dataframe()
    np.testing.assert_allclose(
        modes.to_dataframe()["frequency [rpm]"], project.modes().to_dataframe()["frequency [Hz]"] * 60, rtol=1e-14
    )
    random = trivet.open(example("track/bogie.toml")).random().to(length="in")
    densities = random.to_dataframe("densities.csv")
    assert "frame.x [(in/s²)²/Hz]" in densities


def test_unknown_result_has_a_nearest_name(machine):
    with pytest.raises(trivet.InputError, match=r'did you mean "machine.z"'):
        _ = machine.response()["machine.zz"]


def test_json_is_that_of_the_documents(machine):
    found = machine.modes().to_dict()
    assert found == json.loads(machine.modes().to_json())
    assert len(found["modes"]) == 6


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
@pytest.mark.parametrize(
    ("path", "analysis", "words"),
    [
        ("genset/load_cases.toml", "verdict", "in"),
        ("genset/load_cases.toml", "check", "lbf"),
        ("track/bogie.toml", "random", "in/s²"),
        ("genset/genset.toml", "orders", "in/s"),
    ],
)
def test_print_follows_the_units(path, analysis, words):
    result = getattr(trivet.open(example(path)), analysis)()
    shown = result.to(length="in", force="lbf", level="peak_to_peak")
    assert f" {words}" in str(shown).replace("|", " ").replace("[", " ")
    assert str(shown) != str(result)


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
@pytest.mark.parametrize(
    ("path", "analysis"),
    [
        ("paper/map.toml", "map"),
    ],
)
def test_print_that_does_not_convert_says_so(path, analysis):
    result = getattr(trivet.open(example(path)), analysis)().to(length="in")
    with pytest.raises(trivet.InputError, match="its text is not converted"):
        str(result)
    assert "In SI units" in result._repr_html_() or not result.tables or result._core.tables_convert
    if result.tables and not result._core.tables_convert:
        with pytest.raises(trivet.InputError, match="its tables are not converted"):
            result.to_dataframe()


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
@pytest.mark.parametrize(
    ("path", "analysis", "table", "quantities"),
    [
        ("track/bogie.toml", "random", "random.csv", ["rms", "three_sigma", "rms_of_derivative", "weighted_rms"]),
        ("measured_response/machine.toml", "measurements", "measured_curves.csv", ["measured re", "computed im"]),
        ("two_stage/pump_on_raft.toml", "explain", "explain.csv", ["amplitude"]),
        ("paper/corrected.toml", "peaks", "peaks.csv", ["amplitude", "prominence"]),
    ],
)
def test_quantities_of_rows_follow_the_unit_of_their_row(path, analysis, table, quantities):
    result = getattr(trivet.open(example(path)), analysis)()
    si, inches = result.to_dataframe(table), result.to(length="in").to_dataframe(table)
    assert any("in" in unit for unit in inches["unit"])
    for name in quantities:
        column = next(heading for heading in si.columns if heading.split(" [")[0] == name)
        factor = [1 / 0.0254 if new != old else 1 for old, new in zip(si["unit"], inches["unit"], strict=True)]
        np.testing.assert_allclose(inches[column].astype(float), si[column].astype(float) * factor, rtol=1e-14)


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
def test_words_with_a_unit_in_their_heading_stay_in_it():
    lines = trivet.open(example("genset/genset.toml")).limit_lines()
    si, rpm = lines.to_dataframe(), lines.to(frequency="rpm").to_dataframe()
    assert si["compared [Hz]"].tolist() == rpm["compared [Hz]"].tolist()
    assert rpm["at [rpm]"][0] == pytest.approx(si["at [rad/s]"][0] * 30 / np.pi)


def test_html_has_the_tables_of_the_text(machine):
    peaks = machine.peaks()
    assert f"{peaks.array('angular_frequency')[0] / (2 * np.pi):.7g}" in peaks.to_html()
    assert "[rpm]" in peaks.to(frequency="rpm").to_html() and "[rpm]" not in peaks.to_html()
    with pytest.raises(trivet.InputError, match="no tables for a page"):
        machine.check().to_html()


def test_the_optimum_is_shown_in_other_units():
    optimum = trivet.open(example("powertrain/decoupled.toml")).optimize()
    assert "given [Hz]" in str(optimum) and "given [rpm]" in str(optimum.to(frequency="rpm"))
    assert optimum.to(length="in").to_dataframe().equals(optimum.to_dataframe())  # parameters: the units of the file


def test_curves_do_not_change(machine):
    curve = machine.response()["machine.z"]
    for name in ("name", "unit"):
        with pytest.raises(AttributeError):
            setattr(curve, name, "x")


def test_requirements_say_their_bound_in_the_shown_unit():
    verdict = trivet.open(example("genset/load_cases.toml")).verdict()
    table = verdict.to(length="in", frequency="rpm", level="peak_to_peak").to_dataframe()
    assert "frequency [rpm]" in table.columns
    bounds = [
        (row.requirement, f"≤ {row.allowed:.4g} {row.unit}") for row in table.itertuples() if row.unit.endswith(" p-p")
    ]
    assert bounds and all(words.endswith(bound) for words, bound in bounds)
    si = verdict.to_dataframe()
    assert [words.split("≤")[0] for words in si.requirement] == [words.split("≤")[0] for words in table.requirement]


def test_operating_shapes_have_units_and_a_level(machine):
    result = machine.shapes(at=["8 Hz", "9 Hz"])
    shown = result.to(length="in", level="peak_to_peak")
    si, table = result.to_dataframe(), shown.to_dataframe()
    np.testing.assert_allclose(table["z re [in p-p]"], 2 / 0.0254 * si["z re [m]"], rtol=1e-14)
    np.testing.assert_allclose(table["rx im [rad p-p]"], 2 * si["rx im [rad]"], rtol=1e-14)
    curve = shown.curves["largest_excursion"]
    assert curve.unit == "in p-p"
    np.testing.assert_allclose(curve.values, 2 / 0.0254 * result.array("largest_excursion"), rtol=1e-14)


def test_tables_keep_words_and_shown_units():
    """Names that look like numbers stay words, and every column of a unit is converted."""
    named = trivet.Project(
        **MACHINE
        | {
            "cases": {"1": {"elements": {"a": {"scale": 2.0}}}, "2": {"elements": {"a": {"scale": 3.0}}}},
            "requirements": {"damping_ratio": 1e-4},
        }
    )
    verdict = named.verdict()
    assert set(verdict.to_dataframe()["case"]) == {"", "1", "2"}
    assert "frequency [rpm]" in verdict.to(frequency="rpm").to_dataframe().columns


def test_speeds_in_rpm_appear_once():
    orders = trivet.open(example("genset/genset.toml")).orders()
    table = orders.to(frequency="rpm").to_dataframe("critical_speeds")
    assert list(table.columns).count("speed [rpm]") == 1
    np.testing.assert_allclose(table["speed [rpm]"], orders.to_dataframe("critical_speeds")["speed [rpm]"], rtol=1e-12)


def test_angular_velocities_are_no_frequencies(machine):
    shaken = trivet.Project(
        **MACHINE
        | {
            "excitations": {
                "road": {
                    "type": "random",
                    "on": "machine",
                    "at": [0.05, 0.1, 0],
                    "force": [0, 0, 1],
                    "psd": {"flat": 1.0, "band": ["1 Hz", "60 Hz"]},
                }
            }
        }
    )
    result = shaken.random(of=["machine.rx"], quantity="velocity")
    si = result.to_dataframe()
    assert result.to(frequency="rpm").to_dataframe()["unit"].tolist() == ["rad/s"]
    degrees = result.to(angle="deg").to_dataframe()
    assert degrees["unit"].tolist() == ["deg/s"]
    np.testing.assert_allclose(degrees["rms"], np.degrees(si["rms"]), rtol=1e-14)


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
def test_earthquake_tables_are_converted(machine):
    spectrum = {"direction": "z", "rows": [[0.01, 3.0], [2, 0.75]], "damping": 0.00548}
    result = machine.earthquake(**spectrum)
    si, inches = result.to_dataframe(), result.to(length="in").to_dataframe()
    lengths = si["unit"] == "m"
    assert lengths.any() and (inches["unit"][lengths] == "in").all()
    np.testing.assert_allclose(inches["cqc"][lengths], si["cqc"][lengths] / 0.0254, rtol=1e-14)


def test_pictures_of_real_amplitudes_have_their_level(machine):
    shown = machine.shapes(at=["8 Hz", "9 Hz"]).to(level="peak_to_peak")
    figure = shown.plot("largest_excursion")
    assert "peak to peak" in figure.axes[0].get_ylabel()

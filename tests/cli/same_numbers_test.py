# SPDX-License-Identifier: BSD-3-Clause
"""One description: the numbers of text, report, CSV and arrays are those of the JSON.

Every number that a person sees is a number of the JSON of the same command, through the factor of its unit (Hz, rpm, %, dB,
degrees, prefixes) and within its printed digits, or follows from its numbers by a rule of `derived`. Numbers of CSV and arrays
have all their digits. Names and sentences that the JSON has as texts are removed from the text before."""
import ast
import bisect
import csv
import functools
import html.parser
import io
import json
import math
import os
import pathlib
import re
import struct
import subprocess
import tempfile
import unittest
import zipfile

from trivet_test import HANGS_AFTER

TRIVET = os.environ["TRIVET"]
EXAMPLES = pathlib.Path(os.environ["TRIVET_SOURCE"]) / "examples"

# Every command that shows numbers, each on an example of a second or less.
COMMANDS = [
    ("modes", "three_coil_springs/machine.toml"),
    ("roots", "paper/corrected.toml"),
    ("response", "paper/corrected.toml"),
    ("peaks", "genset/genset.toml"),
    ("static", "genset/load_cases.toml"),
    ("operation", "fan/fan.toml"),
    ("random", "optical_table/table.toml"),
    ("transient", "transport_shock/device.toml"),
    ("orders", "roll_stop/idle.toml"),
    ("transmissibility", "genset/mounts.toml"),
    ("power", "genset/genset.toml"),
    ("shapes", "genset/genset.toml"),
    ("steady", "isolator/hardening.toml"),
    ("backbone", "isolator/hardening.toml"),
    ("shock_spectrum", "transport_shock/device.toml"),
    ("limit_lines", "genset/genset.toml"),
    ("measurements", "measured_response/machine.toml"),
    ("explain", "free_pair/coupled_bodies.toml"),
    ("suspension", "genset/genset.toml"),
    ("map", "paper/map.toml"),
    ("verdict", "genset/mounts.toml"),
    ("optimize", "powertrain/decoupled.toml"),
    ("select", "genset/mounts.toml"),
    ("sample", "paper/robust.toml"),
    ("element", "three_coil_springs/machine.toml"),
]
WITHOUT = {
    "run": "its tables are those of the other commands; its report is checked below",
    "check": "its JSON lists problems, not the checks that passed",
    "export": "its arrays are checked below",
    "earthquake": "no example has one",
    "box": "its printed ends are rounded inward, in the units of the file: box_test",
    "completion": "no numbers of a machine",
    "help": "no numbers of a machine",
    "man": "no numbers of a machine",
    "new": "no numbers of a machine",
    "curves": "its text is a list of curves, its JSON has their functions (curves_test.py)",
    "schema": "no numbers of a machine",
    "scene": "its text is a list of places, its JSON has surfaces besides (scene_test.py)",
    "serve": "its results are the JSON of the other commands, to the byte (serve_test.py)",
}
# Lines and parts of the text that the JSON of the command does not have, each with its reason.
SKIPPED = {
    "static": [(r"Load sharing.*", "another analysis, `load_sharing` of results.json")],
    "steady": [(r"(?m)^note: .*$", "notes on the model, in results.json")],
    "backbone": [(r"(?m)^note: .*$", "notes on the model, in results.json")],
    "element": [(r"(?m)^.*(generates no energy|rigid motion).*$", "a check, whose numbers are its sentence")],
    "map": [(r"(?m)^  \d+ designs? .* one by one.*$", "how it was computed")],
    "orders": [(r"(?m)^note: .*$", "notes on the model, in results.json")],
    "verdict": [(r"limits over [^;\n]*", "the common band, a key of the file")],
    "sample": [
        (r"(?m)^  (requirement|amplitude of) .*$|5 %, 50 % and 95 % of", "headings with the shares of quantiles")
    ],
    "power": [(r"\d+\.\d %", "the quotient of two curves at one frequency")],
}
# Cells of the report: checks of its curves, formulas of laws, and excitations as given.
NO_NUMBERS = r"largest difference|δ\^|^\d+ rpm$| at -?[\d.]+°"
SI = "m/s²|m/s|rad/s²|rad/s|N m/rad|N m|N/m|N|rad|m|Pa|W|J|s"
UNIT = rf"%|°|dB|rpm|rad/s|Hz|[pnµmkMG]?(?:{SI})(?![\w/²])"
NUMBER = re.compile(rf"(?<![\w.])(?P<number>[-+−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?)(?P<unit>[\s\u00a0]?(?:{UNIT}))?(?!\w)")
PREFIXES = {"p": 1e-12, "n": 1e-9, "µ": 1e-6, "m": 1e-3, "k": 1e3, "M": 1e6, "G": 1e9}
ROUND_OFF = 1e-12


def is_number(node):
    return isinstance(node, (int, float)) and not isinstance(node, bool)


def derived(node):
    """Numbers that follow from those of one object or list of the JSON."""
    if isinstance(node, list):
        yield len(node)
        if len(node) == 2 and all(map(is_number, node)):  # a complex number
            yield from (math.hypot(*node), math.atan2(node[1], node[0]))
        return
    if all(is_number(node.get(key)) for key in ("largest", "smallest")):
        yield (node["largest"] - node["smallest"]) / 2
    if is_number(node.get("transmitted")):  # operation: forces as root mean squares, the level of the example
        yield from (node[key] / math.sqrt(2) for key in ("exciting", "transmitted"))
    if bound := re.search(r"≤ ([\d.]+) mm/s$", str(node.get("governing"))):  # select: people read velocities in rms
        yield float(bound[1]) * 1e-3 / math.sqrt(2)
    if "change_size" in node:  # explain: a slope times the change that the text names
        yield from (node[key] * node["change_size"] for key in ("height", "frequency") if is_number(node[key]))
    if is_number(node.get("multiplier")):  # optimize: percent for each percent
        yield node["multiplier"] / 100
    if node.get("peak") and node.get("simplified_peak"):
        for key in ("angular_frequency", "amplitude"):
            yield node["simplified_peak"][key] / node["peak"][key] - 1
    if "after" in node and "parameters" in node:  # optimize: what a step of one parameter changes
        for parameter in node["parameters"]:
            for step in ("one_percent_less", "one_percent_more"):
                if parameter.get(step) and parameter[step]["objective"]:
                    yield parameter[step]["objective"] / node["after"] - 1


def numbers_of(node, into):
    if is_number(node):
        into.append(float(node))
    elif isinstance(node, (dict, list)):
        into.extend(map(float, derived(node)))
        for value in node.values() if isinstance(node, dict) else node:
            numbers_of(value, into)
    return into


def texts_of(node, into):
    if isinstance(node, str):
        into.add(" ".join(node.split()))
    elif isinstance(node, (dict, list)):
        for value in node.values() if isinstance(node, dict) else node:
            texts_of(value, into)
    return into


def has_near(values, number, tolerance):
    at = bisect.bisect_left(values, number - tolerance)
    return at < len(values) and values[at] <= number + tolerance


class Pool:
    """The sizes of all numbers of a JSON document."""

    def __init__(self, document):
        self.plain = sorted({abs(x) for x in numbers_of(document, []) if math.isfinite(x)})
        self.decibels = sorted({abs(20 * math.log10(x)) for x in self.plain if x > 0} | set(self.plain))
        self.shares = sorted({abs(1 - x) for x in self.plain} | set(self.plain))  # 60 % of 0.4

    def has(self, number, tolerance=0.0, unit="", factors=(), rms=False):
        number = abs(number)
        if unit == "dB":
            return has_near(self.decibels, number, tolerance)
        if unit == "%":
            return has_near(self.shares, number / 100, tolerance / 100)
        factors = [1.0, *factors]
        if unit in ("Hz", ""):
            factors.append(2 * math.pi)
        if unit in ("rpm", ""):
            factors.append(math.pi / 30)
        if unit in ("°", ""):
            factors.append(math.pi / 180)
        if len(unit) > 1 and unit[0] in PREFIXES and not re.fullmatch("m/s²?|rad(/s)?", unit):
            factors.append(PREFIXES[unit[0]])
        if rms:  # velocities for people; the JSON is zero-to-peak
            factors += [math.sqrt(2) * factor for factor in factors]
        return any(has_near(self.plain, number * factor, tolerance * factor) for factor in factors)


def printed(token):
    """A number of a text, half a unit of its last digit, and its unit."""
    digits = token["number"].replace("−", "-")
    mantissa, _, exponent = digits.partition("e")
    unit_of_last_digit = 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))
    return float(digits), 0.501 * unit_of_last_digit + ROUND_OFF * abs(float(digits)), (token["unit"] or "").strip()


def without_names(text, document):
    """The text without the names and sentences of the JSON that contain digits."""
    text = re.sub(r"\s*\n\s*(?=\S)", " \n ", text)
    for name in sorted(
        (n for n in texts_of(document, set()) if re.search(r"\d", n) and len(n) > 2), key=len, reverse=True
    ):
        text = re.sub(r"\s+".join(map(re.escape, name.split())), " ", text)
    return text


def strangers(text, pool):
    """Numbers of a text that the pool does not have, with what is around them, and the number of all."""
    text = re.sub(r"\b0-p\b", "", text)
    headed, rms = [0.01] if "[%]" in text else [], bool(re.search(r"\srms", text))
    headed += [PREFIXES[unit[0]] for unit in re.findall(rf"\[([pnµmkMG](?:{SI}))\s*(?:rms)?\]", text)]
    found, all_tokens = [], list(NUMBER.finditer(text))
    for token in all_tokens:
        if not pool.has(*printed(token), headed, rms):
            found.append(" ".join(text[max(0, token.start() - 60) : token.end() + 20].split()))
    return found, len(all_tokens)


@functools.cache
def output(*arguments):
    done = subprocess.run([TRIVET, *map(str, arguments)], capture_output=True, text=True, timeout=HANGS_AFTER)
    assert done.returncode in (0, 1), done.stderr
    return done.stdout


def call(command, example):
    return (command, EXAMPLES / example, *(["spring x"] if command == "element" else []))


@functools.cache
def result_of(command, example):
    """The JSON of a command, its pool, and what it prints, without names and skipped lines."""
    document = json.loads(output(*call(command, example), "--json"))
    if command == "element":  # lists its energy in the modes of the machine by their frequencies
        document = [document, json.loads(output("modes", EXAMPLES / example, "--json"))]
    text = output(*call(command, example))
    for pattern, _ in SKIPPED.get(command, []):
        text = re.sub(pattern, "", text, flags=re.DOTALL if pattern.startswith("Load") else 0)
    return document, Pool(document), without_names(text, document)


class Tables(html.parser.HTMLParser):
    """The texts of the cells of each table."""

    def __init__(self, page):
        super().__init__()
        self.tables, self.inside = [], False
        self.feed(re.sub(r"<script.*?</script>", "", page, flags=re.DOTALL))

    def handle_starttag(self, tag, attributes):
        if tag == "table":
            self.tables.append([])
        if tag in ("td", "th") and self.tables:
            self.tables[-1].append("")
            self.inside = True

    def handle_endtag(self, tag):
        self.inside = self.inside and tag not in ("td", "th")

    def handle_data(self, data):
        if self.inside:
            self.tables[-1][-1] += data


def array_numbers(data):
    """The numbers of a .npy file, real and imaginary parts alternating; none of texts and truth values."""
    length = struct.unpack("<H", data[8:10])[0]
    kind = ast.literal_eval(data[10 : 10 + length].decode("latin-1"))["descr"]
    code = {"<f8": "d", "<c16": "d", "<i8": "q", "<i4": "i"}.get(kind)
    body = data[10 + length :]
    return struct.unpack(f"<{len(body) // struct.calcsize(code)}{code}", body) if code else ()


class SameNumbers(unittest.TestCase):
    def test_every_command_is_checked_or_has_a_reason(self):
        commands = re.findall(r"^  ([a-z_]+)  +\S", output("--help"), re.MULTILINE)
        self.assertEqual(sorted(commands), sorted({command for command, _ in COMMANDS} | set(WITHOUT)))

    def test_numbers_of_the_text_are_those_of_the_json(self):
        for command, example in COMMANDS:
            with self.subTest(command=command, example=example):
                _, pool, text = result_of(command, example)
                found, count = strangers(text, pool)
                self.assertEqual(found, [])
                self.assertGreater(count, 3)

    def test_a_changed_number_is_noticed(self):
        """One hundredth more, of numbers with four digits or more: curves of thousands of points hide some of them."""
        noticed = tried = 0
        for command, example in COMMANDS:
            _, pool, text = result_of(command, example)
            for token in NUMBER.finditer(text):
                if len(re.sub(r"e.*|\D", "", token["number"]).lstrip("0")) < 4:
                    continue
                value, tolerance, unit = printed(token)
                tried += 1
                noticed += not pool.has(1.01 * value, tolerance, unit)
        self.assertGreater(noticed, 0.85 * tried)
        self.assertGreater(tried, 1000)

    def test_numbers_of_csv_are_those_of_the_json(self):
        for command, example in COMMANDS:
            if command in ("element", "select", "explain", "suspension", "map"):
                continue  # no --csv, or it is written from other lists: see the tests of these commands
            with self.subTest(command=command, example=example):
                _, pool, _ = result_of(command, example)
                rows = list(csv.reader(io.StringIO(output(*call(command, example), "--csv"))))
                missing = []
                for row in rows[1:]:
                    for heading, cell in zip(rows[0], row):
                        try:
                            value = float(cell)
                        except ValueError:
                            continue
                        if math.isfinite(value) and not pool.has(value, ROUND_OFF * abs(value), ""):
                            missing.append(f"{heading}: {cell}")
                self.assertEqual(missing[:10], [])

    def test_numbers_of_a_run_and_its_report_are_those_of_results_json(self):
        for example in ("genset/genset.toml", "compressor/requirements.toml", "isolator/hardening.toml"):
            with self.subTest(example=example), tempfile.TemporaryDirectory() as folder:
                summary = output("run", EXAMPLES / example, "-o", folder).partition("Report: ")[0]
                document = json.loads((pathlib.Path(folder) / "results.json").read_text(encoding="utf-8"))
                page = (pathlib.Path(folder) / "report.html").read_text(encoding="utf-8")
                pool = Pool(document)
                found, count = strangers(without_names(re.sub(r"(?m)^note: .*$", "", summary), document), pool)
                for table in Tables(page).tables:
                    cells = " | ".join(cell for cell in table if not re.search(NO_NUMBERS, cell))
                    strange, seen = strangers(without_names(cells, document), pool)
                    found, count = found + strange, count + seen
                self.assertEqual(found, [])
                self.assertGreater(count, 100)

    def test_arrays_are_those_of_the_json(self):
        for command, example in COMMANDS:
            if command in (
                "explain",
                "suspension",
                "map",
                "verdict",
                "optimize",
                "select",
                "sample",
                "element",
                "limit_lines",
            ):
                continue  # not exported; the arrays of limit lines have curves that the JSON does not
            with self.subTest(command=command), tempfile.TemporaryDirectory() as folder:
                _, pool, _ = result_of(command, example)
                path = pathlib.Path(folder) / "all.npz"
                output("export", EXAMPLES / example, "--to", "numpy", "--what", command, "-o", path)
                count, missing = 0, []
                with zipfile.ZipFile(path) as archive:
                    for name in archive.namelist():
                        values = array_numbers(archive.read(name))
                        if set(values) <= {0, 1}:
                            continue  # truth values
                        if any(list(values) == list(range(first, first + len(values))) for first in (0, 1)):
                            continue  # an axis that counts
                        count += len(values)
                        for value in values:
                            if math.isfinite(value) and not pool.has(value, ROUND_OFF * abs(value), ""):
                                missing.append(f"{name}: {value}")
                self.assertEqual(missing[:10], [])
                self.assertGreater(count, 3)


if __name__ == "__main__":
    unittest.main()

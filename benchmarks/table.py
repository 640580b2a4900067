# SPDX-License-Identifier: BSD-3-Clause
"""Tables of benchmarks/README.md from the JSON lines of a run.   table.py RUN.jsonl [README.md to rewrite between its markers]"""
import json
import pathlib
import sys

BEGIN, END = "<!-- measured: begin -->", "<!-- measured: end -->"


def time_text(ns):
    for unit, size in (("s", 1e9), ("ms", 1e6), ("µs", 1e3), ("ns", 1)):
        if ns >= size:
            return f"{ns / size:.3g} {unit}"
    return f"{ns:.2g} ns"


def number(x):
    return f"{x:,.0f}" if abs(x) >= 100 else f"{x:.3g}"


def row(cells):
    return "| " + " | ".join(cells) + " |"


def table(head, rows):
    return "\n".join([row(head), "|" + "---|" * len(head), *(row(r) for r in rows)])


def verdict(line):
    return "" if "goal" not in line else f"{'≥ ' + number(line['goal'])}: {'met' if line['met'] else '**not met**'}"


def times(lines):
    rows = []
    for line in lines:
        speed = ""
        if "gflops" in line:
            speed = f"{line['gflops']:.1f}, {100 * line['part_of_peak']:.0f} % of {line['peak_gflops']:.0f}"
        ratio = f"{number(line['ratio'])} ({number(line['ratio_lowest'])} … {number(line['ratio_highest'])})"
        rows.append(
            [
                line["way"] + (f" ({line['note']})" if line["note"] else ""),
                time_text(line["ns"]),
                "1" if line["ours"] else ratio,
                speed,
                verdict(line),
            ]
        )
    first = lines[0]
    head = [
        f"{first['size']}, medians of {first['turns']}",
        f"per {first['item']}",
        "× ours (lowest … highest)",
        "GFLOP/s",
        "goal",
    ]
    return table(head, rows) + f"\n\nLargest error of ours before timing: {first['error']:.1e}."


def errors(lines):
    ways = list(dict.fromkeys(line["way"] for line in lines))
    ours = [w for w in ways if w.startswith("Trivet")]
    rows = []
    for case in dict.fromkeys(line["question"] for line in lines):
        of = {line["way"]: line for line in lines if line["question"] == case}
        missed = [w for w in ours if w in of and not of[w]["met"]]
        rows.append(
            [
                case,
                *(f"{of[w]['forward']:.0e}" if w in of else "–" for w in ways),
                " ".join(f"{of[w]['backward']:.0e}" for w in ours if w in of),
                "**no**: " + of[missed[0]]["goal"] if missed else "yes",
            ]
        )
    return table(["largest forward error", *ways, "backward, ours", "within goals"], rows)


def figures(lines):
    return table(
        ["", "measured", "goal"],
        [
            [
                line["way"],
                f"{number(line['value'])} {line['unit']}".strip(),
                f"{line['goal']}: {'met' if line['met'] else '**not met**'}" if line["goal"] else "",
            ]
            for line in lines
        ],
    )


def markdown(lines):
    parts = [f"{lines[0]['machine']}. Times are CPU time of one thread unless the row says otherwise."]
    timed = [line for line in lines if line["kind"] == "time"]
    for question in dict.fromkeys(line["question"] for line in lines if line["kind"] != "errors"):
        parts.append(f"### {question[0].upper()}{question[1:]}")
        of = [line for line in timed if line["question"] == question]
        parts += [
            times([line for line in of if line["size"] == size]) for size in dict.fromkeys(line["size"] for line in of)
        ]
        reported = [line for line in lines if line["kind"] == "figure" and line["question"] == question]
        parts += [figures(reported)] if reported else []
    wrong = [line for line in lines if line["kind"] == "errors"]
    parts += ["### Accuracy on sixteen hard cases", errors(wrong)] if wrong else []
    return "\n\n".join(parts)


def main():
    lines = [json.loads(text) for text in pathlib.Path(sys.argv[1]).read_text().splitlines()]
    text = markdown(lines)
    print(text)
    if len(sys.argv) > 2:
        readme = pathlib.Path(sys.argv[2])
        before, _, rest = readme.read_text().partition(BEGIN)
        _, _, after = rest.partition(END)
        readme.write_text(f"{before}{BEGIN}\n\n{text}\n\n{END}{after}")


main()

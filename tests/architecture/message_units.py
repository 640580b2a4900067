# SPDX-License-Identifier: BSD-3-Clause
"""Messages state frequencies in Hz: no text of the sources formats a number in rad/s. Columns of data, the schema and
advice on what to write have the unit without a number before it."""
import pathlib
import re
import sys

ALLOWED = {
    "src/trivet/project/text/admissible_range.cpp": 1,  # beside Hz, because numbers without a unit are in rad/s
    "src/trivet/plausibility/analysis_rules.cpp": 2,  # what to write if rad/s are meant
    "src/trivet/study/explain/explanation_words.cpp": 1,  # beside Hz, in JSON
}

project = pathlib.Path(sys.argv[1])
wrong = []
found = {}
for folder in sys.argv[2:]:
    for path in (project / folder).rglob("*"):
        if path.suffix not in (".cpp", ".h"):
            continue
        uses = len(re.findall(r"\} rad/s|\+ \" rad/s\"", path.read_text()))
        if uses:
            found[path.relative_to(project).as_posix()] = uses
for path in sorted(found.keys() | ALLOWED.keys()):
    uses, allowed = found.get(path, 0), ALLOWED.get(path, 0)
    if uses > allowed:
        wrong.append(f"{path}: {uses} numbers in rad/s; write foundation::hertz_words(omega) (foundation/hertz.h)")
    if uses < allowed:
        wrong.append(f"{path}: {uses} numbers in rad/s, {allowed} allowed: correct the list in message_units.py")
print("\n".join(wrong) or f"messages speak Hz; {sum(found.values())} numbers in rad/s beside it")
sys.exit(1 if wrong else 0)

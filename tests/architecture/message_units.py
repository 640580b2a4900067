# SPDX-License-Identifier: BSD-3-Clause
"""Messages state frequencies in Hz: no text of the sources formats a number in rad/s. Columns of data, the schema and
advice on what to write have the unit without a number before it."""
import pathlib
import re
import sys

ALLOWED = {
    "admissible_range.cpp": 1,  # beside Hz, because numbers without a unit are in rad/s
    "analysis_rules.cpp": 2,  # what to write if rad/s are meant
    "explanation_words.cpp": 1,  # beside Hz, in JSON
}

wrong = []
found = 0
for folder in sys.argv[1:]:
    for path in pathlib.Path(folder).rglob("*.cpp"):
        uses = len(re.findall(r"\} rad/s|\+ \" rad/s\"", path.read_text()))
        found += uses
        if uses > ALLOWED.get(path.name, 0):
            wrong.append(f"{path}: {uses} numbers in rad/s; write foundation::hertz_words(omega) (foundation/hertz.h)")
if found < sum(ALLOWED.values()):
    wrong.append("fewer numbers in rad/s than allowed: shorten the list in message_units.py")
print("\n".join(wrong) or f"messages speak Hz; {found} numbers in rad/s beside it")
sys.exit(1 if wrong else 0)

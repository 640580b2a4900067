# SPDX-License-Identifier: BSD-3-Clause
"""Holds every #include between floors to the arrows declared in CMake."""
import pathlib
import re
import sys

source, floors_file = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
uses = {}
for line in floors_file.read_text().splitlines():
    floor, _, lower = line.partition(":")
    uses[floor] = lower.split()


def below(floor):
    """The floor itself and all it may see: arrows reach through."""
    return {floor}.union(*(below(lower) for lower in uses[floor]))


wrong = []
includes = 0
for path in sorted((source / "trivet").rglob("*")):
    if path.suffix not in (".h", ".cpp", ".in"):
        continue
    floor = path.relative_to(source).parts[1]
    if floor not in uses:
        wrong.append(f"{path}: the folder {floor} is no declared floor")
        continue
    for number, line in enumerate(path.read_text().splitlines(), 1):
        found = re.match(r'\s*#\s*include\s*[<"]trivet/([a-z_]+)/', line)
        if found:
            includes += 1
            if found.group(1) not in below(floor):
                wrong.append(f"{path}:{number}: {floor} must not include {found.group(1)}")
print("\n".join(wrong) or f"{includes} includes between {len(uses)} floors follow the arrows")
sys.exit(1 if wrong or includes == 0 else 0)

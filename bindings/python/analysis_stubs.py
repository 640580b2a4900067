# SPDX-License-Identifier: BSD-3-Clause
"""Writes _analyses.pyi: the signatures of the analyses, with the keys of the schema of the project file.

usage: analysis_stubs.py FOLDER-OF-_core TARGET
"""

import json
import keyword
import pathlib
import re
import sys

folder, target = sys.argv[1:]
sys.path.insert(0, folder)
import _core  # noqa: E402

in_project = set(re.findall(r"    def (\w+)\(", (pathlib.Path(__file__).parent / "trivet/_project.py").read_text()))
analyses = json.loads(_core.schema())["properties"]["analyses"]["properties"]
lines = [
    "# SPDX-License-Identifier: BSD-3-Clause",
    "from typing import Any",
    "",
    "from trivet._result import Result",
    "from trivet._progress import Progress",
    "",
    "class Analyses:",
]
for name, about, _, own_keys in _core.commands():
    if name in in_project:
        continue
    keys = own_keys + [key for key in analyses.get(name, {}).get("properties", {}) if key != "accept"]
    keys = [key + "_" if keyword.iskeyword(key) else key for key in keys]
    arguments = "".join(f"        {key}: Any = ...,\n" for key in keys)
    lines += [
        f"    def {name}(",
        "        self,",
        "        *,",
        '        case: str = "",',
        "        threads: int = 0,",
        "        progress: Progress | bool | None = None,",
        f"{arguments}    ) -> Result:",
        f'        """{about[0].upper()}{about[1:]}."""',
    ]
lines += [
    "    def _ask(self, command: str, own: dict[str, Any], keys: dict[str, Any], case: str, threads: int,"
    " progress: Progress | bool | None) -> Result: ...",
]
with open(target, "w", encoding="utf-8") as file:
    file.write("\n".join(lines) + "\n")

# SPDX-License-Identifier: BSD-3-Clause
"""The Python of the documents runs, and so does the example."""

import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import EXAMPLES, MACHINE, ROOT

import trivet

BLOCK = re.compile(r"```python\n(.*?)```", re.DOTALL)


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
@pytest.mark.parametrize("document", ["README.md", "docs/python.md"])
def test_blocks(document, tmp_path, monkeypatch):
    blocks = BLOCK.findall((ROOT / document).read_text(encoding="utf-8"))
    assert blocks
    elements = {"mount": MACHINE["elements"]["a"]} | {name: MACHINE["elements"][name] for name in "bcd"}
    trivet.Project(**MACHINE | {"elements": elements}).save(tmp_path / "machine.toml")
    (tmp_path / "examples").symlink_to(EXAMPLES)
    monkeypatch.chdir(tmp_path)
    names = {"scales": np.array([0.5, 1.0, 2.0]), "masses": np.array([100.0, 150.0])}
    for block in blocks:
        exec(block, names)  # noqa: S102: our own documents


@pytest.mark.parametrize("example", sorted(file.name for file in (EXAMPLES / "python").glob("*.py")))
def test_examples(example):
    ran = subprocess.run(
        [sys.executable, "-W", "error", str(EXAMPLES / "python" / example)], capture_output=True, text=True
    )
    assert ran.returncode == 0, ran.stderr
    assert "Best design" in ran.stdout

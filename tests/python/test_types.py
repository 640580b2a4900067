# SPDX-License-Identifier: BSD-3-Clause
"""Types of the package and of the examples."""

import pathlib
import subprocess
import sys

from conftest import EXAMPLES, ROOT

import trivet


def test_mypy_strict(tmp_path):
    package = pathlib.Path(trivet.__file__).parent
    assert (package / "py.typed").exists()
    for what in [["-p", "trivet"], *([str(file)] for file in sorted((EXAMPLES / "python").glob("*.py")))]:
        found = subprocess.run(
            [
                sys.executable,
                "-m",
                "mypy",
                "--strict",
                "--cache-dir",
                str(tmp_path),
                "--config-file",
                str(ROOT / "pyproject.toml"),
                *what,
            ],
            capture_output=True,
            text=True,
        )
        assert found.returncode == 0, found.stdout + found.stderr

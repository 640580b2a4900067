# SPDX-License-Identifier: BSD-3-Clause
"""The Python of the documents runs, and so does the example."""

import re
import subprocess
import sys

import pytest
from conftest import EXAMPLES, ROOT

import trivet

BLOCK = re.compile(r"```python\n(.*?)```", re.DOTALL)
DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
WITH_PYTHON = [str(file.relative_to(ROOT)) for file in DOCUMENTS if "```python" in file.read_text(encoding="utf-8")]


def blocks_of(document: str) -> list[str]:
    return BLOCK.findall((ROOT / document).read_text(encoding="utf-8"))


def test_the_documents_have_python():
    assert {"README.md", "docs/python.md"} <= set(WITH_PYTHON)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The folder of a reader: the file that `trivet new` prints, and the examples."""
    (tmp_path / "machine.toml").write_text(trivet.starter(), encoding="utf-8")
    (tmp_path / "examples").symlink_to(EXAMPLES)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.filterwarnings("ignore::trivet.ModelWarning")
@pytest.mark.parametrize("document", WITH_PYTHON)
def test_blocks_run(document, folder):
    names: dict[str, object] = {}
    for block in blocks_of(document):
        exec(block, names)  # noqa: S102: our own documents


@pytest.mark.parametrize("document", WITH_PYTHON)
def test_blocks_have_the_types_of_the_package(document, folder):
    (folder / "blocks.py").write_text("\n".join(blocks_of(document)), encoding="utf-8")
    command = [sys.executable, "-m", "mypy", "--strict", "--config-file", str(ROOT / "pyproject.toml"), "blocks.py"]
    found = subprocess.run(command, capture_output=True, text=True)
    assert found.returncode == 0, found.stdout + found.stderr


@pytest.mark.parametrize("example", sorted(file.name for file in (EXAMPLES / "python").glob("*.py")))
def test_examples(example):
    ran = subprocess.run(
        [sys.executable, "-W", "error", str(EXAMPLES / "python" / example)], capture_output=True, text=True
    )
    assert ran.returncode == 0, ran.stderr
    assert "Best design" in ran.stdout

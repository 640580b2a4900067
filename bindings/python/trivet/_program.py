# SPDX-License-Identifier: BSD-3-Clause
"""The program `trivet`. It runs as a file, without the package: NumPy and its threads have no place in it, because it
takes over the signals of its process."""

import importlib.util
import pathlib
import sys

package = pathlib.Path(__file__).resolve().parent
(compiled,) = [file for file in package.glob("_core*") if file.suffix in (".so", ".pyd", ".dylib")]
spec = importlib.util.spec_from_file_location("_core", compiled)
assert spec and spec.loader
core = importlib.util.module_from_spec(spec)
spec.loader.exec_module(core)
sys.exit(core.main_program(["trivet", *sys.argv[1:]]))

# SPDX-License-Identifier: BSD-3-Clause
"""The layers that compute assert what must hold as they do, at least five times per 1,000 lines of headers and sources.
Release builds leave asserts out; builds with sanitizers run them."""
import pathlib
import re
import sys

source = pathlib.Path(sys.argv[1])
LAYERS = ("numerics", "assembly", "modal", "response", "nonlinear", "design")
LEAST = 5  # per 1,000 lines

wrong = []
total = 0
for layer in LAYERS:
    texts = [path.read_text() for path in (source / layer).rglob("*") if path.suffix in (".h", ".cpp")]
    lines = sum(text.count("\n") for text in texts)
    asserts = sum(len(re.findall(r"^\s*assert\(", text, re.MULTILINE)) for text in texts)
    total += asserts
    if lines == 0:
        wrong.append(f"{source / layer}: this layer has no source")
    elif 1000 * asserts < LEAST * lines:
        wrong.append(f"{source / layer}: {asserts} asserts in {lines} lines; {LEAST} per 1,000 are the least")
print("\n".join(wrong) or f"{total} asserts: at least {LEAST} per 1,000 lines in each of {len(LAYERS)} layers")
sys.exit(1 if wrong else 0)

# SPDX-License-Identifier: BSD-3-Clause
"""Lists that documents repeat are complete: layers and their sub-folders, commands, documents, and the version.

    documented_lists.py SOURCE TRIVET

Layers and sub-folders: CMake, the table of ARCHITECTURE.md and that of docs/api.md. Commands: the help of
the program, the tables of docs/commands.md, and the other documents. Documents: the index
docs/README.md. Version: CMake, which Python's package reads, CITATION.cff, the newest
heading of CHANGELOG.md and `trivet --version`."""
import pathlib
import re
import subprocess
import sys

source, trivet = pathlib.Path(sys.argv[1]), sys.argv[2]
problems = []


def text(path):
    return (source / path).read_text(encoding="utf-8")


def differences(where, found, expected):
    problems.extend(f"{where}: {name} is missing" for name in expected if name not in found)
    problems.extend(f"{where}: {name} is not in the tree" for name in found if name not in expected)


def output(*arguments):
    return subprocess.run([trivet, *arguments], capture_output=True, text=True, check=True, timeout=60).stdout


layers = re.findall(r"^add_layer\((\w+)", text("CMakeLists.txt"), re.MULTILINE)
if len(layers) < 10:
    problems.append("CMakeLists.txt: the layers are not found; this test reads add_layer")
rows = {
    "ARCHITECTURE.md": re.findall(r"^\| `(\w+)` \| (.*)$", text("ARCHITECTURE.md"), re.MULTILINE),
    "docs/api.md": re.findall(r'^\| @ref trivet::(\w+) "\w+" \| (.*)$', text("docs/api.md"), re.MULTILINE),
}
for document, table in rows.items():
    differences(f"layers of {document}", [name for name, _ in table], layers)
    contents = dict(table)
    for layer in layers:
        folder = source / "src/trivet" / layer
        for part in sorted(path.name for path in folder.iterdir() if path.is_dir() and any(path.glob("*.cpp"))):
            if f"`{part}`" not in contents.get(layer, ""):
                problems.append(f"{document}: the sub-folder {layer}/{part} is missing")

commands = re.findall(r"^  ([a-z_]+)  +\S", output("--help"), re.MULTILINE)
if len(commands) < 25:
    problems.append(f"trivet --help: only {len(commands)} commands are found: {commands}")
documents = {
    path: path.read_text(encoding="utf-8") for path in [source / "README.md", *sorted((source / "docs").rglob("*.md"))]
}
for command in commands:
    named = [path for path, one in documents.items() if re.search(rf"\btrivet {command}\b|`{command}`", one)]
    if source / "docs/commands.md" not in named:
        problems.append(f"docs/commands.md: the command {command} is missing")
    if not any(path.name != "commands.md" and path.parent != source for path in named):
        problems.append(f"docs: no document but commands.md names the command {command}")
for path, one in documents.items():
    for called in re.findall(r"^(?:\$ )?trivet ([a-z_]+)", one, re.MULTILINE):
        if called not in commands:
            problems.append(f"{path.relative_to(source)}: trivet {called} is no command")

index = documents[source / "docs/README.md"]
problems.extend(
    f"docs/README.md: {path.relative_to(source)} is missing"
    for path in documents
    if path.name != "README.md" and f"{path.relative_to(source / 'docs')})" not in index.replace("#", ")")
)

version = re.search(r"^project\(trivet VERSION ([0-9.]+)", text("CMakeLists.txt"), re.MULTILINE)[1]
for where, found in {
    "CITATION.cff": re.search(r"^version: (\S+)", text("CITATION.cff"), re.MULTILINE),
    "CHANGELOG.md": re.search(r"^## ([0-9.]+)", text("CHANGELOG.md"), re.MULTILINE),
    "trivet --version": re.match(r"trivet ([0-9.]+)", output("--version")),
}.items():
    if not found or found[1] != version:
        problems.append(f"{where}: version {found[1] if found else 'unknown'}, {version} in CMakeLists.txt")
if "CMakeLists.txt" not in re.search(r"\[tool.scikit-build.metadata.version\]\n(.*\n){1,3}", text("pyproject.toml"))[0]:
    problems.append("pyproject.toml: the version is not read from CMakeLists.txt")

print(*problems, sep="\n")
sys.exit(1 if problems else 0)

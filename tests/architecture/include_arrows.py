# SPDX-License-Identifier: BSD-3-Clause
"""Checks every #include against the permitted includes between layers, and between the folders of a layer, that CMake
declares. No other layer may include a private header. Decompositions of Eigen are compiled only in numerics/linalg,
Boost only in source files."""
import pathlib
import re
import sys

source, layers_file = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
layers, folders, private = {}, {}, set()
for line in layers_file.read_text().splitlines():
    name, _, listed = line.partition(":")
    kind, _, rest = name.rpartition(" ")
    if kind == "folder":
        layer = rest.split("/")[0]
        folders[rest] = {f"{layer}/{folder}" for folder in listed.split()} | {rest}
    elif kind == "private":
        private |= {f"{rest}/{header}" for header in listed.split()}
    else:
        layers[name] = listed.split()

# Each costs a second or two in every file that includes it (docs/decisions/folders-and-a-quick-build.md).
decompositions = {"Cholesky", "Dense", "Eigen", "Eigenvalues", "LU", "QR", "SVD"}
may_decompose = {
    "fem/element_kernel.cpp": {"LU"},  # inverses of 3×3 and 4×4 in the innermost loop
    "fem/partial_elimination.cpp": {"Cholesky"},  # critical path of the elimination, also optimised with sanitizers
}
may_need_boost = {"server/connection.h", "server/listener.h"}  # private, for the three files that are one batch


def below(layer):
    """The layer itself and all layers that it may include, directly or through others."""
    return {layer}.union(*(below(lower) for lower in layers[layer]))


def folder_of(path):
    """ "numerics/sweep" for numerics/sweep/planes.h; "numerics" for a file outside the folders."""
    return str(pathlib.PurePosixPath(path).parent)


# Reading only reads: it ends at a checked description, which judging settles and judges.
never_below = {"project": {"response", "nonlinear", "plausibility", "judging"}}
wrong = [
    f"{upper} must not be built on {lower}"
    for upper, forbidden in never_below.items()
    for lower in sorted(forbidden & below(upper))
]
includes = 0
for path in sorted((source / "trivet").rglob("*")):
    if path.suffix not in (".h", ".cpp", ".in"):
        continue
    name = path.relative_to(source / "trivet").as_posix()
    layer, folder = name.split("/")[0], folder_of(name)
    if layer not in layers:
        wrong.append(f"{path}: the folder {layer} is not a declared layer")
        continue
    if folder != layer and folder not in folders:
        wrong.append(f"{path}: the folder {folder} is not a declared folder")
        continue
    allowed = folders.get(folder)  # None outside the folders: all folders
    for number, line in enumerate(path.read_text().splitlines(), 1):
        eigen = re.match(r"\s*#\s*include\s*[<\"](?:eigen3/)?Eigen/(\w+)", line)
        if (
            eigen
            and eigen.group(1) in decompositions
            and folder != "numerics/linalg"
            and eigen.group(1) not in may_decompose.get(name, ())
        ):
            wrong.append(
                f"{path}:{number}: Eigen/{eigen.group(1)} is for numerics/linalg alone, whose functions stand for it"
            )
        if path.suffix == ".h" and name not in may_need_boost and re.match(r"\s*#\s*include\s*<boost/", line):
            wrong.append(
                f"{path}:{number}: Boost takes a second in every file that includes it, so only source files do"
            )
        found = re.match(r'\s*#\s*include\s*[<"]trivet/([^">]+\.h)', line)
        if not found:
            continue
        includes += 1
        target = found.group(1)
        lower = target.split("/")[0]
        if lower not in below(layer):
            wrong.append(f"{path}:{number}: {layer} must not include {lower}")
        elif lower == layer and allowed is not None and folder_of(target) not in allowed:
            wrong.append(f"{path}:{number}: {folder} must not include {folder_of(target)}")
        elif lower != layer and target in private:
            wrong.append(f"{path}:{number}: {target} is private to {lower}")

# The command line and Python ask the engine, or start the server of the page, and know nothing below them.
root = source.parent
behind_the_door = 0
for path in sorted([*root.glob("apps/cli/*"), *root.glob("bindings/python/core/*")]):
    if path.suffix not in (".h", ".cpp"):
        continue
    for number, line in enumerate(path.read_text().splitlines(), 1):
        found = re.match(r'\s*#\s*include\s*[<"]trivet/([^">]+\.h)', line)
        if not found:
            continue
        behind_the_door += 1
        if not found.group(1).startswith("engine/") and found.group(1) != "server/page_server.h":
            wrong.append(f"{path}:{number}: {found.group(1)} is behind the engine, the one door of programs")
if behind_the_door == 0:
    wrong.append("no program includes the engine")
print(
    "\n".join(wrong) or f"{includes} includes between {len(layers)} layers and {len(folders)} folders follow the arrows"
)
sys.exit(1 if wrong or includes == 0 else 0)

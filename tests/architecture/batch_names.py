# SPDX-License-Identifier: BSD-3-Clause
"""Files of a floor are compiled in batches, where a name of one file's anonymous namespace hides that of a header from all files
behind it: they use another constant, or call another function, without a word of the compiler. So no such name may be one that a
header of the floor declares, and no constant or type that of another file; an alias may, if it says the same."""
import collections
import pathlib
import re
import sys

source = pathlib.Path(sys.argv[1]) / "trivet"
alias = re.compile(r"^using (\w+) = (.*);")
thing = re.compile(
    r"^(?:template <[^>]*> )?(?:struct|class|enum class|enum) (\w+)\b[^;]*$"
    r"|^(?:inline |static )*(?:constexpr|const) [^()]*?\b(\w+)(?:\[[^\]]*\])*\s*[={]"
)
function = re.compile(r"^(?!return|else|using)(?:\[\[nodiscard\]\] |inline |constexpr |static )*[A-Za-z_][\w:<>,&* ]*?[ &*](\w+)\(")


def declared(lines):
    """Names declared at the margin, which is where things of a namespace stand: {name: what it is}."""
    names = {}
    for line in lines:
        if found := alias.match(line):
            names[found[1]] = found[2]
        elif found := thing.match(line):
            names[found[1] or found[2]] = "thing"
        elif found := function.match(line):
            names.setdefault(found[1], "function")
    return names


def anonymous(lines):
    inside = False
    for line in lines:
        inside = (inside or line.startswith("namespace {")) and not line.startswith("}  // namespace")
        if inside:
            yield line


wrong, count = [], 0
for floor in sorted(path for path in source.iterdir() if path.is_dir()):
    of_headers = {}
    for header in sorted(floor.rglob("*.h")):
        if not header.name.endswith("-inl.h"):
            of_headers.update({name: (what, header) for name, what in declared(header.read_text().splitlines()).items()})
    of_files = collections.defaultdict(list)
    for path in sorted(floor.rglob("*.cpp")):
        lines = path.read_text().splitlines()
        if any("foreach_target" in line for line in lines):
            continue  # compiled alone
        names = declared(anonymous(lines))
        count += len(names)
        for name, what in names.items():
            if name in of_headers and of_headers[name][0] != what or what in ("thing", "function") and name in of_headers:
                wrong.append(f"{path}: {name} of the anonymous namespace hides that of {of_headers[name][1]}")
            if what != "function":
                of_files[name].append((what, path))
    for name, found in of_files.items():
        if len(found) > 1 and (found[0][0] == "thing" or len({what for what, _ in found}) > 1):
            wrong.append(f"{name} is in the anonymous namespaces of {', '.join(str(path) for _, path in found)}")
print("\n".join(wrong) or f"{count} names of anonymous namespaces are told apart in their floors")
sys.exit(1 if wrong or count == 0 else 0)

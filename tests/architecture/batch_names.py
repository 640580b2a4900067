# SPDX-License-Identifier: BSD-3-Clause
"""Files of a layer are compiled in batches. There, a name in the anonymous namespace of one file hides the same name of
a header from all files after it: they use another constant or call another function, and the compiler does not warn.
So no such name may be one that a header of the layer declares, and no constant or type may have the name of one in
another file. Aliases may, if they are equal. Functions of two files may share a name: overloads are chosen by their
arguments, and equal ones do not compile. Tests are in batches too, and each file *_test.cpp has a namespace with its name."""
import collections
import pathlib
import re
import sys

attributes = r"(?:template <[^>]*> |\[\[\w+\]\] |inline |static |extern )*"
alias = re.compile(r"^using (\w+) = (.*);")
type_name = re.compile(rf"^{attributes}(?:struct|class|enum class|enum) (\w+)\b(?!;)")
constants = re.compile(rf"^{attributes}(?:constexpr|const) (?![^=]*\b\w+\([^={{]*\) ?(?:const )?[{{;])(.*)$")
function = re.compile(rf"^(?!return|else|using){attributes}(?:constexpr )?[A-Za-z_][\w:<>,&* ]*?[ &*](\w+)\(")


def names_of_constants(text):
    """`const char *const a = "x", *b = y(1, 2);` → a, b."""
    text = re.sub(r'R?"(?:[^"\\]|\\.)*"', "0", text.split("//")[0])
    while (flat := re.sub(r"\([^()]*\)|\{[^{}]*\}|<[^<>]*>|\[[^\[\]]*\]", " ", text)) != text:
        text = flat
    return [
        found[1]
        for part in text.split(",")
        if (found := re.match(r"(?:.*[\s*&])?([A-Za-z_]\w*)$", re.split("[=;({[]", part)[0].strip()))
    ]


def declared(lines):
    """Declarations without indentation, as in a namespace: {name: kind}."""
    names = {}
    for line in lines:
        if found := alias.match(line):
            names[found[1]] = found[2]
        elif found := type_name.match(line):
            names[found[1]] = "thing"
        elif found := constants.match(line):
            names.update(dict.fromkeys(names_of_constants(found[1]), "thing"))
        elif found := function.match(line):
            names.setdefault(found[1], "function")
    return names


def anonymous(lines):
    inside = False
    for line in lines:
        inside = (inside or line.startswith("namespace {")) and not line.startswith("}  // namespace")
        if inside:
            yield line


def problems_of_layer(files):
    """@param files  {path: lines}"""
    of_headers, of_files = {}, collections.defaultdict(list)
    for path, lines in files.items():
        if path.endswith(".h") and not path.endswith("-inl.h"):
            of_headers.update({name: (what, path) for name, what in declared(lines).items()})
    for path, lines in files.items():
        if not path.endswith(".cpp") or any("foreach_target" in line for line in lines):
            continue  # compiled separately
        for name, what in declared(anonymous(lines)).items():
            if name in of_headers and (what in ("thing", "function") or of_headers[name][0] != what):
                yield f"{path}: {name} of the anonymous namespace hides that of {of_headers[name][1]}"
            if what != "function":
                of_files[name].append((what, path))
    for name, found in of_files.items():
        if len(found) > 1 and (found[0][0] == "thing" or len({what for what, _ in found}) > 1):
            yield f"{name} is in the anonymous namespaces of {', '.join(path for _, path in found)}"


def problems_of_tests(files):
    """@param files  {path: lines}"""
    for path, lines in files.items():
        name = pathlib.Path(path).stem
        if name.endswith("_test") and f"namespace {name} {{" not in lines:
            yield f"{path}: its tests are not in namespace {name}"


def check_itself():
    """One sample of each kind of declaration to be found, and some lines that are not declarations."""
    seen = declared(
        """constexpr double a = 1, b[2] = {1, 2}, c = f(1, 2);
const char* const d = "x, y = 2";
constexpr const char* e[] = {"a", "b"};
inline constexpr std::array<double, 3> g{1, 2, 3};
extern const Law h;
enum class Kind { one, two };
struct Empty {};
struct Base : Other {
template <typename T> struct Of;
[[noreturn]] void stop(int x);
[[nodiscard]] const std::string& name(const Thing& of);
Eigen::Vector3d j(double x) {
using Short = std::vector<int>;
const std::map<std::string, int> k = {
return l(1);
  const double m = 1;""".splitlines()
    )
    wanted = {"a", "b", "c", "d", "e", "g", "h", "Kind", "Empty", "Base", "stop", "name", "j", "Short", "k"}
    assert set(seen) == wanted, set(seen) ^ wanted
    files = {
        "a.h": ["constexpr int n = 1;", "void f(int x);"],
        "b.cpp": ["namespace {", "constexpr int n = 2;", "void f(double x) {", "struct S {"],
        "c.cpp": ["namespace {", "struct S {};", "using T = int;"],
        "d.cpp": ["namespace {", "using T = int;", "void g(int x) {"],
    }
    assert len(list(problems_of_layer(files))) == 3, list(problems_of_layer(files))
    tests = {"a_test.cpp": ["namespace a_test {"], "b_test.cpp": ["namespace {"], "c.cpp": ["namespace {"]}
    assert len(list(problems_of_tests(tests))) == 1, list(problems_of_tests(tests))


check_itself()
count, wrong = 0, []
for folder in sys.argv[1:]:
    for layer in sorted(path for path in pathlib.Path(folder).iterdir() if path.is_dir()):
        files = {
            str(path): path.read_text().splitlines()
            for path in sorted(layer.rglob("*"))
            if path.suffix in (".h", ".cpp")
        }
        count += sum(len(declared(anonymous(lines))) for path, lines in files.items() if path.endswith(".cpp"))
        wrong += [*problems_of_layer(files), *problems_of_tests(files)]
print("\n".join(wrong) or f"{count} names of anonymous namespaces hide no other")
sys.exit(1 if wrong or count == 0 else 0)

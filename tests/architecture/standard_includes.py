# SPDX-License-Identifier: BSD-3-Clause
"""Files of a layer are compiled in batches on a common precompiled header, which hides a missing #include of the standard
library. So every file that uses a name of `std` includes its header, itself or by a header of ours."""
import pathlib
import re
import sys

HEADERS = {
    "algorithm": "all_of any_of none_of find find_if find_if_not count count_if copy copy_if transform sort stable_sort min max clamp minmax "
    "min_element max_element minmax_element reverse unique lower_bound upper_bound equal_range binary_search fill equal remove_if "
    "adjacent_find is_sorted nth_element partition rotate set_difference set_union includes search replace for_each shuffle generate "
    "stable_partition partial_sort is_permutation next_permutation lexicographical_compare mismatch merge",
    "numeric": "accumulate iota partial_sum inner_product gcd lcm reduce",
    "numbers": "numbers",
    "map": "map multimap",
    "set": "set multiset",
    "unordered_map": "unordered_map",
    "unordered_set": "unordered_set",
    "deque": "deque",
    "list": "list",
    "vector": "vector",
    "array": "array",
    "tuple": "tuple make_tuple tie",
    "variant": "variant visit holds_alternative get_if monostate",
    "optional": "optional nullopt make_optional",
    "any": "any any_cast",
    "functional": "function greater less greater_equal less_equal hash ref cref",
    "memory": "unique_ptr shared_ptr make_unique make_shared weak_ptr",
    "string": "string to_string getline",
    "string_view": "string_view",
    "regex": "regex smatch",
    "span": "span",
    "bit": "bit_cast popcount countr_zero",
    "charconv": "from_chars to_chars",
    "filesystem": "filesystem",
    "fstream": "ifstream ofstream fstream",
    "sstream": "ostringstream istringstream stringstream",
    "random": "mt19937 mt19937_64 uniform_real_distribution normal_distribution",
    "thread": "thread this_thread",
    "mutex": "mutex lock_guard scoped_lock unique_lock",
    "atomic": "atomic",
    "chrono": "chrono",
    "complex": "complex polar conj norm arg",
    "cmath": "sqrt sin cos tan exp log log10 pow isfinite isinf isnan hypot atan2 floor ceil lround cbrt expm1 log1p sinh cosh tanh",
    "limits": "numeric_limits",
    "iterator": "back_inserter next prev distance istreambuf_iterator",
    "iostream": "cout cerr cin",
    "exception": "exception_ptr current_exception rethrow_exception",
    "stdexcept": "runtime_error invalid_argument logic_error out_of_range",
}
HEADER_OF = {name: header for header, names in HEADERS.items() for name in names.split()}
# What libraries bring by their documentation, or cannot do without.
BROUGHT = {
    "Eigen": {"algorithm", "cmath", "complex", "limits"},
    "nlohmann/json": {"map", "vector", "string"},
    "gmock": {"vector", "string", "map", "set", "tuple", "functional", "algorithm", "limits", "memory"},
    "gtest": {"vector", "string", "map", "set", "tuple", "limits", "memory"},
}
BROUGHT_BY_STANDARD = {
    "filesystem": {"string"},
    "fstream": {"string"},
    "sstream": {"string"},
    "iostream": {"string"},
    "map": {"functional"},
    "regex": {"string"},
    "string": {"string_view"},
}


def included(text):
    own, others = [], set()
    for name in re.findall(r'^\s*#include [<"]([^>"]+)[>"]', text, re.M):
        if "/" in name and name.split("/")[0] in ("trivet", "support"):
            own.append(name)
        elif "." not in name and "/" not in name:
            others.add(name)
            others |= BROUGHT_BY_STANDARD.get(name, set())
        for library, brought in BROUGHT.items():
            if name.startswith(library):
                others |= brought
    return own, others


def problems(files):
    """@param files  {path as it is included, or in full: text}"""
    known = {}

    def closure(path):
        if path not in known:
            known[path] = set()
            own, others = included(files[path])
            known[path] = others.union(*(closure(name) for name in own if name in files))
        return known[path]

    for path, text in files.items():
        code = re.sub(r'//[^\n]*|"(?:\\.|[^"\\\n])*"', "", text)
        missing = {HEADER_OF[name] for name in re.findall(r"\bstd::(\w+)", code) if name in HEADER_OF} - closure(path)
        for header in sorted(missing):
            yield f"{path}: uses <{header}> without including it"


if __name__ == "__main__":
    wrong = list(
        problems(
            {
                "a.h": "#include <vector>\n",
                "trivet/a.h": '#include <vector>\n',
                "b.cpp": '#include "trivet/a.h"\nstd::vector<int> a; auto b = std::all_of;\n',
            }
        )
    )
    assert wrong == ["b.cpp: uses <algorithm> without including it"], wrong
    texts = {}
    for folder in map(pathlib.Path, sys.argv[1:]):
        for path in sorted(folder.rglob("*")):
            if path.suffix in (".h", ".cpp"):
                inside = path.relative_to(folder)
                texts[str(pathlib.Path("trivet") / inside if folder.name == "trivet" else inside)] = path.read_text()
    found = list(problems(texts))
    print("\n".join(found))
    sys.exit(bool(found))

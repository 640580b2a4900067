# SPDX-License-Identifier: BSD-3-Clause
"""The page of classes, methods and functions of the Python package, from its sources: names, arguments and docstrings."""

import ast
import inspect
import keyword
import re

HEAD = """# Python reference

Classes and functions of the package, from its sources; how they are used: [python.md](python.md). Each command of the
[command line](command-line.md) is a method of a project, with the keys of its table in the project file.
"""


def _public(package):
    """Public names of the package in the order of `__all__`, and the module of each; the core has no Python source."""
    tree = ast.parse((package / "__init__.py").read_text(encoding="utf-8"))
    modules = {
        name.asname or name.name: node.module
        for node in tree.body
        if isinstance(node, ast.ImportFrom) and node.module.startswith("trivet.")
        for name in node.names
    }
    listed = next(
        ast.literal_eval(n.value) for n in tree.body if isinstance(n, ast.Assign) and n.targets[0].id == "__all__"
    )
    return [
        (name, modules[name].partition(".")[2])
        for name in listed
        if modules.get(name, "trivet._core") != "trivet._core"
    ]


def _text(node):
    """The docstring in Markdown: indented code remains code."""
    return inspect.cleandoc(ast.get_docstring(node) or "")


def _signature(node):
    """The arguments without `self` and without annotations that only a type checker reads."""
    arguments = re.sub(r"^(self|cls)(, /)?(, |$)", "", ast.unparse(node.args))
    returned = f" → {ast.unparse(node.returns)}" if node.returns else ""
    return f"{node.name}({arguments}){returned}"


def _is_property(node):
    return any(getattr(decorator, "id", "") == "property" for decorator in node.decorator_list)


def _members(node, source):
    """Public fields, methods and properties of a class: signature and text; that of a field is its comment `#:`."""
    for member in node.body:
        if isinstance(member, ast.AnnAssign) and not member.target.id.startswith("_"):
            comment = source[member.end_lineno - 1].partition("#: ")[2]
            yield f"{member.target.id} → {ast.unparse(member.annotation)}", comment
    for member in node.body:
        if not isinstance(member, ast.FunctionDef) or member.name.startswith("_"):
            continue
        if _is_property(member):
            yield f"{member.name} → {ast.unparse(member.returns)}", _text(member)
        else:
            yield _signature(member), _text(member)


def _row(signature, text):
    cells = f"`{signature}`", " ".join(text.split())
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def _table(members):
    rows = [_row(*member) for member in members]
    return ["| member | meaning |", "|---|---|", *rows, ""] if rows else []


def _analyses(schema, project):
    """The methods of a project that the build generates: each table of [analyses] has one."""
    written = {node.name for node in project.body if isinstance(node, ast.FunctionDef)}
    for name, table in schema["properties"]["analyses"]["properties"].items():
        if name not in written:
            keys = [key + "_" if keyword.iskeyword(key) else key for key in table["properties"] if key != "accept"]
            arguments = ", ".join(f"{key}=…" for key in [*keys, "case", "threads", "progress"])
            yield f"{name}({arguments}) → Result", f"Keys: [`[analyses.{name}]`](keys.md#analyses-{name})."


def page(package, schema):
    """The page in Markdown. @param package  the folder of the sources; schema  that of the project file"""
    lines = [HEAD]
    for name, module in _public(package):
        source = (package / f"{module}.py").read_text(encoding="utf-8")
        node = next(node for node in ast.parse(source).body if getattr(node, "name", None) == name)
        lines += [f"## trivet.{name} {{#{name}}}", ""]
        if isinstance(node, ast.FunctionDef):
            lines += ["```python", _signature(node), "```", "", _text(node), ""]
            continue
        hidden = ("_", "Analyses", "Generic")
        bases = [base for base in map(ast.unparse, node.bases) if not base.startswith(hidden)]
        lines += [_text(node), ""]
        if bases:
            lines += [f"Base classes: `{', '.join(bases)}`.", ""]
        lines += _table(_members(node, source.splitlines()))
        if name == "Project":
            lines += ["Analyses, each with the keys of its table, which replace those of the file:", ""]
            lines += _table(_analyses(schema, node))
    return "\n".join(lines)

# SPDX-License-Identifier: BSD-3-Clause
"""The page of all keys of the project file, from its JSON Schema as `trivet schema` prints it."""

import itertools
import re

# Where a table is explained. A link to a place that does not exist stops the build of the site.
EXPLAINED = {
    "bodies": "project-file.md#solids-of-a-body",
    "nodes": "project-file.md#nodes",
    "element_types": "project-file.md#element-types",
    "tables": "project-file.md#tables-of-bodies-and-elements",
    "elements": "elements/README.md",
    "excitations": "project-file.md#excitations",
    "foundations": "project-file.md#flexible-foundations",
    "display": "project-file.md#units-of-tables-and-pictures",
    "report": "project-file.md#report",
    "requirements": "design.md#keys-values-and-margins",
    "parameters": "design.md#parameters",
    "clearances": "design.md#clearances",
    "relative": "analyses.md#relative-motion",
    "sections": "analyses.md#section-forces",
    "measurements": "measurements.md",
    "map": "map.md",
    "optimize": "design.md#trivet-optimize",
    "sample": "sample.md",
    "tolerances": "sample.md#tolerances",
    "random": "random.md",
    "transient": "transient.md",
    "steady": "nonlinear.md",
    "backbone": "nonlinear.md#nonlinear-modes",
    "accept": "plausibility.md",
    "scalar_laws": "nonlinear.md#laws",
}
PLAIN = {"number": "number", "vector": "three numbers", "coordinate": "`x` … `rz`", "matrix": "matrix"}
_ATOM = r"(?:kg|mm|m|N|s|rad|Pa|Hz|g|1(?=/))(?:\^?\d(?!\d)|[²³])?"
_UNIT = rf"{_ATOM}(?:(?: |/|·){_ATOM})*(?= …|[,;:]| beyond| of | per | along | about | \(|$)"
_DEFAULT = re.compile(r"\s*\(default:? ((?:[^()]|\([^()]*\))*)\)|[,;]?\s*\bdefault:? ([^;]*)$")
_POWERS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


def anchor(name):
    """The anchor of the section of a definition."""
    return "of-" + name.replace("_", "-")


def unit_and_rest(text):
    """The units with which a description begins, or one between commas, and the rest."""
    if found := re.match(rf"({_UNIT}(?:, {_UNIT})*)(?: …)?[,;:]?\s*", text):
        return _powers(found[1]), text[found.end() :]
    found = re.search(rf",\s*({_UNIT})(?=[,;]|$)", text)
    if found and "unit of" not in text:
        return _powers(found[1]), text[: found.start()] + text[found.end() :]
    return "", text


def _powers(unit):
    return re.sub(r"\^?(?<=[a-z^])(\d)", lambda power: power[1].translate(_POWERS), unit)


def default_and_rest(text):
    """The default that a description states, and the rest."""
    found = _DEFAULT.search(text)
    if not found:
        return "", text
    return (found[1] or found[2]).strip(), (text[: found.start()] + text[found.end() :]).strip(" ,;")


def _plural(words):
    words = re.sub(r"^(two|three|six)(?= )", r"rows of \1", words)
    return re.sub(r"^(number|whole number|text|table|value)\b", r"\1s", words)


def _cell(text):
    return text.replace("|", "\\|").replace("<", "&lt;").replace(">=", "≥").replace("\n", " ").strip()


def _united(forms):
    """The keys of all forms of a table. A key that is one of several constants may be each of them."""
    united = {}
    for key in dict.fromkeys(key for form in forms for key in form):
        values = [form[key] for form in forms if form.get(key, False) is not False]
        constants = list(dict.fromkeys(value["const"] for value in values if "const" in value))
        united[key] = values[0] if values else False
        if len(constants) > 1:
            about = {"description": text for value in values if (text := value.get("description"))}
            united[key] = {"enum": constants, **about}
    return united


class Keys:
    """Writes the tables of a schema."""

    def __init__(self, schema):
        self.schema = schema
        self.sections = []  # definitions that get a section of their own, in the order of their first use
        self.lines = []

    def definition(self, value):
        """Name of the definition to which a value refers, or None."""
        found = re.fullmatch(r"#/\$defs/(\w+)", value.get("$ref", ""))
        if not found:
            return None
        return self.definition(self.schema["$defs"][found[1]]) or found[1]  # some only add a description to another

    def resolved(self, value):
        if "$ref" not in value:
            return value
        referred = self.schema
        for step in value["$ref"].removeprefix("#/").split("/"):
            referred = referred[step]
        return {**self.resolved(referred), **{key: one for key, one in value.items() if key != "$ref"}}

    def is_table(self, value):
        """Whether a value is a table with keys, in at least one of its forms."""
        value = self.resolved(value)
        forms = [value, *value.get("anyOf", ())]
        return any(self.resolved(form).get("properties") or "additionalProperties" in form for form in forms)

    def kind(self, value):
        """What may be written, in words."""
        name = self.definition(value)
        if name in PLAIN:
            return PLAIN[name]
        if name and self.is_table(value):
            if name not in self.sections:
                self.sections.append(name)
            return f"[{name.replace('_', ' ')}](#{anchor(name)})"
        value = self.resolved(value)
        if "const" in value:
            return f"`{value['const']}`"
        if "enum" in value:
            return ", ".join(f"`{one}`" for one in value["enum"])
        if "anyOf" in value:
            return " or ".join(dict.fromkeys(self.kind(form) for form in value["anyOf"] if form))
        if value.get("type") == "array":
            item = self.kind(value["items"]) if isinstance(value.get("items"), dict) else "value"
            least, most = value.get("minItems"), value.get("maxItems")
            count = {(2, 2): "two", (3, 3): "three", (6, 6): "six"}.get((least, most), "list of")
            return f"{count} {_plural(item)}"
        kinds = {"object": "table", "string": "text", "boolean": "`true`, `false`", "integer": "whole number"}
        return kinds.get(value.get("type"), value.get("type", "value"))

    def rows(self, properties, required=(), prefix=""):
        """Rows of a table of keys: key, kind, unit, default, description; tables inside are opened."""
        for key, value in properties.items():
            if value is False or key == "accept":
                continue
            resolved = self.resolved(value)
            default, text = default_and_rest(resolved.get("description", ""))
            unit, text = unit_and_rest(text)
            if key in required:
                default = "required"
            if value.get("$ref") == "#/$defs/number" and "description" not in value:
                text = ""  # the definition tells only how any number is written
            kind = self.kind(value)
            yield f"| `{prefix}{key}` | {_cell(kind)} | {_cell(unit)} | {_cell(default)} | {_cell(text)} |"
            if self.definition(value) and self.is_table(value):
                continue  # it has a section
            yield from self.inner_rows(resolved, f"{prefix}{key}.")

    def inner_rows(self, value, prefix):
        for form in [value, *value.get("anyOf", ())]:
            if self.definition(form):
                continue
            yield from self.rows(form.get("properties", {}), form.get("required", ()), prefix)
            named = form.get("additionalProperties")
            if isinstance(named, dict) and not (self.definition(named) is None and not named.get("properties")):
                yield from self.rows({"NAME": named}, (), prefix)
            items = form.get("items")
            if isinstance(items, dict) and not self.definition(items) and items.get("properties"):
                yield from self.rows(items["properties"], items.get("required", ()), prefix.rstrip(".") + "[…].")

    def table(self, rows):
        rows = list(dict.fromkeys(rows))
        if rows:
            self.lines += ["", "| key | value | unit | default | meaning |", "|---|---|---|---|---|", *rows]

    def heading(self, level, text, name, about=""):
        self.lines += ["", f"{'#' * level} {text} {{#{name}}}"]
        if about:
            self.lines += ["", about[0].upper() + about[1:] + ("" if about.endswith(".") else ".")]

    def explained(self, name):
        if name in EXPLAINED:
            document, _, part = EXPLAINED[name].partition("#")
            words = (part or document.removesuffix(".md").removesuffix("/README")).replace("-", " ")
            self.lines += ["", f"Explanation: [{words}]({EXPLAINED[name]})."]

    def forms(self, level, table, value):
        """A section for each type of a table with several: excitations, foundations, elements, solids, laws of damping."""
        merged = {}
        for form in value["anyOf"]:
            form = self.resolved(form)
            kind = form.get("properties", {}).get("type", {})
            merged.setdefault(kind.get("const") or kind.get("pattern", "")[1:-2], []).append(form)
        keys = {kind: _united([form.get("properties", {}) for form in forms]) for kind, forms in merged.items()}
        shared = self.shared(keys.values()) if len(keys) > 3 else {}
        if shared:
            self.lines += ["", "Keys of most types; each type lists those that it does not have:"]
            self.table(self.rows(shared))
        for kind, forms in merged.items():
            required = set.intersection(*(set(form.get("required", ())) for form in forms))
            properties = keys[kind]
            if kind:
                kind = kind.replace("catalogue:", "catalogue:NAME")
                self.heading(level, f'{table}, `type = "{kind}"`', f"{table.strip('[]`')}-{kind}".replace(".", "-"))
                properties = {key: one for key, one in properties.items() if key != "type"}
            elif forms[0].get("description"):
                self.lines += ["", forms[0]["description"][0].upper() + forms[0]["description"][1:] + ":"]
            own = {key: value for key, value in properties.items() if shared.get(key) != value}
            if missing := [f"`{key}`" for key in shared if properties.get(key, False) is False]:
                self.lines += ["", f"Without {', '.join(missing)}."]
            self.table(self.rows(own, required))

    def shared(self, types):
        """The keys that more than half of the types have with the same meaning."""
        types = list(types)
        candidates = {key: value for one in reversed(types) for key, value in one.items()}
        return {
            key: value
            for key, value in candidates.items()
            if key != "accept" and sum(one.get(key) == value for one in types) > len(types) / 2
        }

    def section(self, level, title, name, value):
        """A table of the file with its keys."""
        about = value.get("description", "")
        value = self.resolved(value)
        self.heading(level, title, name, about or value.get("description", ""))
        self.explained(name.removeprefix("analyses-").removeprefix("of-").replace("-", "_"))
        if "properties" in value:
            self.table(self.rows(value["properties"], value.get("required", ())))
        if "anyOf" in value and any("properties" in self.resolved(form) for form in value["anyOf"]):
            tables = [form for form in value["anyOf"] if "properties" in self.resolved(form)]
            if any("type" in self.resolved(form)["properties"] for form in tables):
                self.forms(level + 1, title, {"anyOf": tables})
            else:
                plain = [self.kind(form) for form in value["anyOf"] if not self.is_table(form)]
                if plain:
                    self.lines += ["", "Either " + " or ".join(plain) + ", or a table:"]
                self.table(row for form in tables for row in self.rows(form["properties"], form.get("required", ())))
        named = value.get("additionalProperties")
        if isinstance(named, dict) and "properties" not in value and "anyOf" not in value:
            self.lines += ["", f"Any name: {self.kind(named)}."]

    def page(self):
        self.lines += [
            "# Keys of the project file",
            "",
            "All tables and keys, from the schema that `trivet schema` prints. A number is in the unit of its row, or a text",
            'with any unit that converts, `"420 N/mm"`. `NAME` is a name of yours. Rules between keys, and examples:',
            "[project-file.md](project-file.md).",
        ]
        top = self.schema["properties"]
        tables = {name for name, value in top.items() if self.is_table(value)} - {"accept"}
        self.heading(2, "Top of the file", "top")
        self.table(self.rows({name: top[name] for name in top if name not in tables}, self.schema["required"]))
        for name in (name for name in top if name in tables):
            value = self.resolved(top[name])
            named = value.get("additionalProperties")
            if name in ("analyses", "tables"):
                self.heading(2, f"`[{name}]`", name, value.get("description", ""))
                self.explained(name)
                for _, group in itertools.groupby(value["properties"].items(), lambda pair: pair[1]):
                    keys = [key for key, _ in group]
                    title = ", ".join(f"`[{name}.{key}]`" for key in keys)
                    self.section(3, title, f"{name}-{keys[0]}", value["properties"][keys[0]])
            elif isinstance(named, dict) and not value.get("properties") and self.is_table(named):
                about = value.get("description") or self.resolved(named).get("description", "")
                self.section(2, f"`[{name}.NAME]`", name, {**self.resolved(named), "description": about})
            else:
                self.section(2, f"`[{name}]`", name, value)
        self.heading(2, "Values that several tables have", "shared")
        for name in self.sections:  # grows meanwhile
            self.section(3, name.replace("_", " ").capitalize(), anchor(name), {"$ref": f"#/$defs/{name}"})
        return "\n".join(self.lines) + "\n"


def page(schema):
    """The page in Markdown."""
    return Keys(schema).page()

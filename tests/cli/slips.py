# SPDX-License-Identifier: BSD-3-Clause
"""Typical slips of engineers, each as a change of a project read from TOML, and writing projects as TOML."""
import collections
import json
import math
import re

G = 9.80665


def toml(value):
    """A value of a project as TOML, with all tables in braces."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(k, ensure_ascii=False)} = {toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return repr(value)


def text(project):
    lines = []
    for key, value in project.items():
        if not isinstance(value, dict):
            lines.append(f"{key} = {toml(value)}")
    for key, value in project.items():
        if not isinstance(value, dict):
            continue
        lines.append(f"[{key}]")
        lines += [f"{json.dumps(k, ensure_ascii=False)} = {toml(v)}" for k, v in value.items()]
    return "\n".join(lines) + "\n"


def times(value, factor):
    """A number, a text with a unit, or a list or table of these, times a factor."""
    if isinstance(value, list):
        return [times(v, factor) for v in value]
    if isinstance(value, dict):
        return {k: times(v, factor) for k, v in value.items()}
    if isinstance(value, str):
        number, unit = re.match(r"\s*([-+0-9.eE]+)(.*)", value).groups()
        return f"{float(number) * factor!r}{unit}"
    return value * factor


def kilograms(body):
    mass = body["mass"]
    if isinstance(mass, str):
        number, unit = re.match(r"\s*([-+0-9.eE]+)\s*(.*)", mass).groups()
        return float(number) * {"kg": 1, "t": 1000, "g": 1e-3}[unit.strip()]
    return mass


def without_cases(p):
    p["cases"] = {}
    p["analyses"].pop("map", None)


def first_body(p):
    return next(iter(p["bodies"].values()))


def first_name(p):
    return next(iter(p["bodies"]))


def written_out(p):
    """The project with types and rows written into every element, so that a slip changes a single element."""
    types = p.pop("element_types", {})
    for row in p.pop("tables", {}).get("elements", {}).get("rows", []):
        p.setdefault("elements", {})[row.pop("name")] = row
    for element in p["elements"].values():
        shared = types.get(element["type"])
        if shared:
            scale = shared.get("scale", 1) * element.get("scale", 1)
            element.update(shared)
            if scale != 1:
                element["scale"] = scale
    # What names a type has no meaning any more.
    p.get("parameters", {}).clear()
    p["cases"] = {k: v for k, v in p.get("cases", {}).items() if "element_types" not in v}
    if "requirements" in p:
        p["requirements"].pop("hold_in", None)
    return p


def elements(p, *types):
    return [e for e in p["elements"].values() if not types or e["type"] in types]


# Each slip changes a project in place and returns False if the project has no place for it.
def mass(factor):
    def slip(p):
        first_body(p)["mass"] = times(first_body(p)["mass"], factor)

    return slip


def inertia(factor):
    def slip(p):
        j = first_body(p)["inertia"]
        for key in j:
            if key != "about":
                j[key] = times(j[key], factor)

    return slip


def places(factor):
    def slip(p):
        if all(e.get("at", [0, 0, 0]) == [0, 0, 0] for e in elements(p)):
            return False
        for e in elements(p):
            for key in ("at", "from_at"):
                if key in e:
                    e[key] = times(e[key], factor)

    return slip


def stiffness(factor):
    def slip(p):
        typed = elements(p, "bushing", "matrix", "three_springs")
        for e in typed:
            key = "stiffness" if e["type"] == "matrix" else "translation"
            e[key] = times(e[key], factor)
        return bool(typed)

    return slip


def per_degree(p):
    typed = [e for e in elements(p, "bushing", "matrix") if e["type"] == "matrix" or "rotation" in e]
    for e in typed:
        if e["type"] == "bushing":
            e["rotation"] = times(e["rotation"], math.pi / 180)
        else:
            for i, row in enumerate(e["stiffness"]):
                for j in range(len(row)):
                    if i % 6 >= 3 and j % 6 >= 3:
                        row[j] *= math.pi / 180
    return bool(typed)


def gravity(vector):
    def slip(p):
        p["gravity"] = vector

    return slip


def modal_percent(p):
    if first_body(p).get("allow_unphysical"):
        return False
    p["damping"] = {"modal": 2}


def loss_percent(p):
    for e in elements(p):
        if e["type"] != "damper":
            e["damping"] = {"loss_factor": 0.9}
    p["analyses"].pop("transient", None)  # rejects loss factors
    without_cases(p)


def products(p):
    j = first_body(p)["inertia"]
    if not any(j.get(k) for k in ("xy", "xz", "yz")):
        return False
    for key in ("xy", "xz", "yz"):
        if key in j:
            j[key] = times(j[key], -1)


def rayleigh(p):
    p["damping"] = {"rayleigh": {"mass": 4e-4, "stiffness": 2.0}}


def overloaded(p):
    """Every mount of the first body becomes a catalogue mount of equal stiffness, rated for a twelfth of its load."""
    typed = [e for e in elements(p, "bushing") if e["on"] == first_name(p)]
    if not typed:
        return False
    load = sum(map(kilograms, p["bodies"].values())) * G / len(typed)
    for number, e in enumerate(typed):
        mount = {"maker": "test", "translation": e.pop("translation"), "static_load": [0, load / 12]}
        if "rotation" in e:
            mount["rotation"] = e.pop("rotation")
        e["type"] = f"catalogue:M{number}"
        e["catalogue"] = "mounts.toml"
        p.setdefault("+catalogue", {})[f"M{number}"] = mount
    without_cases(p)


def ask_in_time(p, **transient):
    """Adds a transient and replaces loss factors, which it rejects, by the same loss at 10 Hz."""
    for e in [*p["elements"].values(), *p.get("element_types", {}).values()]:
        factor = e.get("damping", {}).get("loss_factor") if isinstance(e.get("damping", {}), dict) else None
        if isinstance(factor, (int, float)):
            e["damping"] = {"proportional": factor / (2 * math.pi * 10)}
    p["analyses"]["transient"] = transient


def short_transient(p):
    p["excitations"]["+shock"] = {
        "type": "time",
        "on": first_name(p),
        "at": [0, 0, 0],
        "force": [0, 0, 1],
        "history": {"half_sine": {"amplitude": "100 N", "duration": "20 ms", "start": "30 ms"}},
    }
    ask_in_time(p, to="35 ms", step="1 ms")
    without_cases(p)


def missed_band(p):
    p["excitations"]["+force"] = {"type": "harmonic", "on": first_name(p), "at": [0, 0, 0], "force": [0, 0, "1 N"]}
    p["analyses"] = {"response": {"band": ["900 Hz", "2000 Hz"]}}
    p.pop("limits", None), p.pop("limit_lines", None)
    p["cases"] = {}


def missed_spectrum(p):
    p["excitations"]["+noise"] = {
        "type": "random",
        "on": first_name(p),
        "at": [0, 0, 0],
        "force": [0, 0, 1],
        "psd": {"flat": 1.0, "band": ["900 Hz", "2000 Hz"]},
    }
    p["analyses"]["random"] = {}
    without_cases(p)


def same_place(p):
    by_type = collections.defaultdict(list)
    for e in elements(p):
        by_type[e["type"], e["on"], e.get("from")].append(e)
    for (kind, _, _), group in by_type.items():
        if kind != "damper" and len(group) > 1:
            for key in ("at", "from_at", "axis", "orientation"):
                group[1].pop(key, None)
                if key in group[0]:
                    group[1][key] = group[0][key]
            return True
    return False


def heavy_rotor(p):
    p["excitations"]["+rotor"] = {
        "type": "unbalance",
        "on": first_name(p),
        "at": [0, 0, 0],
        "axis": "x",
        "grade": 6.3,
        "rotor_mass": 3 * kilograms(first_body(p)),
        "service_speed": "1500 rpm",
    }


def points_in_millimetres(p):
    changed = False
    for body in p["bodies"].values():
        for name, at in body.get("points", {}).items():
            if not isinstance(at, dict):
                body["points"][name] = times(at, 1e3)
                changed = changed or any(v != 0 for v in at)
    p["analyses"].pop("map", None)
    for e in p["excitations"].values():
        if e.get("on") and "at" in e and not isinstance(e["at"], str):
            e["at"] = times(e["at"], 1e3)
    return changed


def viscous_in_newtons_per_mm(p):
    """Every mount of the first body gets a damping ratio of 8 %, in N s/m typed as N s/mm."""
    typed = [e for e in elements(p, "bushing") if e["on"] == first_name(p)]
    for e in typed:
        k = sum(times(v, 1) if not isinstance(v, str) else float(v.split()[0]) for v in e["translation"]) / 3
        if any(isinstance(v, str) for v in e["translation"]):
            return False
        m = kilograms(first_body(p)) / len(typed)
        e["damping"] = {"translation": [1e3 * 0.16 * math.sqrt(k * m)] * 3, "rotation": [0, 0, 0]}
    without_cases(p)
    return bool(typed)


def pulse_in_seconds(p):
    p["excitations"]["+shock"] = {
        "type": "time",
        "on": first_name(p),
        "at": [0, 0, 0],
        "force": [0, 0, 1],
        "history": {"half_sine": {"amplitude": "100 N", "duration": 33}},
    }
    ask_in_time(p, to=40, step="10 ms")
    without_cases(p)


def speed_in_rpm(p):
    p["excitations"]["+rotor"] = {
        "type": "unbalance",
        "on": first_name(p),
        "at": [0, 0, 0],
        "axis": "x",
        "grade": 6.3,
        "rotor_mass": 0.1 * kilograms(first_body(p)),
        "service_speed": 1500,
    }


def soft_foundation(p):
    """A floor twice as stiff as a mount under each of them, in N/mm typed as N/m."""
    typed = [e for e in p["elements"].values() if "from" not in e]
    if not typed or any(
        e["type"] != "bushing" or "foundation" in e or any(isinstance(v, str) for v in e["translation"]) for e in typed
    ):
        return False
    p.setdefault("foundations", {})["+floor"] = {
        "type": "impedance",
        "translation": [2e-3 * max(typed[0]["translation"])] * 3,
    }
    for e in typed:
        e["foundation"] = "+floor"
    without_cases(p)


def bare_numbers(values):
    return not any(isinstance(v, str) for v in values)


def one_direction_in_newtons_per_mm(p):
    """The vertical stiffness of every element of the first body, if only mounts hold it."""
    held = [e for e in p["elements"].values() if first_name(p) in (e["on"], e.get("from"))]
    if not held or any(e["type"] != "bushing" or not bare_numbers(e["translation"]) for e in held):
        return False
    for e in held:
        e["translation"] = e["translation"][:2] + [1e-3 * e["translation"][2]]
    without_cases(p)


def scale_in_percent(p):
    typed = [e for e in elements(p, "bushing") if "scale" not in e]
    for e in typed:
        e["scale"] = 110
    without_cases(p)
    return bool(typed)


def one_without_damping(p):
    typed = elements(p, "bushing")
    if (
        len({(toml(e["translation"]), e["on"], e.get("from"), "damping" in e) for e in typed}) != 1
        or len(typed) < 3
        or "damping" not in typed[0]
    ):
        return False
    typed[0].pop("damping")
    without_cases(p)


def grade_times_thousand(p):
    speed_in_rpm(p)
    p["excitations"]["+rotor"].update({"grade": 6300, "service_speed": "1500 rpm"})


def limit_in_millimetres(p):
    p["limits"] = {f"{first_name(p)}.z": 12}
    p["analyses"]["response"] = {"band": [0, "30 Hz"], "of": [f"{first_name(p)}.z"]}
    p["excitations"]["+force"] = {"type": "harmonic", "on": first_name(p), "at": [0, 0, 0], "force": [0, 0, "1 N"]}
    p.pop("limit_lines", None)
    without_cases(p)


def no_quantity(p):
    p["excitations"]["+sine"] = {"type": "base", "translation": [0, 0, "98 m"]}
    without_cases(p)


def velocity_limit_in_millimetres(p):
    limit_in_millimetres(p)
    p["analyses"]["response"]["quantity"] = "velocity"
    p["limits"] = {f"{first_name(p)}.z": 7.1}


def requirement_in_millimetres(p):
    limit_in_millimetres(p)
    p["requirements"] = {"limits": p.pop("limits")}


def limit_line_in_millimetres(p):
    p["analyses"].setdefault("response", {}).pop("at", None)
    p["limit_lines"] = {"severity": {"of": f"{first_name(p)}.z", "rows": [[10, 4.5], [100, 2.8]]}}
    without_cases(p)


def motor_speed(p):
    speed_in_rpm(p)
    p["excitations"]["+rotor"]["service_speed"] = 1480


def one_damper(p):
    typed = elements(p, "damper")
    if len({(e["on"], e.get("from"), toml(e["coefficient"])) for e in typed}) != 1 or len(typed) < 3:
        return False
    typed[1]["coefficient"] = times(typed[1]["coefficient"], 1e-3)
    without_cases(p)


SLIPS = {
    "mass in grams": ("mass", mass(1e3)),
    "mass in tonnes": ("mass", mass(1e-3)),
    "places in millimetres": ("places", places(1e3)),
    "places in centimetres": ("places", places(1e2)),
    "inertia in kg cm²": ("inertia", inertia(1e4)),
    "inertia in t m²": ("inertia", inertia(1e-3)),
    "N/mm as N/m": ("stiffness", stiffness(1e-3)),
    "N/m as N/mm": ("stiffness", stiffness(1e3)),
    "stiffness per degree": ("stiffness per degree", per_degree),
    "gravity upwards": ("gravity", gravity([0, 0, G])),
    "gravity in g": ("gravity", gravity([0, 0, -1])),
    "gravity in mm/s²": ("gravity", gravity([0, 0, -9806.65])),
    "modal damping in percent": ("modal damping", modal_percent),
    "loss factor in percent": ("loss factor", loss_percent),
    "products with the other sign": ("products of inertia", products),
    "Rayleigh's numbers exchanged": ("rayleigh", rayleigh),
    "mount at 12 times its load": ("rated load", overloaded),
    "transient ends before its shock": ("transient", short_transient),
    "band misses all resonances": ("band", missed_band),
    "spectrum misses all resonances": ("spectrum", missed_spectrum),
    "two mounts at one place": ("same place", same_place),
    "rotor heavier than machine": ("rotor", heavy_rotor),
    "points in millimetres": ("points", points_in_millimetres),
    "viscous damping in N s/mm": ("viscous damping", viscous_in_newtons_per_mm),
    "pulse of ms in s": ("pulse", pulse_in_seconds),
    "speed in rpm": ("speed", speed_in_rpm),
    "floor in N/mm": ("stiffness", soft_foundation),
    "one direction in N/mm": ("stiffness", one_direction_in_newtons_per_mm),
    "scale in percent": ("scale", scale_in_percent),
    "one mount without damping": ("unequal mounts", one_without_damping),
    "grade times 1000": ("rotor", grade_times_thousand),
    "limit in mm": ("limit", limit_in_millimetres),
    "limit in mm/s": ("limit", velocity_limit_in_millimetres),
    "required limit in mm": ("limit", requirement_in_millimetres),
    "limit line in mm/s": ("limit", limit_line_in_millimetres),
    "ground without its quantity": ("ground motion", no_quantity),
    "speed of a motor in rpm": ("speed", motor_speed),
    "one damper in kN s/m": ("viscous damping", one_damper),
}

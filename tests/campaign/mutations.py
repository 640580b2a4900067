# SPDX-License-Identifier: BSD-3-Clause
"""Errors of projects: one function for each kind changes a valid text into a wrong one. The same random generator gives
the same text."""
import re

# A number that is a value: after "=", "[", "," or the opening quote of a text with a unit.
NUMBER = re.compile(r"(?<=[=\[,\s\"])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?=[\s,\]}\"]|$)")
TEXT = re.compile(r'"[^"\n]*"')
LINE = re.compile(r"^[^#\n\[][^\n]*=[^\n]*$", re.M)
HEADER = re.compile(r"^\[[^\n]+\]", re.M)


def without_comments(text):
    return "\n".join(re.sub(r'^((?:[^"#]|"[^"]*")*)#.*$', r"\1", line) for line in text.split("\n"))


def in_header(text, match):
    """Is the match in a table header? There a number is part of a name."""
    return re.match(r'\[["A-Za-z]', text[text.rfind("\n", 0, match.start()) + 1 :]) is not None


def replaced(random, text, pattern, change):
    """The text with one occurrence of the pattern changed."""
    found = [m for m in pattern.finditer(text) if m.group().strip() and not (pattern is NUMBER and in_header(text, m))]
    if not found:
        return text + "\n" + change("0") + "\n"
    one = random.choice(found)
    return text[: one.start()] + change(one.group()) + text[one.end() :]


def number_to(*values):
    return lambda random, text: replaced(random, text, NUMBER, lambda _: random.choice(values))


def scaled(random, text):
    factor = 10.0 ** random.randint(-12, 12)
    return replaced(random, text, NUMBER, lambda old: repr(float(old) * factor))


def sign(random, text):
    return replaced(random, text, NUMBER, lambda old: old[1:] if old.startswith("-") else "-" + old.lstrip("+"))


def to_text(random, text):
    words = [
        "",
        " ",
        "abc",
        "1,5 Hz",
        "5 furlong",
        "12 kg m",
        "kg",
        "1e400 N",
        "0x10",
        "𝟓",
        "NaN mm",
        "5 °C",
        "--5",
        "1 2",
        "ground",
        "x",
        "5 m/s/s/s",
        "%",
        "1e5" * 40,
    ]
    return replaced(random, text, NUMBER, lambda _: '"' + random.choice(words) + '"')


def other_kind(random, text):
    """A number, array, table, boolean or date instead of another value."""
    values = [
        "{}",
        "[]",
        "[[]]",
        "{x = 1}",
        "true",
        "2026-01-01",
        "[1, 2]",
        "[[1, 2], [3]]",
        '["a"]',
        "[1, [2, 3]]",
        "{a = {b = {c = 1}}}",
        "07:30:00",
        '"""a\nb"""',
        "[{}]",
    ]

    def change(line):
        return line.split("=", 1)[0] + "= " + random.choice(values)

    return replaced(random, text, LINE, change)


def twice(random, text):
    return replaced(random, text, random.choice([LINE, HEADER]), lambda line: line + "\n" + line)


def missing(random, text):
    return replaced(random, text, random.choice([LINE, LINE, HEADER]), lambda _: "")


def misspelt(random, text):
    def change(line):
        at = random.randrange(len(line))
        return random.choice(
            [
                line[:at] + line[at + 1 :],
                line[:at] + random.choice("qwx7_.-\"[]{}=") + line[at:],
                line[:at] + line[at : at + 2][::-1] + line[at + 2 :],
            ]
        )

    return replaced(random, text, random.choice([LINE, HEADER]), change)


def strange_name(random, text):
    names = [
        '"\\u001b[31m"',
        '"a\\tb"',
        '"a\\u0000b"',
        '"\\u202etxt"',
        '"\\u0085"',
        '"' + "n" * 101 + '"',
        '"' + "ж" * 200 + '"',
        '"<script>&\'"',
        '"a/b"',
        '"..\\\\.."',
        '""',
        '" "',
        '"ground"',
        '"a.b"',
        '"' + "x" * 5000 + '"',
        '"\\U0001F600"',
        '"%s%n"',
    ]
    if random.random() < 0.5:

        def header(line):
            parts = line[1:-1].split(".")
            return "[" + ".".join(parts[:-1] + [random.choice(names)]) + "]"

        return replaced(random, text, HEADER, header)
    return replaced(random, text, TEXT, lambda _: random.choice(names))


def odd_bytes(random, text):
    data = bytearray(text.encode())
    kind = random.randrange(7)
    if kind == 0:
        data = data[: random.randrange(len(data))]
    elif kind == 1:
        for _ in range(random.randint(1, 8)):
            data[random.randrange(len(data))] = random.randrange(256)
    elif kind == 2:
        data = bytearray(text.encode("utf-16"))
    elif kind == 3:
        data = bytearray(text.encode("latin-1", "replace")) + b"title2 = \"M\xfcller\"\n"
    elif kind == 4:
        at = random.randrange(len(data))
        data[at:at] = random.choice([b"\0", b"\r", b"\xef\xbb\xbf", b"\xff\xfe", b"\x1b[2J", b"\xed\xa0\x80"])
    elif kind == 5:
        data = bytearray(random.randbytes(random.randint(1, 3000)))
    else:
        data = bytearray(text.replace("\n", random.choice(["\r\n", "\r", "\n\n", "\u2028"])).encode())
    return bytes(data)


def sizes(random, text):
    """Too many things, or too much of one."""
    count = random.choice([0, 1, 300, 2000])
    kind = random.randrange(9)
    if kind == 0:
        return text + "".join(
            f'\n[bodies."extra {i}"]\nmass = 1\ninertia = {{about = "pole", xx = 1, yy = 1, zz = 1}}\n'
            for i in range(count)
        )
    if kind == 1:  # each case is a whole study: 30 end in time, 2000 are rejected
        count = 30 if count == 300 else count
        return text + "".join(f'\n[cases."extra {i}"]\nbodies = {{}}\n' for i in range(count))
    if kind == 2:
        return replaced(
            random, text, LINE, lambda line: line.split("=", 1)[0] + "= [" + ", ".join(["1.5"] * count) + "]"
        )
    if kind == 3:
        return replaced(random, text, LINE, lambda line: line.split("=", 1)[0] + "= " + "[" * count + "]" * count)
    if kind == 4:
        return text + "\n" + "a." * count + "b = 1\n"
    if kind == 5:
        return text + "".join(
            f'\n[excitations."extra {i}"]\ntype = "time"\nbase = true\ntranslation = [0, 0, 1]\nhistory = {{step = {{amplitude = 1}}}}\n'
            for i in range(min(count, 600))
        )
    if kind == 6:
        return text + "\nnotes = \"" + "long " * (10 * count) + "\"\n"
    if kind == 7:
        return (
            re.sub(r"points = \d+", f"points = {10 ** random.randint(0, 12)}", text)
            + f"\n[analyses.response]\nspacing = \"linear\"\npoints = {10 ** random.randint(0, 12)}\n"
        )
    return text + "".join(f'\n[elements."extra {i}"]\ntype = "damper"\non = "nobody"\n' for i in range(count))


def swapped(random, text):
    """Exchanges two values, so that their units, kinds and order change."""
    found = [m for m in re.finditer(r"(?<== )[^\n#]+", text)]
    if len(found) < 2:
        return text
    a, b = sorted(random.sample(found, 2), key=lambda m: m.start())
    return text[: a.start()] + b.group() + text[a.end() : b.start()] + a.group() + text[b.end() :]


def other_unit(random, text):
    units = [
        "Hz",
        "mm",
        "kg",
        "g",
        "t",
        "N/mm",
        "kN m/rad",
        "rpm",
        "deg",
        "%",
        "ms",
        "m/s2",
        "MPa",
        "lb",
        "N s/m",
        "kg m2",
        "dB",
        "µm",
        "ft",
        "J",
    ]
    return replaced(random, text, TEXT, lambda old: re.sub(r"[^\d.\-+eE\"]+\"$", f' {random.choice(units)}"', old))


KINDS = {
    "zero": number_to("0", "0.0"),
    "negative zero": number_to("-0.0", "-0"),
    "denormal": number_to("5e-324", "-4.9e-324", "1e-310", "2.2250738585072014e-308"),
    "tiny": number_to("1e-300", "-1e-300", "1e-61", "1e-59", "1e-30", "1e-15"),
    "huge": number_to("1e300", "-1e300", "1.7976931348623157e308", "1e400", "1e30", "1e18", "1e12"),
    "not a number": number_to("nan", "-nan", "inf", "-inf", "+inf"),
    "beyond 64 bits": number_to(
        "9223372036854775807", "9223372036854775808", "-9223372036854775809", "1" + "0" * 40, "0xFFFFFFFFFFFFFFFFFF"
    ),
    "another power of ten": scaled,
    "another sign": sign,
    "text for a number": to_text,
    "another kind of value": other_kind,
    "twice": twice,
    "missing": missing,
    "misspelt": misspelt,
    "strange name": strange_name,
    "odd bytes": odd_bytes,
    "sizes": sizes,
    "swapped": swapped,
    "another unit": other_unit,
}


def odd_table(random, data):
    """The same for a file that a project refers to: bytes to bytes."""
    lines = data.split(b"\n")
    kind = random.randrange(9)
    if kind == 0:
        return b""
    if kind == 1:
        return data[: random.randrange(len(data))]
    if kind == 2:
        return data.replace(b",", random.choice([b";", b"\t", b" ", b",,"]))
    if kind == 3:
        return data.replace(b".", b",")
    if kind == 4:
        row = random.randrange(len(lines))
        lines[row] = random.choice(
            [b"", b"nan,nan,nan", b"1e400,1,1", b"-,-,-", b"a,b,c", lines[row] * 2, b"\"", b"\xff\xfe"]
        )
        return b"\n".join(lines)
    if kind == 5:
        return b"\n".join([lines[0]] + lines[:0:-1])
    if kind == 6:
        return b"\n".join([lines[0]] * 3 + lines)
    if kind == 7:
        return b",".join(b"c%d" % i for i in range(random.choice([3, 5000]))) + b"\n1,2,3\n"
    changed = bytearray(data)
    for _ in range(5):
        changed[random.randrange(len(changed))] = random.randrange(256)
    return bytes(changed)

# SPDX-License-Identifier: BSD-3-Clause
"""Writes the universal files of this folder. pyuff 2.5.8 writes pyuff_*.unv; the others are put together here, with the
deviations from the standard that files of test systems have (README.md)."""
import struct

import numpy as np
import pyuff

START = "    -1\n"
POINTS = 7


def values():
    """Point k has the value (k + 1) 1e-6 (1 − 0.5 i) m/N."""
    k = np.arange(POINTS)
    return (k + 1) * 1e-6 * (1 - 0.5j)


def uneven():
    return np.array([1.0, 2.5, 4.25, 10.1, 11.0, 30.7, 99.9])


def head(ordinate_type, spacing, first=0.0, step=0.0, kind=4, unit="m"):
    lines = ["Receptance", "NONE", "28-Jan-21 14:01:42", "NONE", "NONE"]
    lines.append(f"{kind:5d}{1:10d}{0:5d}{0:10d} {'ENGINE':<10}{12:10d}{-3:4d} {'NONE':<10}{7:10d}{3:4d}")
    lines.append(f"{ordinate_type:10d}{POINTS:10d}{spacing:10d}{first:13.5E}{step:13.5E}{0:13.5E}")
    for quantity, label, its_unit in (
        (18, "Frequency", "Hz"),
        (8, "Displacement", unit),
        (13, "Force", "N"),
        (0, "NONE", "NONE"),
    ):
        lines.append(f"{quantity:10d}{0:5d}{0:5d}{0:5d} {label:<20} {its_unit:<20}")
    return lines


def binary_set(order, stated, line_end, data, lines, before_end=b""):
    top = [START.rstrip("\n"), f"    58b{order:6d}{2:6d}{11:12d}{stated:12d}{0:6d}{0:6d}{0:12d}{0:12d}"]
    text = line_end.join(top + lines) + line_end
    return text.encode("utf-8") + data + before_end + b"    -1" + line_end.encode()


def interleaved(x=None):
    parts = [] if x is None else [x]
    return np.column_stack(parts + [values().real, values().imag]).ravel()


def write(name, content):
    with open(name, "wb") as file:
        file.write(content.encode("latin-1") if isinstance(content, str) else content)


def odd_files():
    # Values without blanks between them, exponents of three digits, CRLF, no closing line.
    glued = [f"{-v:.5E}".replace("E-0", "E-00").rjust(13) for v in interleaved()]
    rows = ["".join(glued[i : i + 6]) for i in range(0, 2 * POINTS, 6)]
    write("without_blanks.unv", "\r\n".join([START.rstrip("\n"), "    58"] + head(5, 1, 5.0, 0.5) + rows + [""]))
    single = interleaved().astype("<f4").tobytes()
    write("line_end_before_delimiter.unv", binary_set(1, len(single), "\r\n", single, head(5, 1, 5.0, 0.5), b"\r\n"))
    double = interleaved().astype(">f8").tobytes()
    write("big_endian_wrong_bytes.unv", binary_set(2, 8 * POINTS, "\n", double, head(6, 1, 5.0, 0.5)))
    mixed = b"".join(struct.pack("<fdd", x, v.real, v.imag) for x, v in zip(uneven(), values()))
    write("uneven_single_abscissa.unv", binary_set(1, len(mixed), "\n", mixed, head(6, 0)))
    all_double = interleaved(uneven()).astype("<f8").tobytes()
    write("uneven_double_abscissa.unv", binary_set(1, 8 * POINTS, "\n", all_double, head(6, 0)))


def inch_file():
    """Units of inch and pound-force, other sets, a comment, delimiters in other columns, a mode without its zero nodes."""
    text = [
        "written by hand",
        "   -1",
        "   151",
        "machine",
        "",
        "NONE",
        "28-Jan-21 14:01:42",
        "",
        "NONE",
        "28-Jan-21 14:01:42",
        "   -1",
    ]
    text += ["    -1", "   164", "         7Inch (pound f)               2"]
    text += [
        "  3.93700787401574814D+01  2.24808943099710489D-01  1.80000000000000000D+00",
        "  4.59670000000000000D+02",
        "    -1",
    ]
    text += ["    -1", "    18", "         1         0         0         8         1", "CS1", "    -1"]
    text += ["    -1", "    15"]
    text += [
        f"{label:10d}{0:10d}{0:10d}{1:10d}{x:13.5E}{y:13.5E}{z:13.5E}"
        for label, x, y, z in ((7, 0, 0, 0), (12, 10, -20, 0.5))
    ]
    text += [
        "    -1",
        "    -1",
        "    82",
        f"{1:10d}{2:10d}{3:10d}",
        "wire",
        "".join(f"{n:10d}" for n in (7, 12, 0, 0, 0, 0, 0, 0)),
        "    -1",
    ]
    text += [
        "    -1",
        "    55",
        "first mode",
        "NONE",
        "NONE",
        "NONE",
        "NONE",
        "".join(f"{n:10d}" for n in (1, 2, 3, 8, 2, 6)),
    ]
    text += [
        "".join(f"{n:10d}" for n in (2, 4, 0, 1)),
        "".join(f"{v:13.5E}" for v in (12.5, 2.0, 0.01, 0.0)),
        f"{12:10d}",
    ]
    text += ["".join(f"{v:13.5E}" for v in (1.0, -2.0, 0.0, 0.1, 0.0, 0.0)), "    -1"]
    rows = ["".join(f"{v:20.12E}" for v in interleaved()[i : i + 4]) for i in range(0, 2 * POINTS, 4)]
    text += ["    -1", "    58"] + head(6, 1, 5.0, 0.5, unit="in") + rows + ["    -1"]
    write("inch_units.unv", "\n".join(text) + "\n")


def pyuff_files():
    for name, binary in (("pyuff_text.unv", 0), ("pyuff_binary.unv", 1)):
        function = dict(
            type=58,
            func_type=4,
            rsp_node=12,
            rsp_dir=-3,
            ref_node=7,
            ref_dir=3,
            data=values(),
            x=uneven(),
            binary=binary,
            abscissa_spacing=0,
            abscissa_spec_data_type=18,
            ordinate_spec_data_type=8,
            orddenom_spec_data_type=13,
        )
        mode = dict(
            type=55,
            analysis_type=3,
            data_ch=2,
            spec_data_type=8,
            load_case=1,
            mode_n=3,
            eig=-1.5 + 62.0j,
            modal_a=1 + 2j,
            modal_b=3 - 1j,
            node_nums=np.array([7, 12]),
            r1=np.array([1 + 2j, 3]),
            r2=np.array([0, -1j]),
            r3=np.array([0.5, 4]),
        )
        # pyuff loses the head of a binary set that is the first one of a file.
        pyuff.UFF(name).write_sets([mode, function], "overwrite")


if __name__ == "__main__":
    odd_files()
    inch_file()
    pyuff_files()

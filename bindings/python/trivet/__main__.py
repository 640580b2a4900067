# SPDX-License-Identifier: BSD-3-Clause
"""python -m trivet, and the command `trivet` of the package: the program of the command line."""

import os
import pathlib
import sys


def main() -> None:
    """Replaces this process by the program."""
    program = str(pathlib.Path(__file__).with_name("_program.py"))
    sys.stdout.flush()
    sys.stderr.flush()
    # -P -S -E: nothing but Python's own library is needed, and no setting of the user's may change it
    os.execv(sys.executable, [sys.executable, "-P", "-S", "-E", program, *sys.argv[1:]])


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: BSD-3-Clause
"""A file that is written as a whole or not at all."""

import os
import tempfile


def replace_file(path: str, text: str) -> None:
    """Writes the text next to the file and then puts it in its place, with the permissions of the earlier file."""
    target = os.path.realpath(path)
    try:
        mode = os.stat(target).st_mode & 0o777
    except FileNotFoundError:
        mode = 0o666 & ~_mask()
    descriptor, temporary = tempfile.mkstemp(prefix=".trivet-", dir=os.path.dirname(target))
    try:
        with open(descriptor, "w", encoding="utf-8", newline="") as file:
            file.write(text)
        os.chmod(temporary, mode)
        os.replace(temporary, target)
    except BaseException:
        os.unlink(temporary)
        raise


def _mask() -> int:
    """Permissions that new files of this process do not get."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask

# SPDX-License-Identifier: BSD-3-Clause
"""What the compiled part needs before its first use and at the end."""

import atexit
import os
import sys

from trivet import _core


@atexit.register
def _end() -> None:
    """Waits for interrupted computations; one that does not end must not use what is being destroyed."""
    if not _core.wait_for_interrupted_work(3.0):
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(130)

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::foundation {

/// For programs whose answers are many small matrices: freed memory stays with the process. By default it goes back to
/// the system as soon as its end is free and is asked for again, page by page: up to a sixth of the time of
/// `trivet steady`. With the GNU C library; others are left as they are. Call it first in main.
void keep_freed_memory();

}  // namespace trivet::foundation

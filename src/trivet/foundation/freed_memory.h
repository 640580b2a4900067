// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace trivet::foundation {

/// For programs whose results are many small matrices: freed memory stays with the process, up to 16 MiB for each
/// thread. By default the GNU C library returns the free end of its heap to the system and requests it again page by
/// page, an eighth of the time of `trivet steady`; other libraries are left as they are. Call it first in main.
void keep_freed_memory();

}  // namespace trivet::foundation

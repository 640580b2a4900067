// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/freed_memory.h"

#include <cstdlib>  // defines __GLIBC__
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace trivet::foundation {

void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int mebibyte = 1 << 20;
  // The first of these calls ends the library's own choice of all three. It would rise to 32 MiB for larger blocks,
  // which are mapped one by one.
  if (mallopt(M_MMAP_THRESHOLD, 32 * mebibyte) != 1) return;
  mallopt(M_TRIM_THRESHOLD, 16 * mebibyte);
  mallopt(M_TOP_PAD, mebibyte);
#endif
}

}  // namespace trivet::foundation

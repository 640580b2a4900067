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
  mallopt(M_TRIM_THRESHOLD, 64 * mebibyte);  // this much may stay
  mallopt(M_TOP_PAD, mebibyte);              // asked for at once
  mallopt(M_MMAP_THRESHOLD, 16 * mebibyte);  // larger blocks go back at once
#endif
}

}  // namespace trivet::foundation

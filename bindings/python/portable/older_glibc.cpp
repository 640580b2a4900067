// SPDX-License-Identifier: BSD-3-Clause
// The C++ runtime in this module asks for one name that C libraries before 2.32 lack. It stays inside the module.
#if __has_include(<sys/single_threaded.h>)
#include <sys/single_threaded.h>
/// False, so that reference counts are always atomic.
char __libc_single_threaded = 0;
#endif

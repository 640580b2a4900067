// SPDX-License-Identifier: BSD-3-Clause
// In a program that contains its C library. Loading a library of the system would load a second C library, of another
// version; so the system has none to load, and large decompositions are those of Trivet (numerics/linalg/lapack).
#include <dlfcn.h>

extern "C" void* dlopen(const char*, int) noexcept { return nullptr; }
extern "C" void* dlsym(void*, const char*) noexcept { return nullptr; }

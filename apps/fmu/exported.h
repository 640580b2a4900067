// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks the functions that the shared library exports. All other names stay inside it.
#if defined(_WIN32)
#define TRIVET_FMU_EXPORT extern "C" __declspec(dllexport)
#else
#define TRIVET_FMU_EXPORT extern "C" __attribute__((visibility("default")))
#endif

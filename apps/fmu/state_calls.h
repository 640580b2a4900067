// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "fmu/guarded_call.h"

/// Functions of both versions of the interface that save and restore the state of an instance.
namespace trivet::fmu {

/// @param state  where an earlier copy, which is overwritten, or null is found, and the copy is left
Outcome get_state(void* instance, const char* function, void** state);
Outcome set_state(void* instance, const char* function, void* state);
/// Does nothing for null.
Outcome free_state(void* instance, const char* function, void** state);
Outcome serialized_state_size(void* instance, const char* function, void* state, std::size_t* size);
Outcome serialize_state(void* instance, const char* function, void* state, void* bytes, std::size_t size);
Outcome deserialize_state(void* instance, const char* function, const void* bytes, std::size_t size, void** state);

}  // namespace trivet::fmu

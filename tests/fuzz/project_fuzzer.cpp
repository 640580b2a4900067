// SPDX-License-Identifier: BSD-3-Clause
// libFuzzer target: any bytes through every reader, then the quick results (tests/fuzz/exercise.h).
#include <cstddef>
#include <cstdint>

#include "fuzz/exercise.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  trivet::fuzz::exercise({reinterpret_cast<const char*>(data), size});
  return 0;
}

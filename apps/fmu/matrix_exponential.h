// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fmu/matrix.h"

namespace trivet::fmu {

/// e^M of a square matrix, to round-off: Padé approximant of order 13 of M/2^s, squared s times. [Higham2005]
/// @throws std::runtime_error if the result has an entry that is not finite
[[nodiscard]] Matrix matrix_exponential(Matrix m);

}  // namespace trivet::fmu

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/response/transient/transient.h"

namespace trivet::study {

struct TransientResult {
  response::TransientResponse response;
  assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement;
};

}  // namespace trivet::study

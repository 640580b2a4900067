// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/response/transient/transient.h"

namespace trivet::study {

struct TransientResult {
  response::TransientResponse response;
  assembly::Quantity quantity = assembly::Quantity::displacement;
};

}  // namespace trivet::study

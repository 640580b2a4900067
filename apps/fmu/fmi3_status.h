// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fmu/fmi3_interface.h"
#include "fmu/guarded_call.h"

namespace trivet::fmu {

[[nodiscard]] inline fmi3Status fmi3_status(Outcome outcome) {
  if (outcome == Outcome::error) return fmi3Error;
  return outcome == Outcome::warning ? fmi3Warning : fmi3OK;
}

}  // namespace trivet::fmu

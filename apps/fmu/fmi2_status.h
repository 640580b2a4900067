// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fmu/fmi2_interface.h"
#include "fmu/guarded_call.h"

namespace trivet::fmu {

[[nodiscard]] inline fmi2Status fmi2_status(Outcome outcome) {
  if (outcome == Outcome::error) return fmi2Error;
  return outcome == Outcome::warning ? fmi2Warning : fmi2OK;
}

}  // namespace trivet::fmu

// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/phase.h"

#include <string>

namespace trivet::fmu {

std::string phase_name(Phases phase) {
  switch (phase) {
    case phase::instantiated:
      return "the state before initialization";
    case phase::initialization:
      return "initialization mode";
    case phase::event:
      return "event mode";
    case phase::continuous_time:
      return "continuous-time mode";
    case phase::step:
      return "step mode";
    case phase::terminated:
      return "the state after termination";
    default:
      return "an unknown state";
  }
}

}  // namespace trivet::fmu

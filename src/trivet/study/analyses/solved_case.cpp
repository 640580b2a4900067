// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/solved_case.h"

namespace trivet::study {

SolvedCase::SolvedCase(const model::System& system_of_case, int lowest)
    : system(system_of_case),
      assembled(assembly::assemble(system)),
      modes(lowest > 0 ? modal::lowest_modes(system, assembled, lowest) : modal::modes(system, assembled)) {}

const modal::Roots& SolvedCase::roots() const {
  std::call_once(roots_once_, [this] { roots_ = modal::roots(system, assembled, modes); });
  return roots_;
}

}  // namespace trivet::study

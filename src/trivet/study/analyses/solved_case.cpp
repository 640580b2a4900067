// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/analyses/solved_case.h"

#include "trivet/numerics/linalg/quadratic_roots.h"

namespace trivet::study {

SolvedCase::SolvedCase(const model::System& system_of_case, int lowest)
    : system(system_of_case),
      assembled(assembly::assemble(system)),
      modes(lowest > 0 ? modal::lowest_modes(system, assembled, lowest) : modal::modes(system, assembled)) {}

const modal::Roots& SolvedCase::roots() const {
  std::call_once(roots_once_, [this] { roots_ = modal::roots(system, assembled, modes); });
  return roots_;
}

const Eigen::VectorXcd& SolvedCase::rough_poles() const {
  if (assembled.frequency_dependent()) return roots().poles;
  std::call_once(rough_poles_once_, [this] {
    rough_poles_ = numerics::poles(numerics::system_roots(assembled.matrices, numerics::RootParts::values));
  });
  return rough_poles_;
}

}  // namespace trivet::study

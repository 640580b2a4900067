// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/random_system.h"
#include "trivet/response/machinery/run_up.h"
#include "trivet/response/steady/peaks.h"

namespace trivet::test {

/// A system with its matrices, modes and roots.
struct SolvedSystem {
  explicit SolvedSystem(const model::Description& description)
      : system(checked(description)),
        assembled(assembly::assemble(system)),
        modes(modal::modes(system, assembled)),
        roots(modal::roots(system, assembled, modes)) {}

  std::vector<assembly::Channel> channels(
      const std::vector<std::string>& of,
      assembly::MotionQuantity quantity = assembly::MotionQuantity::displacement) const {
    return assembly::channels(system, assembled, of, quantity);
  }
  response::RunUp run_up(const std::vector<std::string>& of, const assembly::Band& speed, int points = 101) const {
    return response::run_up(assembled, channels(of), response::order_loadings(system, assembled), modes, roots,
                            {speed, 1e-6, points});
  }
  response::Peaks peaks(const std::vector<assembly::Channel>& of, const assembly::Loading& loading) const {
    return response::peaks(assembled, of, loading, modes, roots);
  }

  model::System system;
  assembly::Assembled assembled;
  modal::Modes modes;
  modal::Roots roots;
};

}  // namespace trivet::test

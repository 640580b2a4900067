// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

#include "trivet/assembly/assembled.h"
#include "trivet/modal/modes.h"
#include "trivet/modal/roots.h"

namespace trivet::study {

/// The solved model of a case. Any number of analyses may share it, on several threads.
class SolvedCase {
 public:
  /// @param system_of_case  must outlive this object
  /// @param lowest  only so many of the lowest modes are needed, and nothing but modes; 0: all
  explicit SolvedCase(const model::System& system_of_case, int lowest = 0);

  const model::System& system;
  const assembly::Assembled assembled;
  const modal::Modes modes;

  /// Damped roots, computed when they are first needed.
  [[nodiscard]] const modal::Roots& roots() const;

  /// The poles of all responses, as a drawing needs them: without refinement, so that light damping has few digits;
  /// those of `roots` if elements depend on frequency. Computed when they are first needed.
  [[nodiscard]] const Eigen::VectorXcd& rough_poles() const;

 private:
  mutable std::once_flag roots_once_, rough_poles_once_;
  mutable modal::Roots roots_;
  mutable Eigen::VectorXcd rough_poles_;
};

}  // namespace trivet::study

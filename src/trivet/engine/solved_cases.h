// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "trivet/project/project.h"
#include "trivet/study/analyses/solved_case.h"

namespace trivet::engine {

/// Solved cases of a session, so that several commands on one case solve it once. Thread-safe.
class SolvedCases {
 public:
  /// The matrices, modes and, when they are first needed, roots of a case, which must outlive them. Kept as long as
  /// this object lives, unless all kept ones together would take more than 256 MB (estimated from their matrices).
  [[nodiscard]] std::shared_ptr<const study::SolvedCase> of(const project::Case& variant);

 private:
  struct Kept {
    const project::Case* variant;
    std::shared_ptr<const study::SolvedCase> solved;
  };
  std::mutex lock_;
  std::vector<Kept> kept_;
  double bytes_ = 0;
};

}  // namespace trivet::engine

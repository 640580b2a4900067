// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "trivet/foundation/interruption.h"
#include "trivet/study/box/box_ends.h"
#include "trivet/study/box/box_growth.h"
#include "trivet/study/box/solution_box.h"

namespace trivet::study {

struct CheckedBox {
  BoxCheck check;
  std::vector<BoxCase> cases;
  std::vector<BoxViolation> violations;  ///< the worst of each requirement, and the first that cannot be judged
};

/// Judges the corners of a box and designs inside, and some of both by assembled models, with kernels that are fitted
/// to this box alone. The same for any number of threads.
[[nodiscard]] CheckedBox checked_box(const project::Project& project, const BoxEnds& ends,
                                     const project::BoxRequest& request, const foundation::Progress& progress);

}  // namespace trivet::study

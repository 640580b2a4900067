// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "trivet/project/analyses/question.h"

namespace trivet::project {

/// Run-up: all orders over the speed of the shaft.
struct OrdersQuestion : Question {
  assembly::Band speed;  ///< [rad/s]
};

}  // namespace trivet::project

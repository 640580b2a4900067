// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace trivet::foundation {

/// A caller broke a documented precondition.
class InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The mathematics gives no answer to a single question that was asked (a singular stiffness, for instance).
class NotComputable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace trivet::foundation

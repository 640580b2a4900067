// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace trivet::foundation {

/// A caller violated a documented precondition.
class InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A single requested result does not exist mathematically (a singular stiffness, for instance).
class NotComputable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace trivet::foundation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <functional>
#include <string_view>

namespace trivet::foundation {

/// Thrown by a progress callback to stop a long computation; the stack unwinds and cleans up.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Callback of long computations: current task and completed fraction, 0 … 1. May throw Interrupted.
using Progress = std::function<void(std::string_view task, double fraction)>;

inline void report_progress(const Progress& progress, std::string_view task, double fraction) {
  if (progress) progress(task, fraction);
}

}  // namespace trivet::foundation

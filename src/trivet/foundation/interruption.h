// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <functional>
#include <string_view>

namespace trivet::foundation {

/// Thrown by a progress callback to stop a long computation; everything on the way unwinds and cleans up.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Called now and then by long work with what it is doing and how far it is, 0 … 1. May throw Interrupted.
using Progress = std::function<void(std::string_view task, double fraction)>;

inline void report_progress(const Progress& progress, std::string_view task, double fraction) {
  if (progress) progress(task, fraction);
}

}  // namespace trivet::foundation

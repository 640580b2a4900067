// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace trivet::server {

/// Lines about refused requests: at most ten in a second, then their number, so that an attack does not fill a disk.
class RefusalLog {
 public:
  using Clock = std::chrono::steady_clock;
  explicit RefusalLog(std::function<void(std::string_view line)> write) : write_(std::move(write)) {}

  /// @param about  of the request: may have any characters
  void add(int status, std::string_view about, std::string_view reason, Clock::time_point now = Clock::now());

 private:
  std::function<void(std::string_view)> write_;
  Clock::time_point second_ = {};  ///< when the present second began
  std::size_t in_second_ = 0;
};

}  // namespace trivet::server

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "trivet/assembly/assembled.h"

namespace trivet::assembly {

/// A system that is assembled when that is first needed, once for all that need it. For one thread.
class AssembledOnce {
 public:
  /// @param system  must outlive this object
  explicit AssembledOnce(const model::System& system) : system_(system) {}

  /// @throws what `assemble` throws, each time
  [[nodiscard]] const Assembled& operator*() const {
    if (!made_) made_.emplace(assemble(system_));
    return *made_;
  }

 private:
  const model::System& system_;
  mutable std::optional<Assembled> made_;
};

}  // namespace trivet::assembly

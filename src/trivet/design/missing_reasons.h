// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "trivet/design/design_outcome.h"

namespace trivet::design {

/// A design in the form that a kernel needs, or the reason why it has no such form: "loss factors", "a moving ground" …
template <typename Design>
struct DesignOrReason {
  std::optional<Design> design;
  std::string reason;
};

/// Reasons why designs have no outcome, counted by kind, noted from any thread.
class MissingReasons {
 public:
  /// @param rule  decides the kind, except for its numbers  @param words  shown for the first design of the kind
  void note(std::size_t design, const std::string& rule, const std::string& words);

  /// In the order of their first designs, whichever thread noted first.
  [[nodiscard]] std::vector<MissingReason> list() const;

 private:
  mutable std::mutex noting_;
  std::vector<std::string> kinds_;
  std::vector<MissingReason> reasons_;
};

}  // namespace trivet::design

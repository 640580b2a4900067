// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "trivet/design/design_outcome.h"
#include "trivet/foundation/stored_words.h"

namespace trivet::design {

/// A design in the form that a kernel needs, or the reason why it has no such form: "loss factors", "a moving ground" …
template <typename Design>
struct DesignOrReason {
  std::optional<Design> design;
  std::string reason;
};

/// Reasons why designs have no outcome, counted by kind.
class MissingReasons {
 public:
  /// @param rule  decides the kind, except for its numbers  @param words  shown for the first design of the kind
  void note(std::size_t design, const std::string& rule, const std::string& words);
  void add(const MissingReasons& others);

  /// In the order of their first designs.
  [[nodiscard]] std::vector<MissingReason> list() const;

  void store(foundation::StoredWords& words) const;
  /// @throws foundation::DamagedText
  [[nodiscard]] static MissingReasons restored(foundation::WordReader& words);

 private:
  void add(const std::string& kind, const MissingReason& reason);

  std::map<std::string, MissingReason> reasons_;  ///< by their kinds
};

}  // namespace trivet::design

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "trivet/study/shared/part_file.h"

namespace trivet::study {

/// Which items of a loop one of several processes computes, and in which order: its own ones from the first, then those
/// of the others from their last. Helpers of one owner begin at different places, so that they do not compute the same.
class ItemOrder {
 public:
  ItemOrder(std::size_t count, const StudyPart& part);

  [[nodiscard]] bool is_found(std::size_t item) const { return state_[item] & found; }
  [[nodiscard]] bool is_taken(std::size_t item) const { return state_[item] & taken; }
  /// It has a result.
  void note_found(std::size_t item) { note(item, found); }
  /// This process computes it.
  void note_taken(std::size_t item) { note(item, taken); }

  [[nodiscard]] std::size_t missing() const { return missing_; }  ///< items without a result
  [[nodiscard]] bool is_over() const { return open_ == 0; }       ///< every item has a result or is taken

  /// The next item of this process that is neither found nor taken.
  [[nodiscard]] std::optional<std::size_t> own();
  /// The same of another part. @param spared  its first missing items that it is computing itself
  [[nodiscard]] std::optional<std::size_t> of(std::uint64_t owner, std::size_t spared);

 private:
  enum State : unsigned char { found = 1, taken = 2 };
  struct Cursor {
    std::size_t first = 0;    ///< places before it are found
    std::size_t helping = 0;  ///< steps of the helper before it lead to items that are done
  };

  void note(std::size_t item, State state);
  [[nodiscard]] std::size_t places(std::uint64_t owner) const;
  [[nodiscard]] std::size_t item_at(std::uint64_t owner, std::size_t place) const {
    return owner - 1 + place * part_.of;
  }

  StudyPart part_;
  std::vector<unsigned char> state_;
  std::vector<Cursor> cursors_;  ///< by owner
  std::size_t missing_, open_;
};

}  // namespace trivet::study

// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/shared/item_order.h"

#include "trivet/foundation/index.h"

namespace trivet::study {

ItemOrder::ItemOrder(std::size_t count, const StudyPart& part)
    : part_(part), state_(count, 0), cursors_(part.of), missing_(count), open_(count) {}

void ItemOrder::note(std::size_t item, State state) {
  if (state_[item] == 0) --open_;
  if (state == found && !is_found(item)) --missing_;
  state_[item] |= state;
}

std::size_t ItemOrder::places(std::uint64_t owner) const {
  return owner > state_.size() ? 0 : (state_.size() - owner) / part_.of + 1;
}

std::optional<std::size_t> ItemOrder::own() {
  Cursor& cursor = cursors_[part_.number - 1];
  const std::size_t count = places(part_.number);
  for (; cursor.first < count; ++cursor.first)
    if (const std::size_t item = item_at(part_.number, cursor.first); state_[item] == 0) return item;
  return std::nullopt;
}

std::optional<std::size_t> ItemOrder::of(std::uint64_t owner, std::size_t spared) {
  Cursor& cursor = cursors_[owner - 1];
  const std::size_t count = places(owner);
  while (cursor.first < count && is_found(item_at(owner, cursor.first))) ++cursor.first;
  std::size_t begin = cursor.first;  // the first place that the owner has probably not begun
  for (std::size_t begun = 0; begin < count && begun < spared; ++begin)
    begun += is_found(item_at(owner, begin)) ? 0 : 1;
  const std::size_t helper = to_size((part_.number + part_.of - owner) % part_.of), helpers = part_.of - 1;
  const std::size_t last = count - (helper - 1) * count / helpers;  // one beyond where this helper begins
  bool all_done = true;
  for (std::size_t step = cursor.helping; step < count; ++step) {
    const std::size_t place = (last + count - 1 - step) % count, item = item_at(owner, place);
    if (state_[item] == 0) {
      if (place >= begin) return item;
      all_done = false;
    } else if (all_done) {
      cursor.helping = step + 1;
    }
  }
  return std::nullopt;
}

}  // namespace trivet::study

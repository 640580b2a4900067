// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/layout.h"

#include <cassert>

namespace trivet::assembly {

Layout::Layout(const model::Description& description, const std::vector<Eigen::Index>& internal,
               const std::vector<bool>& last)
    : internal_(internal.size()) {
  assert(last.size() == internal.size());
  const auto add_block = [this](Eigen::Index rows) {
    if (rows > 0) blocks_.push_back(size_);
    size_ += rows;
  };
  for (const auto& body : description.bodies) {
    auto& rows = rows_.emplace_back();
    assert((body.is_node || of_bodies_ == size_) && "nodes follow all bodies, whose coordinates are the first rows");
    Eigen::Index free = 0;
    for (std::size_t j = 0; j < 6; ++j) rows[j] = body.free[j] ? size_ + free++ : -1;
    add_block(free);
    if (!body.is_node) of_bodies_ = size_;
  }
  for (const auto& foundation : description.foundations) {
    foundations_.push_back(size_);
    add_block(foundation.mass.rows());
  }
  for (const bool these : {false, true}) {
    before_last_ = size_;
    for (std::size_t e = 0; e < internal.size(); ++e) {
      if (last[e] != these) continue;
      internal_[e] = size_;
      add_block(internal[e]);
    }
  }
}

}  // namespace trivet::assembly

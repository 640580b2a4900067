// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/assembly/layout.h"

namespace trivet::assembly {

Layout::Layout(const std::vector<model::Body>& bodies) {
  for (const auto& body : bodies) {
    auto& rows = rows_.emplace_back();
    for (std::size_t j = 0; j < 6; ++j) rows[j] = body.free[j] ? size_++ : -1;
  }
}

}  // namespace trivet::assembly

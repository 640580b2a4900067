// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/format/preload_words.h"

#include <algorithm>

namespace trivet::results {

std::string preload_words(const model::System& system) {
  const bool any = std::ranges::any_of(system.elements(), [](const model::Element& element) {
    return element.law.preload && !element.law.preload->isZero(0);
  });
  return any
      ? " Deflections of elements with a preload are from their preloaded state: 0 where the preload carries the "
        "load."
      : "";
}

}  // namespace trivet::results

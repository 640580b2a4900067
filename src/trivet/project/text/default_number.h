// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "trivet/project/text/document.h"

namespace trivet::project {

/// A number that acts if its key is not written.
struct DefaultNumber {
  double value = 0;
  Quantity quantity = Quantity::pure;
};

/// Default at a path, for keys of which the file need not have any.
[[nodiscard]] std::optional<DefaultNumber> default_number(const std::vector<std::string>& keys);

/// Quantity of the number at a path of a document whose model has been read; none if there is no such number.
[[nodiscard]] std::optional<Quantity> quantity_at(const Node& document, const std::vector<std::string>& keys);

}  // namespace trivet::project

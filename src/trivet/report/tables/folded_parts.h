// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "trivet/documents/html_table.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/report/drawing/in_documents.h"

namespace trivet::report {

/// Parts that open by a click: equal ones once, with all their names.
class FoldedParts {
 public:
  explicit FoldedParts(std::string about) : about_(std::move(about)) {}
  void add(const std::string& name, std::string html) {
    auto known = std::ranges::find(parts_, html, &NamedPart::html);
    if (known == parts_.end()) known = parts_.insert(parts_.end(), {std::move(html), {}});
    known->names.push_back(name);
  }
  [[nodiscard]] std::string html() const {
    std::string all;
    for (const NamedPart& one : parts_) all += folded(about_ + foundation::comma_separated(one.names), one.html);
    return all;
  }

 private:
  struct NamedPart {
    std::string html;
    std::vector<std::string> names;
  };
  std::string about_;
  std::vector<NamedPart> parts_;
};

}  // namespace trivet::report

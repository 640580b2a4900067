// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

namespace trivet::documents {

/// A number as the shortest text that reads back as the same number, without memory of its own to allocate: tables of
/// curves have millions of them.
class ShortestDigits {
 public:
  explicit ShortestDigits(double value);
  [[nodiscard]] std::string_view view() const { return {characters_.data(), size_}; }

 private:
  std::array<char, 32> characters_;  ///< "-1.7976931348623157e+308" has 24
  std::size_t size_;
};

}  // namespace trivet::documents

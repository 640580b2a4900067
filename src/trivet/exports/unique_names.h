// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cctype>
#include <set>
#include <string>

namespace trivet::exports {

/// Names that a format allows only once: a further one like it gets a number, "name_2". Names that differ in the case
/// of letters only are alike: to Excel they are.
class UniqueNames {
 public:
  /// @param separator  between the name and its number
  explicit UniqueNames(std::string separator = "_") : separator_(std::move(separator)) {}

  std::string unique(const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; !used_.insert(lower_case(name)).second; ++i) name = fmt::format("{}{}{}", wanted, separator_, i);
    return name;
  }

 private:
  static std::string lower_case(std::string name) {
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
  }

  std::string separator_;
  std::set<std::string> used_;
};

/// Code points of a text in UTF-8; bytes that are none become U+FFFD.
[[nodiscard]] std::u32string code_points(const std::string& text);

/// The text in UTF-16.
[[nodiscard]] std::u16string utf16(const std::string& text);

}  // namespace trivet::exports

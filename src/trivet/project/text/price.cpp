// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/price.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <sstream>

namespace trivet::project {
namespace {

std::optional<double> amount_from(const std::string& word) {
  double amount = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), amount);
  const bool whole = error == std::errc() && end == word.data() + word.size();
  return whole && std::isfinite(amount) && amount >= 0 ? std::optional(amount) : std::nullopt;
}

bool is_currency(const std::string& word) {
  constexpr std::size_t longest = 8;
  return !word.empty() && word.size() <= longest && word.find_first_of("0123456789.,-+/") == std::string::npos;
}

}  // namespace

std::optional<model::Price> price_from(const std::string& text) {
  std::istringstream words(text);
  std::string first, second, more;
  words >> first >> second;
  if (words >> more) return std::nullopt;
  if (is_currency(first)) std::swap(first, second);
  const auto amount = amount_from(first);
  if (!amount || !is_currency(second)) return std::nullopt;
  return model::Price{*amount, second};
}

std::string price_words(const model::Price& price) { return fmt::format("{:.6g} {}", price.amount, price.currency); }

}  // namespace trivet::project

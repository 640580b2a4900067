// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/unit_parser.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>

namespace trivet::project {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter_or_sign(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80 || c == '_' ||
      c == '%';
}

/// @param exponent  within ±9, so that powers of factors stay in range
UnitValue power_of(const UnitValue& unit, int exponent) {
  UnitValue result{std::pow(unit.mantissa, exponent), unit.ten * exponent, {}, exponent == 1 ? unit.offset : 0};
  for (std::size_t i = 0; i < result.dimension.size(); ++i) result.dimension[i] = unit.dimension[i] * exponent;
  return result;
}

UnitValue product_of(const UnitValue& a, const UnitValue& b) {
  UnitValue result{a.mantissa * b.mantissa, a.ten + b.ten, {}, 0};
  for (std::size_t i = 0; i < result.dimension.size(); ++i) result.dimension[i] = a.dimension[i] + b.dimension[i];
  return result;
}

class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : text_(text) {}

  tl::expected<UnitValue, std::string> whole() {
    auto unit = product();
    if (unit && at_ != text_.size()) return nothing();
    return unit;
  }

 private:
  [[nodiscard]] tl::unexpected<std::string> nothing() const { return tl::make_unexpected(std::string(text_)); }
  [[nodiscard]] char next(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  void skip_spaces() {
    while (next() == ' ') ++at_;
  }

  tl::expected<UnitValue, std::string> product() {
    auto left = power();
    while (left) {
      skip_spaces();
      if (next() == '\0' || next() == ')') break;
      const bool divides = take_division();
      if (!divides) take_multiplication();
      const auto right = power();
      if (!right) return right;
      left = product_of(*left, divides ? power_of(*right, -1) : *right);
    }
    return left;
  }

  bool take_division() {
    constexpr std::string_view per = "per ";
    const bool in_words = text_.substr(at_).starts_with(per);
    if (next() != '/' && !in_words) return false;
    at_ += in_words ? per.size() : 1;
    return true;
  }

  /// A sign between two units; a space alone is one too.
  void take_multiplication() {
    constexpr std::string_view dot = "·";
    if (text_.substr(at_).starts_with(dot)) at_ += dot.size();
    else if (next() == '*' || next() == '.' || (next() == '-' && is_letter_or_sign(next(1)))) ++at_;
  }

  tl::expected<UnitValue, std::string> power() {
    skip_spaces();
    auto unit = single();
    if (!unit) return unit;
    const bool written = next() == '^';
    if (written) ++at_;
    if (!is_digit(next()) && !(next() == '-' && is_digit(next(1)))) {
      if (written) return nothing();
      return unit;
    }
    int exponent = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), exponent);
    constexpr int most = 9;
    if (error != std::errc() || exponent == 0 || std::abs(exponent) > most) return nothing();
    at_ = static_cast<std::size_t>(end - text_.data());
    return power_of(*unit, exponent);
  }

  tl::expected<UnitValue, std::string> single() {
    if (next() == '(') {
      ++at_;
      auto inside = product();
      if (inside && next() != ')') return nothing();
      ++at_;
      return inside;
    }
    if (next() == '1' && !is_digit(next(1))) {
      ++at_;
      return UnitValue{};
    }
    const std::size_t start = at_;
    while (is_letter_or_sign(next()) && !text_.substr(at_).starts_with(dot)) ++at_;
    const std::string_view word = text_.substr(start, at_ - start);
    if (word.empty()) return nothing();
    const auto unit = unit_of_word(word);
    if (!unit) return tl::make_unexpected(std::string(word));
    return *unit;
  }

  static constexpr std::string_view dot = "·";
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

tl::expected<UnitValue, std::string> parsed_unit(std::string_view text) { return UnitParser(text).whole(); }

}  // namespace trivet::project

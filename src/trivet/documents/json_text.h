// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// JSON values, and JSON as text.
namespace trivet::documents::json {

using Json = nlohmann::ordered_json;

/// JSON as text, `indent` blanks for each level (no line breaks by default). Lists of numbers stay on one line. Bytes
/// that are not UTF-8 (possible in file names) become U+FFFD.
[[nodiscard]] std::string text(const Json& json, int indent = -1);

/// A list of numbers, null where one is not finite. It is written as text at once: a value for each of the millions of
/// numbers of a large result would take most of a command's time.
class NumberList {
 public:
  void add(double value);
  void add(const std::complex<double>& value);  ///< [real, imaginary]
  [[nodiscard]] Json json() &&;

 private:
  void separate();

  std::vector<std::uint8_t> text_ = {'['};
};

/// A number, or null if it is not finite.
inline Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

template <typename T>
Json optional(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

inline Json complex_number(const std::complex<double>& z) {
  return std::isfinite(z.real()) && std::isfinite(z.imag()) ? Json{z.real(), z.imag()} : Json(nullptr);
}

/// Real or complex numbers.
template <typename Numbers>
Json list(const Numbers& values) {
  NumberList result;
  for (const auto& value : values) result.add(value);
  return std::move(result).json();
}

template <typename Matrix>
Json rows(const Matrix& matrix) {
  Json result = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) result.push_back(list(matrix.row(i)));
  return result;
}

}  // namespace trivet::documents::json

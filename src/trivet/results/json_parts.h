// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <complex>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "trivet/study/answers.h"

/// JSON values of Trivet's data; shared by the single answers and the result file.
namespace trivet::results::json {

using Json = nlohmann::ordered_json;

/// JSON as text, `indent` blanks for each level (no line breaks by default). Lists of numbers stay on one line. Bytes
/// that are not UTF-8 (possible in file names) become U+FFFD.
[[nodiscard]] std::string text(const Json& json, int indent = -1);

/// A list of numbers, null where one is not finite. It is written as text at once: a value for each of the millions of
/// numbers of a large answer would take most of a command's time.
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

[[nodiscard]] Json warnings(const foundation::Problems& problems);
/// Position of an end of an element: "on", "at", "in_ground", "axes_in_ground".
[[nodiscard]] Json end(const project::Case& variant, const model::End& end);
[[nodiscard]] Json response(const study::Answers& answers);
/// The response for drawing in a page: the curve model if there is one, instead of a long table.
[[nodiscard]] Json drawn_response(const study::Answers& answers);
[[nodiscard]] Json limit_lines(const study::Answers& answers);
[[nodiscard]] Json design_map(const study::DesignMap& map);
[[nodiscard]] Json verdict(const study::CaseVerdict& judged);
/// Least and largest static values over all cases.
[[nodiscard]] Json envelope(const study::Envelope& envelope);

/// Kinds of requirements whose slopes are differences of values. @param evaluations  designs computed for all of them
[[nodiscard]] Json differenced(const std::vector<std::string>& kinds, std::size_t evaluations);

/// The best design, and a front; as the command prints them.
[[nodiscard]] Json optimization(const study::Optimization& found);
[[nodiscard]] Json front(const study::DesignFront& front);

}  // namespace trivet::results::json

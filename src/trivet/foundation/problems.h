// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace trivet::foundation {

/// Place in a source text. Line and column count from 1; 0 means unknown.
struct Origin {
  std::string source;
  int line = 0;
  int column = 0;
};

/// "genset.toml:12"; only the file if the line is unknown; empty without a file.
[[nodiscard]] std::string place(const Origin& origin);

enum class Severity { error, warning };

/// One problem of the input data.
struct Problem {
  Severity severity = Severity::error;
  Origin origin;
  std::string subject;  ///< affected item, as a path: "elements.front spring.stiffness"
  std::string finding;  ///< value found
  std::string rule;     ///< rule that it violates
  std::string remedy;   ///< what to do
};

/// "genset.toml:12: error: bodies.frame.mass = -3 kg; a mass must be > 0; …remedy"
[[nodiscard]] std::string message(const Problem& problem);

/// All problems of one input, errors and warnings, in the order found.
class Problems {
 public:
  Problem& error(std::string subject, std::string finding, std::string rule, std::string remedy);
  Problem& warning(std::string subject, std::string finding, std::string rule, std::string remedy);
  void add(Problem problem) { list_.push_back(std::move(problem)); }
  void add(const Problems& others);

  [[nodiscard]] bool has_errors() const { return errors() > 0; }
  /// Number of errors, warnings not counted.
  [[nodiscard]] std::size_t errors() const;
  [[nodiscard]] const std::vector<Problem>& list() const { return list_; }
  [[nodiscard]] std::vector<Problem>& list() { return list_; }
  /// Orders by source line, unknown lines last, and drops repeats.
  void sort_by_origin();

 private:
  std::vector<Problem> list_;
};

template <typename T>
using Expected = tl::expected<T, Problems>;

/// The result of a function that failed with one problem.
[[nodiscard]] tl::unexpected<Problems> failure(Problem problem);

/// The name among `candidates` that was probably meant, or an empty string.
[[nodiscard]] std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace trivet::foundation

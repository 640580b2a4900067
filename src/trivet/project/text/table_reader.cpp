// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/foundation/plain_text.h"
#include "trivet/project/text/accepting_tables.h"
#include "trivet/project/text/admissible_range.h"
#include "trivet/project/text/level_slips.h"
#include "trivet/project/text/unit_slips.h"
#include "trivet/project/text/unsupported_keys.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::project {
namespace {

/// Largest deviation of a given rotation matrix from orthonormality that counts as rounding of its digits.
constexpr double orthonormal_within = 1e-9;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

TableReader::TableReader(const Node& table, std::string path, foundation::Problems& problems)
    : table_(table), path_(std::move(path)), problems_(problems) {}

foundation::Problem& TableReader::error_at(const Node& node, const std::string& where, std::string finding,
                                           std::string rule, std::string remedy) {
  foundation::Problem& problem = problems_.error(where, std::move(finding), std::move(rule), std::move(remedy));
  problem.origin = node.origin;
  return problem;
}

foundation::Problem& TableReader::error(const std::string& key, std::string finding, std::string rule,
                                        std::string remedy) {
  const Node* node = table_.find(key);
  const std::string where = path_.empty() ? key : key.empty() ? path_ : path_ + "." + key;
  return error_at(node ? *node : table_, where, std::move(finding), std::move(rule), std::move(remedy));
}

void TableReader::also_known(std::initializer_list<const char*> keys) {
  for (const char* key : keys) static_cast<void>(node(key));
}

std::size_t TableReader::errors() const { return problems_.errors(); }

void TableReader::add_of_file(const std::string& key, const foundation::Problems& findings) {
  const std::string where = path_.empty() ? key : path_ + "." + key;
  for (foundation::Problem problem : findings.list()) {
    if (problem.origin.source.empty()) problem.origin = (table_.find(key) ? *table_.find(key) : table_).origin;
    problem.subject = where + (problem.subject.empty() ? "" : ": " + problem.subject);
    problems_.add(std::move(problem));
  }
}

void TableReader::add(const foundation::Problems& findings, const Names& names) {
  const std::size_t before = problems_.list().size();
  const auto unread = [&](const std::string& subject) {
    return std::any_of(
        problems_.list().begin(), problems_.list().begin() + static_cast<std::ptrdiff_t>(before),
        [&](const foundation::Problem& known) {
          const std::string& other = known.subject;
          const bool same = other.starts_with(subject) &&
              (other.size() == subject.size() || other[subject.size()] == '.' || other[subject.size()] == '[');
          return same && known.severity == foundation::Severity::error;
        });
  };
  for (foundation::Problem problem : findings.list()) {
    for (const auto& [from, to] : names)
      if (problem.subject == from) {
        problem.subject = to;
        break;
      }
    if (!problem.subject.empty() && unread(path_ + "." + problem.subject)) continue;
    const Node* node = table_.find(problem.subject.substr(0, problem.subject.find('.')));
    problem.origin = (node ? *node : table_).origin;
    problem.subject = problem.subject.empty() ? path_ : path_ + "." + problem.subject;
    problems_.add(std::move(problem));
  }
}

void TableReader::missing(const std::string& key, const std::string& remedy) {
  error(key, "missing", "it is required", remedy);
}

bool TableReader::has(const std::string& key) const {
  if (std::ranges::find(queried_, key) == queried_.end()) queried_.push_back(key);
  return table_.find(key) != nullptr;
}

const Node* TableReader::node(const std::string& key) {
  if (std::ranges::find(known_, key) == known_.end()) known_.push_back(key);
  return table_.find(key);
}

const Node* TableReader::table(const std::string& key) {
  const Node* found = node(key);
  if (!found || found->kind == Node::Kind::table) return found;
  error(key, value_text(*found), "a table is expected here",
        "write " + key + " = {…} or [" + (path_.empty() ? key : path_ + "." + key) + "]");
  return nullptr;
}

std::optional<double> TableReader::scalar(const Node& value, const std::string& where, Quantity quantity,
                                          Levels levels) {
  value.quantity = quantity;
  const std::string unit = si_unit(quantity);
  const std::string remedy = number_remedy(quantity);
  double number = 0;
  if (value.kind == Node::Kind::integer || value.kind == Node::Kind::real) {
    number = value.number;
    if (quantity == Quantity::angle && std::abs(number) > 2 * std::numbers::pi) {
      problems_
          .warning(where, fmt::format("{:.6g} rad", number),
                   "an angle without a unit is in rad, and this is more than a turn",
                   fmt::format("write \"{:.6g} deg\" if degrees are meant", number))
          .origin = value.origin;
    }
  } else if (value.kind == Node::Kind::text) {
    const auto converted = to_si_at_level(value.text, quantity, levels);
    if (!converted) {
      const auto slip = levels == Levels::none ? std::nullopt : level_slip(value.text, quantity);
      error_at(value, where, value_text(value), slip ? slip->rule : converted.error(),
               slip ? slip->remedy : unit_remedy(split_level(value.text).number, quantity, where));
      return std::nullopt;
    }
    number = *converted;
  } else {
    error_at(value, where, value_text(value), "a number is expected here", remedy);
    return std::nullopt;
  }
  if (!std::isfinite(number)) {
    error_at(value, where, fmt::format("{}", number), "every number must be finite", remedy);
    return std::nullopt;
  }
  if (const auto broken = outside_range(number, quantity)) {
    const bool as_typed = quantity == Quantity::angular_frequency && value.kind == Node::Kind::text;
    error_at(value, where,
             as_typed ? value_text(value) : fmt::format("{:.6g}{}{}", number, unit.empty() ? "" : " ", unit), *broken,
             "check digits and unit");
    return std::nullopt;
  }
  return number;
}

std::optional<double> TableReader::number(const std::string& key, Quantity quantity, Levels levels) {
  const Node* value = node(key);
  if (!value) return std::nullopt;
  return scalar(*value, path_.empty() ? key : path_ + "." + key, quantity, levels);
}

double TableReader::required_number(const std::string& key, Quantity quantity, Levels levels) {
  if (!node(key))
    missing(key,
            quantity == Quantity::pure                    ? "give " + key + " as a number"
                : quantity == Quantity::angular_frequency ? "give " + key + " with its unit, as in \"5 Hz\""
                                                          : fmt::format("give {} in {}", key, si_unit(quantity)));
  return number(key, quantity, levels).value_or(0);
}

std::optional<std::string> TableReader::text(const std::string& key) {
  const Node* value = node(key);
  if (!value) return std::nullopt;
  if (value->kind == Node::Kind::text) return value->text;
  error(key, value_text(*value), "a text is expected here", "put it in quotes");
  return std::nullopt;
}

std::string TableReader::required_text(const std::string& key) {
  if (!node(key)) missing(key, "give " + key + " = \"…\"");
  return text(key).value_or("");
}

std::optional<bool> TableReader::boolean(const std::string& key) {
  const Node* value = node(key);
  if (!value) return std::nullopt;
  if (value->kind == Node::Kind::boolean) return value->boolean;
  error(key, value_text(*value), "true or false is expected here", "write true or false, without quotes");
  return std::nullopt;
}

std::optional<std::vector<std::string>> TableReader::texts(const std::string& key, const std::string& example) {
  const Node* value = node(key);
  if (!value) return std::nullopt;
  std::vector<std::string> result;
  if (value->kind == Node::Kind::text) return std::vector{value->text};
  bool good = value->kind == Node::Kind::array;
  for (const Node& item : value->items) {
    good = good && item.kind == Node::Kind::text;
    result.push_back(item.text);
  }
  if (good) return result;
  error(key, value_text(*value), "a text or an array of texts is expected here",
        "for instance " + key + " = " + example);
  return std::nullopt;
}

std::optional<std::vector<double>> TableReader::numbers(const std::string& key, Quantity quantity, Levels levels) {
  const Node* value = node(key);
  if (!value) return std::nullopt;
  if (value->kind != Node::Kind::array) {
    const bool component = value->kind == Node::Kind::table &&
        std::ranges::all_of(value->keys, [](const std::string& k) { return k == "x" || k == "y" || k == "z"; });
    error(key, component ? "components of an array that the file does not have" : value_text(*value),
          "an array of numbers is expected here", "put the numbers in square brackets, with commas between them");
    return std::nullopt;
  }
  std::vector<double> result;
  bool good = true;
  for (std::size_t i = 0; i < value->items.size(); ++i) {
    const std::string place = value->items.size() == 3 ? std::string{'.', "xyz"[i]}
                                                       : fmt::format("[{}]", i);  // as in its path, if it has one
    const auto item = scalar(value->items[i], path_ + (path_.empty() ? "" : ".") + key + place, quantity, levels);
    good = good && item;
    result.push_back(item.value_or(0));
  }
  return good ? std::optional(result) : std::nullopt;
}

std::optional<Eigen::Vector3d> TableReader::vector(const std::string& key, Quantity quantity, Levels levels) {
  const auto values = numbers(key, quantity, levels);
  if (!values) return std::nullopt;
  if (values->size() == 3) return Eigen::Vector3d((*values)[0], (*values)[1], (*values)[2]);
  error(key, fmt::format("{} numbers", values->size()), "three are expected: x, y, z", "complete or shorten the array");
  return std::nullopt;
}

std::optional<Eigen::MatrixXd> TableReader::matrix(const std::string& key,
                                                   const std::function<Quantity(int, int, int)>& quantity_of,
                                                   const std::vector<int>& allowed_sizes) {
  const Node* value = node(key);
  if (!value) return std::nullopt;
  std::vector<std::string> sizes;
  for (const int size : allowed_sizes) sizes.push_back(fmt::format("{0}×{0}", size));
  const std::string rule = "an array of rows, " + joined(sizes) + ", is expected here";
  const auto refuse = [&](const std::string& finding) {
    error(key, finding, rule, "check brackets, rows and columns");
    return std::nullopt;
  };
  if (value->kind != Node::Kind::array) return refuse(value_text(*value));
  const auto size = static_cast<int>(value->items.size());
  if (std::ranges::find(allowed_sizes, size) == allowed_sizes.end()) return refuse(fmt::format("{} rows", size));
  Eigen::MatrixXd result(size, size);
  bool good = true;
  for (int i = 0; i < size; ++i) {
    const Node& row = value->items[i];
    if (row.kind != Node::Kind::array) return refuse(fmt::format("row {} is {}", i + 1, kind_name(row.kind)));
    if (static_cast<int>(row.items.size()) != size)
      return refuse(fmt::format("row {} has {} entries", i + 1, row.items.size()));
    for (int j = 0; j < size; ++j) {
      const auto entry = scalar(row.items[j], fmt::format("{}.{}[{}][{}]", path_, key, i, j), quantity_of(size, i, j));
      good = good && entry;
      result(i, j) = entry.value_or(0);
    }
  }
  return good ? std::optional(result) : std::nullopt;
}

std::optional<Eigen::Vector3d> TableReader::direction(const std::string& key) {
  const Node* value = node(key);
  if (!value) return std::nullopt;
  if (value->kind == Node::Kind::text) {
    const bool negative = value->text.starts_with('-');
    const std::string letter = value->text.substr(negative || value->text.starts_with('+') ? 1 : 0);
    for (int i = 0; i < 3; ++i)
      if (letter == std::string(1, "xyz"[i])) return (negative ? -1.0 : 1.0) * Eigen::Vector3d::Unit(i);
    error(key, value_text(*value),
          "a direction is \"x\", \"y\", \"z\", one of them with a minus sign, or three numbers",
          "for instance \"-z\" or [0, 0, -1]");
    return std::nullopt;
  }
  const auto components = vector(key, Quantity::pure);
  if (!components) return std::nullopt;
  if (components->norm() > 0) return components->normalized();
  error(key, "[0, 0, 0]", "a direction is not zero", "give at least one number that is not 0");
  return std::nullopt;
}

std::optional<Eigen::Matrix3d> TableReader::orientation(const std::string& key) {
  const Node* value = table(key);
  if (!value) return std::nullopt;
  TableReader inside(*value, path_ + "." + key, problems_);
  if (inside.has("matrix")) {
    const auto matrix = inside.matrix("matrix", [](int, int, int) { return Quantity::pure; }, {3});
    inside.finish();
    if (!matrix) return std::nullopt;
    Eigen::Matrix3d axes = *matrix;
    const double deviation = (axes.transpose() * axes - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    const double handed = axes.col(0).dot(spatial::cross_matrix(axes.col(1)) * axes.col(2));
    if (deviation <= orthonormal_within && handed > 0) return axes;
    const bool left_handed = deviation <= orthonormal_within;
    inside.error("matrix",
                 left_handed ? "a left-handed set of axes"
                             : fmt::format("columns deviate from unit, perpendicular vectors by {:.2g}", deviation),
                 "the columns are the local x, y, z axes: unit vectors, perpendicular, right-handed",
                 "check signs and digits, or use axis and angle");
    return std::nullopt;
  }
  const auto axis = inside.direction("axis");
  const auto angle = inside.number("angle", Quantity::angle);
  if (!inside.has("axis")) inside.missing("axis", "give axis and angle, or matrix");
  if (!inside.has("angle")) inside.missing("angle", "give axis and angle, or matrix");
  inside.finish();
  if (!axis || !angle) return std::nullopt;
  return spatial::rotation_about(*axis, *angle);
}

std::optional<std::string> TableReader::choice(const std::string& key, const std::vector<std::string>& words) {
  auto word = text(key);
  if (!word || std::ranges::find(words, *word) != words.end()) return word;
  const std::string guess = foundation::nearest_name(*word, words);
  error(key, foundation::quoted(*word), "one of " + joined(words) + " is expected here",
        guess.empty() ? "choose one" : "did you mean \"" + guess + "\"?");
  return std::nullopt;
}

void TableReader::finish() {
  std::vector<std::string> named = known_;
  for (const std::string& key : queried_)
    if (std::ranges::find(known_, key) == known_.end()) named.push_back(key);
  for (std::size_t i = 0; i < table_.keys.size(); ++i) {
    const std::string& key = table_.keys[i];
    if (std::ranges::find(known_, key) != known_.end() || (key == "accept" && may_accept(path_))) continue;
    const std::string guess = foundation::nearest_name(key, named);
    const std::string short_key = foundation::shortened(key);
    const std::string where = path_.empty() ? short_key : path_ + "." + short_key;
    if (const auto outside = unsupported_key(path_, key)) {
      error_at(table_.items[i], where, value_text(table_.items[i]), outside->rule, outside->remedy);
      continue;
    }
    error_at(table_.items[i], where, "unknown key",
             named.empty() ? "this table has no keys" : "known here: " + joined(named),
             guess.empty() ? "remove it" : "did you mean \"" + guess + "\"?");
  }
}

}  // namespace trivet::project

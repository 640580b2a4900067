// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/model_number.h"

#include <algorithm>
#include <array>

#include "trivet/foundation/invalid_input.h"
#include "trivet/project/project.h"
#include "trivet/project/text/model_path.h"

namespace trivet::project {
namespace {

/// Default of a key that is not written.
std::optional<double> default_of(const std::vector<std::string>& keys) {
  const auto is_one_of = [](const std::string& key, const auto& words) {
    return std::find(words.begin(), words.end(), key) != words.end();
  };
  static constexpr std::array<const char*, 5> factors = {"scale", "stiffening", "damping_factor", "mass_about_center",
                                                         "modal_factor"};
  static constexpr std::array<const char*, 3> moments = {"xx", "yy", "zz"};
  const std::string& key = keys.back();
  if (is_one_of(key, factors)) return 1;
  if (keys.size() < 2) return std::nullopt;
  const std::string& table = keys[keys.size() - 2];
  if (table == "stiffness_factor") return 1;
  if (table == "moved" || table == "center_moved" || is_zero_by_default(table)) return 0;
  if (table == "inertia_about_center") return is_one_of(key, moments) ? 1 : 0;
  return std::nullopt;
}

}  // namespace

ModelNumber::ModelNumber(const std::string& path, std::string unit)
    : path_(path), unit_(std::move(unit)), keys_(path_keys(path)) {
  if (keys_.empty()) throw foundation::InvalidInput("\"" + path + "\" is not the path of a number");
}

std::optional<double> ModelNumber::read(const Case& variant) const {
  const Node* node = node_at(variant.written, keys_);
  if (!node && keys_.back() != "scale")
    node = node_at(variant.document, keys_);  // from its type, except a scale, which multiplies
  if (!node) {
    const auto plain = default_of(keys_);
    return plain ? in_unit({*plain, ""}, unit_) : std::nullopt;
  }
  const auto written = written_number(*node);
  return written ? in_unit(*written, unit_) : std::nullopt;
}

Node ModelNumber::change(double value) const { return change_of(keys_, value, unit_); }

}  // namespace trivet::project

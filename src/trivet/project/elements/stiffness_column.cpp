// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/stiffness_column.h"

#include <fmt/format.h>

#include <charconv>
#include <numbers>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/identification/causality.h"

namespace trivet::project {

namespace {

constexpr std::string_view ending_of_loss = "_loss";

}  // namespace

std::optional<std::pair<int, int>> matrix_entry_of(std::string_view column) {
  if (column.ends_with(ending_of_loss)) column.remove_suffix(ending_of_loss.size());
  if (!column.starts_with("k_")) return std::nullopt;
  column.remove_prefix(2);
  std::pair<int, int> entry;
  const char* end = column.end();
  const auto first = std::from_chars(column.begin(), end, entry.first);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != '_') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, entry.second);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  return entry;
}

std::optional<ColumnQuantity> stiffness_column_quantity(const std::string& name) {
  if (name == "frequency_hz") return in_hertz();
  if (const auto entry = matrix_entry_of(name)) {
    const bool moment = (entry->first - 1) % 6 >= 3, turn = (entry->second - 1) % 6 >= 3;
    if (moment) return turn ? Quantity::moment_per_angle : Quantity::moment_per_length;
    return turn ? Quantity::force_per_angle : Quantity::force_per_length;
  }
  std::string_view direction = name;
  if (direction.ends_with(ending_of_loss)) direction.remove_suffix(ending_of_loss.size());
  for (const char* axis : {"x", "y", "z"}) {
    if (direction == std::string("k_") + axis) return Quantity::force_per_length;
    if (direction == std::string("k_r") + axis) return Quantity::moment_per_angle;
  }
  return std::nullopt;
}

std::optional<elements::StiffnessTable> checked_table(TableReader& reader, const std::string& name,
                                                      const Eigen::MatrixXd& values,
                                                      elements::Interpolation interpolation, bool coupling) {
  elements::StiffnessTable table;
  table.storage = values.col(1);
  table.loss = values.col(2);
  table.interpolation = interpolation;
  table.angular_frequencies.assign(values.col(0).begin(), values.col(0).end());  // [Hz], for the messages
  elements::StiffnessTable as_written = table;
  if (coupling) as_written.loss = as_written.loss.cwiseAbs();
  foundation::Problems findings = elements::check(as_written, "");
  for (foundation::Problem& problem : findings.list()) problem.finding = name + ": " + problem.finding;
  reader.add_of_file("file", findings);
  if (findings.has_errors()) return std::nullopt;
  for (double& frequency : table.angular_frequencies) frequency *= 2 * std::numbers::pi;
  return table;
}

void judge_causality(TableReader& reader, const std::string& name, const elements::StiffnessTable& table,
                     model::Element& element) {
  identification::DynamicStiffnessTable data;
  std::vector<double> positive;
  std::vector<std::complex<double>> stiffness;
  for (std::size_t i = 0; i < table.angular_frequencies.size(); ++i)
    if (table.angular_frequencies[i] > 0) {
      positive.push_back(table.angular_frequencies[i]);
      stiffness.emplace_back(table.storage(to_index(i), 0), table.loss(to_index(i), 0));
    }
  data.angular_frequency = Eigen::Map<const Eigen::VectorXd>(positive.data(), to_index(positive.size()));
  data.stiffness = Eigen::Map<const Eigen::VectorXcd>(stiffness.data(), to_index(stiffness.size()));
  const auto check = identification::causality(data);
  if (!check) {
    foundation::Problems findings = check.error();
    for (foundation::Problem& problem : findings.list()) {
      problem.subject = "file";
      problem.finding = name + ": " + problem.finding;
    }
    reader.add(findings);
    return;
  }
  element.facts.push_back({"causality of " + name, check->verdict});
  if (check->passes) return;
  foundation::Problems doubtful;
  doubtful.warning(
      "file", fmt::format("{}: {:.3g} % from the nearest passive, causal stiffness", name, 100 * check->relative_rms),
      "storage and loss of a physical element satisfy the Kramers–Kronig relations",
      identification::remedy(check->kind) + ": " + check->verdict);
  reader.add(doubtful);
}

model::Fact defined_range(double from, double to) {
  return {"defined", fmt::format("{:.6g} … {:.6g} Hz", from / (2 * std::numbers::pi), to / (2 * std::numbers::pi))};
}

}  // namespace trivet::project

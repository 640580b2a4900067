// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/elements/stiffness_column.h"

#include <fmt/format.h>

#include <numbers>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/identification/causality.h"

namespace trivet::project {

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

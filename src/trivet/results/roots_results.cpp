// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/foundation/index.h"
#include "trivet/results/answer_writer.h"
#include "trivet/results/csv_field.h"
#include "trivet/results/shown_numbers.h"
#include "trivet/results/text_table.h"

/// Damped roots.
namespace trivet::results {
namespace json {
namespace {

Json names_of_bodies(const project::Case& variant) {
  Json names = Json::array();
  for (const auto& body : variant.system.bodies()) names.push_back(body.name);
  return names;
}

Json roots(const project::Case& variant, const study::Answers& answers) {
  Json result{{"bodies", names_of_bodies(variant)}, {"roots", Json::array()}, {"warnings", warnings(answers.warnings)}};
  for (const modal::Root& root : answers.roots.list) {
    result["roots"].push_back({{"eigenvalue", complex_number(root.eigenvalue)},
                               {"kind", modal::name(root.kind)},
                               {"angular_frequency", optional(root.angular_frequency)},
                               {"damped_angular_frequency", optional(root.damped_angular_frequency)},
                               {"damping_ratio", optional(root.damping_ratio)},
                               {"exact", root.exact},
                               {"shape", list(root.shape)},
                               {"nearest_mode", optional(root.nearest_mode)}});
  }
  return result;
}

}  // namespace
}  // namespace json

namespace {

std::string roots_csv(const project::Case&, const study::Answers& answers) {
  std::string text = "real [1/s],imaginary [rad/s],kind,angular_frequency [rad/s],damping_ratio,nearest_mode\n";
  for (const modal::Root& root : answers.roots.list)
    text += fmt::format("{},{},{},{},{},{}\n", csv_number(root.eigenvalue.real()), csv_number(root.eigenvalue.imag()),
                        modal::name(root.kind), csv_number(root.angular_frequency), csv_number(root.damping_ratio),
                        csv_number(root.nearest_mode));
  return text;
}

std::string roots_text(const project::Case& variant, const study::Answers& answers) {
  const std::string unit = frequency_unit(variant.display, "rad/s");
  const auto in_unit = [&](double omega) { return shown_frequency(variant.display, omega, "rad/s"); };
  TextTable table({"Re λ [1/s]", "Im λ [" + unit + "]", "kind", "|λ| [" + unit + "]", "damping ratio", "nearest mode"});
  for (const modal::Root& root : answers.roots.list)
    table.add({number_text(root.eigenvalue.real(), 8), number_text(in_unit(root.eigenvalue.imag()), 8),
               std::string(modal::name(root.kind)) + (root.exact ? "" : " (approximate)"),
               number_text(in_unit(root.angular_frequency.value_or(nothing)), 8),
               number_text(root.damping_ratio.value_or(nothing)),
               root.nearest_mode ? std::to_string(*root.nearest_mode) : "–"});
  return "Damped roots λ, motion ~ exp(λt)\n" + table.text();
}

void roots_arrays(const project::Case& variant, const study::Answers& answers, LabelledArrays& list) {
  using modal::Root;
  const std::vector<Root>& roots = answers.roots.list;
  Eigen::VectorXcd eigenvalues(to_index(roots.size()));
  for (std::size_t i = 0; i < roots.size(); ++i) eigenvalues(to_index(i)) = roots[i].eigenvalue;
  list.count("root", roots.size());
  list.copy("eigenvalue", "1/s", "root", std::move(eigenvalues));
  list.texts("kind", "root", roots, [](const Root& root) { return modal::name(root.kind); });
  list.column("angular_frequency", "rad/s", "root", roots, &Root::angular_frequency);
  list.column("damped_angular_frequency", "rad/s", "root", roots, &Root::damped_angular_frequency);
  list.column("damping_ratio", "1", "root", roots, &Root::damping_ratio);
  list.column("nearest_mode", "1", "root", roots, &Root::nearest_mode);
  list.column("exact", "1", "root", roots, &Root::exact);
  add_shape_coordinates(variant, {"1", "rad/m"}, list);
  list.lists("shape", unit_of_the_row, {"root", "coordinate"}, 6 * variant.system.bodies().size(), roots, &Root::shape);
}

}  // namespace

const AnswerWriter roots_results = {
    .has_answer = [](const project::Case& variant, const study::Answers&) { return variant.analyses.roots; },
    .json = json::roots,
    .tables = {{"roots.csv", roots_csv}},
    .text = roots_text,
    .arrays = roots_arrays,
};

}  // namespace trivet::results

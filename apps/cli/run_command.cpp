// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "cli/answer_tables.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/further_tables.h"
#include "cli/strictness.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/report/curve_groups.h"
#include "trivet/report/figures.h"
#include "trivet/report/further_figures.h"
#include "trivet/report/report_page.h"
#include "trivet/results/further_json.h"
#include "trivet/results/map_json.h"
#include "trivet/results/result_folder.h"
#include "trivet/results/tables_csv.h"

namespace trivet::cli {
namespace {

/// A case's name as part of a file name.
std::string file_stem(const std::string& case_name) {
  if (case_name.empty()) return "base";
  std::string stem;
  for (const char c : case_name) stem += std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80 ? c : '-';
  return foundation::shortened(stem, report::longest_file_part);
}

/// One folder per case, numbered, because different names may share the letters that are safe in a file name.
std::vector<std::string> case_folders(const project::Project& project) {
  std::vector<std::string> names;
  for (const project::Case& variant : project.cases) names.push_back(fmt::format("{:02}-{}", names.size(), file_stem(variant.name)));
  return names;
}

void write_case(results::ResultFolder& folder, const std::string& stem, const project::Case& variant, const study::Answers& answers) {
  const project::Analyses& asked = variant.analyses;
  if (asked.modes) folder.write(stem + "/modes.csv", results::modes_csv(variant, answers));
  if (asked.roots) folder.write(stem + "/roots.csv", results::roots_csv(answers));
  if (answers.response) folder.write(stem + "/response.csv", results::response_csv(answers));
  if (answers.peaks) folder.write(stem + "/peaks.csv", results::peaks_csv(answers));
  if (answers.statics) folder.write(stem + "/static.csv", results::static_csv(answers));
  if (answers.random) folder.write(stem + "/random.csv", results::random_csv(answers)), folder.write(stem + "/densities.csv", results::random_densities_csv(answers));
  if (answers.transient) folder.write(stem + "/transient.csv", results::transient_csv(answers));
  if (answers.orders) folder.write(stem + "/orders.csv", results::orders_csv(answers)), folder.write(stem + "/critical_speeds.csv", results::critical_speeds_csv(answers));
  if (answers.transmissibility) folder.write(stem + "/transmissibility.csv", results::transmissibility_csv(answers));
  if (answers.power) folder.write(stem + "/power.csv", results::power_csv(answers));
  if (!answers.shapes.empty()) folder.write(stem + "/shapes.csv", results::shapes_csv(answers));
  if (!answers.shock_spectra.empty()) folder.write(stem + "/shock_spectrum.csv", results::shock_spectrum_csv(answers));
  if (answers.map) folder.write(stem + "/map.csv", results::map_csv(*answers.map));
  if (answers.response)
    for (const report::Figure& figure : report::characteristics(answers)) folder.write(stem + "/" + figure.file_name, figure.svg);
  for (const report::Figure& figure : report::further_figures(answers)) folder.write(stem + "/" + figure.file_name, figure.svg);
}

/// A map where the file asks for one, the cases as points on it.
void add_map(const project::Project& project, const project::Case& variant, const foundation::Progress& step, study::Answers& answers) {
  try {
    answers.map = study::design_map(project, variant, *variant.analyses.map, {}, step);
    answers.warnings.add(answers.map->warnings);
  } catch (const foundation::NotComputable& reason) {
    answers.failures.emplace_back(reason.what());
  } catch (const foundation::InvalidInput& reason) {
    answers.failures.emplace_back(reason.what());
  }
}

std::string case_text(const project::Case& variant, const study::Answers& answers) {
  std::string text = variant.name.empty() ? "== Base model ==\n" : "== Case " + variant.name + " ==\n";
  for (const std::string& change : variant.changes) text += "  " + change + "\n";
  text += warnings_text(answers);
  const project::Analyses& asked = variant.analyses;
  if (asked.modes) text += modes_text(variant, answers) + "\n";
  if (asked.roots) text += roots_text(answers) + "\n";
  for (const std::string& failure : answers.failures) text += "NOT COMPUTED: " + failure + "\n";
  if (answers.peaks) text += peaks_text(answers) + "\n";
  if (answers.statics) text += static_text(answers) + "\n";
  if (answers.response) {
    const auto& check = answers.response->curves.check;
    text += fmt::format("Characteristics at {} frequencies from {} solves, backward error ≤ {:.1e}; second solver: {} (difference {:.1e}, allowed {:.1e})\n",
                        answers.response->curves.angular_frequency.size(), answers.response->curves.solves, check.worst_backward_error, answers.response->deep.verdict(),
                        answers.response->deep.worst_difference, answers.response->deep.allowed);
    text += limits_text(answers);
  }
  return text + further_text(answers) + "\n";
}

}  // namespace

int run_command(const Options& options) {
  if (options.output.empty()) {
    write_error("error: -o \"\": the result folder needs a name\n");
    return wrong_input;
  }
  const auto project = read_or_complain(options);
  if (!project) return wrong_input;
  const foundation::Progress report = progress();
  const std::vector<std::string> case_folder = case_folders(*project);
  results::ResultFolder folder(options.output, case_folder);
  std::vector<study::Answers> all;
  std::string text;
  for (std::size_t i = 0; i < project->cases.size(); ++i) {
    const project::Case& variant = project->cases[i];
    const auto step = [&](std::string_view task, double fraction) {
      report(fmt::format("{}: {}", variant.name.empty() ? "base model" : variant.name, task), (static_cast<double>(i) + fraction) / static_cast<double>(project->cases.size()));
    };
    all.push_back(study::answers(variant, variant.analyses, step));
    if (study::has_own_map(*project, variant)) add_map(*project, variant, step, all.back());
    write_case(folder, case_folder[i], variant, all.back());
    text += case_text(variant, all.back());
  }
  folder.write("results.json", results::results_json(*project, all));
  folder.write("report.html", report::report_page(*project, all, results::page_json(*project, all)));
  report("done", 1);
  for (const std::string& note : folder.publish()) write_error("warning: " + foundation::on_one_line(note) + "\n");
  write_output(text + fmt::format("Report: {}/report.html\n", options.output));
  Strictness strictness;
  for (const study::Answers& answers : all) strictness.add(answers);
  const bool complete = std::all_of(all.begin(), all.end(), [](const study::Answers& answers) { return answers.failures.empty(); });
  return strictness.exit_code(options.strict, complete ? done : not_computed);
}

}  // namespace trivet::cli

// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/progress_line.h"
#include "cli/strictness.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/report/answer_sections.h"
#include "trivet/report/curve_groups.h"
#include "trivet/report/figures.h"
#include "trivet/report/report_page.h"
#include "trivet/results/project_json.h"
#include "trivet/results/result_folder.h"
#include "trivet/results/verdict_results.h"
#include "trivet/results/verdict_words.h"
#include "trivet/results/written_answers.h"
#include "trivet/study/whole_study.h"

namespace trivet::cli {
namespace {

/// The name of a case as part of a file name.
std::string file_stem(const std::string& case_name) {
  if (case_name.empty()) return "base";
  std::string stem;
  for (const char c : case_name)
    stem += std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80 ? c : '-';
  return foundation::shortened(stem, report::longest_file_part);
}

/// One folder per case, numbered, because different names may give the same safe file name.
std::vector<std::string> case_folders(const project::Project& project) {
  std::vector<std::string> names;
  for (const project::Case& variant : project.cases)
    names.push_back(fmt::format("{:02}-{}", names.size(), file_stem(variant.name)));
  return names;
}

void write_case(results::ResultFolder& folder, const std::string& stem, const project::Case& variant,
                const study::Answers& answers) {
  for (const results::AnswerFile& file : results::answer_files(variant, answers))
    folder.write(stem + "/" + file.name, file.content);
  if (answers.response)
    for (const report::Figure& figure : report::characteristics(answers))
      folder.write(stem + "/" + figure.file_name, figure.svg);
  for (const report::Figure& figure : report::answer_figures(answers))
    folder.write(stem + "/" + figure.file_name, figure.svg);
}

std::string case_text(const project::Case& variant, const study::Answers& answers) {
  std::string text = variant.name.empty() ? "== Base model ==\n" : "== Case " + variant.name + " ==\n";
  for (const std::string& change : variant.changes) text += "  " + change + "\n";
  text += warnings_text(answers);
  return text + results::answers_summary(variant, answers) + "\n";
}

}  // namespace

int run_command(const Options& options) {
  if (options.output.empty()) {
    write_error("error: -o \"\": the result folder needs a name\n");
    return wrong_input;
  }
  const auto project = read_or_complain(options);
  if (!project) return wrong_input;
  const std::vector<std::string> case_folder = case_folders(*project);
  results::ResultFolder folder(options.output, case_folder);
  const foundation::Progress report = progress();
  std::string verdicts, text;
  const std::vector<study::Answers> all =
      study::run(*project, report, [&](std::size_t i, const study::Answers& answers) {
        write_case(folder, case_folder[i], project->cases[i], answers);
        if (answers.verdict) verdicts += results::verdict_summary(*answers.verdict);
        text += case_text(project->cases[i], answers);
      });
  const study::Envelope envelope = study::envelope_of(all);
  if (!envelope.rows.empty()) folder.write("envelope.csv", results::envelope_csv(envelope));
  folder.write("results.json", results::results_json(*project, all));
  folder.write("report.html", report::report_page(*project, all, results::page_json(*project, all)));
  report("done", 1);
  for (const std::string& note : folder.publish()) write_error("warning: " + foundation::on_one_line(note) + "\n");
  if (all.front().verdict) verdicts += (envelope.rows.empty() ? "" : "\n") + results::envelope_text(envelope);
  if (!verdicts.empty()) verdicts += "\n";
  write_output(verdicts + text + fmt::format("Report: {}/report.html\n", options.output));
  Strictness strictness;
  for (const study::Answers& answers : all) strictness.add(answers);
  const bool complete =
      std::all_of(all.begin(), all.end(), [](const study::Answers& answers) { return answers.failures.empty(); });
  return strictness.exit_code(options.strict, complete ? done : not_computed);
}

}  // namespace trivet::cli

// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/progress_line.h"
#include "cli/strictness.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/report/study_folder.h"
#include "trivet/results/verdict_results.h"
#include "trivet/results/verdict_words.h"
#include "trivet/results/written_answers.h"
#include "trivet/study/cut_short.h"
#include "trivet/study/whole_study.h"

namespace trivet::cli {
namespace {

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
  const report::WrittenStudy study = report::write_study(*project, options.output, progress());
  for (const std::string& note : study.notes) write_error("warning: " + foundation::on_one_line(note) + "\n");
  std::string verdicts, text;
  for (std::size_t i = 0; i < study.answers.size(); ++i) {
    if (study.answers[i].verdict) verdicts += results::verdict_summary(*study.answers[i].verdict);
    text += case_text(project->cases[i], study.answers[i]);
  }
  const study::Envelope& envelope = study.envelope;
  if (study.answers.front().verdict) verdicts += (envelope.rows.empty() ? "" : "\n") + results::envelope_text(envelope);
  if (!verdicts.empty()) verdicts += "\n";
  write_output(verdicts + text + fmt::format("Report: {}/report.html\n", options.output));
  Strictness strictness;
  for (const study::Answers& answers : study.answers) strictness.add(answers);
  const bool complete = std::all_of(study.answers.begin(), study.answers.end(), [](const study::Answers& answers) {
    return answers.failures.empty() && !study::is_cut_short(answers);
  });
  return strictness.exit_code(options.strict, complete ? done : not_computed);
}

}  // namespace trivet::cli

// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "trivet/engine/command_rows.h"
#include "trivet/engine/key_reader.h"
#include "trivet/exports/format.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/report_settings.h"
#include "trivet/report/page/study_folder.h"
#include "trivet/results/design/study_summary.h"
#include "trivet/results/design/verdict_results.h"
#include "trivet/results/format/written_results.h"
#include "trivet/results/model/project_json.h"

namespace trivet::engine {
namespace {

using HeldStudy = std::shared_ptr<const Held<report::WrittenStudy>>;

Result case_result(const HeldStudy& held, std::size_t number) {
  const project::Case& variant = held->project->cases[number];
  const study::CaseResults& found = held->found.results[number];
  Result result;
  result.command = "run";
  result.case_name = variant.name;
  result.title = held->project->title;
  add_notices(found, result);
  result.text = writer([held, &variant, &found] { return results::results_summary(variant, found); });
  result.json = writer([held, &variant, &found] { return results::case_results_json(*held->project, variant, found); });
  return result;
}

std::string case_heading(const project::Case& variant) {
  std::string text = variant.name.empty() ? "== Base model ==\n" : "== Case " + variant.name + " ==\n";
  for (const std::string& change : variant.changes) text += "  " + change + "\n";
  return text;
}

std::string verdicts_text(const report::WrittenStudy& study, std::size_t width) {
  std::string text;
  for (const study::CaseResults& one : study.results)
    if (one.verdict)
      text += as_text(results::verdict_document(*one.verdict), one.verdict->display, documents::in_summary, width);
  const study::Envelope& envelope = study.envelope;
  if (study.results.front().verdict)
    text += (envelope.rows.empty() ? "" : "\n") +
        as_text(results::envelope_document(envelope), envelope.display, documents::on_screen, width);
  return text.empty() ? text : text + "\n";
}

Result run(const Task& task) {
  const std::string folder = task.keys.text("output");
  project::ReportForm form = project::report_settings(*task.project).form;
  if (task.keys.has("report"))
    form = task.keys.text("report") == "short" ? project::ReportForm::brief : project::ReportForm::full;
  const HeldStudy held = hold(task, report::write_study(*task.project, folder, form, task.progress));
  Result result;
  result.remarks = held->found.notes;
  for (std::size_t i = 0; i < task.project->cases.size(); ++i) {
    result.cases.push_back(case_result(held, i));
    result.complete = result.complete && result.cases.back().complete;
    result.findings.add(held->found.results[i]);
  }
  result.text_on = [held, folder, cases = result.cases](const documents::Screen& screen) {
    const report::WrittenStudy& study = held->found;
    std::string text = results::study_summary(*held->project, study.results, screen.width);
    if (screen.full) text += verdicts_text(study, screen.width);
    for (std::size_t i = 0; screen.full && i < cases.size(); ++i)
      text += case_heading(held->project->cases[i]) + preface(cases[i]) +
          results::results_summary(held->project->cases[i], study.results[i], screen.width) + "\n";
    return text +
        fmt::format("Report: {}/report.html{}\n", folder,
                    screen.full ? "" : " (with all tables, also printed by --full)");
  };
  result.text = writer([text = result.text_on] { return text(documents::Screen{}); });
  return result;
}

std::string format_list() {
  std::string formats;
  for (const exports::Format& format : exports::formats())
    formats += std::string("\n  ") + format.name + ": " + format.about;
  return formats;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const exports::Format& format : exports::formats()) names.emplace_back(format.name);
  return names;
}

Result exported(const Task& task) {
  const std::string format = task.keys.text("to"), target = task.keys.text("output");
  Result result;
  result.remarks =
      exports::export_project(*task.project, task.variant, format, task.keys.texts("what"), target, task.progress);
  result.text = writer([format, target] { return fmt::format("{}: {}\n", format, target); });
  return result;
}

}  // namespace

std::vector<Command> whole_commands() {
  return {
      {.name = "run",
       .about = "all analyses of the file: a summary on the screen, numbers and report.html in a folder",
       .group = Group::whole,
       .of_one_case = false,
       .case_alone = "the analyses of this case alone, judged as one in which the design has to hold; no search",
       .all_tables = true,
       .keys = {{.name = "output",
                 .kind = KeyKind::file,
                 .about = "result folder",
                 .by_default = "trivet-results",
                 .short_name = "o"},
                {.name = "report",
                 .kind = KeyKind::choice,
                 .about = "form of report.html, in place of that of the file",
                 .choices = {"full", "short"}}},
       .json = false,
       .strict = true,
       .warnings_within = true,
       .examples = {"trivet run machine.toml", "trivet run machine.toml -o results --strict"},
       .run = run},
      {.name = "export",
       .about = "matrices and results in files of other programs, notes on what these lose",
       .group = Group::data,
       .of_one_case = true,
       .all_tables = true,
       .keys = {{.name = "to",
                 .kind = KeyKind::text,
                 .about = "format:" + format_list(),
                 .choices = format_names(),
                 .required = true,
                 .value = "FORMAT"},
                {.name = "output",
                 .kind = KeyKind::file,
                 .about = "file, or folder of files",
                 .required = true,
                 .short_name = "o"},
                {.name = "what",
                 .kind = KeyKind::text,
                 .about = "matrices and analyses, as in matrices,modes,response; default: what the format and the "
                          "file have",
                 .value = "PART,…"}},
       .json = false,
       .warnings_within = true,
       .examples = {"trivet export machine.toml --to matlab -o machine.mat",
                    "trivet export machine.toml --to csv -o tables --what matrices,modes"},
       .run = exported},
  };
}

}  // namespace trivet::engine

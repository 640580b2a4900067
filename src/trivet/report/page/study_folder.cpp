// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/page/study_folder.h"

#include <fmt/format.h>

#include <cctype>

#include "trivet/foundation/plain_text.h"
#include "trivet/report/drawing/curve_groups.h"
#include "trivet/report/drawing/figures.h"
#include "trivet/report/page/report_page.h"
#include "trivet/report/page/result_sections.h"
#include "trivet/results/design/verdict_results.h"
#include "trivet/results/files/result_folder.h"
#include "trivet/results/format/written_results.h"
#include "trivet/results/model/project_json.h"

namespace trivet::report {
namespace {

/// The name of a case as part of a file name.
std::string file_stem(const std::string& case_name) {
  if (case_name.empty()) return "base";
  std::string stem;
  for (const char c : case_name)
    stem += std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80 ? c : '-';
  return foundation::shortened(stem, longest_file_part);
}

/// One folder per case, numbered, because different names may give the same safe file name.
std::vector<std::string> case_folders(const project::Project& project) {
  std::vector<std::string> names;
  for (const project::Case& variant : project.cases)
    names.push_back(fmt::format("{:02}-{}", names.size(), file_stem(variant.name)));
  return names;
}

void write_case(results::ResultFolder& folder, const std::string& stem, const project::Case& variant,
                const study::CaseResults& results) {
  for (const results::ResultFile& file : results::result_files(variant, results))
    folder.write(stem + "/" + file.name, file.content);
  if (results.response)
    for (const Figure& figure : characteristics(results)) folder.write(stem + "/" + figure.file_name, figure.svg);
  for (const Figure& figure : result_figures(variant, results)) folder.write(stem + "/" + figure.file_name, figure.svg);
}

}  // namespace

WrittenStudy write_study(const project::Project& project, const std::string& folder_name,
                         const project::ReportForm form, const foundation::Progress& progress) {
  const std::vector<std::string> names = case_folders(project);
  results::ResultFolder folder(folder_name, names);
  WrittenStudy study;
  study.results = study::run(project, progress, [&](std::size_t i, const study::CaseResults& results) {
    write_case(folder, names[i], project.cases[i], results);
  });
  study.envelope = study::envelope_of(study.results);
  if (!study.envelope.rows.empty())
    folder.write("envelope.csv", as_csv(results::envelope_document(study.envelope), "envelope.csv"));
  folder.write("results.json", results::results_json(project, study.results));
  const CaseMapCurves curves =
      form == project::ReportForm::full ? case_map_curves(project, study.results, progress) : CaseMapCurves();
  folder.write("report.html",
               report_page(project, study.results, results::page_json(project, study.results), form, curves));
  foundation::report_progress(progress, "done", 1);
  study.notes = folder.publish();
  return study;
}

}  // namespace trivet::report

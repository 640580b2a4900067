// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "trivet/engine/command_rows.h"
#include "trivet/engine/key_reader.h"
#include "trivet/engine/study_keys.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/report/figures/design_lines_figure.h"
#include "trivet/report/figures/sample_figure.h"
#include "trivet/report/figures/share_figure.h"
#include "trivet/results/design/band_parts.h"
#include "trivet/results/design/sample_document.h"
#include "trivet/results/design/study_status_document.h"
#include "trivet/study/sample/sample_study.h"
#include "trivet/study/sample/study_status.h"

namespace trivet::engine {
namespace {

using foundation::InvalidInput;

study::Sample sampled(const Task& task) {
  const auto folder = study_folder(task);
  if (!folder) return study::sample(*task.project, task.progress, {.shares = task.keys.flag("shares")});
  return study::sample_in_folder(*task.project,
                                 {.folder = *folder,
                                  .part = part_of(task).part,
                                  .shares = task.keys.flag("shares"),
                                  .ends = task.request.ends_study},
                                 task.progress);
}

void add_remarks(const study::StudyProgress& study, const Task& task, Result& result) {
  const std::string folder = study.folder.string();
  result.remarks.push_back(fmt::format("{}: {} of {} chunks were there; {} computed {}", folder, study.found,
                                       study.chunks, part_of(task).words(), study.computed));
  if (!study.damaged.empty()) result.remarks.push_back(damaged_files(study.folder, study.damaged));
  if (!study.overlapping.empty())
    result.remarks.push_back(
        fmt::format("{}: {} not counted: other files have the same chunks", folder, files_words(study.overlapping)));
  if (!study.is_locked) result.remarks.push_back(without_locks(study.folder));
}

using HeldSample = std::shared_ptr<const Held<study::Sample>>;

/// The picture of the shares of the variance, if they are wanted, or else of the bands; both below the tables of a
/// page, with the kept designs as lines.
void add_figures(const HeldSample& held, bool wants_shares, Result& result) {
  const auto shares = report::share_figure(held->found), bands = report::band_figure(held->found);
  if (const auto& figure = wants_shares ? shares : bands)
    result.figures.emplace_back(figure->file_name, writer([svg = figure->svg] { return svg; }));
  add_below_tables(
      [held](const project::DisplayUnits& display) {
        std::vector<report::Figure> figures;
        for (auto& figure : {report::band_figure(held->found, display), report::share_figure(held->found, display),
                             report::design_lines_figure(held->found, display)})
          if (figure) figures.push_back(*figure);
        return figures;
      },
      result);
}

/// A part of a study that others go on with has not failed without the shares.
void explain_no_picture(const Task& task, const study::Sample& found, Result& result) {
  const std::string picture = task.keys.written("picture") + ": ";
  if (task.keys.flag("shares") && !found.shares)
    return result.remarks.push_back(picture + "the shares of the variance are computed when the study is complete");
  const std::string reason = found.shares ? found.shares->reason : "";
  result.add_not_written(picture + (found.shares ? "there are no shares of the variance" : "there are no bands") +
                         (reason.empty() ? "" : ": " + reason));
}

/// What a picture needs.
void check_picture(const Task& task) {
  if (!task.keys.has("picture") || task.keys.flag("shares")) return;
  const project::Analyses& analyses = task.project->base().analyses;
  if (!analyses.sample || analyses.sample->bands.empty())
    throw InvalidInput(fmt::format(
        "{}: a picture shows bands; name their results: bands = [\"BODY.z\"] in [analyses.sample]; or shares of "
        "the variance, with {}",
        task.keys.written("picture"), task.keys.written("shares")));
  if (analyses.response && analyses.response->at.size() == 1)
    throw InvalidInput(task.keys.written("picture") +
                       ": a picture shows bands over at least two frequencies of the response; "
                       "without it the table has them");
}

Result sample(const Task& task) {
  check_picture(task);
  const auto held = hold(task, sampled(task));
  Result result;
  result.warnings = task.project->base().warnings;
  const auto document = [held, warnings = result.warnings](const project::DisplayUnits& display) {
    auto shown = std::make_shared<study::Sample>(held->found);
    for (study::SampledCaseResult& one : shown->cases) one.display = display;
    documents::Document found = results::sample_document(*shown, warnings);
    found.held = shown;
    return found;
  };
  std::vector<std::string> files = {"sample.csv", "designs.csv"};
  if (results::has_bands(held->found)) files.emplace_back("bands.csv");
  set_forms(document, held, task.variant.display, files, result);
  if (!held->found.study || held->found.study->is_complete()) {  // a part of the designs has no verdict
    result.findings.add(held->found);
    if (!held->found.request.yield && held->found.any_violates()) result.findings.add_violating_designs();
  }
  add_figures(held, task.keys.flag("shares"), result);
  if (task.keys.has("picture") && result.figures.empty()) explain_no_picture(task, held->found, result);
  if (const auto& study = held->found.study) {
    add_remarks(*study, task, result);
    result.complete = !study->ended_early;
    if (study->ended_early) result.go_on = same_command(task);
    if (study->is_complete() && !study->ended_early) write_result_files(study->folder, result);
  } else {
    note_unshared(task, result);
  }
  return result;
}

Result status(const KeyReader& keys) {
  const auto held = std::make_shared<const study::StudyStatus>(study::study_status(keys.text("status")));
  Result result;
  set_forms([held](const project::DisplayUnits&) { return results::study_status_document(*held); }, held, {},
            {"status.csv"}, result);
  return result;
}

}  // namespace

Command sample_command() {
  return {
      .name = "sample",
      .about = "the share of machines built within [tolerances] that meet every requirement, and what breaks first",
      .group = Group::design,
      .of_one_case = false,
      .case_alone = "sample this case alone, as one in which the design has to hold",
      .looks_at = with_judged_tables({"sample", "tolerances"}),
      .keys = {{.name = "shares",
                .kind = KeyKind::flag,
                .about =
                    "also which tolerance scatters which value: shares of its variance, from as many designs again"},
               study_key("study folder that many processes share, and that goes on where it was ended"),
               picture_key("shares of the variance, if they are wanted, or else bands of amplitudes"),
               part_key(),
               {.name = "status",
                .kind = KeyKind::file,
                .about =
                    "in place of all else, also of the project file: how far the processes of this study folder are",
                .without_project = true,
                .value = "STUDY"}},
      .csv = true,
      .strict = true,
      .examples = {"trivet sample machine.toml", "trivet sample machine.toml --set analyses.sample.seed=2 --csv",
                   "trivet sample machine.toml -o study --part 3/64", "trivet sample --status study"},
      .run = sample,
      .run_alone = status};
}

}  // namespace trivet::engine

// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "core/commands.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/text/toml_value.h"
#include "trivet/report/figures.h"
#include "trivet/report/front_figure.h"
#include "trivet/report/map_figure.h"
#include "trivet/results/front_results.h"
#include "trivet/results/map_json.h"
#include "trivet/results/map_text.h"
#include "trivet/results/optimization_results.h"
#include "trivet/results/selection_results.h"
#include "trivet/results/written_answers.h"
#include "trivet/study/design_front.h"
#include "trivet/study/mount_selection.h"
#include "trivet/study/optimization.h"

namespace trivet::python {
namespace {

/// Answers that exist in addition to those of a question.
struct Found {
  ProjectPointer project;
  study::Answers answers;
};

std::string map_picture(const study::Answers& answers, const std::string& title) {
  return (answers.map ? report::map_figure(*answers.map, title) : report::map_matrix_figure(answers.map_pairs, title))
      .svg;
}

std::string map_as_json(const study::Answers& answers, const foundation::Problems& warnings) {
  std::string text;
  const results::TextSink sink = [&text](std::string_view piece) { text += piece; };
  if (answers.map) results::write_map_json(*answers.map, warnings, sink);
  else results::write_map_pairs_json(answers.map_pairs, warnings, sink);
  return text;
}

/// Numbers of designs along the axes; 0 × 0: those of the file.
void require_points(int nx, int ny) {
  if (static_cast<double>(nx) * ny > project::most_designs)
    throw foundation::InvalidInput(fmt::format("points: {} × {}; a map has at most {:.0e} designs; take fewer points",
                                               nx, ny, project::most_designs));
}

}  // namespace

Answer mapped(const ProjectPointer& project, const std::string& case_name, int nx, int ny, const Progress& progress) {
  require_points(nx, ny);
  const project::Case& variant = case_of(*project, case_name);
  if (!variant.analyses.map)
    throw foundation::InvalidInput(
        "map: none given; add map = {x = {parameter = \"elements.mount.scale\", from = 0.5, to = 2}, y = {…}, "
        "no_peak = \"coordinates\"} to [analyses]");
  const project::MapRequest& request = *variant.analyses.map;
  project::Analyses asked;
  asked.map = variant.analyses.map;
  const auto held = std::make_shared<Found>(Found{project, study::answers(variant, asked)});
  study::Answers& answers = held->answers;
  study::MapOptions options;
  options.nx = nx;
  options.ny = ny;
  answers.map_pairs = study::design_maps(*project, variant, request, options, progress);
  if (answers.map_pairs.empty()) answers.map = study::design_map(*project, variant, request, options, progress);
  Answer answer;
  answer.question = "map";
  answer.case_name = case_name;
  answer.title = project->title;
  answer.warnings = answers.warnings;
  if (answers.map) answer.warnings.add(answers.map->warnings);
  for (const study::DesignMap& map : answers.map_pairs) answer.warnings.add(map.warnings);
  if (!answers.map) answer.warnings.sort_by_origin();
  answer.json = [held, warnings = answer.warnings] { return map_as_json(held->answers, warnings); };
  answer.text = [held, &variant] { return results::answer_text("map", variant, held->answers); };
  answer.tables.emplace_back("map.csv",
                             [held, &variant] { return results::answer_csv("map", variant, held->answers); });
  answer.figures.emplace_back("map.svg", [held] { return map_picture(held->answers, held->project->title); });
  answer.arrays = results::answer_arrays("map", variant, answers);
  answer.held = held;
  return answer;
}

Answer selected(const ProjectPointer& project, int most, const std::string& by, const Progress& progress) {
  if (most < 1) throw foundation::InvalidInput(fmt::format("most = {}; a number of combinations is ≥ 1", most));
  const auto found = std::make_shared<const study::MountSelection>(
      study::mount_selection(*project, static_cast<std::size_t>(most), progress, study::mount_order(by)));
  Answer answer;
  answer.question = "select";
  answer.title = project->title;
  answer.warnings = project->base().warnings;
  answer.warnings.add(found->warnings);
  answer.changes = project::setting_words(study::selection_changes(*found));
  answer.json = [found, warnings = answer.warnings] { return results::selection_json(*found, warnings); };
  answer.text = [found] { return results::selection_text(*found); };
  return answer;
}

Answer optimized(const ProjectPointer& project, const Progress& progress) {
  const auto& request = project->base().analyses.optimize;
  const auto held = std::make_shared<Found>(Found{project, {}});
  study::Answers& answers = held->answers;
  Answer answer;
  answer.question = "optimize";
  answer.title = project->title;
  answer.warnings = project->base().warnings;
  if (request && !request->front.empty()) {
    answers.front = std::make_shared<const study::DesignFront>(study::design_front(*project, progress));
    const study::DesignFront& front = *answers.front;
    answer.warnings.add(front.warnings);
    answer.changes = project::setting_words(study::front_changes(front, study::chosen_point(front)));
    answer.json = [held, warnings = answer.warnings] { return results::front_json(*held->answers.front, warnings); };
    if (front.objectives.size() == 2)
      answer.figures.emplace_back(
          "front.svg", [held] { return report::front_figure(*held->answers.front, held->project->title).svg; });
  } else {
    answers.optimization = std::make_shared<const study::Optimization>(study::optimization(*project, progress));
    const study::Optimization& found = *answers.optimization;
    answer.warnings.add(found.warnings);
    answer.changes = project::setting_words(study::optimum_changes(found));
    answer.json = [held, warnings = answer.warnings] {
      return results::optimization_json(*held->answers.optimization, warnings);
    };
  }
  const project::Case& base = project->base();
  answer.text = [held, &base] { return results::answer_text("optimize", base, held->answers); };
  answer.tables.emplace_back("optimum.csv",
                             [held, &base] { return results::answer_csv("optimize", base, held->answers); });
  answer.arrays = results::answer_arrays("optimize", base, answers);
  answer.held = held;
  return answer;
}

}  // namespace trivet::python

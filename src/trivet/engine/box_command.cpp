// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/command_rows.h"
#include "trivet/report/figures/box_figure.h"
#include "trivet/results/design/box_document.h"
#include "trivet/study/box/solution_box.h"

namespace trivet::engine {
namespace {

Result box(const Task& task) {
  const auto held = hold(task, study::solution_box(*task.project, task.progress));
  Result result;
  result.warnings = task.project->base().warnings;
  const auto in_units_of = [held](const project::DisplayUnits& display) {
    auto shown = std::make_shared<study::SolutionBox>(held->found);
    for (study::BoxCase& one : shown->cases) one.display = display;
    return shown;
  };
  const auto document = [in_units_of, warnings = result.warnings](const project::DisplayUnits& display) {
    const auto shown = in_units_of(display);
    documents::Document found = results::box_document(*shown, warnings);
    found.held = shown;
    return found;
  };
  set_forms(document, held, task.variant.display, {"box.csv"}, result);
  const std::string& title = task.project->title;
  result.figures.emplace_back("box.svg", writer([held, title] { return report::box_figure(held->found, title).svg; }));
  add_below_tables(
      [in_units_of, title](const project::DisplayUnits& display) {
        return std::vector{report::box_figure(*in_units_of(display), title)};
      },
      result);
  return result;
}

}  // namespace

Command box_command() {
  return {
      .name = "box",
      .about = "the largest ranges around the numbers of [tolerances] in which every requirement is met",
      .group = Group::design,
      .of_one_case = false,
      .case_alone = "the box of this case alone, as one in which the design has to hold",
      .looks_at = with_judged_tables({"box", "tolerances"}),
      .keys = {picture_key("box")},
      .csv = true,
      .examples = {"trivet box machine.toml --picture box.svg", "trivet box machine.toml --set analyses.box.most=3"},
      .run = box};
}

}  // namespace trivet::engine

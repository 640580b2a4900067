// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "trivet/engine/command_rows.h"
#include "trivet/engine/key_reader.h"
#include "trivet/engine/names.h"
#include "trivet/foundation/hertz.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/foundation/thread_progress.h"
#include "trivet/project/analysis_filter.h"
#include "trivet/report/figures/element_picture.h"
#include "trivet/results/design/explanation_results.h"
#include "trivet/results/model/check_document.h"
#include "trivet/results/model/element_results.h"
#include "trivet/results/model/project_json.h"
#include "trivet/results/model/suspension_document.h"
#include "trivet/results/scene/scene_document.h"
#include "trivet/study/requirements/verdict.h"

namespace trivet::engine {
namespace {

using foundation::InvalidInput;

/// The note that requirements are judged by `verdict`; empty if the file has nothing to judge.
/// @param alone  a case that is checked without the others
std::string judged_by_verdict(const project::Project& project, const std::string& alone) {
  if (std::ranges::none_of(project.cases, study::has_something_to_judge)) return "";
  const bool clearances = std::ranges::any_of(
      project.cases, [](const project::Case& one) { return !one.system.description().clearances.empty(); });
  return fmt::format("Not judged here: requirements{} and limits{}. Judge them by: trivet verdict {}{}\n",
                     clearances ? ", clearances" : "", alone.empty() ? ", in all cases" : "", project_word(project),
                     alone.empty() ? "" : " --case " + shell_word(alone));
}

Result check(const Task& task) {
  const auto held = hold(task, study::check(*task.project, task.keys.flag("deep")));
  const auto is_good = [](const study::CaseCheck& one) { return !one.deep || one.deep->passed; };
  Result result;
  for (const study::CaseCheck& one : held->found) result.warnings.add(one.warnings);
  result.warnings.sort_by_origin();
  result.complete = std::ranges::all_of(held->found, is_good);
  result.json = writer([held, warnings = result.warnings] {
    return results::problems_json(warnings, held->found.front().free_motions, held->found);
  });
  const std::string closing = judged_by_verdict(*task.project, task.variant.name) +
      fmt::format("{}: no errors{}\n", task.project->source,
                  result.warnings.list().empty() ? "" : ", but there are warnings");
  result.text_in = [held, closing](const project::DisplayUnits& display) {
    std::vector<study::CaseCheck> shown = held->found;
    for (study::CaseCheck& one : shown) one.display = display;
    return documents::as_text(results::check_document(shown, true), display) + closing;
  };
  const project::DisplayUnits& own = task.project->base().display;
  result.text = writer([text = result.text_in, own] { return text(own); });
  result.text_on = [held, closing, own](const documents::Screen& screen) {
    return documents::as_text(results::check_document(held->found, screen.full), own, screen) + closing;
  };
  return result;
}

Result explain(const Task& task) {
  const project::Case& variant = task.variant;
  study::Explanation found =
      study::explanation(variant, {task.keys.names("of"), task.keys.count("most")}, task.progress);
  found.warnings = without_unused(*task.project, found.warnings);
  const auto held = hold(task, std::move(found));
  Result result;
  result.warnings = held->found.warnings;
  const auto document = [held](const project::Case& shown) {
    return results::explanation_document(shown, held->found);
  };
  set_forms(in_units(document, variant), held, variant.display, {"explain.csv"}, result);
  result.text_on = [held, &variant](const documents::Screen& screen) {
    return documents::as_text(screen.full ? results::explanation_document(variant, held->found)
                                          : results::explanation_document(variant, held->found, 1),
                              variant.display, screen);
  };
  return result;
}

Result suspension(const Task& task) {
  const project::Case& variant = task.variant;
  const std::vector<double> excitations = task.keys.frequencies("excitation");
  for (const double omega : excitations)
    if (!(omega > 0) || !std::isfinite(omega))
      throw InvalidInput(fmt::format("{}: {}; a frequency of excitation is > 0 and finite",
                                     task.keys.written("excitation"), foundation::hertz_words(omega)));
  study::SuspensionResult found = study::suspension(variant, task.keys.directions("torque"), excitations);
  found.warnings = without_unused(*task.project, found.warnings);
  const auto held = hold(task, std::move(found));
  Result result;
  result.warnings = held->found.warnings;
  const auto document = [held](const project::Case& shown) { return results::suspension_document(shown, held->found); };
  set_forms(in_units(document, variant), held, variant.display, {"suspension.csv"}, result);
  return result;
}

Result scene(const Task& task) {
  const project::Case& variant = task.variant;
  const foundation::ThreadProgress of_drawing(task.progress);
  const auto held = hold(task, results::scene_of(variant));
  Result result;
  const auto document = [held](const project::Case& shown) { return results::scene_document(shown, held->found); };
  set_forms(in_units(document, variant), held, variant.display, {}, result);
  return result;
}

std::size_t element_of(const project::Case& variant, const std::string& name) {
  std::vector<std::string> names;
  for (const model::Element& element : variant.system.elements()) {
    if (element.name == name) return names.size();
    names.push_back(element.name);
  }
  const std::string guess = foundation::nearest_name(name, names);
  throw InvalidInput(fmt::format(
      "\"{}\": no element has this name; {}", name,
      guess.empty() ? fmt::format("they are {}", fmt::join(names, ", ")) : "did you mean \"" + guess + "\"?"));
}

struct ElementResult {
  study::ElementSummary summary;
  std::optional<study::Simplification> simple;
};

ElementResult element_result(const Task& task, std::size_t element) {
  const project::Case& variant = task.variant;
  ElementResult found{study::element_summary(variant, element), {}};
  std::vector<std::size_t> replaced = {element};
  if (task.keys.flag("all")) {
    replaced.resize(variant.system.elements().size());
    std::iota(replaced.begin(), replaced.end(), std::size_t{0});
  }
  try {
    if (project::has_broken_curves(variant))
      found.summary.warnings.warning("analyses", "errors in response or peaks",
                                     "the comparison with three springs uses the peaks of the coordinates instead of "
                                     "those that the file requests",
                                     "trivet check lists the errors");
    found.simple = study::simplification(variant, replaced, task.progress);
  } catch (const foundation::NotComputable& reason) {
    found.summary.warnings.warning("comparison with three springs", "not computed", reason.what(), "");
  }
  found.summary.warnings = without_unused(*task.project, found.summary.warnings);
  return found;
}

Result element(const Task& task) {
  const project::Case& variant = task.variant;
  const std::size_t number = element_of(variant, task.keys.text("name"));
  const auto held = hold(task, element_result(task, number));
  Result result;
  result.warnings = held->found.summary.warnings;
  const auto document = [held, number](const project::Case& shown) {
    return results::element_document(shown, number, held->found.summary, held->found.simple);
  };
  set_forms(in_units(document, variant), held, variant.display, {}, result);
  result.figures.emplace_back("element.svg",
                              writer([held, &variant, number] { return report::element_picture(variant, number); }));
  return result;
}

}  // namespace

std::vector<Command> machine_commands() {
  return {
      {.name = "check",
       .about = "check a project file and list all its problems",
       .group = Group::machine,
       .of_one_case = false,
       .case_alone = "check this case alone",
       .all_tables = true,
       .keys = {{.name = "deep", .kind = KeyKind::flag, .about = "compare the solver with a second, independent one"}},
       .strict = true,
       .examples = {"trivet check machine.toml", "trivet check machine.toml --deep --strict"},
       .run = check},
      {.name = "element",
       .about = "one element: its 12x12, checks, energy, and a comparison with three springs in its place",
       .group = Group::machine,
       .of_one_case = true,
       .keys = {{.name = "name",
                 .kind = KeyKind::text,
                 .about = "name of the element",
                 .required = true,
                 .positional = true},
                {.name = "all",
                 .kind = KeyKind::flag,
                 .about = "replace every element by three springs for the comparison, not only this one"},
                picture_key("element")},
       .examples = {"trivet element machine.toml \"front left\"",
                    "trivet element machine.toml \"front left\" --picture mount.svg"},
       .run = element},
      {.name = "scene",
       .about = "what is drawn of the machine: bodies, elements, stops, points, forces, for programs that draw it",
       .group = Group::machine,
       .of_one_case = true,
       .examples = {"trivet scene machine.toml", "trivet scene machine.toml --case winter --json"},
       .run = scene},
      {.name = "suspension",
       .about = "elastic centre, roll axes, decoupling and frequency separation",
       .group = Group::machine,
       .of_one_case = true,
       .keys = {{.name = "torque",
                 .kind = KeyKind::text,
                 .about = "axis of the moment, body frame: x, y, z or 0.9,0,0.1; all three by default",
                 .value = "AXIS"},
                {.name = "excitation",
                 .kind = KeyKind::text,
                 .about = "frequencies to compare with the natural ones: \"25 Hz,50 Hz\"",
                 .value = "FREQUENCY,…"}},
       .csv = true,
       .examples = {"trivet suspension machine.toml",
                    "trivet suspension machine.toml --torque x --excitation 25Hz,50Hz"},
       .run = suspension},
      {.name = "explain",
       .about = "causes of each resonance peak, and the parameters that change it",
       .group = Group::design,
       .of_one_case = true,
       .looks_at = {"peaks", "response"},
       .keys = {{.name = "of",
                 .kind = KeyKind::text,
                 .about = "result whose peaks are explained (repeatable); default: the results of `peaks` in the file",
                 .repeatable = true,
                 .value = "RESULT"},
                {.name = "most",
                 .kind = KeyKind::count,
                 .about = "number of peaks explained, the highest relative to their curve",
                 .by_default = "10"}},
       .csv = true,
       .examples = {"trivet explain machine.toml", "trivet explain machine.toml --of machine.z --most 3"},
       .run = explain},
  };
}

}  // namespace trivet::engine

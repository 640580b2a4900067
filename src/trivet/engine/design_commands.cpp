// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>

#include "trivet/engine/command_rows.h"
#include "trivet/engine/key_reader.h"
#include "trivet/engine/new_project_file.h"
#include "trivet/engine/solved_cases.h"
#include "trivet/engine/study_keys.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/model_number.h"
#include "trivet/project/text/document.h"
#include "trivet/report/drawing/figures.h"
#include "trivet/report/figures/front_figure.h"
#include "trivet/report/map/map_figure.h"
#include "trivet/results/design/map_document.h"
#include "trivet/results/design/map_json.h"
#include "trivet/results/design/optimization_results.h"
#include "trivet/results/design/selection_document.h"
#include "trivet/results/design/verdict_results.h"
#include "trivet/results/format/written_results.h"
#include "trivet/study/optimize/design_front.h"
#include "trivet/study/optimize/optimization.h"
#include "trivet/study/select/mount_selection.h"

namespace trivet::engine {
namespace {

using foundation::InvalidInput;

constexpr const char* one_design_for_all =
    "one design is sought for all cases in which it has to hold; requirements.hold_in names them";

Result verdict(const Task& task) {
  const auto held = hold(task, study::verdict(*task.project, task.progress));
  const std::vector<study::CaseVerdict>& cases = held->found.cases;
  Result result;
  for (const study::CaseVerdict& one : cases) {
    result.warnings.add(one.warnings);
    result.findings.add(one);
  }
  result.warnings.sort_by_origin();
  result.complete = std::ranges::all_of(cases, [](const study::CaseVerdict& one) { return one.not_judged() == 0; });
  const auto document = [held, &own = task.variant.display](const project::DisplayUnits& display) {
    if (display == own) return results::whole_verdict(held->found);
    auto shown = std::make_shared<study::Verdict>(held->found);
    for (study::CaseVerdict& one : shown->cases) one.display = display;
    shown->envelope.display = display;
    documents::Document found = results::whole_verdict(*shown);
    found.held = shown;
    return found;
  };
  set_forms(document, held, task.variant.display, {"verdict.csv"}, result);
  return result;
}

/// Numbers of designs along the axes from "1000x1000", one number for both axes, or a list of two.
study::MapOptions map_sizes(const Task& task) {
  study::MapOptions options;
  const std::string text = task.keys.text("points"), key = task.keys.written("points");
  if (text.empty()) return options;
  const auto whole = [&](const std::string& part) {
    int value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc() || end != part.data() + part.size() || value < 2)
      throw InvalidInput(fmt::format(
          "{} {}: give the points of both axes as in 200x150, or one number for both, each 2 or more", key, text));
    return value;
  };
  const std::size_t cross = text.find_first_of("x,");
  options.nx = whole(text.substr(0, cross));
  options.ny = cross == std::string::npos ? options.nx : whole(text.substr(cross + 1));
  if (static_cast<double>(options.nx) * options.ny > project::most_designs)
    throw InvalidInput(fmt::format("{} {}: {:.3g} designs; a map has at most {:.0e}; take fewer points", key, text,
                                   static_cast<double>(options.nx) * options.ny, project::most_designs));
  return options;
}

/// "200x150", of the first pair if there are several maps.
std::string grid_words(const Task& task) {
  const study::MapOptions sizes = map_sizes(task);
  const auto& request = task.variant.analyses.map;
  if (!request) return "";
  return fmt::format("{}x{}", sizes.nx > 0 ? sizes.nx : request->x.points, sizes.ny > 0 ? sizes.ny : request->y.points);
}

study::CaseResults computed_maps(const Task& task, study::SharedWork* shared) {
  const project::Case& variant = task.variant;
  if (!variant.analyses.map)
    throw InvalidInput(
        "map: none given; add map = {x = {parameter = \"elements.mount.scale\", from = 0.5, to = 2}, y = {…}, "
        "no_peak = \"coordinates\"} to [analyses]");
  study::MapOptions sizes = map_sizes(task);
  sizes.shared = shared;
  const project::MapRequest& request = *variant.analyses.map;
  project::Analyses requested;
  requested.map = request;
  study::CaseResults found = study::notices(variant, requested, task.solved.of(variant));
  const foundation::Progress progress = shared_progress(task, shared);
  found.map_pairs = study::design_maps(*task.project, variant, request, sizes, progress);
  if (found.map_pairs.empty()) found.map = study::design_map(*task.project, variant, request, sizes, progress);
  return found;
}

documents::Document map_on_screen(const study::CaseResults& found, const documents::Screen& screen) {
  const auto findings = screen.full ? results::Findings::all : results::Findings::governing;
  return found.map ? results::map_document(*found.map, findings)
                   : results::map_pairs_document(found.map_pairs, findings);
}

Result map(const Task& task) {
  const project::Case& variant = task.variant;
  const auto shared = shared_work(task, {{"case of the map", variant.name}, {"points", grid_words(task)}}, {});
  study::CaseResults computed;
  try {
    computed = computed_maps(task, shared.get());
  } catch (const foundation::Interrupted&) {
    return ended_study(task, shared.get());
  }
  const auto held = hold(task, std::move(computed));
  const study::CaseResults& found = held->found;
  Result result;
  result.warnings = without_unused(*task.project, found.warnings);
  if (found.map) result.warnings.add(found.map->warnings);
  for (const study::DesignMap& one : found.map_pairs) result.warnings.add(one.warnings);
  if (!found.map) result.warnings.sort_by_origin();  // and drop what several maps repeat
  if (found.map) result.findings.add(*found.map);
  for (const study::DesignMap& one : found.map_pairs) result.findings.add(one);
  result.json = [held, warnings = result.warnings](const Sink& sink) {
    if (held->found.map) results::write_map_json(*held->found.map, warnings, sink);
    else results::write_map_pairs_json(held->found.map_pairs, warnings, sink);
  };
  result.text = writer([held, &variant] { return results::result_text("map", variant, held->found); });
  result.text_on = [held, &variant](const documents::Screen& screen) {
    return documents::as_text(map_on_screen(held->found, screen), variant.display, screen);
  };
  result.tables.emplace_back("map.csv", [held](const Sink& sink) {
    if (held->found.map) results::write_map_csv(*held->found.map, sink);
    else results::write_map_pairs_csv(held->found.map_pairs, sink);
  });
  result.figures.emplace_back("map.svg", writer([held, title = task.project->title] {
                                return (held->found.map ? report::map_figure(*held->found.map, title)
                                                        : report::map_matrix_figure(held->found.map_pairs, title))
                                    .svg;
                              }));
  result.arrays = [held, &variant] { return results::result_arrays("map", variant, held->found); };
  result.held = held;
  add_shared(shared.get(), task, result);
  return result;
}

/// Changes that a search may make: the first mount of each choice, and numbers to the middle of their ranges.
std::vector<project::Node> trial_changes(const project::Analyses& requested, bool numbers) {
  const project::OptimizeRequest request =
      numbers ? requested.optimize.value_or(project::OptimizeRequest()) : project::OptimizeRequest();
  std::vector<project::Node> changes;
  for (const project::MountChoice& choice : requested.choices)
    if (request.varies(choice.name) && !choice.mounts.empty()) changes.push_back(project::change_of(choice, 0));
  if (!numbers) return changes;
  for (const project::DesignAxis& axis : requested.parameters)
    if (constexpr double middle = 0.5; request.varies(axis.name))
      changes.push_back(project::ModelNumber(axis).change(axis.at(middle)));
  return changes;
}

/// Ends a search when the asker wants it, or after the key `time-limit`.
std::function<bool()> end_of_search(const Task& task) {
  using Clock = std::chrono::steady_clock;
  const auto limit = task.keys.seconds("time-limit");
  // With a study folder signals end the process, and the same command goes on.
  const std::function<bool()> by_signal = task.keys.has("output") ? nullptr : task.request.ends_search;
  return [requested = by_signal, limit, start = Clock::now()] {
    return (requested && requested()) ||
        (limit && std::chrono::duration<double>(Clock::now() - start).count() > *limit);
  };
}

/// All forms of the best design, or of the front. @param settings  at the end of the text, to be copied
void add_optimum(const std::shared_ptr<const Held<study::CaseResults>>& held, const Task& task,
                 const std::string& settings, Result& result) {
  const auto document = [held](const project::Case& shown) {
    return results::result_document("optimize", shown, held->found);
  };
  set_forms(in_units(document, task.variant), held, task.variant.display, {"optimum.csv"}, result, settings);
  result.json = writer([held, warnings = result.warnings] { return results::optimum_json(held->found, warnings); });
}

Result optimum(const Task& task, const NewProjectFile& file) {
  const auto ends = end_of_search(task);
  const auto shared = shared_work(task, {}, ends);
  study::CaseResults found;
  try {
    found.optimization = std::make_shared<const study::Optimization>(
        study::optimization(*task.project, shared_progress(task, shared.get()), ends, shared.get()));
  } catch (const foundation::Interrupted&) {
    return ended_study(task, shared.get());
  }
  const auto held = hold(task, std::move(found));
  const study::Optimization& best = *held->found.optimization;
  Result result;
  result.warnings = task.project->base().warnings;
  result.warnings.add(best.warnings);
  result.complete = !best.cut_short;
  if (!best.feasible) result.findings.add_infeasible_design();
  const std::vector<project::Node> changes = study::optimum_changes(best);
  result.changes = project::setting_words(changes);
  const std::string settings = "\nThe optimum as settings:\n" + results::optimization_settings(best);
  add_optimum(held, task, settings + file.write(changes, result), result);
  add_shared(shared.get(), task, result);
  return result;
}

Result front(const Task& task, const NewProjectFile& file) {
  if (task.keys.has("time-limit"))
    throw InvalidInput(task.keys.written("time-limit") +
                       ": a front is computed as a whole; take fewer points or starts");
  if (study_folder(task))
    throw InvalidInput(task.keys.written("output") +
                       ": a front is computed by one process; name a file with the ending .json, .csv, .html or .txt");
  study::CaseResults found;
  found.front = std::make_shared<const study::DesignFront>(study::design_front(*task.project, task.progress));
  const auto held = hold(task, std::move(found));
  const study::DesignFront& computed = *held->found.front;
  const std::size_t chosen = study::chosen_point(computed);
  Result result;
  result.warnings = task.project->base().warnings;
  result.warnings.add(computed.warnings);
  const std::vector<project::Node> changes = study::front_changes(computed, chosen);
  result.changes = project::setting_words(changes);
  const std::string settings =
      fmt::format("\nPoint {}{} as settings:\n{}", chosen + 1, computed.knee ? ", the knee," : "",
                  results::front_settings(computed, chosen));
  add_optimum(held, task, settings + file.write(changes, result), result);
  if (computed.objectives.size() == 2)
    result.figures.emplace_back("front.svg", writer([held, title = task.project->title] {
                                  return report::front_figure(*held->found.front, title).svg;
                                }));
  note_unshared(task, result);
  return result;
}

Result optimize(const Task& task) {
  const auto& request = task.variant.analyses.optimize;
  const std::size_t objectives = request ? request->front.size() : 0;
  if (task.keys.has("picture") && objectives != 2)
    throw InvalidInput(task.keys.written("picture") +
                       (objectives == 0 ? ": only a front has a picture; add front = [\"BODY.x\", "
                                          "\"ground.force.x\"] to [analyses.optimize]"
                                        : ": only a front between two results has a picture; use --json"));
  const NewProjectFile file(task, trial_changes(task.variant.analyses, true));
  if (file.problems().has_errors()) return {.errors = file.problems()};
  return objectives > 0 ? front(task, file) : optimum(task, file);
}

Result select(const Task& task) {
  const NewProjectFile file(task, trial_changes(task.variant.analyses, false));
  if (file.problems().has_errors()) return {.errors = file.problems()};
  const auto held = hold(task,
                         study::mount_selection(*task.project, static_cast<std::size_t>(task.keys.count("most")),
                                                task.progress, study::mount_order(task.keys.text("by"))));
  const study::MountSelection& found = held->found;
  const study::MountDesign& best = found.best.front();
  if (task.keys.has("write") && !best.reason.empty())
    throw foundation::NotComputable("select: no combination can be judged, so nothing was written: " + best.reason);
  Result result;
  result.warnings = task.project->base().warnings;
  result.warnings.add(found.warnings);
  if (!best.met) result.findings.add_infeasible_design();
  const std::vector<project::Node> changes = study::selection_changes(found);
  result.changes = project::setting_words(changes);
  const std::string settings =
      "\nThe best as settings:\n" + results::mount_settings(found.choices, best.mounts) + file.write(changes, result);
  const auto document = [held, warnings = result.warnings](const project::DisplayUnits&) {
    return results::selection_document(held->found, warnings);
  };
  set_forms(document, held, task.variant.display, {"select.csv"}, result, settings);
  return result;
}

}  // namespace

std::vector<std::string> with_judged_tables(std::vector<std::string> tables) {
  for (const char* one :
       {"requirements", "clearances", "limits", "limit_lines", "operation", "response", "peaks", "random", "transient"})
    tables.emplace_back(one);
  return tables;
}

Key picture_key(const std::string& drawn) {
  return {.name = "picture",
          .kind = KeyKind::file,
          .about = "draw the " + drawn + " to this SVG file",
          .value = "FILE.svg"};
}

Key write_key(const std::string& best) {
  return {.name = "write",
          .kind = KeyKind::file,
          .about = "write the project file with the " + best + " to this file; comments, order and format stay"};
}

std::vector<Command> design_commands() {
  return {
      {.name = "verdict",
       .about = "is every requirement met in every case, which one governs, and by what margin?",
       .group = Group::design,
       .of_one_case = false,
       .case_alone = "judge this case alone, as one in which the design has to hold",
       .looks_at = with_judged_tables({}),
       .csv = true,
       .strict = true,
       .examples = {"trivet verdict machine.toml", "trivet verdict machine.toml --strict --csv"},
       .run = verdict},
      {.name = "map",
       .about = "map of limits over two parameters: feasible designs and governing rules",
       .group = Group::design,
       .of_one_case = true,
       .looks_at = with_judged_tables({"map", "parameters"}),
       .keys = {{.name = "points",
                 .kind = KeyKind::text,
                 .about = "designs along both axes instead of those of the file: 200x150, or 100 for both",
                 .value = "NXxNY"},
                study_key(
                    "study folder whose processes share designs that take milliseconds, and that goes on where it "
                    "was ended",
                    ".json, .csv or .txt"),
                part_key(),
                picture_key("map")},
       .csv = true,
       .strict = true,
       .examples = {"trivet map machine.toml --picture map.svg", "trivet map machine.toml --points 400 --csv"},
       .run = map},
      {.name = "optimize",
       .about = "the values of [parameters] with the largest least margin, or the smallest amplitudes",
       .group = Group::design,
       .of_one_case = false,
       .without_case = one_design_for_all,
       .looks_at = with_judged_tables({"optimize", "parameters", "sample", "tolerances"}),
       .keys = {study_key("study folder whose processes share looks and climbs, and that goes on where it was ended"),
                part_key(),
                write_key("optimum"),
                {.name = "time-limit",
                 .kind = KeyKind::text,
                 .about = "end the search after this time with the best design so far: \"10 min\", \"2 h\", or seconds",
                 .value = "TIME"},
                picture_key("front")},
       .csv = true,
       .strict = true,
       .examples = {"trivet optimize machine.toml --write best.toml",
                    "trivet optimize machine.toml --time-limit \"10 min\"",
                    "trivet optimize machine.toml -o study --part 3/64"},
       .run = optimize},
      sample_command(),
      box_command(),
      {.name = "select",
       .about = "the mounts of a catalogue with the largest least margin of all requirements",
       .group = Group::design,
       .of_one_case = false,
       .without_case = one_design_for_all,
       .looks_at = with_judged_tables({"parameters"}),
       .keys = {{.name = "most", .kind = KeyKind::count, .about = "number of combinations listed", .by_default = "10"},
                {.name = "by",
                 .kind = KeyKind::choice,
                 .about = "margin, or of those that meet every requirement the isolation, price or mass",
                 .choices = {"margin", "isolation", "price", "mass"},
                 .by_default = "margin"},
                write_key("best mounts")},
       .csv = true,
       .strict = true,
       .examples = {"trivet select machine.toml --most 5 --csv",
                    "trivet select machine.toml --by price --write best.toml"},
       .run = select},
  };
}

}  // namespace trivet::engine

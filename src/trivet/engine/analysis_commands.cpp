// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "trivet/engine/command_rows.h"
#include "trivet/engine/key_reader.h"
#include "trivet/engine/solved_cases.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/thread_progress.h"
#include "trivet/judging/suspicions.h"
#include "trivet/project/analyses/analysis_sizes.h"
#include "trivet/project/analyses/analysis_types.h"
#include "trivet/project/text/admissible_range.h"
#include "trivet/results/analyses/curves_document.h"
#include "trivet/results/analyses/modes_document.h"
#include "trivet/results/format/written_results.h"
#include "trivet/study/analyses/analysis_commands.h"
#include "trivet/study/analyses/case_results.h"
#include "trivet/study/analyses/curve_results.h"
#include "trivet/study/analyses/solved_case.h"
#include "trivet/study/explain/simplification.h"

namespace trivet::engine {
namespace {

using excitation::BandWidth;
using foundation::InvalidInput;

void set_band(const Task& task, project::Analyses& analyses) {
  const std::string key = task.keys.written("band");
  const std::vector<double> band = task.keys.frequencies("band");
  if (band.size() != 2 || !(band[1] > band[0]))
    throw InvalidInput(fmt::format("{} {}: a band is FROM,TO with FROM < TO", key, task.keys.text("band")));
  if (const auto broken = project::wrong_band(band[0], band[1]))
    throw InvalidInput(fmt::format("{} {}: {}", key, task.keys.text("band"), *broken));
  analyses.response->band = assembly::Band{band[0], band[1]};
  analyses.response->at.clear();
  analyses.limit_lines = task.variant.analyses.limit_lines;
}

/// Speeds or frequencies under `at`, all above 0. @throws InvalidInput
std::vector<double> single_frequencies(const Task& task) {
  const std::vector<double> at = task.keys.frequencies("at");
  for (const double omega : at)
    if (!(omega > 0))
      throw InvalidInput(
          fmt::format("{} {}: a speed or frequency is above 0", task.keys.written("at"), task.keys.text("at")));
  return at;
}

/// The operation at the speeds of the request in place of those of the file, which need not have any.
project::Analyses operation_at(const Task& task) {
  project::Analyses analyses;
  if (task.variant.analyses.operation) analyses.operation = task.variant.analyses.operation;
  else analyses.operation.emplace().selection.of.clear();
  analyses.operation->speeds.clear();
  for (const double speed : single_frequencies(task)) analyses.operation->speeds.push_back({speed, speed});
  return analyses;
}

/// The mode of which shapes are wanted; 0: all. @throws InvalidInput if there is no such mode
int shapes_of(const Task& task, const modal::Modes& modes) {
  const int number = task.keys.count("shapes-of");
  if (number > std::ssize(modes.list))
    throw InvalidInput(fmt::format("{} {}: the machine has {} mode{}", task.keys.written("shapes-of"), number,
                                   modes.list.size(), modes.list.size() == 1 ? "" : "s"));
  return number;
}

/// The analysis of the file, or one with defaults, with the keys of the request in place of those of the file.
project::Analyses with_keys(const Task& task) {
  const std::string& name = task.command.name;
  project::Analyses analyses = name == "operation" && task.keys.has("at")
      ? operation_at(task)
      : study::analysis_command(name).request(task.variant);
  if (name == "operation" && task.keys.has("bands"))
    analyses.operation->bands =
        task.keys.text("bands") == excitation::name(BandWidth::octave) ? BandWidth::octave : BandWidth::third_octave;
  if (name == "modes" && task.keys.has("lowest")) analyses.lowest_modes = task.keys.count("lowest");
  if (name == "response" && task.keys.has("at")) {
    analyses.response->at = task.keys.frequencies("at");
    analyses.response->band.reset();
    analyses.limit_lines.clear();
  }
  if (name == "transmissibility" && task.keys.has("at")) analyses.transmissibility->at = single_frequencies(task);
  if (name == "orders" && task.keys.has("at")) analyses.orders->at = single_frequencies(task);
  if (name == "power" && task.keys.has("at")) analyses.power->at = single_frequencies(task);
  if (name == "response" && task.keys.has("band")) set_band(task, analyses);
  if (name != "steady") return analyses;
  project::SteadyAnalysis& steady = *analyses.steady;
  steady.deep = steady.deep || task.keys.flag("deep");
  if (task.keys.has("at")) {
    if (steady.over_load_factor)
      throw InvalidInput(task.keys.written("at") + " " + task.keys.text("at") +
                         ": the steady motion of the file is over the load factor, at one frequency; remove "
                         "over = \"load_factor\" from the file");
    steady.harmonics_at = task.keys.frequencies("at");
  }
  return analyses;
}

Result run_analysis(const Task& task) {
  const std::string& name = task.command.name;
  const project::Case& variant = task.variant;
  const project::Analyses analyses = with_keys(task);
  const bool whole_model = !project::lowest_modes_suffice(analyses);
  study::CaseResults found =
      study::case_results(variant, analyses, task.progress, whole_model ? task.solved.of(variant) : nullptr);
  const int shapes = name == "modes" ? shapes_of(task, found.modes) : 0;
  if (task.command.name == "response" && task.keys.has("band"))
    found.warnings.add(judging::doubts_about_band(variant, *analyses.response->band));
  found.warnings = without_unused(*task.project, found.warnings);
  const bool only_limits_failed = name == "response" && found.response;
  if (!found.failures.empty() && !only_limits_failed) throw foundation::NotComputable(found.failures.front());
  const auto held = hold(task, std::move(found));
  Result result;
  add_notices(held->found, result);
  const auto document = [held, name, shapes](const project::Case& shown) {
    return shapes > 0 ? results::modes_document(shown, held->found, shapes)
                      : results::result_document(name, shown, held->found);
  };
  std::vector<std::string> files;
  for (const results::ResultTable& table : results::result_tables(name))
    if (!table.is_in || table.is_in(held->found)) files.emplace_back(table.file);
  set_forms(in_units(document, variant), held, variant.display, files, result);
  return result;
}

/// The case, with every element replaced by three springs.
project::Case on_three_springs(const project::Case& full) {
  std::vector<std::size_t> all(full.system.elements().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  project::Case simple = full;
  simple.system = study::with_three_springs(full.system, all);
  return simple;
}

Result curves(const Task& task) {
  const foundation::ThreadProgress of_curves(task.progress);  // roots and modes of peaks end with the question, too
  const project::Case& variant = task.variant;
  std::optional<project::Case> simple;
  if (task.keys.flag("three-springs")) simple = on_three_springs(variant);
  project::Analyses request = study::curve_request(variant);
  if (task.keys.has("quantity")) {
    request.response->selection.quantity = assembly::motion_quantity(task.keys.text("quantity"));
    request.peaks->selection = request.response->selection;
    request.limits.clear();  // they are limits of the quantity of the file
  }
  if (task.keys.has("band")) set_band(task, request);
  if (task.keys.has("of")) {
    request.response->selection.of = task.keys.names("of");
    request.peaks->selection = request.response->selection;
  }
  if (task.keys.flag("draft")) {
    request.peaks.reset();
    request.limits.clear();
    request.limit_lines.clear();
  }
  study::CaseResults found = study::curve_results(
      simple ? *simple : variant, request, task.progress,
      simple ? std::make_shared<const study::SolvedCase>(simple->system) : task.solved.of(variant));
  if (task.keys.has("band")) found.warnings.add(judging::doubts_about_band(variant, *request.response->band));
  found.warnings = without_unused(*task.project, found.warnings);
  if (!found.response) throw foundation::NotComputable(found.failures.front());
  const auto held = hold(task, std::move(found));
  Result result;
  add_notices(held->found, result);
  const auto document = [held](const project::Case& shown) { return results::curves_document(shown, held->found); };
  set_forms(in_units(document, variant), held, variant.display, {}, result);
  return result;
}

/// @param excludes  a key that must not be given with it
Key band_key(const char* excludes = "") {
  return {.name = "band",
          .kind = KeyKind::text,
          .about = "FROM,TO with units: \"2 Hz,40 Hz\"",
          .excludes = excludes,
          .value = "FROM,TO"};
}

Command curve_command() {
  return {
      .name = "curves",
      .about = "characteristics of all coordinates, points and forces as rational functions, for programs that draw",
      .group = Group::harmonic,
      .of_one_case = true,
      .looks_at = {"response", "peaks", "limits", "limit_lines"},
      .keys = {band_key(),
               {.name = "of",
                .kind = KeyKind::text,
                .about = "only this result (repeatable): \"machine.z\", \"ground\"",
                .repeatable = true,
                .value = "RESULT"},
               {.name = "quantity",
                .kind = KeyKind::choice,
                .about = "of the motions, instead of that of the response; without the limits of [limits]",
                .choices = assembly::motion_names()},
               {.name = "three-springs",
                .kind = KeyKind::flag,
                .about = "as if every element were three springs, as `element` compares them"},
               {.name = "draft",
                .kind = KeyKind::flag,
                .about = "the models alone, sooner: without exact peaks, extrema, limits and limit lines"}},
      .examples = {"trivet curves machine.toml", "trivet curves machine.toml --of machine.z --json"},
      .run = curves};
}

Group group_of(const std::string& name) {
  static const std::map<std::string, Group> others = {
      {"random", Group::time},        {"transient", Group::time}, {"shock_spectrum", Group::time},
      {"earthquake", Group::time},    {"orders", Group::time},    {"steady", Group::nonlinear},
      {"backbone", Group::nonlinear}, {"static", Group::machine},
  };
  const auto found = others.find(name);
  return found == others.end() ? Group::harmonic : found->second;
}

/// Keys besides those of the file.
std::vector<Key> keys_of(const std::string& name) {
  if (name == "modes")
    return {{.name = "lowest", .kind = KeyKind::count, .about = "report only so many modes"},
            {.name = "shapes-of",
             .kind = KeyKind::count,
             .about = "for programs: the shape, screws and elements of the mode of this number alone"}};
  if (name == "response")
    return {{.name = "at",
             .kind = KeyKind::text,
             .about = "single frequencies with units: \"12.5 Hz,25 Hz\"",
             .value = "FREQUENCY,…"},
            band_key("at")};
  if (name == "operation")
    return {{.name = "at",
             .kind = KeyKind::text,
             .about = "speeds in place of those of the file: \"980 rpm\", or several with units",
             .value = "SPEED,…"},
            {.name = "bands",
             .kind = KeyKind::choice,
             .about = "also the root mean square of the orders in each frequency band",
             .choices = {excitation::name(BandWidth::third_octave), excitation::name(BandWidth::octave)}}};
  if (name == "orders")
    return {{.name = "at",
             .kind = KeyKind::text,
             .about = "tell single speeds besides: \"980 rpm\", or several with units",
             .value = "SPEED,…"}};
  if (name == "transmissibility" || name == "power")
    return {{.name = "at",
             .kind = KeyKind::text,
             .about = "tell single frequencies besides: \"980 rpm\" or \"16.3 Hz\", or several with units",
             .value = "FREQUENCY,…"}};
  if (name == "steady")
    return {
        {.name = "at",
         .kind = KeyKind::text,
         .about =
             "state the harmonics of all motions found there: \"12 Hz\" or \"750 rpm\", or several: \"12 Hz,13 Hz\"",
         .value = "FREQUENCY,…"},
        {.name = "deep", .kind = KeyKind::flag, .about = "judge the stability of every point in two ways"}};
  return {};
}

std::vector<std::string> examples_of(const std::string& name) {
  if (name == "modes") return {"trivet modes machine.toml", "trivet modes machine.toml --lowest 6 --json"};
  if (name == "response")
    return {"trivet response machine.toml --band \"5 Hz,60 Hz\"",
            "trivet response machine.toml --at \"16.3 Hz\" --csv"};
  if (name == "operation")
    return {"trivet operation machine.toml --at \"980 rpm\" --bands third-octave",
            "trivet operation machine.toml --case winter --csv"};
  if (name == "orders" || name == "transmissibility" || name == "power")
    return {"trivet " + name + " machine.toml --at \"980 rpm\"",
            "trivet " + name + " machine.toml --case winter --csv"};
  if (name == "steady")
    return {"trivet steady machine.toml --at \"12 Hz\"", "trivet steady machine.toml --deep --json"};
  return {"trivet " + name + " machine.toml", "trivet " + name + " machine.toml --case winter --csv"};
}

}  // namespace

foundation::Problems without_unused(const project::Project& project, const foundation::Problems& warnings) {
  std::set<std::string> unused;
  for (const foundation::Problem& one : project.unused_parts.list()) unused.insert(foundation::message(one));
  foundation::Problems kept;
  for (const foundation::Problem& one : warnings.list())
    if (!unused.contains(foundation::message(one))) kept.add(one);
  return kept;
}

void add_notices(const study::CaseResults& found, Result& result) {
  result.warnings = found.warnings;
  result.failures = found.failures;
  for (const auto* notes : {&found.free_motions, &found.notes})
    result.notes.insert(result.notes.end(), notes->begin(), notes->end());
  result.complete = found.failures.empty() && !study::is_cut_short(found);
  result.findings.add(found);
}

std::vector<Command> analysis_commands() {
  std::vector<Command> rows;
  for (const study::AnalysisCommand& analysis : study::analysis_commands())
    rows.push_back({.name = analysis.name,
                    .about = analysis.about,
                    .group = group_of(analysis.name),
                    .of_one_case = true,
                    .looks_at = analysis.looks_at,
                    .is_analysis = true,
                    .keys = keys_of(analysis.name),
                    .csv = true,
                    .strict = true,
                    .examples = examples_of(analysis.name),
                    .run = run_analysis});
  rows.push_back(curve_command());
  return rows;
}

}  // namespace trivet::engine

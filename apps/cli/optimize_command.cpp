// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/new_project_file.h"
#include "cli/progress_line.h"
#include "cli/signals.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/model_number.h"
#include "trivet/project/text/units.h"
#include "trivet/report/front_figure.h"
#include "trivet/results/front_results.h"
#include "trivet/results/optimization_results.h"

namespace trivet::cli {
namespace {

/// Changes that the search may make: numbers to the middle of their ranges, the first mount of each choice.
std::vector<project::Node> trial_changes(const project::Analyses& asked) {
  const project::OptimizeRequest request = asked.optimize.value_or(project::OptimizeRequest());
  std::vector<project::Node> changes;
  for (const project::MountChoice& choice : asked.choices)
    if (request.varies(choice.name) && !choice.mounts.empty()) changes.push_back(project::change_of(choice, 0));
  for (const project::DesignAxis& axis : asked.parameters)
    if (constexpr double middle = 0.5; request.varies(axis.name))
      changes.push_back(project::ModelNumber(axis).change(axis.at(middle)));
  return changes;
}

using Clock = std::chrono::steady_clock;

/// The time of --time-limit, or none. @throws BadArgument
std::optional<std::chrono::duration<double>> time_limit(const Options& options) {
  const std::string& text = options.time_limit;
  if (text.empty()) return std::nullopt;
  double seconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (error != std::errc() || end != text.data() + text.size()) {
    const auto converted = project::to_si(text, project::Quantity::time);
    if (!converted)
      throw BadArgument(
          fmt::format("--time-limit: \"{}\": {}; give seconds, or a unit as in \"10 min\"", text, converted.error()));
    seconds = *converted;
  }
  if (!(seconds > 0 && std::isfinite(seconds)))
    throw BadArgument(fmt::format("--time-limit: \"{}\"; a time is above 0", text));
  return std::chrono::duration<double>(seconds);
}

/// The search for one design.
int write_optimum(const Options& options, const project::Project& project, const NewProjectFile& file) {
  const auto limit = time_limit(options);
  const auto start = Clock::now();
  const study::Optimization found = [&] {
    const InterruptibleSearch search;  // what follows takes no time worth an early end
    return study::optimization(project, progress(),
                               [&] { return search.is_to_end() || (limit && Clock::now() - start > *limit); });
  }();
  foundation::Problems warnings = project.base().warnings;
  warnings.add(found.warnings);
  const std::string written = file.write(study::optimum_changes(found));
  if (!options.json) write_problems(warnings);
  write_output(options.json      ? results::optimization_json(found, warnings)
                   : options.csv ? results::optimization_csv(found)
                                 : results::optimization_text(found) + "\nThe optimum as settings:\n" +
                       results::optimization_settings(found) + written);
  if (found.cut_short) return not_computed;
  return options.strict && !found.feasible ? over_a_limit : done;
}

/// The search for a front.
int write_front(const Options& options, const project::Project& project, const NewProjectFile& file) {
  if (!options.time_limit.empty())
    throw BadArgument("--time-limit: a front is computed as a whole; take fewer points or starts");
  const std::unique_ptr<results::PictureFile> picture = new_picture(options);
  const study::DesignFront front = study::design_front(project, progress());
  const std::size_t chosen = study::chosen_point(front);
  const std::string written = file.write(study::front_changes(front, chosen));
  foundation::Problems warnings = project.base().warnings;
  warnings.add(front.warnings);
  if (!options.json) write_problems(warnings);
  write_output(options.json      ? results::front_json(front, warnings)
                   : options.csv ? results::front_csv(front)
                                 : results::front_text(front) +
                       fmt::format("\nPoint {}{} as settings:\n", chosen + 1, front.knee ? ", the knee," : "") +
                       results::front_settings(front, chosen) + written);
  if (picture) picture->publish(report::front_figure(front, project.title).svg);
  return done;
}

/// Only a front between two results has a picture.
void refuse_picture(const Options& options, const std::optional<project::OptimizeRequest>& request) {
  const std::size_t results = request ? request->front.size() : 0;
  if (!options.picture.empty() && results != 2)
    throw BadArgument(results == 0 ? "--picture: only a front has a picture; add front = [\"BODY.x\", "
                                     "\"ground.force.x\"] to [analyses.optimize]"
                                   : "--picture: only a front between two results has a picture; use --json");
}

}  // namespace

int optimize_command(const Options& options) {
  const auto project =
      read_or_complain(options,
                       {std::vector<std::string>{"optimize", "parameters", "requirements", "clearances", "limits",
                                                 "limit_lines", "response", "peaks", "random", "transient"}});
  if (!project) return wrong_input;
  try {
    const auto& request = project->base().analyses.optimize;
    refuse_picture(options, request);
    const NewProjectFile file(options, *project, trial_changes(project->base().analyses));
    if (file.problems().has_errors()) return complain(options, file.problems());
    return request && !request->front.empty() ? write_front(options, *project, file)
                                              : write_optimum(options, *project, file);
  } catch (const foundation::InvalidInput& wrong) {
    write_failure(wrong);
    return wrong_input;
  } catch (const BadArgument& bad) {
    write_failure(bad);
    return wrong_input;
  } catch (const foundation::NotComputable& reason) {
    write_failure(reason);
    return not_computed;
  }
}

}  // namespace trivet::cli

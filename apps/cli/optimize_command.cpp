// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/new_project_file.h"
#include "cli/progress_line.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/model_number.h"
#include "trivet/results/optimization_results.h"

namespace trivet::cli {
namespace {

/// Changes that the search may make: numbers to the middle of their ranges, the first mount of each choice.
std::vector<project::Node> trial_changes(const project::Analyses& asked) {
  const std::vector<std::string> names = asked.optimize ? asked.optimize->parameters : std::vector<std::string>();
  const auto takes_part = [&](const std::string& name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
  };
  std::vector<project::Node> changes;
  for (const project::MountChoice& choice : asked.choices)
    if (takes_part(choice.name) && !choice.mounts.empty()) changes.push_back(project::change_of(choice, 0));
  for (const project::DesignAxis& axis : asked.parameters)
    if (constexpr double middle = 0.5; takes_part(axis.name))
      changes.push_back(project::ModelNumber(axis).change(axis.at(middle)));
  return changes;
}

}  // namespace

int optimize_command(const Options& options) {
  const auto project =
      read_or_complain(options,
                       {std::vector<std::string>{"optimize", "parameters", "requirements", "clearances", "limits",
                                                 "limit_lines", "response", "peaks", "random", "transient"}});
  if (!project) return wrong_input;
  try {
    const NewProjectFile file(options, *project, trial_changes(project->base().analyses));
    if (file.problems().has_errors()) return complain(options, file.problems());
    const study::Optimization found = study::optimization(*project, progress());
    const std::string written = file.write(study::optimum_changes(found));
    if (!options.json) write_problems(project->base().warnings);
    write_output(options.json ? results::optimization_json(found)
                              : results::optimization_text(found) + "\nThe optimum as settings:\n" +
                         results::optimization_settings(found) + written);
    return options.strict && !found.feasible ? over_a_limit : done;
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

// SPDX-License-Identifier: BSD-3-Clause
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/new_project_file.h"
#include "cli/progress_line.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/results/selection_results.h"

namespace trivet::cli {
namespace {

/// Changes that the selection can make.
std::vector<project::Node> trial_mounts(const project::Analyses& asked) {
  std::vector<project::Node> changes;
  for (const project::MountChoice& choice : asked.choices)
    if (!choice.mounts.empty()) changes.push_back(project::change_of(choice, 0));
  return changes;
}

}  // namespace

int select_command(const Options& options) {
  const auto project =
      read_or_complain(options,
                       {std::vector<std::string>{"parameters", "requirements", "clearances", "limits", "limit_lines",
                                                 "response", "peaks", "random", "transient"}});
  if (!project) return wrong_input;
  try {
    const NewProjectFile file(options, *project, trial_mounts(project->base().analyses));
    if (file.problems().has_errors()) return complain(options, file.problems());
    const study::MountSelection found = study::mount_selection(*project, static_cast<std::size_t>(options.most),
                                                               progress(), study::mount_order(options.by));
    const study::MountDesign& best = found.best.front();
    if (!options.write.empty() && !best.reason.empty())
      throw foundation::NotComputable("select: no combination can be judged, so nothing was written: " + best.reason);
    const std::string written = file.write(study::selection_changes(found));
    foundation::Problems warnings = project->base().warnings;
    warnings.add(found.warnings);
    if (!options.json) write_problems(warnings);
    write_output(options.json ? results::selection_json(found, warnings)
                              : results::selection_text(found) + "\nThe best as settings:\n" +
                         results::selection_settings(found) + written);
    return options.strict && !best.met ? over_a_limit : done;
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

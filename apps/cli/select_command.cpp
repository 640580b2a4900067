// SPDX-License-Identifier: BSD-3-Clause
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/progress_line.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/results/selection_results.h"

namespace trivet::cli {

int select_command(const Options& options) {
  const auto project =
      read_or_complain(options,
                       {std::vector<std::string>{"parameters", "requirements", "clearances", "limits", "limit_lines",
                                                 "response", "peaks", "random", "transient"}});
  if (!project) return wrong_input;
  study::MountSelection found;
  try {
    found = study::mount_selection(*project, static_cast<std::size_t>(options.most), progress());
  } catch (const foundation::InvalidInput& wrong) {
    write_failure(wrong);
    return wrong_input;
  } catch (const foundation::NotComputable& reason) {
    write_failure(reason);
    return not_computed;
  }
  if (!options.json) write_problems(project->base().warnings);
  write_output(options.json
                   ? results::selection_json(found)
                   : results::selection_text(found) + "\nThe best as settings:\n" + results::selection_settings(found));
  return options.strict && !found.best.front().met ? over_a_limit : done;
}

}  // namespace trivet::cli

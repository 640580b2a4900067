// SPDX-License-Identifier: BSD-3-Clause
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/progress_line.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/results/optimization_results.h"

namespace trivet::cli {

int optimize_command(const Options& options) {
  const auto project =
      read_or_complain(options,
                       {std::vector<std::string>{"optimize", "parameters", "requirements", "clearances", "limits",
                                                 "limit_lines", "response", "peaks", "random", "transient"}});
  if (!project) return wrong_input;
  study::Optimization found;
  try {
    found = study::optimization(*project, progress());
  } catch (const foundation::InvalidInput& wrong) {
    write_failure(wrong);
    return wrong_input;
  } catch (const foundation::NotComputable& reason) {
    write_failure(reason);
    return not_computed;
  }
  if (!options.json) write_problems(project->base().warnings);
  write_output(options.json ? results::optimization_json(found)
                            : results::optimization_text(found) + "\nThe optimum as settings:\n" +
                       results::optimization_settings(found));
  return options.strict && !found.feasible ? over_a_limit : done;
}

}  // namespace trivet::cli

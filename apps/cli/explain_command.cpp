// SPDX-License-Identifier: BSD-3-Clause
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/progress_line.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/results/explanation_json.h"
#include "trivet/results/explanation_text.h"
#include "trivet/study/explanation.h"

namespace trivet::cli {
int explain_command(const Options& options) {
  const auto project = read_or_complain(options, questions_of(options, {"peaks", "response"}));
  if (!project) return wrong_input;
  try {
    const project::Case& variant = chosen_case(*project, options.case_name);
    const study::Explanation explanation = study::explanation(variant, {options.of, options.most}, progress());
    if (options.csv) write_problems(explanation.warnings);
    write_output(options.json      ? results::explain_json(variant, explanation)
                     : options.csv ? results::explain_csv(explanation)
                                   : results::explain_text(variant, explanation));
    return done;
  } catch (const BadArgument& bad) {
    write_failure(bad);
  } catch (const foundation::InvalidInput& bad) {
    write_failure(bad);
  }
  return wrong_input;
}

}  // namespace trivet::cli

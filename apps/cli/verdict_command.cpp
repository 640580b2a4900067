// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/progress_line.h"
#include "cli/strictness.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/results/verdict_results.h"

namespace trivet::cli {

int verdict_command(const Options& options) {
  const auto project = read_or_complain(options,
                                        {std::vector<std::string>{"requirements", "clearances", "limits", "limit_lines",
                                                                  "response", "peaks", "random", "transient"}});
  if (!project) return wrong_input;
  study::Verdict verdict;
  try {
    verdict = study::verdict(*project, progress());
  } catch (const foundation::InvalidInput& missing) {
    write_failure(missing);
    return wrong_input;
  }
  foundation::Problems warnings;
  for (const study::CaseVerdict& judged : verdict.cases) warnings.add(judged.warnings);
  warnings.sort_by_origin();
  if (!options.json) write_problems(warnings);
  write_output(options.json      ? results::verdict_json(verdict)
                   : options.csv ? results::verdict_csv(verdict)
                                 : results::verdict_text(verdict));
  const bool complete = std::all_of(verdict.cases.begin(), verdict.cases.end(),
                                    [](const study::CaseVerdict& judged) { return judged.not_judged() == 0; });
  Strictness strictness;
  for (const study::CaseVerdict& judged : verdict.cases) strictness.add(judged);
  strictness.add(warnings);
  return strictness.exit_code(options.strict, complete ? done : not_computed);
}

}  // namespace trivet::cli

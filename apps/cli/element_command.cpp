// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <numeric>
#include <optional>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/progress_line.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/project/questions.h"
#include "trivet/report/element_picture.h"
#include "trivet/results/element_json.h"
#include "trivet/results/element_text.h"

namespace trivet::cli {
namespace {

std::size_t chosen_element(const project::Case& variant, const std::string& name) {
  std::vector<std::string> names;
  for (const model::Element& element : variant.system.elements()) {
    if (element.name == name) return names.size();
    names.push_back(element.name);
  }
  const std::string guess = foundation::nearest_name(name, names);
  throw BadArgument(fmt::format(
      "\"{}\": no element has this name{}", name,
      guess.empty() ? fmt::format("; they are {}", fmt::join(names, ", ")) : "; did you mean \"" + guess + "\"?"));
}

std::vector<std::size_t> replaced(const project::Case& variant, std::size_t element, bool all) {
  if (!all) return {element};
  std::vector<std::size_t> every(variant.system.elements().size());
  std::iota(every.begin(), every.end(), std::size_t{0});
  return every;
}

}  // namespace

int element_command(const Options& options) {
  const auto project = read_or_complain(options, questions_of(options, {}));
  if (!project) return wrong_input;
  try {
    const project::Case& variant = chosen_case(*project, options.case_name);
    const std::size_t element = chosen_element(variant, options.element);
    const std::unique_ptr<results::PictureFile> picture = new_picture(options);
    study::ElementSummary summary = study::element_summary(variant, element);
    std::optional<study::Simplification> simple;
    try {
      if (project::has_broken_curves(variant))
        summary.warnings.warning("analyses", "errors in response or peaks",
                                 "the comparison with three springs uses the peaks of the coordinates instead of those "
                                 "that the file requests",
                                 "trivet check lists the errors");
      simple = study::simplification(variant, replaced(variant, element, options.all), progress());
    } catch (const foundation::NotComputable& reason) {
      summary.warnings.warning("comparison with three springs", "not computed", reason.what(), "");
    }
    write_output(options.json ? results::element_json(variant, element, summary, simple)
                              : results::element_text(variant, element, summary) +
                         (simple ? "\n" + results::simplification_text(*simple) : ""));
    if (picture) picture->publish(report::element_picture(variant, element));
    return done;
  } catch (const BadArgument& bad) {
    write_failure(bad);
    return wrong_input;
  }
}

}  // namespace trivet::cli

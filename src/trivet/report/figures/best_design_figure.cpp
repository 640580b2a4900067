// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/judging/changed_case.h"
#include "trivet/report/drawing/machine_drawing.h"
#include "trivet/report/drawing/result_figures.h"
#include "trivet/study/optimize/optimization.h"

/// The best design drawn over the given one, if they differ in what is drawn.
namespace trivet::report {

std::vector<Figure> best_design_figures(const project::Case& variant, const study::CaseResults& results) {
  if (!results.optimization) return {};
  const auto design = judging::changed_case(variant, study::optimum_changes(*results.optimization));
  if (!design || machine_drawing(*design) == machine_drawing(variant)) return {};
  return {{.title = case_title("Best design, and the given one in grey", results),
           .file_name = "best_design.svg",
           .svg = machine_drawing(variant, *design)}};
}

}  // namespace trivet::report

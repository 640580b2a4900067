// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/answer_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trivet::report {

double highest_finite(const Eigen::VectorXd& values) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, value);
  return largest;
}

std::vector<Figure> answer_figures(const study::Answers& answers) {
  std::vector<Figure> all;
  for (const auto& kind : {random_figures, transient_figures, run_up_figures, campbell_figures, waterfall_figures, transmissibility_figures,
                           power_figures, shock_figures, limit_figures, shape_figures, map_figures}) {
    int number = 0;  // different names may share the letters that are safe in a file name
    for (Figure& figure : kind(answers)) {
      const std::size_t dash = figure.file_name.find('-');
      if (dash != std::string::npos) figure.file_name.insert(dash, fmt::format("-{:02}", ++number));
      all.push_back(std::move(figure));
    }
  }
  return all;
}

}  // namespace trivet::report

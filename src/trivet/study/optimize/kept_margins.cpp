// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/kept_margins.h"

#include <algorithm>
#include <cmath>

#include "trivet/foundation/index.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/study/sample/worst_case.h"

namespace trivet::study {
namespace {

/// Margins of designs in all cases side by side; 0 where a design cannot be judged.
Eigen::ArrayXXd judged_designs(const SampleRun& run, const foundation::Progress& progress) {
  Eigen::Index columns = 0;
  for (const SampledCase& one : run.cases()) columns += to_index(one.given().size());
  Eigen::ArrayXXd margins(to_index(searched_machines), columns);
  foundation::parallel_for(searched_machines, {.size = run.piece(), .progress = progress, .task = "machines"},
                           [&](std::size_t first, std::size_t last) {
                             const Eigen::MatrixXd draws = run.drawn().draw(first, last - first);
                             Eigen::Index column = 0;
                             for (const SampledCase& one : run.cases()) {
                               const Eigen::ArrayXXd found = one.judged(draws).margins;
                               margins.block(to_index(first), column, draws.rows(), found.cols()) =
                                   found.isNaN().select(0, found);
                               column += found.cols();
                             }
                           });
  return margins;
}

/// Bounds of all columns, each at the same place of its order, above which a share of the rows lies with all columns.
std::vector<double> common_bounds(const Eigen::ArrayXXd& margins, double share) {
  const std::size_t rows = to_size(margins.rows());
  std::vector<std::vector<double>> sorted;
  std::vector<std::size_t> least(rows, rows);  // of each row: how many rows a column has up to it
  for (Eigen::Index c = 0; c < margins.cols(); ++c) {
    std::vector<double>& column = sorted.emplace_back(margins.col(c).begin(), margins.col(c).end());
    std::ranges::sort(column);
    for (std::size_t i = 0; i < rows; ++i) {
      const auto up_to = std::ranges::upper_bound(column, margins(to_index(i), c)) - column.begin();
      least[i] = std::min(least[i], static_cast<std::size_t>(up_to));
    }
  }
  std::ranges::sort(least);
  const auto allowed = static_cast<std::size_t>((1 - share) * static_cast<double>(rows));
  std::vector<double> bounds;
  for (const std::vector<double>& column : sorted) bounds.push_back(column[std::min(least[allowed], rows) - 1]);
  return bounds;
}

Kept nominal_margins(const SampleRun& run) {
  Kept found;
  for (const SampledCase& one : run.cases()) {
    std::vector<double>& nominal = found.nominal.emplace_back();
    for (const RequirementResult& result : one.given()) nominal.push_back(result.margin);
  }
  found.kept = found.nominal;
  return found;
}

/// The bound that a share of the margins keeps.
double kept_of(const Eigen::ArrayXd& margins, double share) {
  std::vector<double> list(margins.begin(), margins.end());
  const auto place = list.begin() + static_cast<std::ptrdiff_t>((1 - share) * static_cast<double>(list.size()));
  std::ranges::nth_element(list, place);
  return *place;
}

/// Changes the share by how many machines of a design that has the reserves of the bounds are below what counts.
void adapt(Aim& aim, double below) {
  constexpr double most_change = 4, fewest_above = 0.5;
  const double factor = std::clamp((1 - aim.searched) / std::max(below, 1e-9), 1 / most_change, most_change);
  aim.share = std::clamp(1 - (1 - aim.share) * factor, fewest_above, 1 - 2.0 / searched_machines);
}

}  // namespace

Kept kept_by_share(const SampleRun& run, Aim& aim, const foundation::Progress& progress) {
  Kept found = nominal_margins(run);
  const Eigen::ArrayXXd margins = judged_designs(run, progress);
  const Eigen::ArrayXd least_of_each = margins.rowwise().minCoeff();
  std::vector<double> least(least_of_each.begin(), least_of_each.end());
  std::ranges::sort(least);
  const auto count = static_cast<double>(least.size());
  found.least = least[static_cast<std::size_t>((1 - aim.wanted) * count)];
  std::vector<double> bounds = common_bounds(margins, aim.share);
  if (aim.is_adapted) {
    const double level = aim.minimizes ? 1 : *std::ranges::min_element(bounds);
    adapt(aim, static_cast<double>(std::ranges::lower_bound(least, level) - least.begin()) / count);
    bounds = common_bounds(margins, aim.share);
  }
  std::size_t column = 0;
  found.alone = found.kept;
  for (std::size_t c = 0; c < found.kept.size(); ++c)
    for (std::size_t r = 0; r < found.kept[c].size(); ++r, ++column) {
      found.kept[c][r] = bounds[column];
      found.alone[c][r] = kept_of(margins.col(to_index(column)), aim.wanted);
    }
  return found;
}

double kept_least(const SampleRun& run, double wanted, const foundation::Progress& progress) {
  return kept_of(judged_designs(run, progress).rowwise().minCoeff(), wanted);
}

Kept kept_by_worst(const SampleRun& run, const foundation::Progress& progress) {
  Kept found = nominal_margins(run);
  WorstStarts none;
  for (const SampledCase& one : run.cases()) none.emplace_back(one.given().size());
  const WorstSearch worst = worst_search(run.cases(), worst_box(run.drawn()), none, run.request().seed, progress);
  for (std::size_t c = 0; c < found.kept.size(); ++c)
    for (std::size_t r = 0; r < found.kept[c].size(); ++r) {
      found.kept[c][r] = std::min(worst.of[c][r].margin, found.nominal[c][r]);
      found.least = std::min(found.least, found.kept[c][r]);
    }
  found.alone = found.kept;
  found.failed = worst.failed;
  found.first_failure = worst.first_failure;
  if (worst.failed > 0) found.least = 0;  // they are worse than any margin
  return found;
}

bool has_reserve(double nominal, double kept) { return std::isfinite(nominal) && nominal > 0 && kept > 0; }

}  // namespace trivet::study

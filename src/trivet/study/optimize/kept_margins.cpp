// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/kept_margins.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/judging/changed_case.h"
#include "trivet/study/analyses/case_context.h"
#include "trivet/study/family/packed_margins.h"
#include "trivet/study/requirements/requirement_values.h"
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

/// Where the rows are in the order of each column.
class Orders {
 public:
  explicit Orders(const Eigen::ArrayXXd& margins) : least_(to_size(margins.rows()), to_size(margins.rows())) {
    for (Eigen::Index c = 0; c < margins.cols(); ++c) {
      std::vector<std::pair<double, std::size_t>> rows;
      for (std::size_t i = 0; i < least_.size(); ++i) rows.emplace_back(margins(to_index(i), c), i);
      std::ranges::sort(rows);
      std::vector<double>& column = sorted_.emplace_back();
      for (const auto& [margin, row] : rows) column.push_back(margin);
      for (std::size_t first = 0, up_to = 0; first < rows.size(); first = up_to) {
        while (up_to < rows.size() && column[up_to] == column[first]) ++up_to;
        for (std::size_t i = first; i < up_to; ++i) least_[rows[i].second] = std::min(least_[rows[i].second], up_to);
      }
    }
    std::ranges::sort(least_);
  }

  /// Bounds of all columns, each at the same place of its order, above which a share of the rows lies with all columns.
  [[nodiscard]] std::vector<double> bounds(double share) const {
    const auto allowed = static_cast<std::size_t>((1 - share) * static_cast<double>(least_.size()));
    std::vector<double> bounds;
    for (const std::vector<double>& column : sorted_) bounds.push_back(column[least_[allowed] - 1]);
    return bounds;
  }

 private:
  std::vector<std::vector<double>> sorted_;
  std::vector<std::size_t> least_;  ///< of all rows, in order: how many rows a column has up to it
};

Kept nominal_margins(const SampleRun& run) {
  Kept found;
  for (const SampledCase& one : run.cases()) {
    std::vector<double>& nominal = found.nominal.emplace_back();
    for (const RequirementResult& result : one.given()) nominal.push_back(result.margin);
  }
  found.kept = found.alone = found.nominal;
  return found;
}

std::vector<Eigen::Index> columns_with_reserve(const Kept& of) {
  std::vector<Eigen::Index> columns;
  Eigen::Index column = 0;
  for (const std::vector<double>& of_case : of.nominal)
    for (const double nominal : of_case) {
      if (has_reserve(nominal, nominal)) columns.push_back(column);
      ++column;
    }
  return columns;
}

/// The bound that a share of the margins keeps.
double kept_of(const Eigen::ArrayXd& margins, double share) {
  std::vector<double> list(margins.begin(), margins.end());
  const auto place = list.begin() + static_cast<std::ptrdiff_t>((1 - share) * static_cast<double>(list.size()));
  std::ranges::nth_element(list, place);
  return *place;
}

/// The margin that a share of the machines keeps; 0 if it is not above `least`, none if too many are not proven.
/// @param margins  of machines by their numbers, the least of each; NaN: not proven  @param assembled  that of one
std::optional<double> kept_above(double least, double share, std::size_t piece, const foundation::Progress& progress,
                                 const std::function<Eigen::ArrayXd(std::size_t first, std::size_t count)>& margins,
                                 const std::function<double(std::size_t machine)>& assembled = {}) {
  // Both tails of 1 % beyond the range of one draw are 328: a family of this design alone has to assemble them as well.
  constexpr std::size_t most_assembled = searched_machines / 32;
  const auto allowed = static_cast<std::size_t>((1 - share) * static_cast<double>(searched_machines));
  Eigen::ArrayXd all(to_index(searched_machines));
  std::atomic<std::size_t> not_above = 0;
  foundation::parallel_for(searched_machines, {.size = piece, .progress = progress, .task = "machines"},
                           [&](std::size_t first, std::size_t last) {
                             if (not_above > allowed) return;
                             auto part = all.segment(to_index(first), to_index(last - first));
                             part = margins(first, last - first);
                             not_above += to_size((part <= least).count());
                           });
  if (not_above > allowed) return 0;
  std::vector<std::size_t> not_proven;
  for (std::size_t i = 0; i < searched_machines; ++i)
    if (std::isnan(all(to_index(i)))) not_proven.push_back(i);
  if (not_proven.size() > most_assembled) return std::nullopt;
  foundation::parallel_for(not_proven.size(), {.size = 1, .progress = progress, .task = "machines"},
                           [&](std::size_t first, std::size_t last) {
                             for (std::size_t i = first; i < last; ++i)
                               all(to_index(not_proven[i])) = assembled(not_proven[i]);
                           });
  const double kept = kept_of(all, share);
  return kept > least ? kept : 0;
}

/// A design in one case, whose machines are assembled.
struct DesignOfCase {
  project::Case design;
  ToleratedNumbers numbers;
};

/// The least margin of a machine by its model; 0 if it cannot be judged.
double assembled_least(const DesignOfCase& of, const Eigen::VectorXd& draws) {
  double least = foundation::infinity;
  try {
    const model::System machine = of.numbers.machine(of.design, draws);
    foundation::Problems warnings;
    for (const RequirementResult& one : requirement_values(CaseContext(machine, {}), of.design.analyses, warnings))
      least = one.value && !std::isnan(one.margin) ? std::min(least, one.margin) : 0;
  } catch (const foundation::NotComputable&) {
    return 0;
  } catch (const foundation::InvalidInput&) {
    return 0;
  }
  return least;
}

/// What is drawn for a machine after the numbers of its design.
DesignNumbers machine_numbers(const SampleRun& run, const SampledCase& one, const DesignSpace& space) {
  DesignNumbers numbers;
  numbers.any_size = true;
  numbers.compared = design::SumFamily::Compared::ends;
  numbers.variables = space.numbers(one.variant()).variables;
  for (std::size_t d = 0; d < run.drawn().draws(); ++d)
    numbers.variables.push_back({one.from()(to_index(d)), one.to()(to_index(d)), run.drawn().name(d).words()});
  numbers.model = [&](const Eigen::VectorXd& values) {
    Eigen::VectorXd shares(to_index(space.size()));
    for (std::size_t j = 0; j < space.size(); ++j) shares(to_index(j)) = space.axes()[j].share(values(to_index(j)));
    const auto design = judging::changed_case(one.variant(), space.changes(shares));
    if (!design) throw foundation::NotComputable(message(design.error().list().front()));
    return ToleratedNumbers(*design, run.tolerances(), run.drawn())
        .machine(*design, values.tail(to_index(run.drawn().draws())));
  };
  return numbers;
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
  // What has no reserve, such as a curve without a peak, is not helped by larger ones of the others.
  const std::vector<Eigen::Index> reserved = columns_with_reserve(found);
  const Eigen::ArrayXXd of_reserves = margins(Eigen::all, reserved);
  const Orders orders(of_reserves);
  std::vector<double> bounds = orders.bounds(aim.share);
  if (aim.is_adapted && !bounds.empty()) {
    const double level = aim.minimizes ? 1 : *std::ranges::min_element(bounds);
    adapt(aim, static_cast<double>((of_reserves.rowwise().minCoeff() < level).count()) / count);
    bounds = orders.bounds(aim.share);
  }
  Eigen::Index column = 0;
  std::size_t bound = 0;
  for (std::size_t c = 0; c < found.kept.size(); ++c)
    for (std::size_t r = 0; r < found.kept[c].size(); ++r, ++column) {
      found.alone[c][r] = kept_of(margins.col(column), aim.wanted);
      const bool has_bound = bound < reserved.size() && reserved[bound] == column;
      found.kept[c][r] = has_bound ? bounds[bound++] : found.alone[c][r];
    }
  return found;
}

double kept_least(const SampleRun& run, double wanted, double least, const foundation::Progress& progress) {
  return *kept_above(least, wanted, run.piece(), progress, [&](std::size_t first, std::size_t count) {
    const Eigen::MatrixXd draws = run.drawn().draw(first, count);
    Eigen::ArrayXd margins = Eigen::ArrayXd::Constant(draws.rows(), foundation::infinity);
    for (const SampledCase& one : run.cases()) {
      const Eigen::ArrayXXd found = one.judged(draws).margins;
      margins = margins.min(found.isNaN().select(0, found).rowwise().minCoeff());
    }
    return margins;
  });
}

MachineFamily::MachineFamily(const SampleRun& run, const DesignSpace& space) : run_(run), space_(space) {
  const auto has_kernels = [&](const SampledCase& one) {
    if (!one.no_kernels().empty()) return false;
    const DesignBatch& batch =
        batches_.emplace_back(machine_numbers(run, one, space), one.variant(), one.variant().analyses, one.given());
    for (std::size_t r = 0; r < one.given().size(); ++r)
      if (!batch.reason().empty() || (!batch.packed().covers(r) && !is_constant(one.given()[r]))) return false;
    return true;
  };
  if (!std::ranges::all_of(run.cases(), has_kernels)) batches_.clear();
}

std::optional<double> MachineFamily::kept_least(const Eigen::VectorXd& shares, double wanted, double least,
                                                const foundation::Progress& progress) const {
  if (batches_.empty()) return std::nullopt;
  const Eigen::RowVectorXd values = space_.values(shares).transpose();
  std::vector<DesignOfCase> designs;
  for (const SampledCase& one : run_.cases()) {
    auto design = judging::changed_case(one.variant(), space_.changes(shares));
    if (!design) return 0;
    ToleratedNumbers numbers(*design, run_.tolerances(), run_.drawn());
    designs.push_back({std::move(*design), std::move(numbers)});
  }
  const auto assembled = [&](std::size_t machine) {
    const Eigen::VectorXd draws = run_.drawn().draw(machine, 1).row(0).transpose();
    double of_all = foundation::infinity;
    for (const DesignOfCase& one : designs) of_all = std::min(of_all, assembled_least(one, draws));
    return of_all;
  };
  const auto by_kernels = [&](std::size_t first, std::size_t count) {
    const Eigen::MatrixXd draws = run_.drawn().draw(first, count);
    Eigen::MatrixXd machines(draws.rows(), values.size() + draws.cols());
    machines << values.replicate(draws.rows(), 1), draws;
    Eigen::ArrayXd margins = Eigen::ArrayXd::Constant(draws.rows(), foundation::infinity);
    for (std::size_t c = 0; c < batches_.size(); ++c) {
      const SampledCase& one = run_.cases()[c];
      Eigen::ArrayXXd found = packed_margins(batches_[c].packed(), batches_[c].family().designs(machines));
      for (std::size_t r = 0; r < one.given().size(); ++r)
        if (is_constant(one.given()[r])) found.col(to_index(r)).setConstant(one.given()[r].margin);
      for (Eigen::Index i = 0; i < draws.rows(); ++i) {
        const auto drawn = draws.row(i).transpose().array();
        const bool proven = (drawn >= one.from()).all() && (drawn <= one.to()).all() && !found.row(i).isNaN().any();
        margins(i) = proven ? std::min(margins(i), found.row(i).minCoeff()) : std::nan("");
      }
    }
    return margins;
  };
  return kept_above(least, wanted, SampledCase::kernel_piece, progress, by_kernels, assembled);
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

DesignObjective::Reserves reserves_for(const Kept& at) {
  DesignObjective::Reserves reserves;
  for (std::size_t c = 0; c < at.nominal.size(); ++c) {
    std::vector<double>& of_case = reserves.emplace_back();
    for (std::size_t r = 0; r < at.nominal[c].size(); ++r) {
      const double nominal = at.nominal[c][r], kept = at.kept[c][r];
      of_case.push_back(has_reserve(nominal, kept) ? std::max(0.0, std::log(nominal / kept)) + same_reserves : 0);
    }
  }
  return reserves;
}

double largest_difference(const DesignObjective::Reserves& a, const DesignObjective::Reserves& b) {
  if (a.empty() || b.empty()) return foundation::infinity;
  double largest = 0;
  for (std::size_t c = 0; c < a.size(); ++c)
    for (std::size_t r = 0; r < a[c].size(); ++r) largest = std::max(largest, std::abs(a[c][r] - b[c][r]));
  return largest;
}

}  // namespace trivet::study

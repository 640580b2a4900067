// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/sample/sample_shares.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "trivet/foundation/index.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/study/sample/sample_tally.h"

namespace trivet::study {
namespace {

/// Designs of the shares: their values are kept until they are added in their order.
constexpr std::size_t most_of_shares = 200'000, judged_at_once = 960;

/// For each tolerance the first one that is correlated with it, also through others; or itself.
std::vector<std::size_t> first_correlated(const std::vector<project::Tolerance>& tolerances) {
  std::vector<std::size_t> first(tolerances.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  for (std::size_t t = 0; t < tolerances.size(); ++t)
    for (const project::Tolerance::Correlation& one : tolerances[t].correlations) {
      const auto other = std::ranges::find(tolerances, one.with, &project::Tolerance::name) - tolerances.begin();
      const auto [to, from] = std::minmax(first[t], first[to_size(other)]);
      std::ranges::replace(first, std::size_t{from}, std::size_t{to});
    }
  return first;
}

std::vector<DrawnSet> independent_sets(const std::vector<project::Tolerance>& tolerances, const DrawnDesigns& drawn) {
  const std::vector<std::size_t> first = first_correlated(tolerances);
  std::vector<DrawnSet> sets;
  for (std::size_t t = 0; t < tolerances.size(); ++t) {
    if (first[t] != t) continue;
    std::vector<std::string> names;
    DrawnSet all;
    for (std::size_t other = t; other < tolerances.size(); ++other) {
      if (first[other] != t) continue;
      names.push_back(tolerances[other].name);
      for (std::size_t d = 0; d < tolerances[other].draws(); ++d) all.draws.push_back(drawn.draw_of(other, d));
    }
    const bool is_correlated = names.size() > 1;
    const bool is_all = all.draws.size() == drawn.draws();  // the share of all numbers is 1
    if (is_correlated || (all.draws.size() > 1 && !is_all)) {
      all.name = {foundation::comma_separated(names),
                  is_correlated ? "(correlated)" : fmt::format("(all {} numbers)", all.draws.size())};
      sets.push_back(all);
    }
    if (!is_correlated)
      for (const std::size_t draw : all.draws) sets.push_back({drawn.name(draw), {draw}});
  }
  return sets;
}

/// Why there are no shares; empty if there are.
std::string reason_against(std::size_t draws, std::size_t sets, const project::SampleRequest& request) {
  if (2 * draws > numerics::SobolNumbers::most_dimensions) return fmt::format("{} drawn numbers are too many", draws);
  if (request.designs < 2 * project::sample_replicates * (sets + 2))
    return fmt::format("{} designs are too few: {} are needed", request.designs,
                       2 * project::sample_replicates * (sets + 2));
  return "";
}

/// Two independent designs a and b of each number, and a with the draws of single sets of b.
class Pairs {
 public:
  Pairs(const std::vector<project::Tolerance>& tolerances, const std::vector<DrawnSet>& sets,
        const project::SampleRequest& request)
      : sets_(sets), twice_(twice(tolerances)), drawn_(twice_, request), draws_(drawn_.draws() / 2) {}

  [[nodiscard]] std::size_t designs_of_pair() const { return sets_.size() + 2; }
  [[nodiscard]] std::size_t replicate(std::size_t pair) const { return pair % project::sample_replicates; }

  /// All designs of some pairs: a, b, then a with each set of b.
  [[nodiscard]] Eigen::MatrixXd designs(std::size_t first, std::size_t count) const {
    const Eigen::MatrixXd both = drawn_.draw(first, count);
    const auto n = to_index(draws_), step = to_index(designs_of_pair());
    Eigen::MatrixXd all(to_index(count) * step, n);
    for (Eigen::Index pair = 0; pair < to_index(count); ++pair) {
      const Eigen::RowVectorXd a = both.row(pair).head(n), b = both.row(pair).tail(n);
      all.middleRows(pair * step, step).rowwise() = a;
      all.row(pair * step + 1) = b;
      for (std::size_t s = 0; s < sets_.size(); ++s)
        for (const std::size_t d : sets_[s].draws) all(pair * step + 2 + to_index(s), to_index(d)) = b(to_index(d));
    }
    return all;
  }

 private:
  /// Those of b have other names, each longer than all of a, and are correlated with each other only.
  static std::vector<project::Tolerance> twice(std::vector<project::Tolerance> tolerances) {
    const std::size_t count = tolerances.size();
    std::size_t longest = 0;
    for (const project::Tolerance& one : tolerances) longest = std::max(longest, one.name.size());
    const std::string of_b(longest + 1, 'b');
    tolerances.reserve(2 * count);
    for (std::size_t t = 0; t < count; ++t) {
      project::Tolerance& copy = tolerances.emplace_back(tolerances[t]);
      copy.name = of_b + copy.name;
      for (project::Tolerance::Correlation& one : copy.correlations) one.with = of_b + one.with;
    }
    return tolerances;
  }

  const std::vector<DrawnSet>& sets_;
  std::vector<project::Tolerance> twice_;
  DrawnDesigns drawn_;
  std::size_t draws_;
};

/// Values of the requirements in all designs; NaN where there is none.
class ValuesOfPairs {
 public:
  ValuesOfPairs(const std::vector<SampledCase>& cases, std::size_t designs) : cases_(cases) {
    for (std::size_t c = 0; c < cases.size(); ++c)
      for (std::size_t r = 0; r < cases[c].given().size(); ++r) places_.emplace_back(c, r);
    values_.resize(to_index(designs), to_index(places_.size()));
  }

  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& places() const { return places_; }

  void judge(std::size_t first, const Eigen::MatrixXd& designs) {
    std::vector<SampledMargins> margins;
    for (const SampledCase& one : cases_) margins.push_back(one.judged(designs));
    for (std::size_t p = 0; p < places_.size(); ++p) {
      const auto [c, r] = places_[p];
      for (Eigen::Index d = 0; d < designs.rows(); ++d)
        values_(to_index(first) + d, to_index(p)) =
            value_at_margin(cases_[c].given()[r], margins[c].margins(d, to_index(r)))
                .value_or(std::numeric_limits<double>::quiet_NaN());
    }
  }

  /// Values of one requirement in some designs.
  [[nodiscard]] Eigen::VectorXd of(std::size_t place, std::size_t first, std::size_t count) const {
    return values_.col(to_index(place)).segment(to_index(first), to_index(count));
  }

 private:
  const std::vector<SampledCase>& cases_;
  std::vector<std::pair<std::size_t, std::size_t>> places_;
  Eigen::MatrixXd values_;
};

}  // namespace

SampledShares variance_shares(const std::vector<SampledCase>& cases, const std::vector<project::Tolerance>& tolerances,
                              const project::SampleRequest& request, const foundation::Progress& progress) {
  SampledShares found;
  const DrawnDesigns drawn(tolerances, request);
  found.sets = independent_sets(tolerances, drawn);
  found.reason = reason_against(drawn.draws(), found.sets.size(), request);
  if (!found.reason.empty()) return found;
  const Pairs pairs(tolerances, found.sets, request);
  const std::size_t step = pairs.designs_of_pair(), replicates = project::sample_replicates;
  found.pairs = std::min(request.designs, most_of_shares) / step / replicates * replicates;
  ValuesOfPairs values(cases, found.pairs * step);
  foundation::parallel_for(
      found.pairs,
      {.size = std::max<std::size_t>(1, judged_at_once / step), .progress = progress, .task = "designs of shares"},
      [&](std::size_t first, std::size_t last) { values.judge(first * step, pairs.designs(first, last - first)); });
  for (std::size_t p = 0; p < values.places().size(); ++p) {
    const auto [c, r] = values.places()[p];
    RequirementShares& of = found.list.emplace_back(c, r);
    if (!value_at_margin(cases[c].given()[r], 1)) {
      of.reason = "its margin is not that of a value";
      continue;
    }
    numerics::PairedValues paired(found.sets.size(), replicates);
    std::uint64_t left_out = 0;
    for (std::size_t pair = 0; pair < found.pairs; ++pair) {
      const Eigen::VectorXd of_pair = values.of(p, pair * step, step);
      if (!of_pair.allFinite()) ++left_out;
      else paired.add(pairs.replicate(pair), of_pair(0), of_pair(1), of_pair.tail(to_index(found.sets.size())));
    }
    found.left_out = std::max(found.left_out, left_out);
    of.sets = paired.shares(sample_confidence);
    if (of.sets.empty())
      of.reason = paired.fewest_pairs() < 2
          ? fmt::format("its value is unbounded, or cannot be judged, in {} of {} pairs", left_out, found.pairs)
          : "its value does not vary";
  }
  return found;
}

}  // namespace trivet::study

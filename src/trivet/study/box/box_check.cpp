// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/box/box_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/numerics/sampling/sobol_numbers.h"

namespace trivet::study {
namespace {

constexpr std::size_t draws_for_all_corners = 16;  // draws
constexpr std::uint64_t checked_corners = 1 << 16;
constexpr std::uint64_t inside_by_kernels = 1'000'000,
                        inside_by_models = 10'000;                        // designs inside, if none are requested
constexpr std::uint64_t by_models_too = 256;                              // corners and designs inside by models
constexpr std::uint64_t check_scramble = project::sample_replicates + 1;  // other numbers than those of the search

/// The least margin of a requirement, or a design that failed.
struct LeastMargin {
  double margin = std::numeric_limits<double>::infinity();
  std::uint64_t design = std::numeric_limits<std::uint64_t>::max();

  void add(double other, std::uint64_t at) {
    if (other < margin || (other == margin && at < design)) margin = other, design = at;
  }
};

/// What a piece of the designs shows, and all of them together.
struct CheckTally {
  std::vector<std::vector<LeastMargin>> of;  ///< per case and requirement
  std::uint64_t first_failed = std::numeric_limits<std::uint64_t>::max(), violations = 0;
  std::string failure;
  std::vector<std::uint64_t> in_kernels, one_by_one;

  void merge(const CheckTally& other) {
    for (std::size_t c = 0; c < of.size(); ++c) {
      for (std::size_t r = 0; r < of[c].size(); ++r) of[c][r].add(other.of[c][r].margin, other.of[c][r].design);
      in_kernels[c] += other.in_kernels[c];
      one_by_one[c] += other.one_by_one[c];
    }
    violations += other.violations;
    if (other.first_failed < first_failed) first_failed = other.first_failed, failure = other.failure;
  }
};

class DesignCheck {
 public:
  DesignCheck(const project::Project& project, const BoxEnds& ends, const project::BoxRequest& request,
              const foundation::Progress& progress)
      : cases_(project, ends, ends.times()),
        box_(ends.box(ends.times())),
        sobol_(cases_.draws(), request.seed, check_scramble),
        progress_(progress) {
    check_.all_corners = cases_.draws() <= draws_for_all_corners;
    check_.corners = check_.all_corners ? std::uint64_t{1} << cases_.draws() : checked_corners;
    check_.inside = request.points.value_or(cases_.has_kernels() ? inside_by_kernels : inside_by_models);
  }

  CheckedBox run() {
    const std::uint64_t count = check_.corners + check_.inside;
    CheckTally all = empty();
    std::mutex merging;
    foundation::parallel_for(count,
                             {.size = cases_.piece(), .progress = progress_, .task = "corners and designs inside"},
                             [&](std::size_t from, std::size_t to) {
                               CheckTally part = empty();
                               std::vector<std::uint64_t> designs(to - from);
                               for (std::size_t i = from; i < to; ++i) designs[i - from] = i;
                               add(designs, part);
                               const std::lock_guard lock(merging);
                               all.merge(part);
                             });
    if (cases_.has_kernels()) add_models(all, merging);
    return found(all);
  }

 private:
  [[nodiscard]] CheckTally empty() const {
    CheckTally tally;
    for (const SampledCase& one : cases_.list()) tally.of.emplace_back(one.given().size());
    tally.in_kernels.resize(tally.of.size());
    tally.one_by_one.resize(tally.of.size());
    return tally;
  }

  /// Corners first.
  [[nodiscard]] Eigen::VectorXd place(std::uint64_t design) const {
    Eigen::VectorXd point(to_index(cases_.draws()));
    const bool corner = design < check_.corners;
    if (corner && check_.all_corners) {
      for (Eigen::Index d = 0; d < point.size(); ++d) point(d) = static_cast<double>((design >> d) & 1);
      return point;
    }
    const std::uint64_t number = corner ? check_.inside + design : design - check_.corners;
    sobol_.set_point(number, {point.data(), cases_.draws()});
    if (corner) point = point.array().round();
    return point;
  }

  [[nodiscard]] Eigen::VectorXd draws(std::uint64_t design) const {
    return box_.at(place(design).transpose()).row(0).transpose();
  }

  [[nodiscard]] Eigen::MatrixXd numbers(const std::vector<std::uint64_t>& designs) const {
    DrawPlaces places(to_index(designs.size()), to_index(cases_.draws()));
    for (std::size_t i = 0; i < designs.size(); ++i) places.row(to_index(i)) = place(designs[i]).transpose();
    return box_.at(places);
  }

  /// The designs that violate a requirement or cannot be judged.
  std::vector<bool> violators(const std::vector<std::uint64_t>& designs, bool by_models, CheckTally& into) const {
    const Eigen::MatrixXd of = numbers(designs);
    std::vector<bool> bad(designs.size());
    for (std::size_t c = 0; c < cases_.list().size(); ++c) {
      const SampledCase& one = cases_.list()[c];
      const SampledMargins found = by_models ? one.assembled(of) : one.judged(of);
      into.in_kernels[c] += by_models ? 0 : found.in_kernels;
      into.one_by_one[c] += by_models ? 0 : found.one_by_one;
      for (std::size_t i = 0; i < designs.size(); ++i) {
        if (!found.failures[i].empty()) {
          bad[i] = true;
          if (designs[i] < into.first_failed) into.first_failed = designs[i], into.failure = found.failures[i];
          continue;
        }
        for (std::size_t r = 0; r < into.of[c].size(); ++r) {
          const double margin = found.margins(to_index(i), to_index(r));
          into.of[c][r].add(margin, designs[i]);
          if (margin < 1) bad[i] = true;
        }
      }
    }
    return bad;
  }

  void add(const std::vector<std::uint64_t>& designs, CheckTally& into) const {
    into.violations += to_size(std::ranges::count(violators(designs, false, into), true));
  }

  /// Of designs that were added: those that meet everything by kernels only are further violations.
  void add_by_models(const std::vector<std::uint64_t>& designs, CheckTally& into) const {
    CheckTally counted = empty();
    const std::vector<bool> before = violators(designs, false, counted), bad = violators(designs, true, into);
    for (std::size_t i = 0; i < designs.size(); ++i) into.violations += bad[i] && !before[i];
  }

  /// Kernels and models have matrices of different origin.
  void add_models(CheckTally& all, std::mutex& merging) {
    std::vector<std::uint64_t> chosen;
    const std::uint64_t corners = std::min(check_.corners, by_models_too),
                        inside = std::min(check_.inside, by_models_too);
    for (std::uint64_t i = 0; i < corners; ++i) chosen.push_back(i * check_.corners / corners);
    for (std::uint64_t i = 0; i < inside; ++i) chosen.push_back(check_.corners + i);
    check_.models = chosen.size();
    foundation::parallel_for(
        chosen.size(), {.size = SampledCase::model_piece, .progress = progress_, .task = "assembled models"},
        [&](std::size_t from, std::size_t to) {
          CheckTally part = empty();
          add_by_models(
              {chosen.begin() + static_cast<std::ptrdiff_t>(from), chosen.begin() + static_cast<std::ptrdiff_t>(to)},
              part);
          const std::lock_guard lock(merging);
          all.merge(part);
        });
  }

  [[nodiscard]] CheckedBox found(const CheckTally& all) {
    CheckedBox result;
    check_.violations = all.violations;
    result.check = check_;
    for (std::size_t c = 0; c < cases_.list().size(); ++c) {
      const SampledCase& one = cases_.list()[c];
      BoxCase in{one.variant().name, one.variant().display, {}, all.in_kernels[c], all.one_by_one[c], one.no_kernels()};
      for (std::size_t r = 0; r < one.given().size(); ++r) {
        const LeastMargin& least = all.of[c][r];
        in.requirements.push_back({one.given()[r], least.margin, least.design < check_.corners});
        if (least.margin < 1) result.violations.push_back({draws(least.design), c, r, least.margin, ""});
      }
      result.cases.push_back(std::move(in));
    }
    if (!all.failure.empty()) result.violations.push_back({draws(all.first_failed), 0, 0, 0, all.failure});
    return result;
  }

  BoxCases cases_;
  DrawBox box_;
  numerics::SobolNumbers sobol_;
  const foundation::Progress& progress_;
  BoxCheck check_;
};

}  // namespace

CheckedBox checked_box(const project::Project& project, const BoxEnds& ends, const project::BoxRequest& request,
                       const foundation::Progress& progress) {
  return DesignCheck(project, ends, request, progress).run();
}

}  // namespace trivet::study

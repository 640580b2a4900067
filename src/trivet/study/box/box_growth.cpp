// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/box/box_growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::study {
namespace {

constexpr double margin_at_ends = 1 + box_reserve;                 // of the margin at the end
constexpr double margin_found = 1 + box_reserve / 2;               // that a search may find there
constexpr int most_growth_rounds = 60;                             // of one growth, each with a search
constexpr int most_restarts = 30;                                  // after a search that missed a violation
constexpr double first_growth_limit = 1, growth_limit_factor = 2;  // of distances for which kernels are fitted
constexpr double narrowest_growth = 1e-3;                          // they are not fitted for less
constexpr double stuck = 1e-4;                                     // an end that cannot move so far alone
constexpr double kept_before_known = 1e-3 * box_step;              // kernels may not see that these violate
constexpr int parts_of_section = 16, most_sections = 8;  // of the distance at which a design begins to violate

bool is_below(const BoxViolation& one, double margin) { return !one.failure.empty() || one.margin < margin; }

double step_beyond(double times) { return box_step * std::max(1.0, times); }

bool is_inside(const DrawBox& box, const Eigen::VectorXd& draws) {
  for (std::size_t d = 0; d < box.ranges().size(); ++d)
    if (draws(to_index(d)) < box.ranges()[d].from || draws(to_index(d)) > box.ranges()[d].to) return false;
  return true;
}

}  // namespace

BoxGrowth::BoxGrowth(const project::Project& project, BoxEnds& ends, const project::BoxRequest& request,
                     const foundation::Progress& progress)
    : project_(project), ends_(ends), request_(request), progress_(progress), stops_(ends.size()) {}

BoxGrowth::Ends BoxGrowth::growing() const {
  Ends list;
  for (std::size_t e = 0; e < ends_.size(); ++e)
    if (!stops_[e]) list.push_back(e);
  return list;
}

Eigen::VectorXd BoxGrowth::moved(const Ends& movers, double to) const {
  Eigen::VectorXd times = ends_.times();
  for (const std::size_t e : movers) times(to_index(e)) = std::max(times(to_index(e)), std::min(to, ends_[e].reach));
  return times;
}

void BoxGrowth::run(const std::vector<BoxViolation>& known) {
  known_ = known;
  for (int restarts = 0;; ++restarts) {
    std::ranges::fill(stops_, std::nullopt);
    for (std::size_t e = 0; e < ends_.size(); ++e) ends_[e].times = 0;
    missed_.reset();
    cases_.reset();
    stop_at_reach();
    double limit = 0;
    while (!missed_) {
      const Ends movers = growing();
      if (movers.empty()) return;
      double from = std::numeric_limits<double>::infinity();
      for (const std::size_t e : movers) from = std::min(from, ends_[e].times);
      if (!cases_ || from >= limit) {
        limit = std::min(request_.most, std::max(first_growth_limit, growth_limit_factor * from));
        fit(from, limit);
      }
      const double to = grow(movers, from, limit);
      if (missed_) break;
      stop_at_reach();
      if (exhausted_) {
        for (const std::size_t e : movers)
          if (!stops_[e]) stops_[e] = EndStop{BoxStop::not_determined};
        continue;
      }
      if (to >= limit || stop_blocked(movers, 1)) continue;
      if (stop_stuck(movers, limit) || missed_) continue;
      // No end is blocked alone, only several together: the first goes on alone.
      for (const std::size_t e : movers) {
        if (stops_[e] || ends_[e].times >= limit) continue;
        const bool free = grow({e}, ends_[e].times, limit) >= limit;
        stop_at_reach();
        if (!free && !missed_) stop_alone(e);
        break;
      }
    }
    if (restarts == most_restarts)
      throw foundation::NotComputable(fmt::format(
          "box: the search of the worst designs has missed violations in {} boxes, one after the other: the "
          "ranges cannot be determined; their regions are too narrow for it",
          most_restarts + 1));
    known_.push_back(*missed_);
  }
}

bool BoxGrowth::stop_stuck(const Ends& movers, double limit) {
  bool any = false;
  for (const std::size_t e : movers) {
    if (stops_[e] || ends_[e].times >= limit) continue;
    const double before = ends_[e].times, alone = grow({e}, before, limit);
    if (missed_) return any;
    if (alone - before < stuck) stop_alone(e), any = true;
    else ends_[e].times = before;
  }
  return any;
}

void BoxGrowth::stop_alone(std::size_t end) {
  if (stops_[end] || stop_blocked({end}, 1)) return;
  // Where the margin hardly changes, a step uses up a part of the reserve only.
  if (!stop_blocked({end}, margin_at_ends)) stops_[end] = EndStop{BoxStop::not_determined};
}

void BoxGrowth::fit(double from, double& limit) {
  const double wanted = limit;
  while (true) {
    Eigen::VectorXd times = ends_.times();
    for (std::size_t e = 0; e < ends_.size(); ++e) {
      if (!stops_[e]) times(to_index(e)) = std::max(times(to_index(e)), limit);
      times(to_index(e)) += 2 * step_beyond(times(to_index(e)));
    }
    cases_ = std::make_unique<BoxCases>(project_, ends_, times);
    if (cases_->has_kernels() || !may_have_kernels_) break;
    limit = from + (limit - from) / 4;
    if (limit - from < narrowest_growth) {
      may_have_kernels_ = false;
      limit = wanted;
    }
  }
  if (worst_.empty())
    for (const SampledCase& one : cases_->list()) worst_.emplace_back(one.given().size());
}

double BoxGrowth::grow(const Ends& movers, double from, double limit) {
  double to = limit;
  blockers_.clear();
  exhausted_ = true;
  for (int round = 0; round < most_growth_rounds && !missed_; ++round) {
    std::vector<Blocker> found;
    if (to > from) found = violations(moved(movers, to));
    if (found.empty()) {
      exhausted_ = false;
      break;
    }
    for (Blocker& one : found) to = std::max(from, bounded(one, movers, from, to));
    blockers_ = std::move(found);
  }
  if (missed_) return from;
  if (exhausted_) to = from;
  const Eigen::VectorXd times = moved(movers, to);
  for (const std::size_t e : movers) ends_[e].times = times(to_index(e));
  return to;
}

double BoxGrowth::left_at(const Eigen::VectorXd& draws, const Ends& movers) const {
  double at = 0;
  for (const std::size_t e : movers) {
    const GrowingEnd& end = ends_[e];
    for (std::size_t p = 0; p < ends_.tolerances()[end.tolerance].places.size(); ++p) {
      const double deviation = draws(to_index(cases_->draw_of(end.tolerance, p))) - end.given;
      const double distance = (end.upper ? deviation : -deviation) / end.width;
      if (distance > end.times) at = std::max(at, distance);
    }
  }
  return at;
}

double BoxGrowth::bounded(Blocker& one, const Ends& movers, double from, double to) {
  const double left = left_at(one.found.draws, movers);
  if (left <= from && is_below(one.found, 1)) {
    if (!one.is_known) missed_ = one.found;
    return from;
  }
  const double high = std::clamp(left, from, to);
  one.place = ends_.box(moved(movers, high)).place(one.found.draws);
  const double met = last_met(one.place, movers, from, high);
  return one.is_known ? std::min(met, left - kept_before_known * std::max(1.0, left)) : met;
}

void BoxGrowth::stop_at_reach() {
  for (std::size_t e = 0; e < ends_.size(); ++e) {
    if (stops_[e] || ends_[e].times < ends_[e].reach) continue;
    stops_[e] = EndStop{ends_[e].beyond.empty() ? BoxStop::most : BoxStop::no_model, {}};
    stops_[e]->beyond.failure = ends_[e].beyond;
  }
}

bool BoxGrowth::stop_blocked(const Ends& movers, double margin) {
  bool any = false;
  std::vector<std::pair<std::size_t, EndStop>> found;
  for (const std::size_t e : movers)
    if (!stops_[e])
      if (auto stop = blocked(e, margin)) found.emplace_back(e, std::move(*stop));
  for (auto& [e, stop] : found) stops_[e] = std::move(stop), any = true;
  return any;
}

std::optional<EndStop> BoxGrowth::blocked(std::size_t end, double margin) const {
  Eigen::VectorXd times = ends_.times();
  times(to_index(end)) += step_beyond(times(to_index(end)));
  if (times(to_index(end)) >= ends_[end].reach) return std::nullopt;
  const DrawBox box = ends_.box(times), before = ends_.box(ends_.times());
  std::vector<Eigen::VectorXd> places;
  for (const Blocker& one : blockers_) places.push_back(one.place);
  for (const auto& in_case : worst_)
    for (const Eigen::VectorXd& draws : in_case)
      if (draws.size() > 0) places.push_back(before.place(draws));
  DrawPlaces all(to_index(places.size()), box.draws());
  for (std::size_t i = 0; i < places.size(); ++i) all.row(to_index(i)) = places[i].transpose();
  std::vector<BoxViolation> found = judged(box.at(all));
  for (const BoxViolation& one : known_)
    if (is_inside(box, one.draws)) found.push_back(one);
  const auto worst = std::ranges::min_element(found, [](const BoxViolation& a, const BoxViolation& b) {
    return a.failure.empty() == b.failure.empty() ? a.margin < b.margin : b.failure.empty();
  });
  if (worst == found.end() || !is_below(*worst, margin)) return std::nullopt;
  const Eigen::VectorXd at = box.place(worst->draws);
  return EndStop{worst->failure.empty() ? BoxStop::requirement : BoxStop::no_model, *worst,
                 (at.array() == 0 || at.array() == 1).all()};
}

std::vector<BoxGrowth::Blocker> BoxGrowth::violations(const Eigen::VectorXd& times) {
  const DrawBox box = ends_.box(times);
  WorstStarts starts;
  for (const auto& in_case : worst_) {
    starts.emplace_back();
    for (const Eigen::VectorXd& draws : in_case) {
      starts.back().emplace_back();
      if (draws.size() > 0) starts.back().back().push_back(draws);
    }
  }
  std::vector<Blocker> found;
  for (const BoxViolation& one : known_) {
    if (one.failure.empty()) starts[one.in_case][one.requirement].push_back(one.draws);
    if (is_inside(box, one.draws)) found.push_back({box.place(one.draws), one, true});
  }
  double share = 0;
  for (std::size_t e = 0; e < ends_.size(); ++e) share += stops_[e] ? 1 : ends_[e].times / ends_[e].reach;
  const auto progress = [&](std::string_view, double) {
    foundation::report_progress(progress_, "ranges", share / static_cast<double>(ends_.size()));
  };
  const WorstSearch search = worst_search(cases_->list(), box, starts, request_.seed, progress);
  if (search.failed > 0)
    found.push_back({box.place(search.first_failed), {search.first_failed, 0, 0, 0, search.first_failure}});
  searched_ += search.corners + search.inside + 1;
  for (std::size_t c = 0; c < search.of.size(); ++c)
    for (std::size_t r = 0; r < search.of[c].size(); ++r) {
      const WorstFound& one = search.of[c][r];
      searched_ += one.looked_at - (search.corners + search.inside + 1);
      worst_[c][r] = one.draws;
      if (one.margin < margin_found) found.push_back({box.place(one.draws), {one.draws, c, r, one.margin, ""}});
    }
  return found;
}

double BoxGrowth::last_met(const Eigen::VectorXd& place, const Ends& movers, double from, double to) {
  double high = to, low = from;
  for (int section = 0; section < most_sections && high > low; ++section) {
    Eigen::MatrixXd designs(parts_of_section, place.size());
    const auto at = [&](int i) { return low + (high - low) * i / parts_of_section; };
    for (int i = 0; i < parts_of_section; ++i)
      designs.row(i) = ends_.box(moved(movers, at(i))).at(place.transpose()).row(0);
    const std::vector<BoxViolation> all = judged(designs);
    searched_ += parts_of_section;
    if (section == 0 && is_below(all.front(), 1)) {
      missed_ = all.front();
      return from;
    }
    if (section == 0 && is_below(all.front(), margin_at_ends)) return from;
    int first = parts_of_section;
    for (int i = parts_of_section - 1; i > 0; --i)
      if (is_below(all[to_size(i)], margin_at_ends)) first = i;
    const double next_low = at(first - 1);
    high = first == parts_of_section ? high : at(first);
    low = next_low;
  }
  return low;
}

std::vector<BoxViolation> BoxGrowth::judged(const Eigen::MatrixXd& designs) const {
  std::vector<BoxViolation> found(to_size(designs.rows()));
  for (Eigen::Index d = 0; d < designs.rows(); ++d) {
    found[to_size(d)].draws = designs.row(d).transpose();
    found[to_size(d)].margin = std::numeric_limits<double>::infinity();
  }
  for (std::size_t c = 0; c < cases_->list().size(); ++c) {
    const SampledMargins margins = cases_->list()[c].judged(designs);
    for (std::size_t d = 0; d < found.size(); ++d) {
      if (found[d].failure.empty()) found[d].failure = margins.failures[d];
      if (!margins.failures[d].empty() || margins.margins.cols() == 0) continue;
      Eigen::Index least = 0;
      const double margin = margins.margins.row(to_index(d)).minCoeff(&least);
      if (margin < found[d].margin)
        found[d].margin = margin, found[d].in_case = c, found[d].requirement = to_size(least);
    }
  }
  return found;
}

}  // namespace trivet::study

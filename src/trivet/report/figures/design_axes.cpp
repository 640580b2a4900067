// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/figures/design_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "trivet/foundation/plain_text.h"
#include "trivet/results/design/kept_parts.h"
#include "trivet/results/design/sample_words.h"
#include "trivet/results/design/verdict_words.h"

namespace trivet::report {
namespace {

using study::KeptDesign;
using study::Sample;
using study::VariedNumber;

constexpr std::size_t most_numbers = 8, most_margins = 6;
constexpr double wide_scale = 10;  ///< positive values with a larger ratio have a logarithmic scale
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// The square of the correlation of two lists; 0 if one does not vary. Pairs that are not finite are ignored.
double squared_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto usable = [&](std::size_t i) { return std::isfinite(a[i]) && std::isfinite(b[i]); };
  double count = 0, mean_a = 0, mean_b = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (usable(i)) ++count, mean_a += a[i], mean_b += b[i];
  if (count < 3) return 0;
  mean_a /= count, mean_b /= count;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!usable(i)) continue;
    const double of_a = a[i] - mean_a, of_b = b[i] - mean_b;
    aa += of_a * of_a, bb += of_b * of_b, ab += of_a * of_b;
  }
  const double square = ab * ab / (aa * bb);
  return std::isfinite(square) ? square : 0;
}

/// From the least to the largest value.
Axis scale_over(const std::vector<double>& values) {
  double from = std::numeric_limits<double>::infinity(), to = -from;
  for (const double value : values)
    if (std::isfinite(value)) from = std::min(from, value), to = std::max(to, value);
  if (!(from <= to)) from = to = 0;
  if (from == to) {
    const double air = std::max(1e-3 * std::abs(from), 1e-12);
    from -= air, to += air;
  }
  return {from, to, from > 0 && to > wide_scale * from, ""};
}

void set_scale(DesignLinesAxis& axis, const std::vector<double>& further) {
  std::vector<double> all = axis.values;
  all.insert(all.end(), further.begin(), further.end());
  axis.scale = scale_over(all);
  axis.has_infinite = std::ranges::any_of(all, [](double value) { return std::isinf(value); });
}

/// The axis of a drawn number, as the first number of the model that it moves.
DesignLinesAxis number_axis(const Sample& sample, std::size_t draw) {
  const std::vector<VariedNumber>& numbers = sample.kept.numbers;
  const auto first = std::ranges::find(numbers, draw, &VariedNumber::draw);
  const auto column = static_cast<std::size_t>(first - numbers.begin());
  const auto places = std::ranges::count(numbers, draw, &VariedNumber::draw);
  DesignLinesAxis axis{.name = first->drawn.tolerance, .detail = first->path, .unit = first->unit.name};
  if (places > 1) axis.detail = fmt::format("{} and {} more", axis.detail, places - 1);
  for (const KeptDesign& one : sample.kept.list) axis.values.push_back(one.numbers[column] / first->unit.si);
  axis.given = first->given / first->unit.si;
  set_scale(axis, {axis.given});
  return axis;
}

DesignLinesAxis margin_axis(const Sample& sample, std::size_t requirement, const project::DisplayUnits& display) {
  const results::KeptRequirement one = results::kept_requirements(sample)[requirement];
  DesignLinesAxis axis{.name = one.of->given.words.judged, .of_margins = true};
  const std::string all = results::requirement_words(one.of->given, display);
  if (all.starts_with(axis.name + " ")) axis.detail = all.substr(axis.name.size() + 1);
  else axis.name = all;
  axis.detail += results::in_case_words(one.in->case_name);
  for (const KeptDesign& design : sample.kept.list)
    axis.values.push_back(design.is_judged() ? design.margins[requirement] : no_value);
  axis.given = one.of->given.margin;
  set_scale(axis, {axis.given, 1});
  return axis;
}

bool varies(const DesignLinesAxis& axis) {
  double first = no_value;
  for (const double value : axis.values) {
    if (std::isnan(value)) continue;
    if (std::isnan(first)) first = value;
    if (value != first) return true;
  }
  return false;
}

/// "shares of the variance" and the largest total share of each drawn number; without shares, correlations.
struct Influence {
  std::string words;
  std::vector<double> of, at_most;  ///< estimates, and the ends of their intervals
};

/// All numbers of a tolerance, which are single sets too.
bool has_single_numbers(const std::vector<study::DrawnSet>& sets, const study::DrawnSet& all) {
  return all.draws.size() > 1 && std::ranges::any_of(sets, [&](const study::DrawnSet& one) {
           return one.draws.size() == 1 && one.draws.front() == all.draws.front();
         });
}

Influence influence(const Sample& sample, const std::vector<DesignLinesAxis>& numbers,
                    const std::vector<DesignLinesAxis>& margins) {
  Influence found{"share of the variance of a value, with others", std::vector<double>(numbers.size()),
                  std::vector<double>(numbers.size())};
  bool any = false;
  if (sample.shares)
    for (const study::RequirementShares& one : sample.shares->list)
      for (std::size_t i = 0; i < one.sets.size(); ++i)
        if (const study::DrawnSet& set = sample.shares->sets[i]; !has_single_numbers(sample.shares->sets, set))
          for (const std::size_t d : set.draws) {
            found.of[d] = std::max(found.of[d], one.sets[i].total.estimate);
            found.at_most[d] = std::max(found.at_most[d], one.sets[i].total.to);
            any = true;
          }
  if (any) return found;
  found.words = "squared correlation with a margin in these designs";
  for (std::size_t d = 0; d < numbers.size(); ++d)
    for (const DesignLinesAxis& margin : margins)
      found.of[d] = std::max(found.of[d], squared_correlation(numbers[d].values, margin.values));
  found.at_most = found.of;
  return found;
}

/// Takes the first axes of an order; names of the others.
std::vector<std::string> take_first(std::size_t most, const std::vector<std::size_t>& order,
                                    std::vector<DesignLinesAxis>& axes) {
  std::vector<DesignLinesAxis> taken;
  std::vector<std::string> others;
  for (const std::size_t i : order)
    if (taken.size() < most) taken.push_back(std::move(axes[i]));
    else if (!axes[i].of_margins) others.push_back(axes[i].detail);
    else others.push_back(axes[i].name + (axes[i].detail.empty() ? "" : " " + axes[i].detail));
  axes = std::move(taken);
  return others;
}

template <typename Before>
std::vector<std::size_t> ordered(std::size_t size, Before before) {
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, before);
  return order;
}

double largest_of_others(const Influence& influence, const std::vector<std::size_t>& order) {
  double largest = 0;
  for (std::size_t i = most_numbers; i < order.size(); ++i) largest = std::max(largest, influence.at_most[order[i]]);
  return largest;
}

void choose_numbers(const Influence& influence, DesignLinesAxes& axes) {
  const auto order =
      ordered(axes.numbers.size(), [&](std::size_t a, std::size_t b) { return influence.of[a] > influence.of[b]; });
  const std::vector<std::string> others = take_first(most_numbers, order, axes.numbers);
  if (order.size() > 1)
    axes.notes.push_back(fmt::format("Drawn numbers in the order of their largest {}.", influence.words));
  if (others.empty()) return;
  const double largest = std::max(largest_of_others(influence, order), 1e-4);
  axes.notes.push_back(fmt::format(
      "Left out: {} drawn number{} with at most {} % each: {}.", others.size(), others.size() == 1 ? "" : "s",
      results::rounded_percent(largest, results::decimals_of(largest), results::Rounded::up),
      foundation::comma_separated(others)));
}

/// Those that break first most often, then those with the least margins.
void choose_margins(const Sample& sample, DesignLinesAxes& axes) {
  const std::vector<results::KeptRequirement> requirements = results::kept_requirements(sample);
  std::vector<std::string> constant;
  std::vector<std::size_t> order = ordered(axes.margins.size(), [&](std::size_t a, std::size_t b) {
    const study::SampledRequirement &one = *requirements[a].of, &other = *requirements[b].of;
    if (one.first != other.first) return one.first > other.first;
    return one.margin.extremes.least < other.margin.extremes.least;
  });
  std::erase_if(order, [&](std::size_t r) {
    const bool is_constant = !varies(axes.margins[r]);
    if (is_constant) constant.push_back(axes.margins[r].name);
    return is_constant;
  });
  const std::vector<std::string> others = take_first(most_margins, order, axes.margins);
  if (!others.empty())
    axes.notes.push_back(fmt::format(
        "Left out: {} requirement{} that break{} first less often or {} larger least margin{}: {}.", others.size(),
        others.size() == 1 ? "" : "s", others.size() == 1 ? "s" : "", others.size() == 1 ? "has a" : "have",
        others.size() == 1 ? "" : "s", foundation::comma_separated(others)));
  if (!constant.empty())
    axes.notes.push_back(fmt::format("Left out: requirements whose margin is the same in all these designs: {}.",
                                     foundation::comma_separated(constant)));
}

}  // namespace

double DesignLinesAxis::share(double value) const {
  return std::isinf(value) && value > 0 ? 1 : end_of_scale() * scale.share(value);
}

DesignLinesAxes design_lines_axes(const Sample& sample, const std::optional<project::DisplayUnits>& display) {
  DesignLinesAxes axes;
  if (sample.kept.list.empty()) return axes;
  for (std::size_t draw = 0; draw < sample.draws; ++draw) axes.numbers.push_back(number_axis(sample, draw));
  const std::vector<results::KeptRequirement> requirements = results::kept_requirements(sample);
  for (std::size_t r = 0; r < requirements.size(); ++r)
    axes.margins.push_back(margin_axis(sample, r, display.value_or(requirements[r].in->display)));
  choose_numbers(influence(sample, axes.numbers, axes.margins), axes);
  choose_margins(sample, axes);
  return axes;
}

}  // namespace trivet::report

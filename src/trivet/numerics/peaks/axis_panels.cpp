// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/peaks/axis_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "trivet/foundation/hertz.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::numerics {
namespace {

constexpr double most_turns = 20'000;  // revolutions of a delayed load's phase
/// A pole needs some 20 panels per decade of its damping ratio, a delay with `most_turns` 16,000: more panels mean that
/// the poles are wrong.
constexpr std::size_t most_panels = 200'000;
constexpr double lowest_of_free_motion = 1e-6;  // [rad/s]; a period of two months

/// First ω [rad/s] of the cover of a system with rigid-body modes. The elastic modes at rest are missed by
/// (ω/smallest)², and the rigid-body mode is wrong by ε (largest/ω)², because ω²A is small compared with the round-off
/// of K: both errors are equal here.
double lowest_beside_free_motion(double smallest, double largest) {
  if (largest == 0) return lowest_of_free_motion;
  return std::min(1e-4 * std::sqrt(smallest * largest), 1e-2 * smallest);
}

/// Poles of the system, and a pole at 0 if the load is unbounded at rest.
Eigen::VectorXcd with_load(const Eigen::VectorXcd& poles, const CoverOptions& load) {
  if (!load.unbounded_at_rest) return poles;
  Eigen::VectorXcd all = Eigen::VectorXcd::Zero(poles.size() + 1);
  all.head(poles.size()) = poles;
  return all;
}

/// A system without mass has no poles, so that any distance will do: with this one, panel radii are about 1 rad/s.
double distance_to_poles(const Eigen::VectorXcd& poles, double omega) {
  return poles.size() == 0 ? 1 / panel_ratio : (poles.array() - std::complex<double>(0, omega)).abs().minCoeff();
}

/// Panel radius r [rad/s], the largest tried: the panel starts at `from`, and r ≤ panel_ratio · (distance of its centre
/// from the poles).
double panel_radius(const Eigen::VectorXcd& poles, double from) {
  const double here = distance_to_poles(poles, from);
  const double certain = panel_ratio * here / (1 + panel_ratio);
  const double most = panel_ratio * here / (1 - panel_ratio);
  for (const double share : {1.0, 0.8, 0.6, 0.4, 0.2}) {
    const double r = certain + share * (most - certain);
    if (r <= panel_ratio * distance_to_poles(poles, from + r)) return r;
  }
  return certain;
}

}  // namespace

PanelCover cover_axis(const Eigen::VectorXcd& of_system, const CoverOptions& load) {
  PanelCover cover;
  const Eigen::VectorXcd poles = with_load(of_system, load);
  if (!poles.allFinite())
    throw foundation::NotComputable(
        "peaks: a root of the system is beyond the range of computation: check the magnitudes of masses, "
        "stiffnesses and dampings");
  const Eigen::VectorXd size = poles.cwiseAbs();
  const double largest = size.size() > 0 ? size.maxCoeff() : 0;
  double smallest = largest;
  for (Eigen::Index k = 0; k < poles.size(); ++k) {
    if (size(k) > 0) smallest = std::min(smallest, size(k));
    const double round_off = std::max(64 * std::numeric_limits<double>::epsilon() * size(k), 1e-16 * largest);
    if (std::abs(poles(k).real()) <= round_off && poles(k).imag() > round_off)
      cover.poles_on_axis.push_back(poles(k).imag());
  }
  std::ranges::sort(cover.poles_on_axis);
  const auto same = [](double a, double b) { return b - a <= 4 * gap_at_pole * b; };
  cover.poles_on_axis.erase(std::ranges::unique(cover.poles_on_axis, same).begin(), cover.poles_on_axis.end());
  const bool free = (of_system.array() == std::complex<double>(0)).any();
  cover.lowest = free           ? lowest_beside_free_motion(smallest, largest)
      : !load.unbounded_at_rest ? 0
      : smallest > 0            ? 1e-6 * smallest
                                : lowest_of_free_motion;

  const bool turning = load.longest_delay > 0;
  const double end = turning ? load.highest
      : poles.size() == 0    ? 1
                             : std::max(largest / panel_ratio, 2 * cover.lowest);  // at least one panel before infinity
  const double most = turning ? most_turning / load.longest_delay : std::numeric_limits<double>::infinity();
  if (turning && end * load.longest_delay > most_turns * 2 * std::numbers::pi)
    throw foundation::NotComputable(
        fmt::format("peaks: a delay of {:.4g} s turns the phase by {:.3g} revolutions up to {}; at most {:.0f} can be "
                    "searched: use "
                    "a faster wave or a lower band",
                    load.longest_delay, end * load.longest_delay / (2 * std::numbers::pi), foundation::hertz_words(end),
                    most_turns));
  double from = cover.lowest;
  auto pole = cover.poles_on_axis.begin();
  while (from < end) {
    while (pole != cover.poles_on_axis.end() && from >= *pole * (1 - gap_at_pole)) {
      from = std::max(from, *pole * (1 + 4 * gap_at_pole));
      ++pole;
    }
    const double radius =
        std::max(std::min(panel_radius(poles, from), most), 64 * std::numeric_limits<double>::epsilon() * from);
    if (!(from + 2 * radius > from) || cover.panels.size() >= most_panels)
      throw foundation::NotComputable(fmt::format(
          "peaks: {} cannot be covered with {} panels free of poles: the roots of the system are spread too "
          "widely",
          foundation::hertz_range(from, end), most_panels));
    cover.panels.push_back({from + radius, radius, false});
    from += 2 * radius;
  }
  if (!turning) cover.panels.push_back({0, 1 / from, true});
  return cover;
}

}  // namespace trivet::numerics

// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/response/transient/time_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <set>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::response {
namespace {

using foundation::two_pi;
constexpr double points_per_period = 20;  ///< by default: a curve through them looks smooth
constexpr double fewest_points_per_period = 10;
constexpr double fewest_samples_per_period = 10;  ///< straight lines between them still contain 97 % of the motion
constexpr double periods_after = 10;
constexpr double present = 1e-8;  ///< energy share below which a mode counts as not excited

/// Squared amplitude of the free vibration of a mode after a jump of the jth derivative of u: (|h(iω)|/ω^{j+1})².
double ringing(const StateMode& mode, std::size_t course, int smoothness) {
  const std::complex<double> s(0, mode.angular_frequency);
  std::complex<double> force = 0, power = 1.0 / (s * s);
  assert(mode.angular_frequency > 0 && course < mode.forces.size());
  for (Eigen::Index m = 0; m < 5; ++m, power *= s) force += mode.forces[course](m) * power;
  return std::norm(force) / std::pow(mode.angular_frequency, 2 * (smoothness + 1));
}

double fastest(const std::vector<ExcitedMode>& modes, double share) {
  double omega = 0;
  for (const ExcitedMode& mode : modes)
    if (mode.energy_share >= share) omega = std::max(omega, mode.angular_frequency);
  return omega;
}

double slowest(const std::vector<ExcitedMode>& modes) {
  double omega = 0;
  for (const ExcitedMode& mode : modes)
    if (mode.energy_share >= noticeable_share && (omega == 0 || mode.angular_frequency < omega))
      omega = mode.angular_frequency;
  return omega;
}

double chosen_end(double from, const std::vector<ExcitedMode>& modes, const std::vector<InputCourse>& courses) {
  double last = from, first = from;
  for (const InputCourse& course : courses)
    last = std::max(last, course.last_corner()), first = std::min(first, course.start());
  const double omega = slowest(modes), kappa = largest_kappa(courses);
  if (omega > 0) return last + periods_after * two_pi / omega;
  if (kappa > 0) return last + periods_after * two_pi / kappa;
  if (last > first) return last + (last - first);
  throw foundation::InvalidInput(
      "transient: no oscillating mode determines how long the motion lasts; give the end of the time");
}

void warn_of_coarse_step(const TimeGrid& grid, const std::vector<ExcitedMode>& modes, bool limited,
                         foundation::Problems& warnings) {
  const double omega = fastest(modes, noticeable_share);
  if (omega == 0 || grid.step * omega * fewest_points_per_period <= two_pi * (1 + 1e-9)) return;
  warnings.warning(
      "transient.step",
      fmt::format("{:.4g} s, {:.3g} points in a period of the mode at {:.4g} Hz", grid.step, two_pi / omega / grid.step,
                  omega / two_pi),
      "results are exact at the points, but showing the motion of the fastest excited mode takes ten points per period",
      fmt::format("a step of {:.3g} s shows it{}", two_pi / omega / points_per_period,
                  limited ? "; allow more points, or take a shorter time" : ""));
}

void warn_of_coarse_samples(const InputCourse& course, const std::string& name, const std::vector<ExcitedMode>& modes,
                            foundation::Problems& warnings) {
  const double step = course.sampling_step();
  // A coarse record may not show that it excites the mode, so every mode counts.
  const bool shows = fastest(modes, present) * step * fewest_samples_per_period > two_pi;
  const double omega = fastest(modes, shows ? present : -1), frequency = omega / two_pi;
  if (step == 0 || frequency * step * fewest_samples_per_period <= 1) return;
  const double x = std::numbers::pi * frequency * step, passed = std::pow(std::sin(x) / x, 2);
  const bool beyond = 2 * frequency * step > 1;
  warnings.warning(
      name,
      fmt::format("sampled every {:.4g} s (Nyquist frequency {:.4g} Hz), while {} at {:.4g} Hz", step, 0.5 / step,
                  shows ? "a mode is excited" : "the model has a mode", frequency),
      beyond ? "samples contain no motion above their Nyquist frequency: the response of this mode comes from the "
               "straight lines between them"
             : fmt::format("straight lines between samples reproduce {:.0f} % of a motion at this frequency",
                           100 * passed),
      fmt::format("sample at least every {:.3g} s for this mode", 1 / (fewest_samples_per_period * frequency)));
}

}  // namespace

std::vector<ExcitedMode> excited_modes(const StateSpace& space, const std::vector<InputCourse>& courses,
                                       const Eigen::VectorXd& initial) {
  std::vector<ExcitedMode> result;
  for (const StateMode& mode : space.modes()) result.push_back({mode.angular_frequency, 0});
  const auto add = [&](const auto& energy) {
    double total = 0;
    for (const StateMode& mode : space.modes()) total += energy(mode);
    if (!(total > 0)) return;
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i].energy_share = std::max(result[i].energy_share, energy(space.modes()[i]) / total);
  };
  for (std::size_t c = 0; c < courses.size(); ++c)
    if (courses[c].count() > 0) add([&](const StateMode& mode) { return ringing(mode, c, courses[c].smoothness()); });
  if (initial.size() > 0)
    add([&](const StateMode& mode) {
      return std::pow(initial(mode.place), 2) + std::pow(initial(mode.place + space.massive()), 2);
    });
  if (!space.modes().empty()) return result;
  const Eigen::VectorXcd eigenvalues = numerics::general_eigenvalues(space.F()).values;
  for (const std::complex<double>& lambda : eigenvalues)
    if (lambda.imag() > 1e-8 * std::abs(lambda)) result.push_back({lambda.imag(), 1});
  return result;
}

TimeGrid time_grid(const TransientOptions& options, const std::vector<ExcitedMode>& modes,
                   const std::vector<InputCourse>& courses, const std::vector<std::string>& names,
                   foundation::Problems& warnings) {
  constexpr double shortest_step = 1e4, most_steps = 2e7;  // the first in resolutions
  TimeGrid grid;
  grid.from = grid.start = options.from;
  if (!std::isfinite(options.from))
    throw foundation::InvalidInput(fmt::format("transient: from {} s; it must be finite", options.from));
  if (options.most_points < 2)
    throw foundation::InvalidInput(
        fmt::format("transient: at most {} points; it must be two or more", options.most_points));
  const double to = options.to ? *options.to : chosen_end(options.from, modes, courses);
  if (!(to > options.from) || !std::isfinite(to))
    throw foundation::InvalidInput(
        fmt::format("transient: from {:.6g} s to {:.6g} s; the end must be finite and later", options.from, to));
  if (!options.initial)
    for (const InputCourse& course : courses) grid.start = std::min(grid.start, course.start());
  if (options.step && *options.step > 0 && (options.from - grid.start) / *options.step > most_steps)
    throw foundation::NotComputable(
        fmt::format("transient: an input begins {:.4g} s before the results, as with negative delays: more than {:.0e} "
                    "steps in between",
                    options.from - grid.start, most_steps));
  grid.resolution = 4 * std::numeric_limits<double>::epsilon() *
      std::max({std::abs(grid.start), std::abs(options.from), std::abs(to)});
  grid.fastest = std::max(fastest(modes, noticeable_share), largest_kappa(courses));
  bool limited = false;
  if (options.step) {
    if (!(*options.step > shortest_step * grid.resolution) || !std::isfinite(*options.step))
      throw foundation::InvalidInput(
          fmt::format("transient: step {:.6g} s; it must be finite and above {:.3g} s, the resolution of these times",
                      *options.step, shortest_step * grid.resolution));
    grid.step = *options.step;
    const double steps = std::floor((to - options.from) / grid.step * (1 + 1e-12));
    if (steps < 1)
      throw foundation::InvalidInput(
          fmt::format("transient: a step of {:.6g} s is longer than the time from {:.6g} s to {:.6g} s", grid.step,
                      options.from, to));
    if (steps > most_steps)
      throw foundation::InvalidInput(
          fmt::format("transient: {:.3g} steps of {:.6g} s; at most {:.0e} are allowed", steps, grid.step, most_steps));
    grid.points = 1 + static_cast<Eigen::Index>(steps);
  } else {
    const double wanted =
        grid.fastest > 0 ? std::ceil((to - options.from) * grid.fastest * points_per_period / two_pi) : 1000;
    const auto most = static_cast<double>(options.most_points - 1);
    limited = wanted > most;
    const double steps = std::min(std::max(wanted, std::min(200.0, most)), most);
    grid.points = 1 + static_cast<Eigen::Index>(steps);
    grid.step = (to - options.from) / steps;
  }
  warn_of_coarse_step(grid, modes, limited, warnings);
  assert(grid.points >= 2 && grid.step > 0 && grid.start <= grid.from && "inputs may begin before the results");
  std::set<std::string> judged;
  for (std::size_t c = 0; c < courses.size(); ++c)
    if (judged.insert(names[c]).second) warn_of_coarse_samples(courses[c], names[c], modes, warnings);
  return grid;
}

}  // namespace trivet::response

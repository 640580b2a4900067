// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/requirements/peak_absence.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/search/zeros_and_minima.h"
#include "trivet/response/steady/body_dynamics.h"

namespace trivet::study {
namespace {

/// Samples reach so far beyond the natural frequencies on both sides. There |y| differs from its limits at 0 and ∞ by a
/// share of 1 / far_beyond², and so does the measure.
constexpr double far_beyond = 1e3;
constexpr double samples_per_decade = 24;
constexpr std::size_t most_absent_peaks = 8;

/// f′/f of a curve at any ω, its derivative over x = ω².
class RelativeRise {
 public:
  RelativeRise(const model::System& system, const assembly::Assembled& assembled, const RequirementResult& result)
      : assembled_(assembled),
        channel_(assembly::channels(system, assembled, {result.subject}, result.quantity).front()),
        load_(assembly::harmonic_loading(system, assembled, result.excitations)) {}

  /// NaN where the curve is zero or is not defined.
  [[nodiscard]] double at(double omega) const {
    try {
      const response::Motion motion = response::motion(response::body_dynamics(
          response::dynamics(assembled_, channel_, load_, omega, response::element_jets(assembled_, omega)),
          assembled_.layout.of_bodies()));
      const double square = std::norm(motion.value[0]);
      if (square < std::numeric_limits<double>::min()) return std::numeric_limits<double>::quiet_NaN();
      return (std::conj(motion.value[0]) * motion.value[1]).real() / (square * omega);
    } catch (const foundation::NotComputable&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

 private:
  const assembly::Assembled& assembled_;
  assembly::Channel channel_;
  assembly::Loading load_;
};

double weighted(double rise, double omega, bool rising, double reference) {
  const double x = omega * omega, x0 = reference * reference;
  return rising ? -x * (x + x0) / x0 * rise : (x + x0) * rise;
}

struct RiseSample {
  double omega, falling, rising;  ///< both measures
};

std::vector<RiseSample> samples(const CaseContext& context, const RelativeRise& rise, double reference) {
  double lowest = reference, highest = reference;
  for (const modal::Mode& mode : context.modes.list)
    if (const double omega = mode.angular_frequency.value_or(0); omega > 0) {
      lowest = std::min(lowest, omega);
      highest = std::max(highest, omega);
    }
  const double from = lowest / far_beyond, ratio = highest * far_beyond / from;
  const auto count = static_cast<std::size_t>(std::ceil(samples_per_decade * std::log10(ratio)));
  std::vector<RiseSample> result;
  for (std::size_t i = 0; i <= count; ++i) {
    const double omega = from * std::pow(ratio, static_cast<double>(i) / static_cast<double>(count));
    const double relative = rise.at(omega);
    if (std::isfinite(relative))
      result.push_back(
          {omega, weighted(relative, omega, false, reference), weighted(relative, omega, true, reference)});
  }
  return result;
}

/// Number of samples before the valley: the split into a fall and a rise with the least largest measure.
std::size_t valley(const std::vector<RiseSample>& all) {
  std::vector<double> rising_from(all.size() + 1, -foundation::infinity);
  for (std::size_t i = all.size(); i-- > 0;) rising_from[i] = std::max(rising_from[i + 1], all[i].rising);
  double falling = -foundation::infinity, least = foundation::infinity;
  std::size_t split = 0;
  for (std::size_t i = 0; i <= all.size(); ++i) {
    if (const double largest = std::max(falling, rising_from[i]); largest <= least) {
      least = largest;
      split = i;
    }
    if (i < all.size()) falling = std::max(falling, all[i].falling);
  }
  return split;
}

}  // namespace

std::vector<AbsentPeak> absent_peaks(const CaseContext& context, const RequirementResult& result, double reference) {
  const RelativeRise rise(context.system, context.assembled, result);
  const std::vector<RiseSample> all = samples(context, rise, reference);
  const std::size_t split = valley(all);
  const auto measure = [&](std::size_t i) { return i < split ? all[i].falling : all[i].rising; };
  std::vector<AbsentPeak> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool rising = i >= split;
    const bool first = i == 0 || (rising && i == split), last = i + 1 == all.size() || (!rising && i + 1 == split);
    if ((!first && measure(i - 1) > measure(i)) || (!last && measure(i + 1) > measure(i))) continue;
    AbsentPeak peak{all[i].omega, rising, measure(i)};
    if (!first && !last) {
      const auto lowered = [&](double logarithm) {
        const double omega = std::exp(logarithm), value = rise.at(omega);
        return std::isfinite(value) ? -weighted(value, omega, rising, reference) : foundation::infinity;
      };
      const double at =
          std::exp(numerics::minimum_between(std::log(all[i - 1].omega), std::log(all[i + 1].omega), lowered).at);
      if (const double refined = weighted(rise.at(at), at, rising, reference); refined >= peak.measure)
        peak = {at, rising, refined};
    }
    found.push_back(peak);
  }
  std::ranges::stable_sort(found, std::ranges::greater{}, &AbsentPeak::measure);
  found.resize(std::min(found.size(), most_absent_peaks));
  std::ranges::stable_sort(found, {}, &AbsentPeak::angular_frequency);
  return found;
}

double absence_measure(const model::System& system, const assembly::Assembled& assembled,
                       const RequirementResult& result, const AbsentPeak& place, double reference) {
  return weighted(RelativeRise(system, assembled, result).at(place.angular_frequency), place.angular_frequency,
                  place.rising, reference);
}

}  // namespace trivet::study

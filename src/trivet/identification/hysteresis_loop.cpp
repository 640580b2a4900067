// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/hysteresis_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "trivet/foundation/hertz.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/significant_digits.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/numerics/sampling/student_distribution.h"

namespace trivet::identification {
namespace {

using std::numbers::pi;
constexpr int fewest_samples_per_cycle = 8;

void check(const LoopOptions& options) {
  const auto in_range = [](const char* name, double value, double low, double high) {
    if (!(value >= low && value <= high))
      throw foundation::InvalidInput(fmt::format("{} = {}, must be between {} and {}", name, value, low, high));
  };
  if (!(options.confidence > 0 && options.confidence < 1))
    throw foundation::InvalidInput(fmt::format("confidence = {}, must be between 0 and 1", options.confidence));
  in_range("drift_order", options.drift_order, 0, 3);
  in_range("harmonics", options.harmonics, 1, 20);
}

foundation::Problems sample_problems(const LoopRecord& record) {
  foundation::Problems problems;
  const std::string subject = fmt::format("loop '{}'", record.name);
  const Eigen::Index count = record.displacement.size();
  if (record.force.size() != count || (record.time.size() != 0 && record.time.size() != count)) {
    problems.error(subject,
                   fmt::format("{} displacements, {} forces, {} times", count, record.force.size(), record.time.size()),
                   "each sample must have all of them", "give the columns the same length");
    return problems;
  }
  if (count < Eigen::Index{2} * fewest_samples_per_cycle)
    problems.error(subject, fmt::format("{} samples", count),
                   fmt::format("at least {} are needed", 2 * fewest_samples_per_cycle), "record more");
  const auto report = [&](Eigen::Index sample, const std::string& finding, const char* rule, const char* remedy) {
    problems.error(subject, fmt::format("sample {}: {}", sample + 1, finding), rule, remedy);
  };
  for (Eigen::Index i = 0; i < count && problems.list().size() < 20; ++i) {
    if (!std::isfinite(record.displacement(i)) || !std::isfinite(record.force(i)) ||
        (record.time.size() > 0 && !std::isfinite(record.time(i))))
      report(i, "a value is missing or not finite", "every cell must contain a number",
             "cut the record there, or remove the row");
    else if (i > 0 && record.time.size() > 0 && !(record.time(i) > record.time(i - 1)))
      report(i, fmt::format("time {} s after {} s", record.time(i), record.time(i - 1)), "time must increase",
             "sort the rows, one loop per record");
  }
  if (!std::isnan(record.angular_frequency) &&
      !(record.angular_frequency > 0 && std::isfinite(record.angular_frequency)))
    problems.error(subject, "a frequency of " + foundation::hertz_words(record.angular_frequency), "it must be > 0",
                   "omit it if it is unknown");
  return problems;
}

/// X, k, W, η, W/(π X²) of the coefficients (a₁, b₁, a₂, …) of displacement and force.
std::array<double, 5> quantities(const Eigen::VectorXd& x, const Eigen::VectorXd& f) {
  const double square = x(0) * x(0) + x(1) * x(1), stiffness = (f(0) * x(0) + f(1) * x(1)) / square;
  double energy = 0;
  for (Eigen::Index n = 1; 2 * n <= x.size(); ++n)
    energy += pi * static_cast<double>(n) * (f(2 * n - 2) * x(2 * n - 1) - f(2 * n - 1) * x(2 * n - 2));
  return {std::sqrt(square), stiffness, energy, energy / (pi * stiffness * square), energy / (pi * square)};
}

/// Standard deviations of the quantities, from their sensitivity to each coefficient.
std::array<double, 5> deviations(const Eigen::VectorXd& x, const Eigen::VectorXd& f,
                                 const Eigen::MatrixXd& unit_covariance, const Eigen::VectorXd& noise) {
  std::array<double, 5> variance{};
  for (int signal = 0; signal < 2; ++signal) {
    const Eigen::VectorXd& of = signal == 0 ? x : f;
    const double step = 1e-6 * of.norm();
    Eigen::MatrixXd sensitivity(5, of.size());
    for (Eigen::Index i = 0; i < of.size(); ++i) {
      const Eigen::VectorXd change = step * Eigen::VectorXd::Unit(of.size(), i);
      const auto up = signal == 0 ? quantities(x + change, f) : quantities(x, f + change);
      const auto down = signal == 0 ? quantities(x - change, f) : quantities(x, f - change);
      for (std::size_t q = 0; q < 5; ++q) sensitivity(to_index(q), i) = step > 0 ? (up[q] - down[q]) / (2 * step) : 0;
    }
    for (std::size_t q = 0; q < 5; ++q) {
      const Eigen::RowVectorXd row = sensitivity.row(to_index(q));
      variance[q] += noise(signal) * noise(signal) * row.dot(row * unit_covariance);
    }
  }
  for (double& v : variance) v = std::sqrt(std::max(0.0, v));
  return variance;
}

std::complex<double> fundamental(const Eigen::VectorXd& coefficients) { return {coefficients(0), -coefficients(1)}; }

/// Mean square of the deviation of F̂₁/x̂₁ in each cycle / the value that white noise explains.
double cycle_variance_ratio(const Eigen::VectorXd& phase, const HarmonicFit& fit, const LoopFit& loop) {
  const auto cycles = to_size(loop.cycles);
  std::vector<std::complex<double>> off(cycles);
  std::vector<double> count(cycles);
  for (Eigen::Index i = 0; i < phase.size(); ++i) {
    const auto cycle = std::min(cycles - 1, static_cast<std::size_t>(phase(i) / (2 * pi)));
    off[cycle] +=
        2.0 * (fit.residuals(i, 1) - loop.dynamic_stiffness * fit.residuals(i, 0)) * std::polar(1.0, -phase(i));
    count[cycle] += 1;
  }
  const double white = 4 * (std::pow(fit.noise(1), 2) + std::norm(loop.dynamic_stiffness) * std::pow(fit.noise(0), 2));
  double sum = 0;
  for (std::size_t c = 0; c < cycles; ++c) sum += white > 0 ? std::norm(off[c]) / (count[c] * white) : 1;
  return sum / static_cast<double>(cycles - 1);
}

void fill(const HarmonicFit& fit, int order, const Eigen::VectorXd& phase, double confidence, LoopFit& loop) {
  const Eigen::Index first = order + 1, count = fit.coefficients.rows() - first;
  const Eigen::VectorXd x = fit.coefficients.col(0).tail(count), f = fit.coefficients.col(1).tail(count);
  loop.dynamic_stiffness = fundamental(f) / fundamental(x);
  loop.displacement_harmonics.resize(count / 2);
  loop.force_harmonics.resize(count / 2);
  for (Eigen::Index n = 0; n < count / 2; ++n) {
    loop.displacement_harmonics(n) = fundamental(x.segment(2 * n, 2));
    loop.force_harmonics(n) = fundamental(f.segment(2 * n, 2));
  }
  loop.displacement_distortion = x.tail(count - 2).norm() / x.head(2).norm();
  loop.force_distortion = f.tail(count - 2).norm() / f.head(2).norm();
  for (int p = 1; p <= order; p += 2) {
    loop.displacement_drift += 2 * fit.coefficients(p, 0);
    loop.force_drift += 2 * fit.coefficients(p, 1);
  }
  loop.displacement_noise = fit.noise(0);
  loop.force_noise = fit.noise(1);

  double freedom = static_cast<double>(std::max<Eigen::Index>(1, fit.residuals.rows() - fit.coefficients.rows())),
         widening = 1;
  if (loop.cycles >= 4) {
    const double ratio = cycle_variance_ratio(phase, fit, loop), independent = 2.0 * (loop.cycles - 1);
    loop.cycle_scatter = std::sqrt(ratio);
    if (ratio > 1 + 2.6 * std::sqrt(2 / independent)) {  // beyond the 99.5 % point of white noise
      widening = loop.cycle_scatter;
      freedom = independent;
    }
  }
  const auto value = quantities(x, f),
             deviation = deviations(x, f, fit.unit_covariance.bottomRightCorner(count, count), fit.noise);
  const double factor = widening * numerics::student_quantile(confidence, freedom);
  const auto estimate = [&](std::size_t q) { return Estimate{value[q], factor * deviation[q]}; };
  loop.amplitude = estimate(0);
  loop.stiffness = estimate(1);
  loop.loss_energy = estimate(2);
  loop.loss_factor = estimate(3);
  loop.dynamic_stiffness_deviation = widening * deviation[1];
  if (loop.angular_frequency)
    loop.viscous_coefficient =
        Estimate{value[4] / *loop.angular_frequency, factor * deviation[4] / *loop.angular_frequency};
}

void warn(const LoopRecord& record, LoopFit& loop) {
  const std::string subject = fmt::format("loop '{}'", record.name);
  const auto warning = [&](std::string finding, std::string rule, std::string remedy) {
    loop.warnings.warning(subject, std::move(finding), std::move(rule), std::move(remedy));
  };
  constexpr double far = 0.05, frequency_differs = 0.02;
  if (loop.stiffness.value < -loop.stiffness.half_width)
    warning("stiffness " + foundation::prefixed(loop.stiffness.value, "N/m"), "the stiffness should be > 0",
            "reverse the sign of the force");
  if (loop.loss_energy.value < -loop.loss_energy.half_width)
    warning(fmt::format("loss energy {:.4g} J per cycle", loop.loss_energy.value),
            "a passive element dissipates energy",
            "reverse the sign of the force, exchange the columns, or look for a delay between the channels");
  if (loop.displacement_distortion > far)
    warning(fmt::format("the harmonics of the displacement are {:.0f} % of its fundamental",
                        100 * loop.displacement_distortion),
            "amplitude, viscous coefficient and loss factor are defined for a sine",
            "excite with a sine; without time the samples must be equally spaced");
  if (loop.amplitude.half_width > far * loop.amplitude.value)
    warning(fmt::format("amplitude {} ± {}", foundation::prefixed(loop.amplitude.value, "m"),
                        foundation::prefixed_exactly(loop.amplitude.half_width, "m", 2)),
            "the motion should be well above the noise", "record more cycles");
  if (record.time.size() > 0 && std::abs(*loop.angular_frequency / record.angular_frequency - 1) > frequency_differs)
    warning(fmt::format("{} from the sample times, {} stated", foundation::hertz_words(*loop.angular_frequency, 5),
                        foundation::hertz_words(record.angular_frequency, 5)),
            "the two should agree; the sample times are used", "check the units of time and frequency");
  if (loop.cycles >= 4 && loop.cycle_scatter > 1.5)
    warning(fmt::format("cycles differ {:.1f} times more than noise explains", loop.cycle_scatter),
            "the cycles of a steady test should be equal; the intervals are widened",
            "remove the first cycles, raise drift_order, or let the element warm up");
}

}  // namespace

foundation::Expected<LoopFit> loop_fit(const LoopRecord& record, const LoopOptions& options) {
  check(options);
  foundation::Problems problems = sample_problems(record);
  const auto refuse = [&](std::string finding, std::string rule, std::string remedy) {
    problems.error(fmt::format("loop '{}'", record.name), std::move(finding), std::move(rule), std::move(remedy));
    return tl::make_unexpected(std::move(problems));
  };
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));

  const Eigen::Index all = record.displacement.size();
  const Eigen::VectorXd time =
      record.time.size() > 0 ? record.time : Eigen::VectorXd::LinSpaced(all, 0, static_cast<double>(all - 1));
  const auto frequency = frequency_of(time, record.displacement, options.drift_order, options.harmonics);
  if (!frequency) return refuse("the displacement does not change", "a loop needs motion", "check the column");
  const double duration = time(all - 1) - time(0), spacing = duration / static_cast<double>(all - 1);
  const double cycles_in_record = *frequency * (duration + spacing) / (2 * pi);
  const double samples_per_cycle = static_cast<double>(all) / cycles_in_record;
  constexpr double nearly_whole = 0.02,
                   nearly_one = 0.1;  // of a cycle: scatter of the frequency found, smaller if there are several
  if (cycles_in_record < 1 - nearly_one)
    return refuse(fmt::format("{:.2f} cycles", cycles_in_record), "a loop must have at least one whole cycle",
                  "record longer");
  if (samples_per_cycle < fewest_samples_per_cycle)
    return refuse(fmt::format("{:.1f} samples per cycle", samples_per_cycle),
                  fmt::format("at least {} are needed", fewest_samples_per_cycle), "sample faster");

  LoopFit loop;
  loop.name = record.name;
  loop.cycles = std::max(1, static_cast<int>(cycles_in_record + nearly_whole));
  if (record.time.size() > 0) loop.angular_frequency = frequency;
  else if (!std::isnan(record.angular_frequency)) loop.angular_frequency = record.angular_frequency;
  Eigen::Index used = all;
  while (time(used - 1) - time(0) >= 2 * pi * loop.cycles / *frequency - 0.25 * spacing && used > all / 3) --used;
  const int harmonics = std::clamp(static_cast<int>(samples_per_cycle / 4), 1, options.harmonics);
  const Eigen::VectorXd whole = time.head(used), phase = *frequency * (whole.array() - whole(0));
  Eigen::MatrixXd signals(used, 2);
  signals << record.displacement.head(used), record.force.head(used);
  fill(harmonic_fit(harmonic_columns(whole, *frequency, options.drift_order, harmonics), signals), options.drift_order,
       phase, options.confidence, loop);
  warn(record, loop);
  return loop;
}

}  // namespace trivet::identification

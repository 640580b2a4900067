// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/law_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "trivet/foundation/hertz.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/identification/levenberg_marquardt.h"
#include "trivet/numerics/sampling/student_distribution.h"

namespace trivet::identification {
namespace {

using Complex = std::complex<double>;

/// A family of laws. Parameters are fitted as logarithms, the order as a logit, so that every value is admissible.
struct Family {
  const char* name;
  std::vector<const char*> parameters;
  Complex (*relative_modulus)(const std::vector<double>& values,
                              double angular_frequency);  // values without the stiffness
};

Complex hysteretic(const std::vector<double>& v, double) { return {1, v[0]}; }
Complex viscous(const std::vector<double>& v, double w) {
  return elements::relative_modulus(elements::KelvinVoigt{v[0]}, Complex(w));
}
Complex zener(const std::vector<double>& v, double w) {
  return elements::relative_modulus(elements::Zener{v[0], v[1]}, Complex(w));
}
Complex fractional(const std::vector<double>& v, double w) {
  return elements::relative_modulus(elements::FractionalZener{v[0], v[1], v[2]}, Complex(w));
}

const std::vector<Family>& families() {
  static const std::vector<Family> all = {{"hysteretic", {"loss_factor"}, hysteretic},
                                          {"viscous (Kelvin–Voigt)", {"time"}, viscous},
                                          {"Zener", {"ratio", "time"}, zener},
                                          {"fractional Zener", {"ratio", "time", "order"}, fractional}};
  return all;
}

bool is_order(const Family& family, std::size_t i) { return std::string(family.parameters[i]) == "order"; }

double value_of(const Family& family, std::size_t i, double fitted) {
  return is_order(family, i) ? 1 / (1 + std::exp(-fitted)) : std::exp(fitted);
}

std::vector<double> values_of(const Family& family, const Eigen::VectorXd& fitted) {
  std::vector<double> values;
  for (std::size_t i = 0; i < family.parameters.size(); ++i)
    values.push_back(value_of(family, i, fitted(to_index(i) + 1)));
  return values;
}

/// Points with their weights, frequencies / their geometric mean ω₀ and stiffnesses / their mean modulus k₀, so that
/// parameters are near 1.
struct Scaled {
  std::vector<StiffnessPoint> points;
  std::vector<double> weight;
  double frequency = 1, stiffness = 1;
};

Scaled scaled(const std::vector<StiffnessPoint>& points) {
  Scaled result{points, {}, 0, 0};
  const auto count = static_cast<double>(points.size());
  for (const StiffnessPoint& p : points) {
    result.frequency += std::log(p.angular_frequency) / count;
    result.stiffness += std::abs(p.stiffness) / count;
  }
  result.frequency = std::exp(result.frequency);
  const bool weighted =
      std::ranges::none_of(points, [](const StiffnessPoint& p) { return std::isnan(p.standard_deviation); });
  for (StiffnessPoint& p : result.points) {
    result.weight.push_back(result.stiffness / (weighted ? p.standard_deviation : std::abs(p.stiffness)));
    p.angular_frequency /= result.frequency;
    p.stiffness /= result.stiffness;
  }
  return result;
}

Eigen::VectorXd residuals(const Scaled& data, const Family& family, const Eigen::VectorXd& fitted) {
  const std::vector<double> values = values_of(family, fitted);
  Eigen::VectorXd result(2 * to_index(data.points.size()));
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Complex off = std::exp(fitted(0)) * family.relative_modulus(values, data.points[i].angular_frequency) -
        data.points[i].stiffness;
    result(2 * to_index(i)) = data.weight[i] * off.real();
    result(2 * to_index(i) + 1) = data.weight[i] * off.imag();
  }
  return result;
}

/// Starting values on a grid: times over the band and a decade beyond, ratios and orders; the stiffness is found
/// linearly.
std::vector<Eigen::VectorXd> starts(const Scaled& data, const Family& family) {
  double low = 1, high = 1;
  for (const StiffnessPoint& p : data.points)
    low = std::min(low, p.angular_frequency), high = std::max(high, p.angular_frequency);
  std::vector<Eigen::VectorXd> result{Eigen::VectorXd::Zero(1)};
  for (std::size_t i = 0; i < family.parameters.size(); ++i) {
    std::vector<double> trials;
    const std::string name = family.parameters[i];
    if (name == "order") trials = {-1, 0, 1, 2};
    else if (name == "ratio") trials = {-3, -1.5, 0, 1.5};
    else if (name == "loss_factor") trials = {-4, -2, 0};
    else
      for (double t = -std::log(high) - 2.3; t <= -std::log(low) + 2.4; t += 1.15) trials.push_back(t);
    std::vector<Eigen::VectorXd> longer;
    for (const Eigen::VectorXd& one : result)
      for (const double trial : trials) {
        Eigen::VectorXd next(one.size() + 1);
        next << one, trial;
        longer.push_back(next);
      }
    result = std::move(longer);
  }
  return result;
}

/// The stiffness that fits best with given other parameters.
double best_stiffness(const Scaled& data, const Family& family, const Eigen::VectorXd& fitted) {
  const std::vector<double> values = values_of(family, fitted);
  double product = 0, square = 0;
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Complex modulus = data.weight[i] * family.relative_modulus(values, data.points[i].angular_frequency);
    product += (std::conj(modulus) * data.weight[i] * data.points[i].stiffness).real();
    square += std::norm(modulus);
  }
  return std::max(product / square, 1e-6);
}

LeastSquaresMinimum best_minimum(const Scaled& data, const Family& family) {
  const auto residuals_at = [&](const Eigen::VectorXd& fitted) { return residuals(data, family, fitted); };
  std::vector<std::pair<double, Eigen::VectorXd>> tried;
  for (Eigen::VectorXd& start : starts(data, family)) {
    start(0) = std::log(best_stiffness(data, family, start));
    tried.emplace_back(residuals_at(start).squaredNorm(), start);
  }
  const std::size_t kept = std::min<std::size_t>(5, tried.size());
  std::partial_sort(tried.begin(), tried.begin() + static_cast<std::ptrdiff_t>(kept), tried.end(),
                    [](const auto& a, const auto& b) { return a.first < b.first; });
  LeastSquaresMinimum best;
  for (std::size_t i = 0; i < kept; ++i)
    if (LeastSquaresMinimum one = least_squares_minimum(residuals_at, tried[i].second);
        i == 0 || one.residuals.squaredNorm() < best.residuals.squaredNorm())
      best = std::move(one);
  return best;
}

/// Value and interval of fitted coordinate i, in SI units.
Parameter parameter(const Scaled& data, const Family& family, const LeastSquaresMinimum& minimum, Eigen::Index i,
                    double factor) {
  const double half = factor * std::sqrt(minimum.unit_covariance(i, i)), centre = minimum.parameters(i);
  if (i == 0) {
    const double unit = data.stiffness;
    return {"stiffness", "N/m", unit * std::exp(centre), unit * std::exp(centre - half),
            unit * std::exp(centre + half)};
  }
  const auto place = to_size(i - 1);
  const std::string name = family.parameters[place];
  const double unit = name == "time" ? 1 / data.frequency : 1;
  return {name, name == "time" ? "s" : "", unit * value_of(family, place, centre),
          unit * value_of(family, place, centre - half), unit * value_of(family, place, centre + half)};
}

LawFit fitted(const Scaled& data, const std::vector<StiffnessPoint>& points, const Family& family, double confidence) {
  const LeastSquaresMinimum minimum = best_minimum(data, family);
  const auto count = 2 * static_cast<double>(points.size()), constants = static_cast<double>(minimum.parameters.size());
  constexpr double exact = 1e-24;  // squared residuals of noise-free data, by rounding
  const double squares = std::max(minimum.residuals.squaredNorm(), exact * count);
  const double freedom = count - constants;
  const double factor = freedom > 0 ? numerics::student_quantile(confidence, freedom) * std::sqrt(squares / freedom)
                                    : std::numeric_limits<double>::infinity();
  LawFit law;
  law.law = family.name;
  law.converged = minimum.converged;
  for (Eigen::Index i = 0; i < minimum.parameters.size(); ++i)
    law.parameters.push_back(parameter(data, family, minimum, i, factor));
  const auto value = [&](std::size_t i) { return law.parameters[i].value; };
  law.stiffness = value(0);
  if (family.relative_modulus == hysteretic) law.loss_factor = value(1);
  else if (family.relative_modulus == viscous) law.viscoelastic = elements::KelvinVoigt{value(1)};
  else if (family.relative_modulus == zener) law.viscoelastic = elements::Zener{value(1), value(2)};
  else law.viscoelastic = elements::FractionalZener{value(1), value(2), value(3)};
  const double estimated = constants + 1;  // the noise is estimated too
  law.akaike = count - estimated - 1 > 0
      ? count * std::log(squares / count) + 2 * estimated + 2 * estimated * (estimated + 1) / (count - estimated - 1)
      : std::numeric_limits<double>::quiet_NaN();
  double relative = 0;
  for (const StiffnessPoint& p : points)
    relative += std::norm(stiffness_at(law, p.angular_frequency) / p.stiffness - 1.0);
  law.relative_rms = std::sqrt(relative / static_cast<double>(points.size()));
  return law;
}

foundation::Problems point_problems(const std::vector<StiffnessPoint>& points) {
  foundation::Problems problems;
  Complex sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const StiffnessPoint& p = points[i];
    const std::string subject = fmt::format("point {}", i + 1);
    if (!(p.angular_frequency > 0 && std::isfinite(p.angular_frequency)))
      problems.error(subject, "a frequency of " + foundation::hertz_words(p.angular_frequency), "it must be > 0",
                     "remove static points");
    if (!std::isfinite(p.stiffness.real()) || !std::isfinite(p.stiffness.imag()) || std::abs(p.stiffness) == 0)
      problems.error(subject, "the stiffness is 0 or not a number", "every point must have a stiffness",
                     "remove the point");
    if (!std::isnan(p.standard_deviation) && !(p.standard_deviation > 0 && std::isfinite(p.standard_deviation)))
      problems.error(subject, fmt::format("standard deviation {} N/m", p.standard_deviation), "it must be > 0",
                     "omit it");
    sum += p.stiffness;
  }
  if (!problems.has_errors() && sum.real() <= 0)
    problems.error("dynamic_stiffness", "the stiffness is negative", "it must be > 0 for every law",
                   "reverse the sign of the force");
  if (!problems.has_errors() && sum.imag() <= 0)
    problems.error("dynamic_stiffness", "the mean loss is not positive", "a passive element dissipates energy",
                   "check the phase between the channels");
  return problems;
}

}  // namespace

std::vector<StiffnessPoint> stiffness_points(const std::vector<LoopFit>& loops, bool with_deviations,
                                             foundation::Problems& problems) {
  constexpr double same_frequency = 0.01, other_amplitude = 0.1, other_stiffness = 0.05;
  std::vector<StiffnessPoint> points;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const LoopFit& loop = loops[i];
    if (!loop.angular_frequency) {
      problems.warning(fmt::format("loop '{}'", loop.name), "its frequency is unknown",
                       "laws are fitted over frequency", "give its time or its frequency");
      continue;
    }
    StiffnessPoint point{*loop.angular_frequency, loop.dynamic_stiffness};
    if (with_deviations) point.standard_deviation = loop.dynamic_stiffness_deviation;
    points.push_back(point);
    const auto differs = [](double a, double b, double by) { return std::abs(a - b) > by * std::abs(b); };
    for (std::size_t j = 0; j < i; ++j)
      if (loops[j].angular_frequency &&
          !differs(*loops[j].angular_frequency, *loop.angular_frequency, same_frequency) &&
          differs(loops[j].amplitude.value, loop.amplitude.value, other_amplitude) &&
          differs(loops[j].stiffness.value, loop.stiffness.value, other_stiffness)) {
        problems.warning(fmt::format("loop '{}'", loop.name),
                         fmt::format("stiffness {} at amplitude {}, but {} at {} in '{}'",
                                     foundation::prefixed(loop.stiffness.value, "N/m"),
                                     foundation::prefixed(loop.amplitude.value, "m"),
                                     foundation::prefixed(loops[j].stiffness.value, "N/m"),
                                     foundation::prefixed(loops[j].amplitude.value, "m"), loops[j].name),
                         "a linear law does not depend on amplitude", "fit each amplitude separately");
        break;
      }
  }
  return points;
}

std::complex<double> stiffness_at(const LawFit& law, double angular_frequency) {
  if (law.loss_factor) return law.stiffness * Complex(1, *law.loss_factor);
  return law.stiffness * elements::relative_modulus(*law.viscoelastic, Complex(angular_frequency));
}

foundation::Expected<LawFit> fitted_law(const std::string& law, const std::vector<StiffnessPoint>& points,
                                        double confidence) {
  const auto family = std::ranges::find(families(), law, &Family::name);
  if (family == families().end() || !(confidence > 0 && confidence < 1))
    throw foundation::InvalidInput(fmt::format("law \"{}\", confidence {}", law, confidence));
  foundation::Problems problems;
  std::vector<double> frequencies;
  for (const StiffnessPoint& point : points) {
    constexpr double same = 0.01;
    if (std::ranges::none_of(frequencies,
                             [&](double other) { return std::abs(point.angular_frequency - other) <= same * other; }))
      frequencies.push_back(point.angular_frequency);
  }
  // Each frequency gives two numbers. With as many numbers as constants, a law that bends over frequency may not be
  // unique; the simple ones are.
  const std::size_t constants = 1 + family->parameters.size(), fewest = constants == 2 ? 1 : constants / 2 + 1;
  if (frequencies.size() < fewest)
    problems.error(
        "dynamic_stiffness", fmt::format("{} frequencies", frequencies.size()),
        fmt::format("the {} law has {} constants: at least {} frequencies determine them", law, constants, fewest),
        "measure at more frequencies, or name a law with fewer constants");
  problems.add(point_problems(points));
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));
  return fitted(scaled(points), points, *family, confidence);
}

foundation::Expected<LawRanking> fitted_laws(const std::vector<StiffnessPoint>& points, double confidence) {
  if (!(confidence > 0 && confidence < 1))
    throw foundation::InvalidInput(fmt::format("confidence = {}, must be between 0 and 1", confidence));
  foundation::Problems problems;
  if (points.size() < fewest_ranked_points)
    problems.error("dynamic_stiffness", fmt::format("{} points", points.size()),
                   "at least three points are needed to decide between laws",
                   "measure at more frequencies, or name the law");
  problems.add(point_problems(points));
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));
  LawRanking ranking;
  const Scaled data = scaled(points);
  for (const Family& family : families()) {
    const std::size_t constants = 1 + family.parameters.size();
    if (2 * points.size() > constants + 2) {
      ranking.laws.push_back(fitted(data, points, family, confidence));
    } else {
      ranking.warnings.warning("dynamic_stiffness", fmt::format("{} points", points.size()),
                               fmt::format("the {} law has {} constants", family.name, constants),
                               "measure at more frequencies to include it");
    }
  }
  std::ranges::sort(ranking.laws, {}, &LawFit::akaike);
  for (LawFit& law : ranking.laws) law.akaike_difference = law.akaike - ranking.laws.front().akaike;
  for (const Parameter& parameter : ranking.laws.front().parameters)
    if (constexpr double open = 100; !(parameter.high < open * parameter.low) && parameter.name != "order")
      ranking.warnings.warning("dynamic_stiffness",
                               fmt::format("{} of the {} law between {:.3g} and {:.3g} {}", parameter.name,
                                           ranking.laws.front().law, parameter.low, parameter.high, parameter.unit),
                               "the band should cover the range in which the parameter has an effect",
                               "measure over a wider band, or use a simpler law");
  return ranking;
}

}  // namespace trivet::identification

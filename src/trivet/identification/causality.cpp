// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/causality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/nonnegative_least_squares.h"

namespace trivet::identification {
namespace {

using Complex = std::complex<double>;
constexpr double two_pi = 6.283185307179586;

/// Relaxation times per decade, and decades of them beyond the band: a single relaxation between two times is met to 1e-3.
constexpr int times_per_decade = 12;
constexpr double decades_beyond = 2;

/// Columns of the sum of relaxations at the frequencies: static, viscous, branches, mass; unit constants.
Eigen::MatrixXcd relaxation_columns(const Eigen::VectorXd& frequency, const Eigen::VectorXd& times, bool with_mass) {
  Eigen::MatrixXcd columns(frequency.size(), 2 + times.size() + (with_mass ? 1 : 0));
  for (Eigen::Index i = 0; i < frequency.size(); ++i) {
    const Complex s(0, frequency(i));
    columns(i, 0) = 1;
    columns(i, 1) = s;
    for (Eigen::Index j = 0; j < times.size(); ++j) columns(i, 2 + j) = s * times(j) / (1.0 + s * times(j));
    if (with_mass) columns(i, 2 + times.size()) = s * s;
  }
  return columns;
}

Eigen::VectorXd relaxation_times(const Eigen::VectorXd& frequency) {
  const double from = -std::log10(frequency(frequency.size() - 1)) - decades_beyond, to = -std::log10(frequency(0)) + decades_beyond;
  const auto count = static_cast<Eigen::Index>(std::ceil((to - from) * times_per_decade)) + 1;
  return Eigen::VectorXd::LinSpaced(count, from, to).unaryExpr([](double decade) { return std::pow(10, decade); });
}

PassiveStiffness nearest_passive(const DynamicStiffnessTable& table, bool with_mass) {
  const Eigen::Index rows = table.angular_frequency.size();
  const Eigen::VectorXd times = relaxation_times(table.angular_frequency), weight = table.stiffness.cwiseAbs().cwiseInverse();
  const Eigen::MatrixXcd columns = weight.asDiagonal() * relaxation_columns(table.angular_frequency, times, with_mass);
  const Eigen::VectorXcd wanted = weight.asDiagonal() * table.stiffness;
  Eigen::MatrixXd a(2 * rows, columns.cols());
  a << columns.real(), columns.imag();
  Eigen::VectorXd b(2 * rows);
  b << wanted.real(), wanted.imag();
  const Eigen::VectorXd size = a.colwise().norm();
  const Eigen::VectorXd constants = numerics::nonnegative_least_squares(a * size.cwiseInverse().asDiagonal(), b).cwiseQuotient(size);

  PassiveStiffness passive{constants(0), constants(1), with_mass ? constants(constants.size() - 1) : 0, {}, {}};
  std::vector<Eigen::Index> kept;
  for (Eigen::Index j = 0; j < times.size(); ++j)
    if (constants(2 + j) > 0) kept.push_back(j);
  passive.branches.resize(static_cast<Eigen::Index>(kept.size()));
  passive.times.resize(passive.branches.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    passive.branches(static_cast<Eigen::Index>(k)) = constants(2 + kept[k]);
    passive.times(static_cast<Eigen::Index>(k)) = times(kept[k]);
  }
  return passive;
}

}  // namespace

foundation::Problems table_problems(const DynamicStiffnessTable& table) {
  constexpr std::size_t most_listed = 20;
  foundation::Problems problems;
  const Eigen::VectorXd& w = table.angular_frequency;
  if (w.size() != table.stiffness.size() || w.size() < 2) {
    problems.error("dynamic_stiffness", fmt::format("{} frequencies and {} stiffnesses", w.size(), table.stiffness.size()),
                   "a table has at least two rows of both", "complete the table");
    return problems;
  }
  const double stiffest = table.stiffness.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < w.size() && problems.list().size() < most_listed; ++i) {
    const std::string subject = fmt::format("row {}", i + 1);
    const Complex k = table.stiffness(i);
    if (!std::isfinite(w(i)) || !std::isfinite(k.real()) || !std::isfinite(k.imag()))
      problems.error(subject, "an entry is missing or not finite", "every row has a frequency and a complex stiffness",
                     "leave the row out");
    else if (!(w(i) > 0))
      problems.error(subject, fmt::format("{:.6g} Hz", w(i) / two_pi), "a frequency is > 0", "leave the static row out");
    else if (i > 0 && w(i) == w(i - 1))
      problems.error(subject, fmt::format("{:.6g} Hz stands twice", w(i) / two_pi), "frequencies increase",
                     "average the two rows, or leave one out");
    else if (i > 0 && w(i) < w(i - 1))
      problems.error(subject, fmt::format("{:.6g} Hz after {:.6g} Hz", w(i) / two_pi, w(i - 1) / two_pi), "frequencies increase",
                     "sort the rows");
    else if (k == 0.0)
      problems.error(subject, fmt::format("the stiffness is 0 at {:.6g} Hz", w(i) / two_pi), "a stiffness has a size", "leave the row out");
    else if (constexpr double rounding = 1e-9; k.imag() < -rounding * stiffest)
      problems.warning(subject, fmt::format("negative loss at {:.6g} Hz: k'' = {:.4g} N/m, k' = {:.4g} N/m", w(i) / two_pi, k.imag(),
                                            k.real()),
                       "a passive element loses energy (e^{+iωt}: k'' ≥ 0)", "check the sign of the phase, or the noise");
  }
  return problems;
}

std::complex<double> interpolated_stiffness(const DynamicStiffnessTable& table, double angular_frequency) {
  const foundation::Problems problems = table_problems(table);
  if (problems.has_errors()) throw foundation::InvalidInput("dynamic stiffness table: " + foundation::message(problems.list().front()));
  const Eigen::VectorXd& w = table.angular_frequency;
  const Eigen::Index last = w.size() - 1;
  if (!(angular_frequency >= w(0) && angular_frequency <= w(last)))
    throw foundation::InvalidInput(fmt::format("{:.6g} rad/s, the table holds {:.6g} to {:.6g} rad/s", angular_frequency, w(0), w(last)));
  const Eigen::Index above = std::max<Eigen::Index>(1, std::lower_bound(w.data(), w.data() + last, angular_frequency) - w.data());
  const double share = std::log(angular_frequency / w(above - 1)) / std::log(w(above) / w(above - 1));
  return (1 - share) * table.stiffness(above - 1) + share * table.stiffness(above);
}

std::complex<double> stiffness_at(const PassiveStiffness& passive, double angular_frequency) {
  const Complex s(0, angular_frequency);
  Complex k = passive.static_stiffness + passive.viscous_coefficient * s + passive.mass * s * s;
  for (Eigen::Index j = 0; j < passive.times.size(); ++j) k += passive.branches(j) * s * passive.times(j) / (1.0 + s * passive.times(j));
  return k;
}

foundation::Expected<CausalityCheck> causality(const DynamicStiffnessTable& table, const CausalityOptions& options) {
  if (!(options.tolerance > 0)) throw foundation::InvalidInput(fmt::format("tolerance = {}, must be > 0", options.tolerance));
  CausalityCheck check;
  check.warnings = table_problems(table);
  if (check.warnings.has_errors()) return tl::make_unexpected(std::move(check.warnings));
  const Eigen::Index rows = table.angular_frequency.size();
  check.nearest = nearest_passive(table, options.with_mass);
  check.fitted.resize(rows);
  for (Eigen::Index i = 0; i < rows; ++i) check.fitted(i) = stiffness_at(check.nearest, table.angular_frequency(i));
  check.misfit = (check.fitted - table.stiffness).cwiseAbs().cwiseQuotient(table.stiffness.cwiseAbs());
  check.relative_rms = std::sqrt(check.misfit.squaredNorm() / static_cast<double>(rows));
  const double worst = check.misfit.maxCoeff(&check.worst), hertz = table.angular_frequency(check.worst) / two_pi;
  check.passes = check.relative_rms <= options.tolerance;
  check.verdict = check.passes ? fmt::format("k' and k'' belong together within {:.2g} % (worst {:.2g} % at {:.4g} Hz)",
                                             100 * check.relative_rms, 100 * worst, hertz)
                               : fmt::format("{:.2g} % of k* belongs to no passive relaxing material (worst {:.2g} % at {:.4g} Hz)",
                                             100 * check.relative_rms,
                                             100 * worst, hertz);
  if (!check.passes)
    check.warnings.warning("dynamic_stiffness", check.verdict, fmt::format("up to {:.2g} % pass", 100 * options.tolerance),
                           "look for a wrong phase, mass or resonance in the band (with_mass), "
                           "another temperature or amplitude within the table");
  return check;
}

}  // namespace trivet::identification

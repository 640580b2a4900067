// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/causality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/hertz.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/unit_prefix.h"
#include "trivet/identification/passive_sections.h"

namespace trivet::identification {
namespace {

using Complex = std::complex<double>;
using foundation::two_pi;

/// Relaxation times per decade, and decades of them beyond the band: a single relaxation between two times is fitted to
/// 1e-3.
constexpr int times_per_decade = 12;
constexpr double decades_beyond = 2;

/// A fit stops this far below the tolerance: the rest is noise.
constexpr double of_the_tolerance = 0.2;
/// Half width of a resonance / row spacing: resolved by the rows; not resolved by them.
constexpr double shown = 0.5, hidden = 0.1;

Eigen::VectorXd relaxation_times(const std::vector<double>& frequency) {
  const double from = -std::log10(frequency.back()) - decades_beyond,
               to = -std::log10(frequency.front()) + decades_beyond;
  const auto count = static_cast<Eigen::Index>(std::ceil((to - from) * times_per_decade)) + 1;
  return Eigen::VectorXd::LinSpaced(count, from, to).unaryExpr([](double decade) { return std::pow(10, decade); });
}

/// The rows used for the fit.
struct Rows {
  std::vector<double> fitted;  ///< their angular frequencies [rad/s]
  Eigen::VectorXcd stiffness;
};

Rows rows_of(const DynamicStiffnessTable& table) {
  Rows rows;
  const std::vector<Eigen::Index> chosen =
      rows_that_follow({table.angular_frequency.begin(), table.angular_frequency.end()}, table.stiffness);
  for (const Eigen::Index i : chosen) rows.fitted.push_back(table.angular_frequency(i));
  rows.stiffness = table.stiffness(chosen);
  return rows;
}

/// Nearest sum of a static stiffness, a dashpot, relaxations and, if sections are given, of these and a mass.
PassiveStiffness nearest_passive(const Rows& rows, const std::vector<Section>& sections, double enough) {
  const Eigen::VectorXd times = relaxation_times(rows.fitted);
  const auto count = to_index(rows.fitted.size()), resonances = to_index(sections.size());
  const Eigen::Index first = 2 + times.size();
  Eigen::MatrixXcd columns(count, first + (sections.empty() ? 0 : 1 + 2 * resonances));
  for (Eigen::Index i = 0; i < count; ++i) {
    const Complex s(0, rows.fitted[i]);
    columns(i, 0) = 1;
    columns(i, 1) = s;
    for (Eigen::Index j = 0; j < times.size(); ++j) columns(i, 2 + j) = s * times(j) / (1.0 + s * times(j));
    if (sections.empty()) continue;
    columns(i, first) = s * s;
    for (Eigen::Index j = 0; j < resonances; ++j) {
      const Section& section = sections[j];
      columns(i, first + 1 + 2 * j) = s * inertial_section(section, s);
      columns(i, first + 2 + 2 * j) = s * elastic_section(section, s);
    }
  }
  const Eigen::VectorXd constants = nearest_weights(columns, rows.stiffness, enough);

  PassiveStiffness passive;
  passive.static_stiffness = constants(0);
  passive.viscous_coefficient = constants(1);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index j = 0; j < times.size(); ++j)
    if (constants(2 + j) > 0) kept.push_back(j);
  passive.branches = constants.segment(2, times.size())(kept);
  passive.times = times(kept);
  if (sections.empty()) return passive;
  passive.mass = constants(first);
  for (Eigen::Index j = 0; j < resonances; ++j) {
    const double inertial = constants(first + 1 + 2 * j), elastic = constants(first + 2 + 2 * j);
    const Section& section = sections[j];
    if (inertial > 0 || elastic > 0)
      passive.resonances.push_back({section.angular_frequency, section.damping_ratio, inertial, elastic});
  }
  return passive;
}

void compare(const DynamicStiffnessTable& table, CausalityCheck& check) {
  const Eigen::Index rows = table.angular_frequency.size();
  check.fitted.resize(rows);
  for (Eigen::Index i = 0; i < rows; ++i) check.fitted(i) = stiffness_at(check.nearest, table.angular_frequency(i));
  check.misfit = (check.fitted - table.stiffness).cwiseAbs().cwiseQuotient(table.stiffness.cwiseAbs());
  check.relative_rms = std::sqrt(check.misfit.squaredNorm() / static_cast<double>(rows));
  check.misfit.maxCoeff(&check.worst);
}

/// True if the stiffness changes by more than a third from one row to the next.
bool has_steep_rows(const DynamicStiffnessTable& table) {
  constexpr double steep = 1.0 / 3;
  for (Eigen::Index i = 1; i < table.stiffness.size(); ++i)
    if (std::abs(table.stiffness(i) - table.stiffness(i - 1)) >
        steep * std::min(std::abs(table.stiffness(i)), std::abs(table.stiffness(i - 1))))
      return true;
  return false;
}

/// Text on the motion inside the element: its strongest resonance in the band, or what acts as a mass there.
std::string inner_motion(const PassiveStiffness& passive, const DynamicStiffnessTable& table) {
  const Eigen::VectorXd& w = table.angular_frequency;
  PassiveStiffness massive;
  massive.mass = passive.mass;
  double strongest = 0, at = 0;
  for (const PassiveStiffness::Resonance& r : passive.resonances) {
    if (r.angular_frequency > w(w.size() - 1)) massive.resonances.push_back(r);
    if (!(r.angular_frequency >= w(0) && r.angular_frequency <= w(w.size() - 1))) continue;
    PassiveStiffness alone;
    alone.resonances = {r};
    if (const double height = std::abs(stiffness_at(alone, r.angular_frequency)); height > strongest)
      strongest = height, at = r.angular_frequency;
  }
  double as_a_mass = 0;
  for (const double omega : w) as_a_mass = std::max(as_a_mass, std::abs(stiffness_at(massive, omega)));
  return as_a_mass > strongest ? std::string(", with inertia: a mass, or a resonance above the band")
                               : fmt::format(", with an internal resonance near {:.3g} Hz", at / two_pi);
}

std::string verdict_text(const CausalityCheck& check, const DynamicStiffnessTable& table) {
  const std::string worst = fmt::format("(worst {:.2g} % at {:.4g} Hz)", 100 * check.misfit(check.worst),
                                        table.angular_frequency(check.worst) / two_pi);
  const double share = 100 * check.relative_rms;
  switch (check.kind) {
    case Causality::relaxing:
      return fmt::format("k' and k'' are consistent within {:.2g} % {}", share, worst);
    case Causality::resonant:
      return fmt::format("k' and k'' are consistent within {:.2g} % {}{}", share, worst,
                         inner_motion(check.nearest, table));
    case Causality::too_coarse:
      return fmt::format("only a resonance narrower than the row spacing explains {:.2g} % of k* {}", share, worst);
    case Causality::impossible:
      break;
  }
  return fmt::format("k* differs by {:.2g} % from the nearest passive, causal element {}", share, worst);
}

}  // namespace

foundation::Problems table_problems(const DynamicStiffnessTable& table) {
  constexpr std::size_t most_listed = 20;
  foundation::Problems problems;
  const Eigen::VectorXd& w = table.angular_frequency;
  if (w.size() != table.stiffness.size() || w.size() < 2) {
    problems.error("dynamic_stiffness",
                   fmt::format("{} frequencies and {} stiffnesses", w.size(), table.stiffness.size()),
                   "a table must have at least two rows of both", "complete the table");
    return problems;
  }
  const double stiffest = table.stiffness.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < w.size() && problems.list().size() < most_listed; ++i) {
    const std::string subject = fmt::format("row {}", i + 1);
    const Complex k = table.stiffness(i);
    if (!std::isfinite(w(i)) || !std::isfinite(k.real()) || !std::isfinite(k.imag()))
      problems.error(subject, "an entry is missing or not finite",
                     "every row must have a frequency and a complex stiffness", "remove the row");
    else if (!(w(i) > 0))
      problems.error(subject, fmt::format("{:.6g} Hz", w(i) / two_pi), "a frequency must be > 0",
                     "remove the static row");
    else if (i > 0 && w(i) == w(i - 1))
      problems.error(subject, fmt::format("{:.6g} Hz is listed twice", w(i) / two_pi), "frequencies must increase",
                     "average the two rows, or remove one");
    else if (i > 0 && w(i) < w(i - 1))
      problems.error(subject, fmt::format("{:.6g} Hz after {:.6g} Hz", w(i) / two_pi, w(i - 1) / two_pi),
                     "frequencies must increase", "sort the rows");
    else if (k == 0.0)
      problems.error(subject, fmt::format("the stiffness is 0 at {:.6g} Hz", w(i) / two_pi),
                     "a stiffness must not be 0", "remove the row");
    else if (constexpr double rounding = 1e-9; k.imag() < -rounding * stiffest)
      problems.warning(subject,
                       fmt::format("negative loss at {}: k'' = {}, k' = {}", foundation::hertz_words(w(i), 6),
                                   foundation::prefixed(k.imag(), "N/m"), foundation::prefixed(k.real(), "N/m")),
                       "a passive element dissipates energy (e^{+iωt}: k'' ≥ 0)",
                       "check the sign of the phase, or the noise");
  }
  return problems;
}

std::complex<double> interpolated_stiffness(const DynamicStiffnessTable& table, double angular_frequency) {
  const foundation::Problems problems = table_problems(table);
  if (problems.has_errors())
    throw foundation::InvalidInput("dynamic stiffness table: " + foundation::first_message(problems));
  const Eigen::VectorXd& w = table.angular_frequency;
  const Eigen::Index last = w.size() - 1;
  if (!(angular_frequency >= w(0) && angular_frequency <= w(last)))
    throw foundation::InvalidInput(fmt::format("{} is outside the table, which covers {}",
                                               foundation::hertz_words(angular_frequency, 6),
                                               foundation::hertz_range(w(0), w(last), 6)));
  const Eigen::Index above =
      std::max<Eigen::Index>(1, std::lower_bound(w.data(), w.data() + last, angular_frequency) - w.data());
  const double share = std::log(angular_frequency / w(above - 1)) / std::log(w(above) / w(above - 1));
  return (1 - share) * table.stiffness(above - 1) + share * table.stiffness(above);
}

std::complex<double> stiffness_at(const PassiveStiffness& passive, double angular_frequency) {
  const Complex s(0, angular_frequency);
  Complex k = passive.static_stiffness + passive.viscous_coefficient * s + passive.mass * s * s;
  for (Eigen::Index j = 0; j < passive.times.size(); ++j)
    k += passive.branches(j) * s * passive.times(j) / (1.0 + s * passive.times(j));
  for (const PassiveStiffness::Resonance& r : passive.resonances) {
    const Section section{r.angular_frequency, r.damping_ratio};
    k += s * (r.inertial * inertial_section(section, s) + r.elastic * elastic_section(section, s));
  }
  return k;
}

std::string remedy(Causality kind) {
  return kind == Causality::too_coarse
      ? "measure with a finer frequency step there; if the step is fine enough, check the phase"
      : "look for a wrong phase, or a change of temperature or amplitude within the table";
}

foundation::Expected<CausalityCheck> causality(const DynamicStiffnessTable& table, const CausalityOptions& options) {
  if (!(options.tolerance > 0))
    throw foundation::InvalidInput(fmt::format("tolerance = {}, must be > 0", options.tolerance));
  CausalityCheck check;
  check.warnings = table_problems(table);
  if (check.warnings.has_errors()) return tl::make_unexpected(std::move(check.warnings));
  const Rows rows = rows_of(table);
  check.nearest = nearest_passive(rows, {}, 0);
  compare(table, check);
  check.kind = Causality::relaxing;
  check.passes = check.relative_rms <= options.tolerance;
  if (!check.passes) {
    const double enough = of_the_tolerance * options.tolerance;
    check.nearest = nearest_passive(rows, sections_shown(rows.fitted, shown), enough);
    compare(table, check);
    check.passes = check.relative_rms <= options.tolerance;
    check.kind = check.passes ? Causality::resonant : Causality::impossible;
    if (!check.passes) {
      CausalityCheck finer = check;
      finer.nearest = nearest_passive(rows, sections_shown(rows.fitted, hidden), enough);
      compare(table, finer);
      if (finer.relative_rms <= options.tolerance && has_steep_rows(table)) check.kind = Causality::too_coarse;
    }
  }
  check.verdict = verdict_text(check, table);
  if (!check.passes)
    check.warnings.warning("dynamic_stiffness", check.verdict,
                           fmt::format("up to {:.2g} % is accepted", 100 * options.tolerance), remedy(check.kind));
  return check;
}

}  // namespace trivet::identification

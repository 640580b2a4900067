// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/passive_sections.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/nonnegative_least_squares.h"

namespace trivet::identification {

namespace {

using Complex = std::complex<double>;

constexpr double per_decade = 24, margin = 30;
constexpr Eigen::Index most_rows = 120;

/// Least ζω that the rows resolve around ω: given by the row spacing, outside the band also by the distance from the
/// band.
double least_half_width(const std::vector<double>& rows, double omega, double share) {
  const std::size_t last = rows.size() - 1;
  if (omega < rows.front()) return share * (rows[1] - rows[0]) - (rows[0] - omega);
  if (omega > rows.back()) return share * (rows[last] - rows[last - 1]) - (omega - rows[last]);
  const auto above = std::clamp<std::size_t>(to_size(std::ranges::lower_bound(rows, omega) - rows.begin()), 1, last);
  return share * (rows[above] - rows[above - 1]);
}

}  // namespace

Complex inertial_section(const Section& section, Complex s) {
  const double w = section.angular_frequency;
  return s / (s * s + 2 * section.damping_ratio * w * s + w * w);
}

Complex elastic_section(const Section& section, Complex s) {
  const double w = section.angular_frequency, twice = 2 * section.damping_ratio * w;
  return (s + twice) / (s * s + twice * s + w * w);
}

std::vector<Section> sections_shown(const std::vector<double>& frequencies, double share) {
  std::vector<Section> sections;
  const double from = frequencies.front() / margin, ratio = margin * frequencies.back() / from;
  const int count = static_cast<int>(std::ceil(per_decade * std::log10(ratio)));
  for (int i = 0; i <= count; ++i) {
    const double omega = from * std::pow(ratio, static_cast<double>(i) / count),
                 least = least_half_width(frequencies, omega, share) / omega;
    for (const double damping : {0.01, 0.02, 0.04, 0.08, 0.15, 0.3, 0.6, 1.0})
      if (damping >= least) sections.push_back({omega, damping});
  }
  const int per_interval = share < 0.25 ? 4 : 2;  // narrow ones need closer spacing
  for (std::size_t r = 0; r + 1 < frequencies.size(); ++r)
    for (int i = 0; i < per_interval; ++i) {
      const double omega =
          frequencies[r] * std::pow(frequencies[r + 1] / frequencies[r], static_cast<double>(i) / per_interval);
      for (const double wider : {1.0, 2.0, 4.0})
        if (const double damping = wider * least_half_width(frequencies, omega, share) / omega; damping < 1)
          sections.push_back({omega, damping});
    }
  return sections;
}

std::vector<Eigen::Index> rows_that_follow(const std::vector<double>& frequencies, const Eigen::VectorXcd& values) {
  const Eigen::Index count = values.size();
  std::vector<Eigen::Index> rows;
  if (count <= most_rows) {
    for (Eigen::Index i = 0; i < count; ++i) rows.push_back(i);
    return rows;
  }
  Eigen::VectorXd turned = Eigen::VectorXd::Zero(count), passed = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 1; i < count; ++i) {
    const auto k = to_size(i);
    turned(i) =
        turned(i - 1) + std::abs(values(i) - values(i - 1)) / std::max(std::abs(values(i)), std::abs(values(i - 1)));
    passed(i) = passed(i - 1) + std::log(frequencies[k] / frequencies[k - 1]);
  }
  const double all_turned = turned(count - 1), all_passed = passed(count - 1);
  const Eigen::VectorXd along = passed / all_passed +
      (all_turned > 0 ? Eigen::VectorXd(turned / all_turned) : Eigen::VectorXd(passed / all_passed));
  for (Eigen::Index i = 0; i < count; ++i)
    if (i == 0 || i == count - 1 || along(i) * (most_rows - 2) >= 2 * static_cast<double>(rows.size()))
      rows.push_back(i);
  return rows;
}

Eigen::VectorXd nearest_weights(const Eigen::MatrixXcd& columns, const Eigen::VectorXcd& values, double enough) {
  const Eigen::Index rows = values.size();
  const Eigen::VectorXd relative = values.cwiseAbs().cwiseInverse();
  Eigen::MatrixXd a(2 * rows, columns.cols());
  a << relative.asDiagonal() * columns.real(), relative.asDiagonal() * columns.imag();
  Eigen::VectorXd b(2 * rows);
  b << relative.cwiseProduct(values.real()), relative.cwiseProduct(values.imag());
  const Eigen::VectorXd size = a.colwise().norm();
  const Eigen::MatrixXd scaled = a * size.cwiseInverse().asDiagonal();
  return numerics::nonnegative_least_squares(scaled, b, enough * std::sqrt(static_cast<double>(rows)))
      .cwiseQuotient(size);
}

namespace {

constexpr double explained_by_noise = 0.1, wrong_phase = 0.4;
/// Half width of a resonance / row spacing: resolved by the rows; not resolved by them.
constexpr double clearly_active = 0.5, within_noise = 0.05;

/// Distance from the nearest sum of a mass, a spring, a dashpot and sections, rms over the rows.
double distance(const std::vector<double>& fitted, const Eigen::VectorXcd& mobility,
                const std::vector<Section>& sections) {
  constexpr double enough = 0.2 * explained_by_noise;
  const auto rows = to_index(fitted.size()), count = to_index(sections.size());
  Eigen::MatrixXcd columns(rows, 3 + 2 * count);
  for (Eigen::Index r = 0; r < rows; ++r) {
    const Complex s(0, fitted[r]);
    columns.row(r).head<3>() << 1.0 / s, s, 1.0;
    for (Eigen::Index j = 0; j < count; ++j) {
      columns(r, 3 + 2 * j) = inertial_section(sections[j], s);
      columns(r, 4 + 2 * j) = elastic_section(sections[j], s);
    }
  }
  const Eigen::VectorXcd nearest = columns * nearest_weights(columns, mobility, enough);
  return std::sqrt((nearest - mobility).cwiseQuotient(mobility).squaredNorm() / static_cast<double>(rows));
}

}  // namespace

MobilityVerdict mobility_causality(const std::vector<double>& omega, const Eigen::VectorXcd& mobility) {
  std::vector<double> present, fitted;
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < mobility.size(); ++i)
    if (std::abs(mobility(i)) > 0) present.push_back(omega[i]), rows.push_back(i);
  if (rows.size() < 2) return {};
  const Eigen::VectorXcd values = mobility(rows);
  const std::vector<Eigen::Index> chosen = rows_that_follow(present, values);
  for (const Eigen::Index i : chosen) fitted.push_back(present[i]);
  const Eigen::VectorXcd judged = values(chosen);
  MobilityVerdict verdict;
  verdict.relative_rms = distance(fitted, judged, sections_shown(fitted, clearly_active));
  verdict.passes = verdict.relative_rms <= explained_by_noise;
  if (verdict.passes) return verdict;
  const double finer = distance(fitted, judged, sections_shown(fitted, within_noise));
  verdict.too_coarse = finer <= explained_by_noise;
  verdict.refused = std::min(verdict.relative_rms, finer) > wrong_phase;
  return verdict;
}

}  // namespace trivet::identification

// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/mobility_causality.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "trivet/foundation/index.h"
#include "trivet/identification/passive_sections.h"

namespace trivet::identification {
namespace {

using Complex = std::complex<double>;
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

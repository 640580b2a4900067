// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/measured/mobility_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/hertz.h"
#include "trivet/foundation/index.h"
#include "trivet/identification/passive_sections.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"

namespace trivet::project {

namespace {

/// Largest negative eigenvalue of Re Y, scaled to a unit diagonal of |Y|, that noise, or rounding, explains.
constexpr double noisy = 0.02, rounded = 1e-9;
/// Least reciprocal condition of Y, scaled alike, of which the inverse has four digits; and the one below which errors
/// of one percent, usual in measurements, change the inverse by more than its size.
constexpr double invertible = 1e-12, well_conditioned = 1e-2;

foundation::Origin origin(const GroundMobility& mobility, std::size_t row) {
  return {mobility.source, mobility.lines.empty() ? 0 : mobility.lines[row]};
}

double hertz(const GroundMobility& mobility, std::size_t row) { return foundation::hertz(mobility.knots[row]); }

Eigen::VectorXcd driving_point(const GroundMobility& mobility, std::size_t direction) {
  Eigen::VectorXcd values(to_index(mobility.rows.size()));
  const auto d = to_index(direction);
  for (std::size_t i = 0; i < mobility.rows.size(); ++i) values(to_index(i)) = mobility.rows[i](d, d);
  return values;
}

/// Y with unit magnitudes on its diagonal: D⁻½ Y D⁻½ with D = |diag Y|. A point that does not move gives zeros.
Eigen::MatrixXcd scaled(const Eigen::MatrixXcd& y) {
  Eigen::VectorXd inverse_size = y.diagonal().cwiseAbs().cwiseSqrt();
  for (double& one : inverse_size) one = one > 0 ? 1 / one : 0;
  const Eigen::VectorXcd sides = inverse_size.cast<std::complex<double>>();
  return sides.asDiagonal() * y * sides.asDiagonal();
}

void check_passive(const GroundMobility& mobility, foundation::Problems& found) {
  double worst = 0;
  std::size_t at = 0;
  for (std::size_t i = 0; i < mobility.rows.size(); ++i) {
    const double share = numerics::symmetric_eigenvalues(scaled(mobility.rows[i]).real().eval())(0);
    if (share < worst) worst = share, at = i;
  }
  if (worst >= -rounded) return;
  const std::string finding = fmt::format("at {:.6g} Hz Re Y has the eigenvalue {:.3g}, relative to the driving points",
                                          hertz(mobility, at), worst);
  const char* rule = "a passive ground absorbs energy in every motion: Re Y is positive semidefinite";
  foundation::Problem& problem = worst < -noisy
      ? found.error("", finding, rule, "check sign and phase of velocity against force")
      : found.warning("", finding, rule,
                      "measurement noise may be the cause; such a ground can feed energy into a motion");
  problem.origin = origin(mobility, at);
}

void check_invertible(const GroundMobility& mobility, foundation::Problems& found) {
  double worst = 1;
  std::size_t at = 0;
  for (std::size_t i = 0; i < mobility.rows.size(); ++i)
    if (const double condition =
            numerics::PivotedLu<std::complex<double>>(scaled(mobility.rows[i])).reciprocal_condition();
        !(condition >= worst))
      worst = condition, at = i;
  const char* remedy =
      "leave out a zero column; points on one rigid part are a body on elements, or a modal foundation";
  if (!(worst >= invertible))
    found
        .error("", fmt::format("at {:.6g} Hz Y is singular", hertz(mobility, at)),
               "the compliant directions move independently: Y has an inverse", remedy)
        .origin = origin(mobility, at);
  else if (worst < well_conditioned)
    found
        .warning("",
                 fmt::format("at {:.6g} Hz Y is nearly singular: its reciprocal condition is {:.2g}",
                             hertz(mobility, at), worst),
                 "an error of the measurement grows by up to its inverse in the dynamic stiffness Y⁻¹", remedy)
        .origin = origin(mobility, at);
}

void check_causal(GroundMobility& mobility, foundation::Problems& found) {
  for (std::size_t d = 0; d < mobility.directions.size(); ++d) {
    const identification::MobilityVerdict verdict =
        identification::mobility_causality(mobility.knots, driving_point(mobility, d));
    mobility.directions[d].causality_rms = verdict.relative_rms;
    if (verdict.passes) continue;
    const std::string finding = fmt::format("{}: {:.3g} % rms from the nearest passive, causal mobility",
                                            mobility.directions[d].name, 100 * verdict.relative_rms);
    const char* rule = "real and imaginary part of a physical mobility satisfy the Kramers–Kronig relations";
    if (verdict.too_coarse)
      found.warning("", finding, "its rows must resolve the width of every resonance",
                    "measure at closer frequencies; if they are close enough, check the phase");
    else if (verdict.refused)
      found.error("", finding, rule,
                  "check the phase: with e^{+iωt} a mass has a negative, a spring a positive imaginary mobility");
    else found.warning("", finding, rule, "check noise, leakage and the phase of the measurement");
  }
}

/// Warns if the phase turns far from one row to the next: linear interpolation then cuts a resonance short.
void check_spacing(const GroundMobility& mobility, foundation::Problems& found) {
  constexpr double widest = 30 * foundation::two_pi / 360;
  double worst = 0;
  std::size_t at = 0;
  for (std::size_t i = 1; i < mobility.rows.size(); ++i)
    for (Eigen::Index d = 0; d < mobility.rows[i].rows(); ++d)
      if (const double turn = std::abs(std::arg(mobility.rows[i](d, d) * std::conj(mobility.rows[i - 1](d, d))));
          turn > worst)
        worst = turn, at = i;
  if (worst <= widest) return;
  found
      .warning("",
               fmt::format("the phase turns by {:.3g}° from {:.6g} to {:.6g} Hz", worst * 360 / foundation::two_pi,
                           hertz(mobility, at - 1), hertz(mobility, at)),
               "the mobility is interpolated linearly: the peak of a resonance narrower than a few rows is cut off",
               "measure it at closer frequencies")
      .origin = origin(mobility, at);
}

}  // namespace

foundation::Problems judge_mobility(GroundMobility& mobility) {
  foundation::Problems found;
  check_passive(mobility, found);
  if (!found.has_errors()) check_invertible(mobility, found);
  if (!found.has_errors()) check_causal(mobility, found);
  if (!found.has_errors()) check_spacing(mobility, found);
  return found;
}

}  // namespace trivet::project

// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/ground_mobility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "trivet/foundation/constants.h"
#include "trivet/foundation/index.h"
#include "trivet/identification/mobility_causality.h"
#include "trivet/numerics/linalg/pivoted_lu.h"
#include "trivet/numerics/linalg/symmetric_eigen.h"
#include "trivet/project/elements/stiffness_column.h"

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

double hertz(const GroundMobility& mobility, std::size_t row) { return mobility.knots[row] / foundation::two_pi; }

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

/// Dynamic stiffness of all directions. The elements of a foundation need it one after another at each frequency; so
/// the last one of a thread is kept, with its mobility.
const Eigen::MatrixXcd& dynamic_stiffness_of_all(const std::shared_ptr<const GroundMobility>& mobility,
                                                 std::complex<double> omega, double near) {
  struct Last {
    std::weak_ptr<const GroundMobility> mobility;  // a later mobility at the same address is another one
    std::complex<double> omega;
    double near = 0;
    Eigen::MatrixXcd value;
  };
  thread_local Last last;
  const bool same = !last.mobility.owner_before(mobility) && !mobility.owner_before(last.mobility);
  if (!same || last.omega != omega || last.near != near)
    last = {mobility, omega, near, mobility->dynamic_stiffness(omega, near)};
  return last.value;
}

/// A table whose dynamic stiffness is taken from that of all directions.
elements::FrequencyDependence table(
    const std::shared_ptr<const GroundMobility>& mobility,
    const std::function<void(const Eigen::MatrixXcd& all, elements::Matrix12c& full)>& fill) {
  elements::FrequencyDependence result;
  result.elastic = false;
  result.from = mobility->knots.front();
  result.to = mobility->knots.back();
  result.knots = mobility->knots;
  result.stiffness = [mobility, fill](std::complex<double> omega, double near) {
    elements::Matrix12c full = elements::Matrix12c::Zero();
    fill(dynamic_stiffness_of_all(mobility, omega, near), full);
    return full;
  };
  return result;
}

}  // namespace

std::vector<int> GroundMobility::coordinates(std::size_t point) const {
  std::vector<int> result;
  for (const Direction& direction : directions)
    if (direction.point == point) result.push_back(direction.coordinate);
  return result;
}

Eigen::MatrixXcd GroundMobility::dynamic_stiffness(std::complex<double> omega, double near) const {
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, near);
  const auto i = to_size(above - knots.begin());
  const std::complex<double> share = (omega - knots[i - 1]) / (knots[i] - knots[i - 1]);
  const Eigen::MatrixXcd y = (1.0 - share) * rows[i - 1] + share * rows[i];
  return std::complex<double>(0, 1) * omega * numerics::inverse(y);
}

foundation::Problems judge_mobility(GroundMobility& mobility) {
  foundation::Problems found;
  check_passive(mobility, found);
  if (!found.has_errors()) check_invertible(mobility, found);
  if (!found.has_errors()) check_causal(mobility, found);
  if (!found.has_errors()) check_spacing(mobility, found);
  return found;
}

void join_to_ground(const std::shared_ptr<const GroundMobility>& mobility, std::size_t point, model::Element& element) {
  const auto fill = [directions = mobility->directions, point](const Eigen::MatrixXcd& all, elements::Matrix12c& full) {
    for (std::size_t a = 0; a < directions.size(); ++a)
      for (std::size_t b = 0; b < directions.size(); ++b) {
        if (directions[a].point != point || directions[b].point != point) continue;
        const int i = directions[a].coordinate, j = directions[b].coordinate;
        full(i, j) = full(6 + i, 6 + j) = all(to_index(a), to_index(b));
        full(i, 6 + j) = full(6 + i, j) = -full(i, j);
      }
  };
  element.law.frequency_dependence = table(mobility, fill);
  // For starting values only: magnitude of the dynamic stiffness in the first row, per direction.
  elements::Matrix12c first_row = elements::Matrix12c::Zero();
  fill(mobility->dynamic_stiffness(mobility->knots.front(), mobility->knots.front()), first_row);
  const elements::Vector6 first = first_row.diagonal().head<6>().cwiseAbs();
  element.law.nominal_stiffness = elements::constants_at_point(first, Eigen::Vector3d::Zero(), 1);
  for (const GroundMobility::Direction& direction : mobility->directions)
    if (direction.point == point)
      element.facts.push_back(
          {"causality of " + direction.name,
           fmt::format("{:.3g} % rms from the nearest passive, causal mobility", 100 * direction.causality_rms)});
  element.facts.push_back(defined_range(mobility->knots.front(), mobility->knots.back()));
}

void couple(const std::shared_ptr<const GroundMobility>& mobility, std::size_t n, std::size_t k,
            model::Element& element) {
  element.law.frequency_dependence = table(
      mobility, [directions = mobility->directions, n, k](const Eigen::MatrixXcd& all, elements::Matrix12c& full) {
        for (std::size_t a = 0; a < directions.size(); ++a)
          for (std::size_t b = 0; b < directions.size(); ++b)
            if (directions[a].point == n && directions[b].point == k)
              full(directions[a].coordinate, 6 + directions[b].coordinate) =
                  full(6 + directions[b].coordinate, directions[a].coordinate) = all(to_index(a), to_index(b));
      });
  element.facts.push_back(defined_range(mobility->knots.front(), mobility->knots.back()));
}

}  // namespace trivet::project

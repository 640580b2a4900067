// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/rig_regression.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "trivet/elements/law.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/sampling/student_distribution.h"

namespace trivet::identification {

namespace {

/// Ratio of smallest to largest pivot that still counts as excited; designs are scaled, so rounding is near 1e-15.
constexpr double rank_tolerance = 1e-9;
/// Ratio of noise to readings below which a group counts as exact.
constexpr double least_noise = 1e-10;

Eigen::VectorXd group_sizes(const Regression& regression, const Eigen::VectorXd& values) {
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(regression.groups), count = squares;
  for (Eigen::Index r = 0; r < values.size(); ++r) {
    squares(regression.group[r]) += std::pow(values(r) / regression.relative_deviation(r), 2);
    count(regression.group[r]) += 1;
  }
  return (squares.array() / count.array().max(1)).sqrt();
}

/// Directions without influence on the readings: R₁₁ x₁ = −R₁₂ x₂ for every unit x₂, in the order of the parameters.
Eigen::MatrixXd null_space(const numerics::PivotedQr& qr, Eigen::Index rank) {
  const Eigen::Index count = qr.R.cols();
  Eigen::MatrixXd pivoted(count, count - rank);
  pivoted.topRows(rank) = -qr.R.topRightCorner(rank, count - rank);
  pivoted.topRows(rank) =
      qr.R.topLeftCorner(rank, rank).triangularView<Eigen::Upper>().solve(pivoted.topRows(rank).eval());
  pivoted.bottomRows(count - rank).setIdentity();
  return qr.P * pivoted;
}

Eigen::VectorXd deviations(const Regression& regression, const Eigen::VectorXd& group_scale) {
  Eigen::VectorXd deviation = regression.relative_deviation;
  for (Eigen::Index r = 0; r < deviation.size(); ++r) deviation(r) *= group_scale(regression.group[r]);
  return deviation;
}

/// One weighted solution; `judge_rank` sets the rank. False if the rank is less than full.
bool solve(const Regression& regression, bool judge_rank, RegressionFit& fit) {
  const Eigen::VectorXd weight = fit.deviation.cwiseInverse();
  const Eigen::MatrixXd weighted = weight.asDiagonal() * regression.design;
  const numerics::PivotedQr qr = numerics::pivoted_qr(weighted, rank_tolerance);
  const Eigen::Index count = regression.design.cols();
  if (judge_rank) fit.rank = static_cast<int>(qr.rank);
  if (fit.rank < count) {
    fit.null_space = null_space(qr, fit.rank);
    return false;
  }
  const Eigen::MatrixXd inverse = qr.R.triangularView<Eigen::Upper>().solve(qr.Q.transpose());
  fit.influence = qr.P * inverse * weight.asDiagonal();
  fit.parameters = fit.influence * regression.measured;
  fit.residual = regression.measured - regression.design * fit.parameters;
  fit.leverage = qr.Q.rowwise().squaredNorm();
  fit.condition = std::abs(qr.R(0, 0) / qr.R(count - 1, count - 1));
  return true;
}

}  // namespace

RegressionFit fit(const Regression& regression) {
  RegressionFit fit;
  Eigen::VectorXd readings = group_sizes(regression, regression.measured);
  const double stand_in =
      readings.maxCoeff() > 0 ? (readings.array() > 0).select(readings, readings.maxCoeff()).minCoeff() : 1;
  readings = (readings.array() > 0).select(readings, stand_in);  // for a channel whose readings are all 0
  const Eigen::VectorXd floor = least_noise * readings;
  fit.group_scale = readings;
  constexpr int most_rounds = 60;
  constexpr double settled = 1e-4;  // of the noise: far below its own uncertainty
  fit.deviation = deviations(regression, fit.group_scale);
  for (int round = 0; round < most_rounds; ++round) {
    if (!solve(regression, round == 0, fit)) return fit;
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(regression.groups);
    fit.group_freedom = squares;
    for (Eigen::Index r = 0; r < fit.residual.size(); ++r) {
      const int g = regression.group[r];
      squares(g) += std::pow(fit.residual(r) / regression.relative_deviation(r), 2);
      fit.group_freedom(g) += 1 - fit.leverage(r);
    }
    const Eigen::VectorXd scale = (squares.array() / fit.group_freedom.array().max(1e-3)).sqrt().max(floor.array());
    const bool done = ((scale - fit.group_scale).array().abs() <= settled * scale.array()).all();
    fit.group_scale = scale;
    fit.deviation = deviations(regression, scale);
    if (done) break;
  }
  return fit;
}

double half_width(const Regression& regression, const RegressionFit& fit, const Eigen::RowVectorXd& functional,
                  double confidence) {
  const Eigen::RowVectorXd sensitivity = functional * fit.influence;
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(regression.groups);
  for (Eigen::Index r = 0; r < sensitivity.size(); ++r)
    variance(regression.group[r]) += std::pow(sensitivity(r) * fit.deviation(r), 2);
  const double total = variance.sum();
  if (total == 0) return 0;
  const double share = (variance / total).array().square().cwiseQuotient(fit.group_freedom.array().max(1e-3)).sum();
  return numerics::student_quantile(confidence, 1 / share) * std::sqrt(total);
}

Eigen::MatrixXd covariance(const RegressionFit& fit) {
  const Eigen::MatrixXd spread = fit.influence * fit.deviation.asDiagonal();
  return spread * spread.transpose();
}

namespace {

Basis basis(Unknowns unknowns, const Eigen::Vector3d& arm, const std::array<double, 2>& motion) {
  const int size = unknowns == Unknowns::self_balanced ? 6 : 12;
  Basis result;
  std::vector<double> units;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j) {
      Eigen::MatrixXd one = Eigen::MatrixXd::Zero(size, size);
      one(i, j) = one(j, i) = 1;
      result.matrices.push_back(size == 6 ? elements::from_moved_end(one, arm) : Matrix12(one));
      result.entry.push_back({12 - size + i, 12 - size + j});
      units.push_back(1 / (motion[i % 6 < 3 ? 0 : 1] * motion[j % 6 < 3 ? 0 : 1]));
    }
  result.unit = Eigen::Map<const Eigen::VectorXd>(units.data(), to_index(units.size()));
  return result;
}

/// Readings that a channel needs for a noise estimate from its own residuals; with fewer, forces share one noise and
/// moments another.
int readings_for_own_noise(Unknowns unknowns) { return unknowns == Unknowns::self_balanced ? 15 : 27; }

void group_by_noise(const StiffnessFitOptions& options, Rig& rig) {
  std::array<int, 12> count{};
  for (const auto& [load_case, channel] : rig.reading) ++count[channel];
  bool given = true, own = true;
  for (int c = 0; c < 12; ++c) {
    const int n = count[c];
    if (n == 0) continue;
    given = given && !std::isnan(options.standard_deviation(c));
    own = own && n >= readings_for_own_noise(options.unknowns);
  }
  Regression& regression = rig.regression;
  regression.groups = given ? 1 : own ? 12 : 2;
  for (Eigen::Index r = 0; r < regression.measured.size(); ++r) {
    const int channel = rig.reading[r][1];
    regression.relative_deviation(r) = given ? options.standard_deviation(channel) : 1;
    regression.group.push_back(given ? 0 : own ? channel : channel % 6 < 3 ? 0 : 1);
  }
}

}  // namespace

std::array<double, 2> typical_motion(const std::vector<LoadCase>& cases) {
  std::array<double, 2> squares{};
  for (const LoadCase& one : cases)
    for (int i = 0; i < 12; ++i)
      squares[i % 6 < 3 ? 0 : 1] += one.displacement(i) * one.displacement(i) / static_cast<double>(cases.size());
  for (double& square : squares) square = square > 0 ? std::sqrt(square) : 1;
  return squares;
}

Rig rig_regression(const std::vector<LoadCase>& cases, const Eigen::Vector3d& arm, const StiffnessFitOptions& options) {
  Rig rig;
  const auto motion = typical_motion(cases);
  rig.basis = basis(options.unknowns, arm, motion);
  for (std::size_t k = 0; k < cases.size(); ++k)
    for (int c = 0; c < 12; ++c)
      if (!std::isnan(cases[k].wrench(c))) rig.reading.push_back({static_cast<int>(k), c});
  if (options.zero_offsets)
    for (int c = 0; c < 12; ++c)
      if (std::ranges::any_of(rig.reading, [&](const auto& r) { return r[1] == c; })) rig.offset_channel.push_back(c);

  const auto rows = to_index(rig.reading.size()), constants = rig.basis.unit.size();
  Regression& regression = rig.regression;
  regression.design = Eigen::MatrixXd::Zero(rows, constants + to_index(rig.offset_channel.size()));
  regression.measured.resize(rows);
  regression.relative_deviation.resize(rows);
  for (Eigen::Index r = 0; r < rows; ++r) {
    const auto [k, c] = rig.reading[r];
    const LoadCase& one = cases[k];
    regression.measured(r) = one.wrench(c);
    for (Eigen::Index p = 0; p < constants; ++p)
      regression.design(r, p) = rig.basis.unit(p) * rig.basis.matrices[p].row(c).dot(one.displacement);
    for (std::size_t o = 0; o < rig.offset_channel.size(); ++o)
      if (rig.offset_channel[o] == c) regression.design(r, constants + to_index(o)) = 1 / motion[c % 6 < 3 ? 0 : 1];
  }
  group_by_noise(options, rig);
  return rig;
}

namespace {

/// A reading with nearly full leverage determines a constant alone: no other reading can contradict it.
constexpr double judged_below_leverage = 1 - 1e-6;

Contradiction worst(const Regression& regression, const RegressionFit& fit, double risk) {
  Contradiction found;
  Eigen::VectorXd limits = Eigen::VectorXd::Zero(regression.groups);
  for (int g = 0; g < regression.groups; ++g)
    if (fit.group_freedom(g) >= 2)
      limits(g) =
          numerics::student_quantile(1 - risk / static_cast<double>(fit.residual.size()), fit.group_freedom(g) - 1);
  for (Eigen::Index r = 0; r < fit.residual.size(); ++r) {
    const int group = regression.group[r];
    const double freedom = fit.group_freedom(group) - 1, limit = limits(group);
    if (fit.leverage(r) > judged_below_leverage || limit == 0) continue;
    const double internal = fit.residual(r) / (fit.deviation(r) * std::sqrt(1 - fit.leverage(r)));
    const double left =
        std::max(freedom + 1 - internal * internal, 1e-9 * freedom);  // share of the noise from the others
    const double external = internal * std::sqrt(freedom / left);
    if (std::abs(external) / limit > (found.limit > 0 ? std::abs(found.studentised) / found.limit : 0))
      found = {r, fit.residual(r) / (1 - fit.leverage(r)), external, limit};
  }
  return found;
}

void drop(Regression& regression, Eigen::Index reading) {
  const Eigen::Index left = regression.measured.size() - 1, below = left - reading;
  regression.design.middleRows(reading, below) = regression.design.bottomRows(below).eval();
  regression.measured.segment(reading, below) = regression.measured.tail(below).eval();
  regression.relative_deviation.segment(reading, below) = regression.relative_deviation.tail(below).eval();
  regression.design.conservativeResize(left, Eigen::NoChange);
  regression.measured.conservativeResize(left);
  regression.relative_deviation.conservativeResize(left);
  regression.group.erase(regression.group.begin() + reading);
}

}  // namespace

std::vector<Contradiction> contradictions(Regression regression, double risk) {
  std::vector<Contradiction> found;
  std::vector<Eigen::Index> name(to_size(regression.measured.size()));
  std::iota(name.begin(), name.end(), Eigen::Index{0});
  const std::size_t most = name.size() / 10;
  while (found.size() < most) {
    const RegressionFit current = fit(regression);
    if (current.null_space.cols() > 0) break;
    Contradiction next = worst(regression, current, risk);
    if (next.limit == 0 || std::abs(next.studentised) <= next.limit) break;
    drop(regression, next.reading);
    const Eigen::Index place = next.reading;
    next.reading = name[place];
    name.erase(name.begin() + place);
    found.push_back(next);
  }
  return found;
}

}  // namespace trivet::identification

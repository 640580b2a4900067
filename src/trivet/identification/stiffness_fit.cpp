// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/identification/stiffness_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/elements/checks.h"
#include "trivet/elements/law.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/plain_text.h"
#include "trivet/identification/load_cases.h"
#include "trivet/identification/rig_regression.h"

namespace trivet::identification {
namespace {

Eigen::MatrixXd motions(const std::vector<LoadCase>& cases, const Eigen::Vector3d& arm, Unknowns unknowns) {
  Eigen::MatrixXd all(12, to_index(cases.size()));
  for (std::size_t k = 0; k < cases.size(); ++k) all.col(to_index(k)) = cases[k].displacement;
  if (unknowns == Unknowns::full_symmetric) return all;
  // Motion of K relative to the rigid motion of N; it equals the wrench at K of a unit block.
  return elements::from_moved_end(Matrix6::Identity(), arm).bottomRows<6>() * all;
}

/// Channels that were never measured, at ends where others were.
std::vector<std::string> missing_channels(const Rig& rig) {
  const auto measured = [&](int first, int end) {
    return std::ranges::any_of(rig.reading, [&](const auto& r) { return r[1] >= first && r[1] < end; });
  };
  std::vector<std::string> missing;
  for (int c = 0; c < 12; ++c)
    if (measured(c < 6 ? 0 : 6, c < 6 ? 6 : 12) && !measured(c, c + 1))
      missing.push_back(channel_words(c) + " was not measured");
  return missing;
}

/// Error that states why the readings do not determine every constant.
foundation::Problems rank_problems(const std::vector<LoadCase>& cases, const Eigen::Vector3d& arm, const Rig& rig,
                                   const RegressionFit& fit, Unknowns unknowns) {
  constexpr double seen = 1e-6;  // share of a constant in what the readings do not determine
  foundation::Problems problems;
  std::vector<std::string> reasons = unexcited_motions(motions(cases, arm, unknowns)), unknown;
  if (reasons.empty()) reasons = missing_channels(rig);
  for (std::size_t p = 0; p < rig.basis.entry.size(); ++p)
    if (fit.null_space.row(to_index(p)).cwiseAbs().maxCoeff() > seen)
      unknown.push_back(
          fmt::format("({}, {})", coordinate_words(rig.basis.entry[p][0]), coordinate_words(rig.basis.entry[p][1])));
  for (std::size_t o = 0; o < rig.offset_channel.size(); ++o)
    if (fit.null_space.row(rig.basis.unit.size() + to_index(o)).cwiseAbs().maxCoeff() > seen)
      unknown.push_back("the zero offset of " + channel_words(rig.offset_channel[o]));
  problems.error(
      "load_cases",
      fmt::format("{} readings determine {} of {} constants: {}", rig.regression.measured.size(), fit.rank,
                  rig.regression.design.cols(),
                  reasons.empty() ? "the readings depend on each other" : foundation::comma_separated(reasons)),
      "every constant must affect a reading; not determined: " + foundation::comma_separated(unknown),
      unknowns == Unknowns::self_balanced ? "add load cases with these motions, or measure these channels"
                                          : "add load cases with these motions at both ends, "
                                            "or identify the 21 constants of a self-balanced element");
  return problems;
}

void check(const StiffnessFitOptions& options, const Eigen::Vector3d& arm) {
  const auto fraction = [](const char* name, double value) {
    if (!(value > 0 && value < 1))
      throw foundation::InvalidInput(fmt::format("{} = {}, must be between 0 and 1", name, value));
  };
  fraction("confidence", options.confidence);
  fraction("outlier_risk", options.outlier_risk);
  for (int c = 0; c < 12; ++c)
    if (!std::isnan(options.standard_deviation(c)) &&
        !(options.standard_deviation(c) > 0 && std::isfinite(options.standard_deviation(c))))
      throw foundation::InvalidInput(
          fmt::format("standard deviation of {} = {}, must be > 0", channel_words(c), options.standard_deviation(c)));
  if (!arm.allFinite()) throw foundation::InvalidInput("arm from N to K, must be finite");
}

/// Half-width of a linear function of the constants, given by its value for each basis matrix.
template <typename Function>
double width(const Rig& rig, const RegressionFit& fit, double confidence, const Function& of_matrix) {
  Eigen::RowVectorXd functional = Eigen::RowVectorXd::Zero(rig.regression.design.cols());
  for (std::size_t p = 0; p < rig.basis.matrices.size(); ++p) {
    const auto column = to_index(p);
    functional(column) = rig.basis.unit(column) * of_matrix(rig.basis.matrices[p]);
  }
  return half_width(rig.regression, fit, functional, confidence);
}

void fill_matrix(const Rig& rig, const RegressionFit& fit, const Eigen::Vector3d& arm,
                 const StiffnessFitOptions& options, StiffnessFit& result) {
  const Eigen::Index constants = rig.basis.unit.size();
  Eigen::VectorXd values = fit.parameters.head(constants).cwiseProduct(rig.basis.unit);
  result.stiffness.setZero();
  for (Eigen::Index p = 0; p < constants; ++p) result.stiffness += values(p) * rig.basis.matrices[p];
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j <= i; ++j)
      result.half_width(i, j) = result.half_width(j, i) =
          width(rig, fit, options.confidence, [&](const Matrix12& m) { return m(i, j); });
  result.covariance =
      rig.basis.unit.asDiagonal() * covariance(fit).topLeftCorner(constants, constants) * rig.basis.unit.asDiagonal();

  const Eigen::Matrix<double, 12, 6> rigid = elements::rigid_motions(arm, Eigen::Matrix3d::Identity());
  const elements::MatrixVerdict verdict = elements::examine(result.stiffness, rigid);
  result.rigid_residual = verdict.residual;
  result.scaled_rigid_residual = verdict.rigid_residual;
  result.lowest_eigenvalue = verdict.lowest_eigenvalue;
  result.rigid_residual_half_width.setZero();
  if (options.unknowns == Unknowns::full_symmetric)
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 6; ++j)
        result.rigid_residual_half_width(i, j) =
            width(rig, fit, options.confidence, [&](const Matrix12& m) { return m.row(i).dot(rigid.col(j)); });
}

void fill_readings(const Rig& rig, const RegressionFit& fit, const std::array<double, 2>& motion,
                   StiffnessFit& result) {
  result.noise.setConstant(std::numeric_limits<double>::quiet_NaN());
  result.offset.setConstant(std::numeric_limits<double>::quiet_NaN());
  for (Eigen::Index r = 0; r < fit.residual.size(); ++r) {
    const auto [k, c] = rig.reading[r];
    const double spread = fit.deviation(r) * std::sqrt(std::max(0.0, 1 - fit.leverage(r)));
    result.readings.push_back({k, c, rig.regression.measured(r), rig.regression.measured(r) - fit.residual(r),
                               fit.residual(r), fit.leverage(r) < 1 - 1e-6 && spread > 0 ? fit.residual(r) / spread : 0,
                               fit.leverage(r)});
    result.noise(c) = fit.deviation(r);
    result.offset(c) = 0;
  }
  for (std::size_t o = 0; o < rig.offset_channel.size(); ++o) {
    const int c = rig.offset_channel[o];
    result.offset(c) = fit.parameters(rig.basis.unit.size() + to_index(o)) / motion[c % 6 < 3 ? 0 : 1];
  }
  result.degrees_of_freedom = fit.group_freedom.sum();
  result.condition = fit.condition;
}

void warn(const std::vector<LoadCase>& cases, const StiffnessFitOptions& options, StiffnessFit& result) {
  for (const Outlier& outlier : result.outliers)
    result.warnings.warning(
        fmt::format("load case '{}'", cases[outlier.load_case].name),
        fmt::format("{} deviates by {:.4g} {} from the prediction of the other readings ({:.1f} standard deviations)",
                    channel_words(outlier.channel), outlier.deviation, outlier.channel % 6 < 3 ? "N" : "N m",
                    outlier.studentised),
        fmt::format("a good data set of {} readings stays below {:.1f} with {:.3g} % probability",
                    result.readings.size(), outlier.limit, 100 * (1 - options.outlier_risk)),
        "check the raw data; the reading is still used in the fit");
  for (int i = 0; i < 12; ++i)
    if (result.stiffness(i, i) < -result.half_width(i, i))
      result.warnings.warning("load_cases",
                              fmt::format("the stiffness of {} is {:.4g}", coordinate_words(i), result.stiffness(i, i)),
                              "without preload a diagonal stiffness must be > 0",
                              "check the sign: a wrench is what the rig exerts on the element");
  std::vector<std::string> vague;
  for (int i = 0; i < 12; ++i)
    if (result.half_width(i, i) > std::abs(result.stiffness(i, i))) vague.push_back(coordinate_words(i));
  if (!vague.empty())
    result.warnings.warning(
        "load_cases", "the stiffness of " + foundation::comma_separated(vague) + " is smaller than its uncertainty",
        fmt::format("its {:.3g} % interval contains 0", 100 * options.confidence),
        "move these coordinates more, or measure with less noise");
  if (result.lowest_eigenvalue <
      -elements::rounding_of_data - 2 * std::min(result.scaled_rigid_residual, elements::refused_residual))
    result.warnings.warning(
        "load_cases", fmt::format("the scaled matrix has the eigenvalue {:.4g}", result.lowest_eigenvalue),
        "a passive element has no negative eigenvalue",
        "reduce the noise or add load cases; nearest_semidefinite gives the nearest passive matrix");
}

}  // namespace

foundation::Expected<StiffnessFit> identified_stiffness(const std::vector<LoadCase>& cases, const Eigen::Vector3d& arm,
                                                        const StiffnessFitOptions& options) {
  check(options, arm);
  foundation::Problems problems = load_case_problems(cases);
  if (problems.has_errors()) return tl::make_unexpected(std::move(problems));
  const Rig rig = rig_regression(cases, arm, options);
  const RegressionFit fitted = fit(rig.regression);
  if (fitted.null_space.cols() > 0)
    return tl::make_unexpected(rank_problems(cases, arm, rig, fitted, options.unknowns));
  if (rig.regression.measured.size() == rig.regression.design.cols()) {
    problems.error("load_cases", fmt::format("{} readings for as many constants", rig.regression.measured.size()),
                   "noise and intervals need more readings than constants", "repeat load cases or add some");
    return tl::make_unexpected(std::move(problems));
  }

  StiffnessFit result;
  result.warnings = std::move(problems);
  fill_matrix(rig, fitted, arm, options, result);
  fill_readings(rig, fitted, typical_motion(cases), result);
  for (const Contradiction& one : contradictions(rig.regression, options.outlier_risk)) {
    const auto [k, c] = rig.reading[one.reading];
    result.outliers.push_back({k, c, one.deviation, one.studentised, one.limit});
  }
  const Vector12 diagonal = result.stiffness.diagonal();
  const bool resists = diagonal.head<3>().sum() + diagonal.segment<3>(6).sum() > 0 &&
      diagonal.segment<3>(3).sum() + diagonal.tail<3>().sum() > 0;
  if (options.nearest_semidefinite && resists) result.semidefinite = nearest_semidefinite(result.stiffness, arm);
  warn(cases, options, result);
  return result;
}

}  // namespace trivet::identification

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/pole_residue.h"
#include "trivet/numerics/roots/root_table.h"

namespace trivet::numerics {
namespace {

constexpr double tolerance = 1e-11;
/// Roots that nearly coincide have large residues of opposite sign: sums lose at most this factor in accuracy.
constexpr double most_cancellation = 1e4;
/// Least decay rate relative to the fastest pole: below it, round-off of the eigensolver (in units of that pole)
/// affects the height of a peak.
constexpr double least_decay = 1e-5;
/// Round-off of sums over these roots is `margin` times the error of the sum rules, which may be small by chance.
constexpr double margin = 10, least_round_off = 2e-15;

/// Sum rules Σ r = 0, Σ λr = A⁻¹h and Σ r/λ = −K⁻¹h: a root that is missing, found twice or too close to another
/// violates one of them.
/// @return the largest error of these sums relative to their terms; infinite if the terms cancel too much
double missed_sums(const DynamicMatrices& m, const Eigen::VectorXd& load, const Eigen::VectorXcd& poles,
                   const Eigen::MatrixXcd& r) {
  const Eigen::VectorXd acceleration = cholesky_solution(m.A, load), displacement = -cholesky_solution(m.K, load);
  const Eigen::VectorXd weight = m.A.diagonal().cwiseSqrt();  // makes metres and radians comparable
  const auto share = [&](const Eigen::VectorXcd& factor, const Eigen::VectorXd& sum) {
    const Eigen::VectorXcd missed = weight.asDiagonal() * (r * factor - sum.cast<Complex>());
    const double size = weight.cwiseProduct((r * factor.asDiagonal()).cwiseAbs().rowwise().sum()).maxCoeff(),
                 weighed = weight.cwiseProduct(sum).norm();
    const double part = missed.cwiseAbs().maxCoeff() / size;
    return (weighed > 0 && size > most_cancellation * weighed) || !std::isfinite(part)
        ? std::numeric_limits<double>::infinity()
        : part;
  };
  return std::max({share(Eigen::VectorXcd::Ones(poles.size()), Eigen::VectorXd::Zero(load.size())),
                   share(poles, acceleration), share(poles.cwiseInverse(), displacement)});
}

}  // namespace

bool roots_of_states(const DynamicMatrices& m, const Eigen::VectorXd& load, RootTable& table, int lane) {
  const Eigen::Index n = m.size();
  PoleResidueForm form;
  try {
    form = pole_residue_form(m, load.cast<Complex>());
  } catch (const foundation::NotComputable&) {
    return false;
  }
  if (form.poles.size() != 2 * n || !(form.poles.real().array() < 0).all() || !form.shapes.allFinite()) return false;
  if (form.poles.real().cwiseAbs().minCoeff() < least_decay * form.poles.cwiseAbs().maxCoeff()) return false;
  const Eigen::MatrixXcd r = form.shapes * form.participation.col(0).asDiagonal();
  const double missed = missed_sums(m, load, form.poles, r);
  if (!(missed <= tolerance)) return false;
  table.coordinates = static_cast<int>(n);
  for (int j = 0; j < table.coordinates; ++j) table.mass[j][lane] = m.A(j, j);
  table.round_off[lane] = std::max(least_round_off, margin * missed);
  std::vector<Eigen::Index> turning, real;
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    if (form.poles(k).imag() > 0) turning.push_back(k);
    if (form.poles(k).imag() == 0) real.push_back(k);
  }
  if (turning.size() + real.size() / 2 != to_size(n)) return false;
  std::ranges::sort(real, [&](Eigen::Index a, Eigen::Index b) { return form.poles(a).real() > form.poles(b).real(); });
  for (int pair = 0; pair < n; ++pair) {
    const auto turns = static_cast<int>(turning.size());
    const bool is_real = pair >= turns;
    const Eigen::Index one = is_real ? real[2 * (pair - turns)] : turning[pair];
    const Eigen::Index two = is_real ? real[2 * (pair - turns) + 1] : one;
    table.real[pair][lane] = is_real;
    table.first[pair][lane] = form.poles(one).real();
    table.second[pair][lane] = is_real ? form.poles(two).real() : form.poles(one).imag();
    for (int j = 0; j < n; ++j) {
      table.r_first[pair][j][lane] = r(j, one).real();
      table.r_second[pair][j][lane] = is_real ? r(j, two).real() : r(j, one).imag();
    }
  }
  return true;
}

}  // namespace trivet::numerics

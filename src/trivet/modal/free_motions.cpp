// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/modal/free_motions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "trivet/foundation/index.h"
#include "trivet/modal/motion_words.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/linalg/eigenvalues.h"
#include "trivet/numerics/linalg/reduced_echelon.h"
#include "trivet/spatial/rigid_motion.h"

namespace trivet::modal {

namespace {

/// Gram–Schmidt, twice: the columns may be almost parallel.
void make_orthonormal(Eigen::MatrixXcd& x) {
  for (int round = 0; round < 2; ++round)
    for (Eigen::Index j = 0; j < x.cols(); ++j) {
      for (Eigen::Index i = 0; i < j; ++i) x.col(j) -= x.col(i).dot(x.col(j)) * x.col(i).eval();
      x.col(j).normalize();
    }
}

Eigen::MatrixXcd right_null_vectors(const Eigen::MatrixXcd& z, Eigen::Index count) {
  assert(z.rows() == z.cols() && count > 0 && count <= z.rows());
  if (count == z.rows()) return Eigen::MatrixXcd::Identity(count, count);  // z is nothing but round-off, or exactly 0
  const double shift = 4 * std::numeric_limits<double>::epsilon() * z.cwiseAbs().maxCoeff();
  const Eigen::MatrixXcd regular = z + shift * Eigen::MatrixXcd::Identity(z.rows(), z.cols());
  const numerics::PivotedLu<std::complex<double>> lu(regular);
  // A start that no symmetry of a machine makes orthogonal to what is searched.
  Eigen::MatrixXcd x(z.rows(), count);
  for (Eigen::Index j = 0; j < count; ++j)
    for (Eigen::Index i = 0; i < z.rows(); ++i)
      x(i, j) = 1 + 0.3 * std::cos(static_cast<double>((i + 1) * (j + 1)) * 1.7 + static_cast<double>(j));
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    make_orthonormal(x);
    x = lu.solve(x);
  }
  make_orthonormal(x);
  return x;
}

}  // namespace

NullVectors null_vectors(const Eigen::MatrixXcd& Z, const Eigen::VectorXd& scale, Eigen::Index count) {
  const Eigen::MatrixXcd scaled = scale.asDiagonal() * Z * scale.asDiagonal(), transposed = scaled.transpose();
  return {scale.asDiagonal() * right_null_vectors(transposed, count),
          scale.asDiagonal() * right_null_vectors(scaled, count)};
}

namespace {

using Matrix6x = Eigen::Matrix<double, 6, Eigen::Dynamic>;

Eigen::Vector3d centre_of_all(const model::System& system) {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double mass = 0;
  for (const auto& body : system.bodies()) {
    moment += body.mass.mass * (body.pose.position + body.pose.rotation * body.mass.centre);
    mass += body.mass.mass;
  }
  assert(mass != 0 && "a machine has a body");
  return moment / mass;
}

/// Coordinates of the bodies (6 rows per body) in a rigid motion of the whole system about `about`, ground axes.
Eigen::MatrixXd whole_motions(const model::System& system, const Eigen::Vector3d& about) {
  Eigen::MatrixXd g(6 * to_index(system.bodies().size()), 6);
  for (std::size_t b = 0; b < system.bodies().size(); ++b) {
    const spatial::Pose& pose = system.bodies()[b].pose;
    g.middleRows<6>(6 * to_index(b)) =
        spatial::both_blocks(pose.rotation).transpose() * spatial::rigid_motion(pose.position - about);
  }
  return g;
}

/// Rigid motions of the whole system that neither constraints nor elements resist, one per column (reduced echelon
/// form).
Matrix6x unresisted_motions(const model::System& system, const assembly::Assembled& assembled,
                            const Eigen::MatrixXd& motions) {
  spatial::Matrix6 resistance = spatial::Matrix6::Zero();
  Eigen::MatrixXd free_rows = Eigen::MatrixXd::Zero(assembled.layout.size(), 6);
  for (std::size_t b = 0; b < system.bodies().size(); ++b)
    for (int j = 0; j < 6; ++j) {
      const Eigen::RowVectorXd row = motions.row(6 * to_index(b) + j);
      if (assembled.layout.row(b, j) >= 0) free_rows.row(assembled.layout.row(b, j)) = row;
      else if (system.bodies()[b].is_constrained(to_size(j))) resistance += row.transpose() * row;
    }
  const Eigen::VectorXd d = numerics::unit_scale(assembled.matrices);
  const Eigen::MatrixXd force = d.asDiagonal() * assembled.matrices.K * free_rows;
  const double scale = (d.asDiagonal() * assembled.matrices.K.cwiseAbs() * free_rows.cwiseAbs()).maxCoeff();
  if (scale > 0) resistance += (force / scale).transpose() * (force / scale);
  const numerics::SymmetricEigen<spatial::Matrix6> eigen = numerics::symmetric_eigen(resistance);
  Eigen::Index count = 0;
  while (count < 6 && eigen.values(count) < 1e-20) ++count;
  const Eigen::MatrixXd basis = eigen.vectors.leftCols(count).transpose();
  return numerics::reduced_echelon(basis).transpose();
}

std::string whole_words(const spatial::Vector6& motion, const Eigen::Vector3d& about) {
  spatial::Screw screw = spatial::screw({motion.head<3>(), motion.tail<3>()}, 1, Eigen::Vector3d::Zero());
  screw.point += about;
  std::string words = motion_words(screw, 1);
  if (words.starts_with("translation"))
    return "the system is free to slide" + words.substr(std::string("translation").size());
  if (words.starts_with("rotation")) return "the system is free to turn" + words.substr(std::string("rotation").size());
  return "the system is free in a " + words;
}

}  // namespace

std::vector<std::string> free_motions(const model::System& system, const assembly::Assembled& assembled,
                                      const Modes& modes) {
  std::vector<std::string> words;
  std::vector<const Mode*> rigid;
  for (const Mode& mode : modes.list)
    if (mode.eigenvalue_squared == 0) rigid.push_back(&mode);
  if (rigid.empty()) return words;

  const Eigen::Vector3d about = centre_of_all(system);
  const Eigen::MatrixXd motions = whole_motions(system, about);
  const Matrix6x whole = unresisted_motions(system, assembled, motions);
  assert(whole.cols() <= 6 && whole.allFinite());
  for (Eigen::Index i = 0; i < whole.cols(); ++i) words.push_back(whole_words(whole.col(i), about));

  if (words.size() < rigid.size()) {
    constexpr std::size_t most_named = 6;
    std::string parts;
    std::size_t moving = 0;
    for (std::size_t b = 0; b < system.bodies().size(); ++b) {
      const bool moves = std::ranges::any_of(rigid, [&](const Mode* mode) {
        return mode->principal_kinetic_energy_share.segment<6>(6 * to_index(b)).cwiseAbs().sum() > 1e-9;
      });
      if (moves && ++moving <= most_named) parts += (parts.empty() ? "" : ", ") + system.bodies()[b].name;
    }
    if (moving > most_named) parts += fmt::format(" and {} more bodies", moving - most_named);
    const std::size_t more = rigid.size() - words.size();
    words.push_back(fmt::format("{}{} that no element resists{}: {} move{}", more,
                                more == 1 ? " rigid-body mode" : " rigid-body modes",
                                words.empty() ? "" : ", in addition", parts, moving == 1 ? "s" : ""));
  }
  return words;
}

}  // namespace trivet::modal

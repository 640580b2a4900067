// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "trivet/assembly/layout.h"
#include "trivet/foundation/index.h"
#include "trivet/model/system.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::assembly {

/// Map from the global coordinates to those of an element (12 end displacements in its local frame, then its internal
/// coordinates): Tᵀ, nonzero columns only.
struct ElementMap {
  std::vector<Eigen::Index> rows;         ///< global rows of the columns of `ends`
  Eigen::MatrixXd ends;                   ///< (12 + internal) × rows.size()
  std::vector<Eigen::Index> ground_rows;  ///< ground coordinates that move its ends, see Ground
  Eigen::MatrixXd ground_ends;            ///< (12 + internal) × ground_rows.size()
  Eigen::MatrixXd
      followed_ends;  ///< (12 + internal) × Ground::followed(): their motion when everything moves with the ground
  bool resists_following = true;  ///< false: that motion causes no force at any ω
  elements::Matrices matrices;    ///< as assembled, with its scale and what forces at rest add to the stiffness
  elements::Matrix12 of_forces_at_rest = elements::Matrix12::Zero();  ///< that addition
  /// D(ω), 12×12, if the matrices are not exact; the columns of `ends` that belong to the ends come first.
  std::function<elements::Matrix12c(std::complex<double> omega, double near)> dynamic_stiffness;
  Eigen::Index end_columns = 0;
  double defined_from = 0, defined_to = std::numeric_limits<double>::infinity();  ///< range of D(ω) [rad/s]
  std::vector<double> knots;                                                      ///< of a tabulated D(ω) [rad/s]

  [[nodiscard]] bool frequency_dependent() const { return static_cast<bool>(dynamic_stiffness); }

  /// End displacements and internal coordinates for a global vector.
  template <typename Vector>
  [[nodiscard]] Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1> coordinates(const Vector& q) const {
    Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1> d =
        Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1>::Zero(ends.rows());
    for (Eigen::Index j = 0; j < ends.cols(); ++j)
      d += ends.col(j).template cast<typename Vector::Scalar>() * q(rows[j]);
    return d;
  }
  /// Contribution of a ground motion g; a motion that everything follows counts only if it causes forces.
  template <typename Vector>
  [[nodiscard]] Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1> moved_by_ground(const Vector& g) const {
    Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1> d =
        Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1>::Zero(ends.rows());
    for (Eigen::Index j = 0; j < ground_ends.cols(); ++j)
      d += ground_ends.col(j).template cast<typename Vector::Scalar>() * g(ground_rows[j]);
    if (resists_following) d += followed_ends.template cast<typename Vector::Scalar>() * g.tail(followed_ends.cols());
    return d;
  }
};

/// An end on the ground, and its first ground coordinate.
struct GroundEnd {
  std::size_t element = 0;
  spatial::Pose pose;  ///< ground frame
  Eigen::Index first_row = 0;
};

/// The driven coordinates g, all in ground axes: (1) six of the rigid foundation about the ground origin; (2) six of
/// each ground end about its own reference point, in addition to (1); (3) six for each group of ends that moves
/// together. A load that drives (3) has free coordinates relative to R g. All enter the rows of the free coordinates:
/// Z q = Q − (K + iωB − ω²A) g. In the columns of (3), the stiffness of a part that moves freely with the ground is
/// zero, not the difference of equal terms (following.h).
struct Ground {
  std::vector<GroundEnd> ends;
  /// First rows of coordinates that move together: the rigid foundation, then, per excitation given by velocity or
  /// acceleration, the ground ends that it moves.
  std::vector<std::vector<Eigen::Index>> together = {{0}};
  Eigen::MatrixXd A, B, K;  ///< free coordinates × ground coordinates, without frequency-dependent elements
  Eigen::MatrixXd K_loss;   ///< empty if there is no loss factor
  Eigen::MatrixXd R;        ///< free coordinates × followed(): their static motion with the ground
  Eigen::Array<bool, Eigen::Dynamic, 1> rigid;  ///< per column of R: a rigid motion, not one computed with K⁻¹
  Eigen::ArrayXd round_off;                     ///< of a row times each column of R, as a share of the terms

  [[nodiscard]] Eigen::Index followed_row() const {
    return 6 + 6 * to_index(ends.size());
  }  ///< first row of the followed coordinates
  [[nodiscard]] Eigen::Index followed() const { return 6 * to_index(together.size()); }  ///< their number
  [[nodiscard]] Eigen::Index size() const { return followed_row() + followed(); }
  /// Sums the columns in space over all that moves together: one column per followed coordinate.
  template <typename Matrix>
  [[nodiscard]] Matrix gathered(const Matrix& of_ground) const {
    Matrix result = Matrix::Zero(of_ground.rows(), followed());
    for (std::size_t t = 0; t < together.size(); ++t)
      for (const Eigen::Index row : together[t]) result.middleCols(6 * to_index(t), 6) += of_ground.middleCols(row, 6);
    return result;
  }
};

/// A q̈ + B q̇ + K q = Q of the whole system, in its free coordinates, with the maps to bodies and elements.
struct Assembled {
  Layout layout;
  numerics::DynamicMatrices
      matrices;  ///< of the whole system; frequency-dependent elements by their nearest linear system
  std::vector<ElementMap> elements;
  numerics::DynamicMatrices
      constant;  ///< without the frequency-dependent elements, first rows of `layout`; empty if there are none
  Ground ground;
  /// Part of K that no element has: the points of bodies at which forces act at rest move on circles.
  Eigen::MatrixXd of_levers;
  /// The machine without the second-order effect of its forces at rest; null if it has none.
  std::shared_ptr<const Assembled> without_second_order;
  std::vector<std::size_t> without_rest;  ///< bodies whose weight nothing holds: first order
  bool hangs_aside = false;  ///< the forces at rest are those of a hung body that swings aside: no sums over elements

  [[nodiscard]] const Assembled& first_order() const { return without_second_order ? *without_second_order : *this; }
  [[nodiscard]] bool frequency_dependent() const { return constant.size() > 0; }
  /// Adds the contribution of the frequency-dependent elements to Z(ω), first rows of `layout`.
  void add_frequency_dependent(std::complex<double> omega, double near, Eigen::MatrixXcd& z) const;
  /// Exact Z(ω) in the first rows of `layout`, also for complex ω; the real frequency `near` selects the table segment.
  [[nodiscard]] Eigen::MatrixXcd dynamic_stiffness(std::complex<double> omega, double near) const;
};

/// K = Σ T C_e Tᵀ; B and A in the same way, plus the bodies and the damping of the system. Under gravity with the
/// effect of the forces at rest (SecondOrder).
[[nodiscard]] Assembled assemble(const model::System& system);
/// The same without this effect, except of preloads: for positions of rest.
[[nodiscard]] Assembled assemble_first_order(const model::System& system);

}  // namespace trivet::assembly

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "trivet/assembly/layout.h"
#include "trivet/model/system.h"
#include "trivet/numerics/linalg/dynamic_matrices.h"

namespace trivet::assembly {

/// How an element (12 end displacements in its local frame, then its internal coordinates) follows the global
/// coordinates: Tᵀ, a few columns only.
struct ElementMap {
  std::vector<Eigen::Index> rows;         ///< global rows of the columns of `ends`
  Eigen::MatrixXd ends;                   ///< (12 + internal) × rows.size()
  std::vector<Eigen::Index> ground_rows;  ///< ground coordinates that move its ends, see Ground
  Eigen::MatrixXd ground_ends;            ///< (12 + internal) × ground_rows.size()
  Eigen::MatrixXd
      followed_ends;  ///< (12 + internal) × Ground::followed(): how they move when everything follows the ground
  bool resists_following = true;  ///< false: no force at any ω comes of that
  elements::Matrices matrices;    ///< as assembled, scale included
  /// D(ω), 12×12, where the matrices are not exact; the columns of `ends` that belong to the ends come first.
  std::function<elements::Matrix12c(std::complex<double> omega, double near)> dynamic_stiffness;
  Eigen::Index end_columns = 0;
  double defined_from = 0, defined_to = std::numeric_limits<double>::infinity();  ///< of D(ω) [rad/s]
  std::vector<double> knots;                                                      ///< of a tabulated D(ω) [rad/s]

  [[nodiscard]] bool frequency_dependent() const { return static_cast<bool>(dynamic_stiffness); }

  /// End displacements and internal coordinates for a global vector.
  template <typename Vector>
  [[nodiscard]] Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1> coordinates(const Vector& q) const {
    Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1> d =
        Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1>::Zero(ends.rows());
    for (Eigen::Index j = 0; j < ends.cols(); ++j)
      d += ends.col(j).template cast<typename Vector::Scalar>() * q(rows[static_cast<std::size_t>(j)]);
    return d;
  }
  /// What a motion of the ground adds to them; one that everything follows counts only where it brings forces.
  template <typename Vector>
  [[nodiscard]] Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1> moved_by_ground(const Vector& g) const {
    Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1> d =
        Eigen::Matrix<typename Vector::Scalar, Eigen::Dynamic, 1>::Zero(ends.rows());
    for (Eigen::Index j = 0; j < ground_ends.cols(); ++j)
      d += ground_ends.col(j).template cast<typename Vector::Scalar>() * g(ground_rows[static_cast<std::size_t>(j)]);
    if (resists_following) d += followed_ends.template cast<typename Vector::Scalar>() * g.tail(followed_ends.cols());
    return d;
  }
};

/// An end that stands on the ground, and its first ground coordinate.
struct GroundEnd {
  std::size_t element = 0;
  spatial::Pose pose;  ///< ground frame
  Eigen::Index first_row = 0;
};

/// The driven coordinates g: six of one rigid foundation about the ground origin, then six of each ground end about its
/// own reference point (all in ground axes; they add up), and at last, for what moves together, six again for free
/// coordinates that follow it: driven by those, they count from R g. What all these bring into the rows of the free
/// coordinates: Z q = Q − (K + iωB − ω²A) g. In the columns that are followed, the stiffness of whatever follows freely
/// is zero, not the difference of equal terms (following.h).
struct Ground {
  std::vector<GroundEnd> ends;
  /// First rows of coordinates that move together: the rigid foundation, then the ground ends of each excitation that
  /// gives velocities or accelerations of some of them.
  std::vector<std::vector<Eigen::Index>> together = {{0}};
  Eigen::MatrixXd A, B, K;  ///< free coordinates × ground coordinates, without frequency-dependent elements
  Eigen::MatrixXd K_loss;   ///< empty if there is no loss factor
  Eigen::MatrixXd R;        ///< free coordinates × followed(): how they follow at rest
  Eigen::Array<bool, Eigen::Dynamic, 1> rigid;  ///< of each column of R: rigidly, and not as K⁻¹ says
  Eigen::ArrayXd round_off;                     ///< of what each column of R makes of a row, as a share of the terms

  [[nodiscard]] Eigen::Index followed_row() const {
    return 6 + 6 * static_cast<Eigen::Index>(ends.size());
  }  ///< first of the last coordinates
  [[nodiscard]] Eigen::Index followed() const {
    return 6 * static_cast<Eigen::Index>(together.size());
  }  ///< how many these are
  [[nodiscard]] Eigen::Index size() const { return followed_row() + followed(); }
  /// Columns in space, added up over what moves together: one for each followed coordinate.
  template <typename Matrix>
  [[nodiscard]] Matrix gathered(const Matrix& of_ground) const {
    Matrix result = Matrix::Zero(of_ground.rows(), followed());
    for (std::size_t t = 0; t < together.size(); ++t)
      for (const Eigen::Index row : together[t])
        result.middleCols(6 * static_cast<Eigen::Index>(t), 6) += of_ground.middleCols(row, 6);
    return result;
  }
};

/// A q̈ + B q̇ + K q = Q of the whole system, in its free coordinates, with the way back to bodies and elements.
struct Assembled {
  Layout layout;
  numerics::DynamicMatrices matrices;  ///< of everything; frequency-dependent elements by their nearest linear system
  std::vector<ElementMap> elements;
  numerics::DynamicMatrices
      constant;  ///< without the frequency-dependent elements, first rows of `layout`; empty if there are none
  Ground ground;

  [[nodiscard]] bool frequency_dependent() const { return constant.size() > 0; }
  /// Adds what the frequency-dependent elements bring into Z(ω), first rows of `layout`.
  void add_frequency_dependent(std::complex<double> omega, double near, Eigen::MatrixXcd& z) const;
  /// Exact Z(ω) in the first rows of `layout`, also for complex ω near a real one (which piece of a table holds).
  [[nodiscard]] Eigen::MatrixXcd dynamic_stiffness(std::complex<double> omega, double near) const;
};

/// K = Σ T C_e Tᵀ; B and A likewise plus the damping of the system and the bodies.
[[nodiscard]] Assembled assemble(const model::System& system);

}  // namespace trivet::assembly

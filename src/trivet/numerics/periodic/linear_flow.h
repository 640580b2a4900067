// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::numerics {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The flow e^{F t} of ẋ = F x from the eigenvalues of F, in real coordinates y, x = T y, in which F has 2×2 blocks.
class LinearFlow {
 public:
  explicit LinearFlow(const Eigen::MatrixXd& F);

  /// False if the eigenvectors are nearly dependent; the rest of the class is then not to be used.
  [[nodiscard]] bool is_diagonalizable() const { return regular_; }

  [[nodiscard]] const Eigen::MatrixXd& to_states() const { return to_states_; }      ///< T
  [[nodiscard]] const Eigen::MatrixXd& from_states() const { return from_states_; }  ///< T⁻¹

  /// Imaginary parts of the eigenvalues [rad/s], one per row of y: positive in the first and negative in the second row
  /// of a block, else 0.
  [[nodiscard]] const Eigen::VectorXd& turning() const { return turning_; }

  /// e^{F t}, states × states.
  [[nodiscard]] Eigen::MatrixXd at(double time) const;

  /// The blocks of the flow in the coordinates y over one time.
  struct Step {
    Eigen::VectorXd diagonal, beside;  ///< row i: diagonal_i y_i + beside_i y_partner(i)
  };
  [[nodiscard]] Step step(double time) const;
  /// y → flow y for all columns.
  void apply(const Step& step, RowMatrix& y) const;
  /// Steps of equal length, with y → y + kick answer seen y in the middle of each.
  struct Kicks {
    RowMatrix kick;     ///< rows of y × forces
    RowMatrix seen;     ///< values × rows of y
    RowMatrix answers;  ///< forces × values of one step below those of another
  };
  /// @param y  rows below those of the flow stay as they are between the kicks
  void apply_with_kicks(double step, const Kicks& kicks, RowMatrix& y) const;

 private:
  Eigen::VectorXd growth_, turning_;   ///< real and imaginary parts, the latter with opposite signs in a block
  std::vector<Eigen::Index> partner_;  ///< the other row of the block, or the row itself
  Eigen::MatrixXd to_states_, from_states_;
  bool regular_ = false;
};

}  // namespace trivet::numerics

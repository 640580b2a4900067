// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

#include "trivet/numerics/lanes/line_memory.h"

namespace trivet::numerics {

/// Steps of a linear flow in 2×2 blocks with a kick in the middle of each: y changes by kick · Jacobian · seen · y.
struct KickedFlow {
  /// Row i becomes diagonal_i y_i + beside_i y_partner(i); the rows of a block follow each other.
  struct Step {
    const double *diagonal, *beside;
  };
  std::ptrdiff_t states = 0, forces = 0, values = 0, steps = 0;
  const double* seen = nullptr;       ///< values × states, by rows
  const double* jacobians = nullptr;  ///< forces × values of one step after another, by rows
  const double* kick = nullptr;       ///< states × forces, by rows
  const char* leads = nullptr;        ///< is this row the first of a block of two?
  Step half{}, whole{};
};

/// Takes them: half a step first and last, whole ones between the kicks.
/// @param y       states × columns, by rows, aligned to a cache line
/// @param columns  up to the stride; the rest of their last pack changes too
/// @param stride  numbers from row to row, a multiple of longest_pack
void take_kicked_steps(const KickedFlow& flow, double* y, std::ptrdiff_t columns, std::ptrdiff_t stride);

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
  /// Steps of equal length, with y → y + kick J seen y in the middle of each.
  struct Kicks {
    RowMatrix kick;       ///< rows of y × forces
    RowMatrix seen;       ///< values × rows of y
    RowMatrix jacobians;  ///< forces × values of one step below those of another
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

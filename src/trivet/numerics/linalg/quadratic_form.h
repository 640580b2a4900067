// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace trivet::numerics {

/// vᵀMv of a square matrix in extended precision, from its nonzero entries: in a system of many bodies most entries
/// are zero.
class QuadraticForm {
 public:
  explicit QuadraticForm(const Eigen::MatrixXd& M);

  [[nodiscard]] long double operator()(const Eigen::Ref<const Eigen::VectorXd>& v) const;
  /// |v|ᵀ|M||v|: the size of the terms that the form is a sum of.
  [[nodiscard]] double terms(const Eigen::Ref<const Eigen::VectorXd>& v) const;

 private:
  struct Entry {
    Eigen::Index row;
    double value, magnitude;  ///< means of M_ij and M_ji, and of their magnitudes
  };
  std::vector<Entry> entries_;       ///< above the diagonal, column by column
  std::vector<std::size_t> end_of_;  ///< end of each column in `entries_`
  Eigen::VectorXd diagonal_;
};

}  // namespace trivet::numerics

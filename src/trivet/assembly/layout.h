// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::assembly {

/// Which row of the global matrices a body's coordinate is: bodies in their order, only free coordinates.
class Layout {
 public:
  explicit Layout(const std::vector<model::Body>& bodies);

  [[nodiscard]] Eigen::Index size() const { return size_; }
  /// −1 for a coordinate that is not free.
  [[nodiscard]] Eigen::Index row(std::size_t body, int coordinate) const { return rows_[body][static_cast<std::size_t>(coordinate)]; }
  /// All six coordinates of a body out of a global vector; zeros where it is guided.
  template <typename Vector>
  [[nodiscard]] Eigen::Matrix<typename Vector::Scalar, 6, 1> of_body(std::size_t body, const Vector& global) const {
    Eigen::Matrix<typename Vector::Scalar, 6, 1> six;
    for (int j = 0; j < 6; ++j) {
      six(j) = 0;
      if (row(body, j) >= 0) six(j) = global(row(body, j));
    }
    return six;
  }

 private:
  std::vector<std::array<Eigen::Index, 6>> rows_;
  Eigen::Index size_ = 0;
};

}  // namespace trivet::assembly

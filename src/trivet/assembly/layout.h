// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "trivet/model/system.h"

namespace trivet::assembly {

/// Rows of the coordinates in the global matrices: bodies in their order, only free coordinates; then nodes, in the
/// same way; then foundations; then the internal coordinates of elements, those of frequency-dependent elements last.
class Layout {
 public:
  /// `internal`: number of internal coordinates of each element; `last`: true if they come last.
  explicit Layout(const model::Description& description, const std::vector<Eigen::Index>& internal = {},
                  const std::vector<bool>& last = {});

  [[nodiscard]] Eigen::Index size() const { return size_; }
  /// Coordinates of bodies, without nodes: the first rows.
  [[nodiscard]] Eigen::Index of_bodies() const { return of_bodies_; }
  /// Rows before the internal coordinates of the elements that come last.
  [[nodiscard]] Eigen::Index before_last() const { return before_last_; }
  /// First row of the coordinates of a foundation.
  [[nodiscard]] Eigen::Index foundation_row(std::size_t foundation) const { return foundations_[foundation]; }
  /// First row of the internal coordinates of an element.
  [[nodiscard]] Eigen::Index internal_row(std::size_t element) const { return internal_[element]; }
  /// First rows, ascending, of the coordinate blocks: of a body or node, of a foundation, the internal ones of an
  /// element.
  [[nodiscard]] const std::vector<Eigen::Index>& blocks() const { return blocks_; }
  /// −1 for a coordinate that is not free.
  [[nodiscard]] Eigen::Index row(std::size_t body, int coordinate) const { return rows_[body][coordinate]; }
  /// All six coordinates of a body from a global vector; zero for constrained ones.
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
  std::vector<Eigen::Index> foundations_, internal_, blocks_;
  Eigen::Index of_bodies_ = 0, before_last_ = 0, size_ = 0;
};

}  // namespace trivet::assembly

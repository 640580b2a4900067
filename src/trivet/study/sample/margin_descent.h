// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "trivet/study/sample/drawn_designs.h"
#include "trivet/study/sample/sampled_case.h"

namespace trivet::study {

/// The range of a drawn number.
struct DrawRange {
  double from = 0, to = 0;
};

/// Designs × draws, 0 … 1 in their ranges.
using DrawPlaces = Eigen::MatrixXd;

/// Numbers within the ranges of all draws.
class DrawBox {
 public:
  /// @param given  draws of the design of the file; the nearest ones in the ranges are taken
  DrawBox(std::vector<DrawRange> ranges, const Eigen::VectorXd& given);

  [[nodiscard]] Eigen::Index draws() const { return given_.size(); }
  [[nodiscard]] const std::vector<DrawRange>& ranges() const { return ranges_; }
  /// The place of the design of the file; of a batch that does not contain it the nearest one that is in its range.
  [[nodiscard]] const Eigen::VectorXd& given() const { return given_; }
  /// The nearest place of a design, draws by draws.
  [[nodiscard]] Eigen::VectorXd place(const Eigen::VectorXd& numbers) const;
  /// Exact at the ends, where the range of the kernels ends too.
  [[nodiscard]] Eigen::MatrixXd at(const DrawPlaces& places) const;

 private:
  std::vector<DrawRange> ranges_;
  Eigen::VectorXd given_;
};

/// Goes down the slopes of the margin of one requirement of one case within a box.
class MarginDescent {
 public:
  /// @param in, box  live as long
  MarginDescent(const SampledCase& in, Eigen::Index requirement, const DrawBox& box)
      : in_(in), requirement_(requirement), box_(box) {}

  struct Place {
    Eigen::VectorXd at;
    double margin = std::numeric_limits<double>::infinity();
    bool ended = false;
  };

  /// Goes on until neither a step along the slopes nor along one number lowers the margin.
  [[nodiscard]] Place run(Place here);
  /// The corner that the slopes of a design point to.
  [[nodiscard]] Place pointed_corner(const Place& from);
  [[nodiscard]] Place judged(const Eigen::VectorXd& at) { return {at, margins(at.transpose())(0)}; }

  std::uint64_t looked_at = 0, failed = 0;
  std::string first_failure;
  Eigen::VectorXd first_failed;  ///< draws of a design that cannot be judged

 private:
  /// Designs that cannot be judged are counted, and infinite here.
  [[nodiscard]] Eigen::ArrayXd margins(const DrawPlaces& places);
  [[nodiscard]] Place worst_of(const DrawPlaces& places, const Place& otherwise);
  /// Per width of each range; 0 where there is none.
  [[nodiscard]] Eigen::VectorXd slopes(const Place& here);

  const SampledCase& in_;
  Eigen::Index requirement_;
  const DrawBox& box_;
};

}  // namespace trivet::study

// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/roots/design_modes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "trivet/foundation/index.h"
#include "trivet/numerics/linalg/decompositions.h"
#include "trivet/numerics/roots/design_modes.h"
#include "trivet/numerics/roots/modes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Copies the columns of a few designs next to each other: the processor cannot prefetch many distant columns at once
/// (twice as slow).
class Tile {
 public:
  static constexpr Eigen::Index designs = 64;

  explicit Tile(int columns) : numbers_(to_size(columns) * designs) {}

  /// Designs first … first + taken − 1 of all columns; the last one is repeated to fill the tile.
  void read(const Eigen::ArrayXXd& from, Eigen::Index first, Eigen::Index taken) {
    for (Eigen::Index c = 0; c < from.cols(); ++c) {
      const double* column = from.data() + c * from.rows() + first;
      double* to = at(static_cast<int>(c), 0);
      std::fill(std::copy_n(column, taken, to), to + designs, column[taken - 1]);
    }
  }
  void write(Eigen::ArrayXXd& to, Eigen::Index first, Eigen::Index taken) {
    for (Eigen::Index c = 0; c < to.cols(); ++c)
      std::copy_n(at(static_cast<int>(c), 0), taken, to.data() + c * to.rows() + first);
  }
  [[nodiscard]] double* at(int column, Eigen::Index design) { return numbers_.data() + column * designs + design; }

 private:
  std::vector<double> numbers_;
};

template <bool shapes, typename Size>
void pieces_of_modes(Size n, const Designs& designs, Eigen::Index first, Eigen::Index last, DesignModes& result) {
  const int entries = n * (n + 1) / 2;
  const Pack nothing = all(std::numeric_limits<double>::quiet_NaN());
  Tile A(entries), K(entries), lambda(n), x(shapes ? n * n : 0);
  for (; first < last; first += Tile::designs) {
    const Eigen::Index taken = std::min(Tile::designs, last - first);
    A.read(designs.A, first, taken);
    K.read(designs.K, first, taken);
    for (Eigen::Index at = 0; at < taken; at += lane_count()) {
      Pack a[Size::most * (Size::most + 1) / 2], k[Size::most * (Size::most + 1) / 2];
      for (int entry = 0; entry < entries; ++entry) {
        a[entry] = hn::LoadU(Lanes(), A.at(entry, at));
        k[entry] = hn::LoadU(Lanes(), K.at(entry, at));
      }
      PackOfModes<Size> modes;
      const LaneMask definite = modes_of_pack<shapes>(n, a, k, modes);
      sort<shapes>(n, modes);
      const LaneMask known = hn::And(definite, modes.settled);
      for (int i = 0; i < n; ++i)
        hn::StoreU(hn::IfThenElse(known, modes.lambda[i], nothing), Lanes(), lambda.at(i, at));
      if constexpr (shapes)
        for (int i = 0; i < n * n; ++i) hn::StoreU(hn::IfThenElse(known, modes.x[i], nothing), Lanes(), x.at(i, at));
      double verdict[8];
      hn::StoreU(hn::IfThenElseZero(definite, all(1.0)), Lanes(), verdict);
      for (Eigen::Index lane = 0; lane < lane_count() && at + lane < taken; ++lane)
        result.definite[first + at + lane] = verdict[lane] != 0;
    }
    lambda.write(result.lambda, first, taken);
    x.write(result.shapes, first, taken);
  }
}

template <typename Size>
void modes_of_size(Size n, const Designs& designs, Eigen::Index first, Eigen::Index last, DesignModes& result) {
  result.shapes.size() > 0 ? pieces_of_modes<true>(n, designs, first, last, result)
                           : pieces_of_modes<false>(n, designs, first, last, result);
}

void modes_of_designs(const Designs& designs, int n, Eigen::Index first, Eigen::Index last, DesignModes& result) {
  n == 6 ? modes_of_size(six_coordinates(), designs, first, last, result)
         : modes_of_size(AtMostTwelve{n}, designs, first, last, result);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/numerics/lanes/dispatch.h"
#include "trivet/numerics/linalg/generalized_modes.h"

namespace trivet::numerics {

TRIVET_VARIANTS(modes_of_designs);

namespace {

void modes_without_lanes(const Designs& designs, Eigen::Index first, Eigen::Index last, DesignModes& result) {
  for (Eigen::Index design = first; design < last; ++design) {
    const Eigen::MatrixXd A = unpacked(designs.A, design), K = unpacked(designs.K, design);
    const bool definite = A.allFinite() && K.allFinite() && is_positive_definite(A);
    result.definite[design] = definite;
    if (!definite) {
      result.lambda.row(design).setConstant(std::numeric_limits<double>::quiet_NaN());
      result.shapes.row(design).setConstant(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const GeneralizedModes modes = generalized_modes(K, A, true);
    result.lambda.row(design) = modes.lambda.transpose();
    if (result.shapes.size() > 0) result.shapes.row(design) = modes.shapes.reshaped().transpose();
  }
}

}  // namespace

DesignModes design_modes(const Designs& designs, const DesignModesOptions& options) {
  DesignModes result;
  design_modes(designs, result, options);
  return result;
}

void design_modes(const Designs& designs, DesignModes& result, const DesignModesOptions& options) {
  const Eigen::Index count = designs.A.rows(), entries = designs.A.cols();
  const int n = static_cast<int>(coordinates_of(entries));
  if (n < 1 || designs.K.cols() != entries || designs.K.rows() != count)
    throw foundation::InvalidInput(
        "designs: A and K must have the same number of rows, and n(n + 1)/2 columns with n ≥ 1");
  result.lambda.resize(count, n);
  result.shapes.resize(count, options.shapes ? n * n : 0);
  result.definite.resize(to_size(count));
  constexpr std::size_t designs_a_piece = 256;
  foundation::parallel_for(to_size(count),
                           {.size = designs_a_piece,
                            .threads = options.threads,
                            .progress = options.progress,
                            .task = "modes of the designs"},
                           [&](std::size_t first, std::size_t last) {
                             const auto from = to_index(first), to = to_index(last);
                             if (n > 12) return modes_without_lanes(designs, from, to, result);
                             TRIVET_DISPATCH(modes_of_designs)(designs, n, from, to, result);
                             for (Eigen::Index d = from; d < to; ++d)  // not converged in lanes
                               if (result.definite[d] && std::isnan(result.lambda(d, 0)))
                                 modes_without_lanes(designs, d, d + 1, result);
                           });
}

}  // namespace trivet::numerics
#endif

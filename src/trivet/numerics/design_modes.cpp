// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/design_modes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "trivet/numerics/design_modes.h"
#include "trivet/numerics/modes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {

/// Designs first … first + lanes − 1 of one column; the last of them again where they end.
HWY_INLINE Pack load(const double* column, Eigen::Index first, Eigen::Index last) {
  const Lanes d;
  if (first + lane_count() <= last) return hn::LoadU(d, column + first);
  HWY_ALIGN double buffer[8];
  for (Eigen::Index lane = 0; lane < lane_count(); ++lane) buffer[lane] = column[std::min(first + lane, last - 1)];
  return hn::Load(d, buffer);
}

HWY_INLINE void store(const Pack& value, double* column, Eigen::Index first, Eigen::Index last) {
  const Lanes d;
  if (first + lane_count() <= last) return hn::StoreU(value, d, column + first);
  HWY_ALIGN double buffer[8];
  hn::Store(value, d, buffer);
  std::copy(buffer, buffer + (last - first), column + first);
}

template <bool shapes, typename Size>
void pieces_of_modes(Size n, const Designs& designs, Eigen::Index first, Eigen::Index last, DesignModes& result) {
  const Eigen::Index count = designs.A.rows();
  const Pack nothing = all(std::numeric_limits<double>::quiet_NaN());
  for (; first < last; first += lane_count()) {
    Pack a[Size::most * (Size::most + 1) / 2], k[Size::most * (Size::most + 1) / 2];
    for (int entry = 0; entry < n * (n + 1) / 2; ++entry) {
      a[entry] = load(designs.A.data() + entry * count, first, last);
      k[entry] = load(designs.K.data() + entry * count, first, last);
    }
    PackOfModes<Size> modes;
    const LaneMask definite = modes_of_pack<shapes>(n, a, k, modes);
    sort<shapes>(n, modes);
    for (int i = 0; i < n; ++i) store(hn::IfThenElse(definite, modes.lambda[i], nothing), result.lambda.data() + i * count, first, last);
    if constexpr (shapes)
      for (int i = 0; i < n * n; ++i) store(hn::IfThenElse(definite, modes.x[i], nothing), result.shapes.data() + i * count, first, last);
    double verdict[8];
    hn::StoreU(hn::IfThenElseZero(definite, all(1.0)), Lanes(), verdict);
    for (Eigen::Index lane = 0; lane < lane_count() && first + lane < last; ++lane)
      result.definite[static_cast<std::size_t>(first + lane)] = verdict[lane] != 0;
  }
}

template <typename Size>
void modes_of_size(Size n, const Designs& designs, Eigen::Index first, Eigen::Index last, DesignModes& result) {
  result.shapes.size() > 0 ? pieces_of_modes<true>(n, designs, first, last, result) : pieces_of_modes<false>(n, designs, first, last, result);
}

void modes_of_designs(const Designs& designs, int n, Eigen::Index first, Eigen::Index last, DesignModes& result) {
  n == 6 ? modes_of_size(six_coordinates(), designs, first, last, result) : modes_of_size(AtMostTwelve{n}, designs, first, last, result);
}

}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "trivet/foundation/invalid_input.h"
#include "trivet/foundation/pieces.h"
#include "trivet/numerics/dispatch.h"
#include "trivet/numerics/generalized_modes.h"

namespace trivet::numerics {

TRIVET_VARIANTS(modes_of_designs);

namespace {

Eigen::MatrixXd symmetric(const Eigen::ArrayXXd& packed_rows, Eigen::Index design, int n) {
  Eigen::MatrixXd matrix(n, n);
  for (int i = 0, entry = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j, ++entry) matrix(i, j) = matrix(j, i) = packed_rows(design, entry);
  return matrix;
}

void one_by_one(const Designs& designs, int n, Eigen::Index first, Eigen::Index last, DesignModes& result) {
  for (Eigen::Index design = first; design < last; ++design) {
    const Eigen::MatrixXd A = symmetric(designs.A, design, n), K = symmetric(designs.K, design, n);
    const bool definite = A.allFinite() && K.allFinite() && is_positive_definite(A);
    result.definite[static_cast<std::size_t>(design)] = definite;
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
  const Eigen::Index count = designs.A.rows(), entries = designs.A.cols();
  const int n = static_cast<int>((std::sqrt(8.0 * static_cast<double>(entries) + 1) - 1) / 2);
  if (n < 1 || n * (n + 1) / 2 != entries || designs.K.cols() != entries || designs.K.rows() != count)
    throw foundation::InvalidInput("designs: A and K must have as many rows and n(n + 1)/2 columns, n ≥ 1");
  DesignModes result;
  result.lambda.resize(count, n);
  result.shapes.resize(count, options.shapes ? n * n : 0);
  result.definite.resize(static_cast<std::size_t>(count));
  constexpr std::size_t designs_a_piece = 256;
  foundation::for_each_piece(static_cast<std::size_t>(count), {designs_a_piece, options.threads, options.progress, "modes of the designs"},
                             [&](std::size_t first, std::size_t last) {
                               const auto from = static_cast<Eigen::Index>(first), to = static_cast<Eigen::Index>(last);
                               if (n > 12) one_by_one(designs, n, from, to, result);
                               else TRIVET_DISPATCH(modes_of_designs)(designs, n, from, to, result);
                             });
  return result;
}

}  // namespace trivet::numerics
#endif

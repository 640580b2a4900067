// SPDX-License-Identifier: BSD-3-Clause
// A tile of C stays in registers while all its products are added. The rows of A and B of each tile are copied to
// consecutive memory before (Goto and van de Geijn 2008).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trivet/numerics/linalg/product_update.cpp"
#include <hwy/foreach_target.h>

#include "trivet/numerics/lanes/lanes-inl.h"
#include "trivet/numerics/linalg/product_update.h"

HWY_BEFORE_NAMESPACE();
namespace trivet::numerics::HWY_NAMESPACE {
namespace {

constexpr std::ptrdiff_t packs = 3;
#if HWY_CAP_GE512
constexpr std::ptrdiff_t columns = 8;  // 24 of 32 registers hold sums
#else
constexpr std::ptrdiff_t columns = 4;  // 12 of 16
#endif

TileSize tile_size() { return {.rows = packs * lane_count(), .columns = columns}; }

/// The products of one tile, subtracted from its part of C.
void subtract_tile(std::ptrdiff_t depth, const double* HWY_RESTRICT a, const double* HWY_RESTRICT b,
                   double* HWY_RESTRICT c, std::ptrdiff_t stride) {
  const std::ptrdiff_t lanes = lane_count();
  Pack sum[columns][packs];
  TRIVET_UNROLL for (auto& column : sum) TRIVET_UNROLL for (Pack& pack : column) pack = hn::Zero(Lanes());
  for (std::ptrdiff_t k = 0; k < depth; ++k) {
    Pack x[packs];
    TRIVET_UNROLL for (std::ptrdiff_t i = 0; i < packs; ++i) x[i] = hn::Load(Lanes(), a + i * lanes);
    TRIVET_UNROLL for (std::ptrdiff_t j = 0; j < columns; ++j) {
      const Pack y = all(b[j]);
      TRIVET_UNROLL for (std::ptrdiff_t i = 0; i < packs; ++i) sum[j][i] = hn::MulAdd(x[i], y, sum[j][i]);
    }
    a += packs * lanes;
    b += columns;
  }
  TRIVET_UNROLL for (std::ptrdiff_t j = 0; j < columns; ++j) TRIVET_UNROLL for (std::ptrdiff_t i = 0; i < packs; ++i) {
    double* at = c + j * stride + i * lanes;
    hn::StoreU(hn::Sub(hn::LoadU(Lanes(), at), sum[j][i]), Lanes(), at);
  }
}

}  // namespace
}  // namespace trivet::numerics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>
#include <array>
#include <cassert>

#include "trivet/foundation/index.h"
#include "trivet/foundation/parallel_for.h"
#include "trivet/numerics/lanes/dispatch.h"

namespace trivet::numerics {
namespace {

TRIVET_VARIANTS(tile_size);
TRIVET_VARIANTS(subtract_tile);

using Index = Eigen::Index;

constexpr Index rows_at_once = 240;        ///< a multiple of all tiles: these rows of A stay in the second cache
constexpr double work_of_a_thread = 4e6;   ///< multiplications that take longer than the start of a thread
constexpr std::size_t largest_tile = 192;  ///< entries: 24 rows, 8 columns

/// Groups of `height` rows one after the other, each by columns; missing rows of the last group are zero.
void copy_in_groups(const ProductUpdate::ConstBlock& from, Index height, LineMemory& to) {
  const Index groups = (from.rows() + height - 1) / height, needed = groups * height * from.cols();
  assert(height > 0);
  if (to.size() < to_size(needed)) to.resize(to_size(needed));
  double* at = to.data();
  for (Index first = 0; first < from.rows(); first += height) {
    const Index present = std::min(height, from.rows() - first);
    for (Index k = 0; k < from.cols(); ++k, at += height) {
      const double* source = &from.coeffRef(first, k);
      std::copy(source, source + present, at);
      std::fill(at + present, at + height, 0.0);
    }
  }
  assert(at == to.data() + needed && "the groups follow each other without gaps");
}

/// Tiles of the rows from `first` to `last` of C.
struct RowsUpdate {
  const double *a, *b;
  Index depth;
  TileSize tile;
  bool lower;

  void operator()(Index first, Index last, ProductUpdate::Block& c) const {
    assert(first % tile.rows == 0 && tile.rows * tile.columns <= to_index(largest_tile) && "pieces are whole tiles");
    const auto subtract = TRIVET_DISPATCH(subtract_tile);
    alignas(64) std::array<double, largest_tile> rest;
    const Index end = lower ? std::min(last, c.cols()) : c.cols();
    for (Index j = 0; j < end; j += tile.columns) {
      const Index from = lower ? std::max(first, j / tile.rows * tile.rows) : first;
      for (Index i = from; i < last; i += tile.rows) {
        const double *left = a + i * depth, *right = b + j * depth;
        const Index height = std::min<Index>(tile.rows, c.rows() - i),
                    width = std::min<Index>(tile.columns, c.cols() - j);
        if (height == tile.rows && width == tile.columns) {
          subtract(depth, left, right, &c.coeffRef(i, j), c.outerStride());
          continue;
        }
        rest.fill(0);
        subtract(depth, left, right, rest.data(), tile.rows);
        for (Index column = 0; column < width; ++column)
          for (Index row = 0; row < height; ++row) c(i + row, j + column) += rest[column * tile.rows + row];
      }
    }
  }
};

}  // namespace

void ProductUpdate::subtract(const ConstBlock& a, const ConstBlock& b, Block c, Needed needed, int threads) {
  assert(a.rows() == c.rows() && b.rows() == c.cols() && a.cols() == b.cols());
  const TileSize tile = TRIVET_DISPATCH(tile_size)();
  copy_in_groups(a, tile.rows, a_);
  copy_in_groups(b, tile.columns, b_);
  const RowsUpdate update{a_.data(), b_.data(), a.cols(), tile, needed == Needed::lower_triangle};
  const Index pieces = (c.rows() + rows_at_once - 1) / rows_at_once;
  const double work = static_cast<double>(c.size()) * static_cast<double>(a.cols());
  if (threads > 1) threads = static_cast<int>(std::clamp(work / work_of_a_thread, 1.0, double(threads)));
  const auto piece = [&](Index at) { update(at * rows_at_once, std::min(c.rows(), (at + 1) * rows_at_once), c); };
  // The last rows of a lower triangle are the longest: they are begun first.
  if (threads > 1)
    foundation::parallel_for(to_size(pieces), {.threads = threads}, [&](std::size_t first, std::size_t last) {
      for (std::size_t p = first; p < last; ++p) piece(pieces - 1 - to_index(p));
    });
  else
    for (Index p = 0; p < pieces; ++p) piece(p);
}

}  // namespace trivet::numerics
#endif

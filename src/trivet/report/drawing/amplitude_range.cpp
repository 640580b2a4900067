// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/report/drawing/amplitude_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivet::report {
namespace {

double largest_finite(std::span<const double> values) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, value);
  return largest;
}

/// The amplitude that a curve exceeds except in its dips: the lowest parts of it, which have a share of its band.
/// @param from  amplitudes below are not counted
double except_dips(const DrawnAmplitudes& curve, double from) {
  struct Piece {
    double height, width;
  };
  std::vector<Piece> pieces;
  double band = 0;
  for (std::size_t i = 1; i < curve.amplitude.size(); ++i) {
    const double height = std::max(curve.amplitude[i - 1], curve.amplitude[i]), width = curve.at[i] - curve.at[i - 1];
    if (!std::isfinite(curve.amplitude[i - 1]) || !std::isfinite(curve.amplitude[i]) || height < from) continue;
    pieces.push_back({height, width});
    band += width;
  }
  std::ranges::sort(pieces, {}, &Piece::height);
  double left = amplitude_rule.dips * band;
  for (const Piece& piece : pieces) {
    left -= piece.width;
    if (left <= 0) return piece.height;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

AmplitudeRange amplitude_range(const std::vector<DrawnAmplitudes>& curves) {
  AmplitudeRange range;
  for (const DrawnAmplitudes& curve : curves) {
    range.largest = std::max(range.largest, largest_finite(curve.amplitude));
    range.unbounded = range.unbounded ||
        std::ranges::any_of(curve.amplitude, [](double value) { return std::isinf(value) && value > 0; });
  }
  const double round_off = amplitude_rule.round_off * range.largest;
  double smallest = range.least = range.largest;
  for (const DrawnAmplitudes& curve : curves) {
    if (!(largest_finite(curve.amplitude) > amplitude_rule.negligible * range.largest)) continue;
    range.least = std::min(range.least, except_dips(curve, round_off));
    for (const double value : curve.amplitude)
      if (std::isfinite(value) && value > round_off) smallest = std::min(smallest, value);
  }
  range.bottom = std::max(smallest, range.least / amplitude_rule.below);
  return range;
}

}  // namespace trivet::report

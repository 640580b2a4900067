// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "trivet/excitation/signal.h"
#include "trivet/foundation/index.h"
#include "trivet/response/transient/exponential_step.h"

namespace trivet::response {

/// One signal with one delay, with its integrals, evaluated forward in time piece by piece. Zero before its first
/// piece.
class InputCourse {
 public:
  InputCourse(const excitation::Signal& signal, double delay);

  /// Index of a piece, −1 before the first.
  using Place = std::ptrdiff_t;

  /// ∬u … ü at time t by the formula of the piece at `place`.
  [[nodiscard]] InputVector at(Place place, double t) const;
  [[nodiscard]] double kappa(Place place) const { return place < 0 ? 0 : piece(place).kappa; }
  /// Index of the κ of the piece in `kappas`.
  [[nodiscard]] std::size_t kappa_index(Place place) const { return place < 0 ? 0 : kappa_index_[to_size(place)]; }
  [[nodiscard]] const std::vector<double>& kappas() const { return kappas_; }
  /// Start of the next piece [s]; infinite after the last.
  [[nodiscard]] double next_corner(Place place) const {
    return place + 1 < count() ? starts_[to_size(place + 1)] : std::numeric_limits<double>::infinity();
  }
  /// Index of the piece at t; a piece that begins within `resolution` after t has begun.
  [[nodiscard]] Place place_at(double t, double resolution) const;
  /// Jumps of u, u̇, ü at the start of the piece at `place`; the integrals do not jump.
  [[nodiscard]] InputVector jump_into(Place place) const;

  [[nodiscard]] Place count() const { return static_cast<Place>(starts_.size()); }
  [[nodiscard]] double start() const {
    return starts_.empty() ? std::numeric_limits<double>::infinity() : starts_.front();
  }
  [[nodiscard]] double last_corner() const {
    return starts_.empty() ? -std::numeric_limits<double>::infinity() : starts_.back();
  }
  /// True if the mth derivative of u, m = 0, 1, 2, jumps (beyond round-off) at the start of the piece at `place`.
  [[nodiscard]] bool jumps(Place place, int m) const { return (jumps_[to_size(place)] >> m & 1) != 0; }
  /// Lowest derivative of u that jumps anywhere: 0 a step, 1 a corner, 2 a change of curvature.
  [[nodiscard]] int smoothness() const { return smoothness_; }
  /// Median time between samples of a polygon of many straight lines; 0 for other signals [s].
  [[nodiscard]] double sampling_step() const { return sampling_step_; }

 private:
  [[nodiscard]] const excitation::Piece& piece(Place place) const { return pieces_[to_size(place)]; }

  std::vector<excitation::Piece> pieces_;
  std::vector<double> starts_;                       ///< delayed [s]
  std::vector<excitation::SignalIntegrals> before_;  ///< ∫u and ∬u up to the start of each piece
  std::vector<double> kappas_;
  std::vector<std::size_t> kappa_index_;
  std::vector<unsigned char> jumps_;  ///< bit m: the mth derivative jumps
  int smoothness_ = 2;
  double sampling_step_ = 0;
};

/// Largest κ of these courses [rad/s]; 0 without any.
[[nodiscard]] double largest_kappa(const std::vector<InputCourse>& courses);

}  // namespace trivet::response

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "trivet/excitation/signal.h"
#include "trivet/response/transient/exponential_step.h"

namespace trivet::response {

/// One signal with one delay, with its integrals, evaluated forward in time piece by piece. Zero before its first
/// piece. Refers to the signal, which must live as long.
class InputCourse {
 public:
  enum class Integrals { needed, not_needed };  ///< not needed: ∬u and ∫u are 0
  InputCourse(const excitation::Signal& signal, double delay, Integrals integrals = Integrals::needed);
  InputCourse(excitation::Signal&& signal, double delay, Integrals integrals = Integrals::needed) = delete;

  /// Index of a piece, −1 before the first.
  using Place = std::ptrdiff_t;

  /// ∬u … ü at time t by the formula of the piece at `place`.
  [[nodiscard]] InputVector at(Place place, double t) const;
  [[nodiscard]] double kappa(Place place) const { return place < 0 ? 0 : piece(place).kappa; }
  /// Index of the κ of the piece in `kappas`.
  [[nodiscard]] std::size_t kappa_index(Place place) const {
    return place < 0 || kappa_index_.empty() ? 0 : kappa_index_[place];
  }
  [[nodiscard]] const std::vector<double>& kappas() const { return kappas_; }
  /// Start of the next piece [s]; infinite after the last.
  [[nodiscard]] double next_corner(Place place) const {
    return place + 1 < count() ? start_of(place + 1) : std::numeric_limits<double>::infinity();
  }
  /// Index of the piece at t; a piece that begins within `resolution` after t has begun.
  [[nodiscard]] Place place_at(double t, double resolution) const;
  /// Jumps of u, u̇, ü at the start of the piece at `place`; the integrals do not jump.
  [[nodiscard]] InputVector jump_into(Place place) const;

  [[nodiscard]] Place count() const { return static_cast<Place>(pieces_->size()); }
  [[nodiscard]] double start() const { return count() == 0 ? std::numeric_limits<double>::infinity() : start_of(0); }
  [[nodiscard]] double last_corner() const {
    return count() == 0 ? -std::numeric_limits<double>::infinity() : start_of(count() - 1);
  }
  /// True if the mth derivative of u, m = 0, 1, 2, jumps (beyond round-off) at the start of the piece at `place`.
  [[nodiscard]] bool jumps(Place place, int m) const {
    return std::abs(jump_into(place)(of_value + m)) > least_jump_[m];
  }
  /// True if ü is zero throughout.
  [[nodiscard]] bool is_polygon() const { return polygon_; }
  /// Lowest derivative of u that jumps anywhere: 0 a step, 1 a corner, 2 a change of curvature.
  [[nodiscard]] int smoothness() const { return smoothness_; }
  /// Median time between samples of a polygon of many straight lines; 0 for other signals [s].
  [[nodiscard]] double sampling_step() const { return sampling_step_; }

 private:
  [[nodiscard]] const excitation::Piece& piece(Place place) const { return (*pieces_)[place]; }
  [[nodiscard]] double start_of(Place place) const { return piece(place).start + delay_; }
  [[nodiscard]] InputVector with_integrals(Place place, double t) const;
  void examine_pieces();
  void add_kappa(Place place, double kappa);
  [[nodiscard]] double median_step() const;

  const std::vector<excitation::Piece>* pieces_;
  double delay_;
  std::vector<excitation::SignalIntegrals> before_;  ///< ∫u and ∬u up to the start of each piece, if needed
  std::vector<double> kappas_;
  std::vector<std::size_t> kappa_index_;  ///< empty if all pieces have the same κ
  std::array<double, 3> least_jump_{};    ///< of u, u̇, ü: smaller ones are round-off
  bool polygon_ = true;
  int smoothness_ = 2;
  double sampling_step_ = 0;
};

inline InputVector InputCourse::at(Place place, double t) const {
  if (place < 0 || !before_.empty() || piece(place).kappa != 0) return with_integrals(place, t);
  const excitation::SignalState u = excitation::state_on(piece(place), t - start_of(place));
  return {0, 0, u.value, u.rate, u.curvature};
}

/// Largest κ of these courses [rad/s]; 0 without any.
[[nodiscard]] double largest_kappa(const std::vector<InputCourse>& courses);

}  // namespace trivet::response

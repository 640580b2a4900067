// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/pulses.h"

#include <numbers>

#include "trivet/excitation/refusal.h"

namespace trivet::excitation {
namespace {

using std::numbers::pi;

/// One piece with a duration, then the constant `afterwards`. Throws if the duration is lost in the round-off of the
/// start.
Signal one_piece(Piece piece, double duration, double afterwards) {
  require_positive(duration, "duration", "s");
  require_finite(piece.start, "start", "s");
  require_finite(piece.value, "amplitude", "");
  require_finite(piece.rate, "amplitude", "");
  require_finite(piece.curvature, "amplitude", "");
  Signal signal{{piece, Piece{piece.start + duration, afterwards}}};
  require_valid(signal);
  return signal;
}

}  // namespace

Signal step(double amplitude, double at) {
  require_finite(amplitude, "amplitude", "");
  require_finite(at, "start", "s");
  return {{Piece{at, amplitude}}};
}

Signal ramp(double amplitude, double rise, double at) { return one_piece({at, 0, amplitude / rise}, rise, amplitude); }

Signal rounded_step(double amplitude, double rise, double at) {
  const double kappa = pi / rise;
  return one_piece({at, 0, 0, amplitude / 2 * kappa * kappa, kappa}, rise, amplitude);
}

Signal rectangular(double amplitude, double duration, double start) {
  return one_piece({start, amplitude}, duration, 0);
}

Signal half_sine(double amplitude, double duration, double start) {
  const double kappa = pi / duration;
  return one_piece({start, 0, amplitude * kappa, 0, kappa}, duration, 0);
}

Signal versed_sine(double amplitude, double duration, double start) {
  const double kappa = 2 * pi / duration;
  return one_piece({start, 0, 0, amplitude / 2 * kappa * kappa, kappa}, duration, 0);
}

Signal trapezoid(double amplitude, double rise, double hold, double fall, double start) {
  require_finite(amplitude, "amplitude", "");
  require_finite(start, "start", "s");
  require_not_negative(rise, "rise", "s");
  require_not_negative(hold, "hold", "s");
  require_not_negative(fall, "fall", "s");
  require_positive(rise + hold + fall, "duration", "s");
  Signal signal;
  if (rise > 0) signal.pieces.push_back({start, 0, amplitude / rise});
  if (hold > 0) signal.pieces.push_back({start + rise, amplitude});
  if (fall > 0) signal.pieces.push_back({start + rise + hold, amplitude, -amplitude / fall});
  signal.pieces.push_back({start + rise + hold + fall});
  require_valid(signal);
  return signal;
}

Signal triangle(double amplitude, double rise, double fall, double start) {
  return trapezoid(amplitude, rise, 0, fall, start);
}

Signal sine_burst(double amplitude, double angular_frequency, double cycles, double start) {
  require_positive(angular_frequency, "angular frequency", "rad/s");
  require_positive(cycles, "cycles", "");
  return one_piece({start, 0, amplitude * angular_frequency, 0, angular_frequency}, 2 * pi * cycles / angular_frequency,
                   0);
}

}  // namespace trivet::excitation

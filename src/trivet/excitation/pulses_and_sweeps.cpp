// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/pulses_and_sweeps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trivet/excitation/refusal.h"
#include "trivet/foundation/invalid_input.h"

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

namespace {

constexpr double most_parabolas = 6e6;  // 240 MB of pieces, and as many time steps

/// Largest error of two parabolas of length g through values and rates at both ends: (2/81) |u‴| g³.
constexpr double two_parabolas_error = 2.0 / 81;

void require_valid_sweep(const Sweep& s) {
  require_finite(s.amplitude, "amplitude of a sweep", "");
  require_finite(s.phase, "phase of a sweep", "rad");
  require_finite(s.start, "start of a sweep", "s");
  require_positive(s.duration, "duration of a sweep", "s");
  const bool logarithmic = s.law == Sweep::Law::logarithmic,
             run_up = s.amplitude_law == Sweep::Amplitude::speed_squared;
  (logarithmic ? require_positive : require_not_negative)(s.from, "first frequency of a sweep", "rad/s");
  (logarithmic || run_up || s.from == 0 ? require_positive : require_not_negative)(s.to, "last frequency of a sweep",
                                                                                   "rad/s");
}

/// φ, ω, ω̇, ω̈ at s.
struct Phase {
  double angle, omega, rate, second_rate;
};

Phase phase_of(const Sweep& sweep, double s) {
  if (sweep.law == Sweep::Law::linear) {
    const double rate = (sweep.to - sweep.from) / sweep.duration;
    return {sweep.phase + s * (sweep.from + rate * s / 2), sweep.from + rate * s, rate, 0};
  }
  const double growth = std::log(sweep.to / sweep.from) / sweep.duration, x = growth * s,
               omega = sweep.from * std::exp(x);
  return {sweep.phase + sweep.from * s * (x == 0 ? 1 : std::expm1(x) / x), omega, omega * growth,
          omega * growth * growth};
}

double local_amplitude(const Sweep& sweep, double s) {
  if (sweep.amplitude_law == Sweep::Amplitude::constant) return std::abs(sweep.amplitude);
  const double ratio = phase_of(sweep, s).omega / sweep.to;
  return std::abs(sweep.amplitude) * ratio * ratio;
}

/// Two parabolas over [s, s + 2g] with the value and rate of the sweep at both ends.
std::pair<Piece, Piece> two_parabolas(const Sweep& sweep, double s, double g) {
  const SignalState a = sweep_state(sweep, s), b = sweep_state(sweep, s + 2 * g);
  const double middle_rate = (b.value - a.value) / g - (a.rate + b.rate) / 2;
  const Piece first{sweep.start + s, a.value, a.rate, (middle_rate - a.rate) / g};
  return {first, {sweep.start + s + g, state_on(first, g).value, middle_rate, (b.rate - middle_rate) / g}};
}

/// Largest difference between the two and the sweep, at the two points where it is largest for a cubic.
double error_of(const Sweep& sweep, const std::pair<Piece, Piece>& pair, double s, double g) {
  return std::max(std::abs(state_on(pair.first, g * 2 / 3).value - sweep_state(sweep, s + g * 2 / 3).value),
                  std::abs(state_on(pair.second, g / 3).value - sweep_state(sweep, s + g * 4 / 3).value));
}

}  // namespace

SignalState sweep_state(const Sweep& sweep, double s) {
  const Phase p = phase_of(sweep, s);
  const double sine = std::sin(p.angle), cosine = std::cos(p.angle), A = sweep.amplitude;
  double a = A, a1 = 0, a2 = 0;
  if (sweep.amplitude_law == Sweep::Amplitude::speed_squared) {
    const double scale = A / (sweep.to * sweep.to);
    a = scale * p.omega * p.omega;
    a1 = 2 * scale * p.omega * p.rate;
    a2 = 2 * scale * (p.rate * p.rate + p.omega * p.second_rate);
  }
  return {a * sine, a1 * sine + a * p.omega * cosine,
          a2 * sine + (2 * a1 * p.omega + a * p.rate) * cosine - a * p.omega * p.omega * sine};
}

Signal sweep_signal(const Sweep& sweep, double tolerance) {
  require_valid_sweep(sweep);
  if (!(tolerance >= 1e-12 && tolerance <= 0.1))
    throw foundation::InvalidInput(fmt::format("sweep: tolerance {:.3g}, must be between 1e-12 and 0.1", tolerance));
  const double radians_per_piece = std::cbrt(0.9 * tolerance / two_parabolas_error);
  if (const double count = phase_of(sweep, sweep.duration).angle / radians_per_piece; count > most_parabolas)
    throw foundation::NotComputable(fmt::format(
        "a sweep of {:.3g} cycles needs {:.2g} parabolas at a tolerance of {:.1g}; the limit is {:.1g}",
        (phase_of(sweep, sweep.duration).angle - sweep.phase) / 6.283185307179586, count, tolerance, most_parabolas));
  Signal signal;
  for (double s = 0; s < sweep.duration;) {
    const double left = sweep.duration - s;
    const auto evenly = [&](double g) { return left / (2 * std::max(1.0, std::ceil(left / (2 * g)))); };
    const auto fastest = [&](double g) { return std::max(phase_of(sweep, s).omega, phase_of(sweep, s + 2 * g).omega); };
    double g = left / 2;
    for (int i = 0; i < 2; ++i)
      g = evenly(std::min(left / 2, radians_per_piece / fastest(i == 0 && fastest(0) > 0 ? 0 : g)));
    auto pair = two_parabolas(sweep, s, g);
    const double shortest = 1e-9 * sweep.duration;  // no sweep within most_parabolas needs shorter ones
    while (error_of(sweep, pair, s, g) >
           0.9 * tolerance * std::max(local_amplitude(sweep, s), local_amplitude(sweep, s + 2 * g)))
      if (pair = two_parabolas(sweep, s, g = evenly(0.7 * g)); !(g > shortest))
        throw foundation::NotComputable(fmt::format(
            "parabolas do not approximate a sweep at {:.4g} s of its duration: check its frequencies and amplitude",
            s));
    signal.pieces.push_back(pair.first);
    signal.pieces.push_back(pair.second);
    s = 2 * g < left ? s + 2 * g : sweep.duration;
  }
  signal.pieces.push_back({sweep.start + sweep.duration});
  require_valid(signal);
  return signal;
}

}  // namespace trivet::excitation

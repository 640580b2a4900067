// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/excitation/signal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "trivet/excitation/refusal.h"
#include "trivet/foundation/first_error.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::excitation {

namespace {

/// C_n(s) = sⁿ Σ_k (−κ²s²)ᵏ/(n + 2k)!, n = 0 … 4 (Stumpff functions): cos κs, sin κs/κ, (1 − cos κs)/κ² and so on,
/// C′_{n+1} = C_n. Powers of s if κ = 0. The recurrence loses digits for small κs, so the series is used there.
std::array<double, 5> stumpff(double kappa, double s) {
  const double x = kappa * kappa * s * s;
  std::array<double, 5> c{};
  if (x > 1) {
    const double angle = kappa * s, half = std::sin(angle / 2);
    c = {std::cos(angle), std::sin(angle) / angle, 2 * half * half / x, 0, 0};
    c[3] = (1 - c[1]) / x;
    c[4] = (0.5 - c[2]) / x;
  } else {
    double factorial = 1;
    for (std::size_t n = 0; n < c.size(); ++n) {
      if (n > 0) factorial *= static_cast<double>(n);
      double term = 1 / factorial;
      for (double k = static_cast<double>(n); std::abs(term) > 1e-18 / factorial; k += 2) {
        c[n] += term;
        term *= -x / ((k + 1) * (k + 2));
      }
    }
  }
  double power = 1;
  for (double& value : c) value *= power, power *= s;
  return c;
}

}  // namespace

SignalState state_on_sine(const Piece& p, double s) {
  const auto c = stumpff(p.kappa, s);
  return {p.value + p.rate * c[1] + p.curvature * c[2], p.rate * c[0] + p.curvature * c[1],
          p.curvature * c[0] - p.kappa * p.kappa * p.rate * c[1]};
}

std::ptrdiff_t piece_at(const Signal& signal, double t) {
  const auto after = std::upper_bound(signal.pieces.begin(), signal.pieces.end(), t,
                                      [](double time, const Piece& p) { return time < p.start; });
  return after - signal.pieces.begin() - 1;
}

SignalState state(const Signal& signal, double t) {
  const std::ptrdiff_t i = piece_at(signal, t);
  if (i < 0) return {};
  const Piece& piece = signal.pieces[i];
  return state_on(piece, t - piece.start);
}

SignalIntegrals integrals(const Signal& signal, double t) {
  SignalIntegrals sum;
  for (std::size_t i = 0; i < signal.pieces.size() && signal.pieces[i].start < t; ++i) {
    const Piece& p = signal.pieces[i];
    const double end = i + 1 < signal.pieces.size() ? std::min(t, signal.pieces[i + 1].start) : t, s = end - p.start;
    const SignalIntegrals more = integrals_on(p, s);
    sum.twice += sum.once * s + more.twice;
    sum.once += more.once;
  }
  return sum;
}

SignalIntegrals integrals_on(const Piece& p, double s) {
  if (p.kappa == 0)
    return {s * (p.value + s / 2 * (p.rate + s / 3 * p.curvature)),
            s * s / 2 * (p.value + s / 3 * (p.rate + s / 4 * p.curvature))};
  const auto c = stumpff(p.kappa, s);
  return {p.value * s + p.rate * c[2] + p.curvature * c[3], p.value * s * s / 2 + p.rate * c[3] + p.curvature * c[4]};
}

Signal delayed(Signal signal, double delay) {
  require_finite(delay, "delay", "s");
  for (Piece& piece : signal.pieces) piece.start += delay;
  require_valid(signal);  // throws if the delay is so long that short pieces vanish in round-off
  return signal;
}

Signal scaled(Signal signal, double factor) {
  require_finite(factor, "factor", "");
  for (Piece& piece : signal.pieces) piece.value *= factor, piece.rate *= factor, piece.curvature *= factor;
  return signal;
}

void require_valid(const Signal& signal) {
  const auto is_valid = [](const Piece& p) {
    // A sum of zeros, unless a number is infinite or NaN.
    return 0 * p.start + 0 * p.value + 0 * p.rate + 0 * p.curvature + 0 * p.kappa == 0 && p.kappa >= 0;
  };
  for (std::size_t i = 0; i < signal.pieces.size(); ++i) {
    const Piece& p = signal.pieces[i];
    if (is_valid(p) && (i == 0 || p.start > signal.pieces[i - 1].start)) continue;
    for (const double number : {p.start, p.value, p.rate, p.curvature})
      require_finite(number, "a number in a piece of a signal", "");
    require_not_negative(p.kappa, "κ of a piece of a signal", "rad/s");
    if (i > 0 && !(p.start > signal.pieces[i - 1].start))
      throw foundation::InvalidInput(
          fmt::format("piece {} of a signal starts at {:.9g} s, the one before at {:.9g} s: starts must increase",
                      i + 1, p.start, signal.pieces[i - 1].start));
  }
}

namespace {

constexpr const char* times_increase = "times must increase";

void check_times(foundation::Problems& problems, const std::string& subject, const std::vector<double>& t) {
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (t[i] > t[i - 1]) continue;
    const bool repeated = t[i] == t[i - 1];
    problems.error(subject, fmt::format("row {}: time {:.9g} s after {:.9g} s", i + 1, t[i], t[i - 1]), times_increase,
                   repeated ? "for a jump, give two different times, however close" : "sort the rows");
    return;
  }
}

}  // namespace

foundation::Problems check(const Samples& samples, const std::string& subject) {
  foundation::Problems problems;
  const std::vector<double>&t = samples.times, &u = samples.values;
  if (t.size() != u.size())
    problems.error(subject, fmt::format("{} times and {} values", t.size(), u.size()), "each time has one value",
                   "complete the rows");
  if (t.size() < 2)
    problems.error(subject, fmt::format("{} samples", t.size()), "a time history has two or more", "add rows");
  for (const auto* column : {&t, &u})
    for (std::size_t i = 0; i < column->size(); ++i)
      if (!std::isfinite((*column)[i])) {
        problems.error(subject,
                       fmt::format("row {}: the {} is {}", i + 1, column == &t ? "time" : "value", (*column)[i]),
                       "numbers must be finite", "fill the gap or remove the row");
        break;
      }
  if (!problems.has_errors()) check_times(problems, subject, t);
  if (problems.has_errors()) return problems;
  if (u.front() != 0)
    problems.warning(subject, fmt::format("the first value is {:.6g}", u.front()),
                     "the signal is zero before it and jumps there",
                     "begin with zero, or remove the mean, if no jump is intended");
  if (u.back() != 0) {
    const bool held = samples.afterwards == Samples::Afterwards::hold;
    problems.warning(subject, fmt::format("the last value is {:.6g}", u.back()),
                     held ? "the last value is held" : "the signal jumps to zero after it",
                     held ? "end with zero, or choose zero afterwards, if it should not be held"
                          : "end with zero if no jump is intended");
  }
  return problems;
}

Signal from_samples(const Samples& samples) {
  foundation::refuse_errors(check(samples, "samples"));
  Signal signal;
  signal.pieces.reserve(samples.times.size());
  for (std::size_t i = 0; i + 1 < samples.times.size(); ++i)
    signal.pieces.push_back({samples.times[i], samples.values[i],
                             (samples.values[i + 1] - samples.values[i]) / (samples.times[i + 1] - samples.times[i])});
  signal.pieces.push_back(
      {samples.times.back(), samples.afterwards == Samples::Afterwards::hold ? samples.values.back() : 0});
  require_valid(signal);  // throws if two times are so close that the rate overflows
  return signal;
}

}  // namespace trivet::excitation

// SPDX-License-Identifier: BSD-3-Clause
// Shock response spectra against the Runge–Kutta method with small steps, on signals with all kinds of pieces.
#include "trivet/excitation/shock_spectrum.h"

#include <gmock/gmock.h>

#include <cmath>

#include "support/matchers.h"
#include "trivet/excitation/pulses_and_sweeps.h"
#include "trivet/excitation/signal.h"

namespace shock_spectrum_test {

using namespace trivet::excitation;

/// Largest and smallest values over steps of the classical Runge–Kutta method; pieces end at whole steps, so no step
/// crosses a jump.
ShockResponse stepped(const Signal& base, double omega, double zeta, double ring_out) {
  ShockResponse r{omega};
  double z = 0, v = 0;
  for (std::size_t i = 0; i < base.pieces.size(); ++i) {
    const bool last = i + 1 == base.pieces.size();
    const Piece& piece = base.pieces[i];
    const double duration = last ? ring_out : base.pieces[i + 1].start - piece.start;
    const auto count = static_cast<int>(std::ceil(duration * std::max(omega, piece.kappa) * 1500)) + 100;
    const double h = duration / count;
    const auto acceleration = [&](double s, double zz, double vv) {
      return -state_on(piece, s).value - 2 * zeta * omega * vv - omega * omega * zz;
    };
    for (int k = 0; k <= count; ++k) {
      const double absolute = -2 * zeta * omega * v - omega * omega * z;
      double& largest = last ? r.residual_largest : r.primary_largest;
      double& smallest = last ? r.residual_smallest : r.primary_smallest;
      largest = std::max(largest, absolute);
      smallest = std::min(smallest, absolute);
      r.relative_displacement = std::max(r.relative_displacement, std::abs(z));
      if (k == count) break;
      const double s = k * h, a1 = acceleration(s, z, v), v2 = v + h / 2 * a1,
                   a2 = acceleration(s + h / 2, z + h / 2 * v, v2), v3 = v + h / 2 * a2,
                   a3 = acceleration(s + h / 2, z + h / 2 * v2, v3), v4 = v + h * a3,
                   a4 = acceleration(s + h, z + h * v3, v4);
      z += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
      v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
  }
  return r;
}

TEST(ShockSpectrum, AgreesWithSmallStepsInEveryColumn) {
  const Signal broken{{Piece{0, 1, 3, -40, 0}, Piece{0.2, -2, 30, 10, 25}, Piece{0.9, 0.5, 0, 0, 3}, Piece{1.0, 0.7}}};
  const Signal measured = from_samples({{0, 0.1, 0.15, 0.4, 0.45, 0.8}, {0, 2, -1, 0.3, -3, 0}});
  constexpr double step_error =
      1e-5;  // a peak between samples 1/1500 rad apart: some 1e-7 of the fastest part; the steps are more accurate
  for (const Signal& signal : {broken, measured, trapezoid(2, 0.1, 0.3, 0.05), sine_burst(1, 20, 3.3)})
    for (const double omega : {0.3, 2.0, 20.0, 90.0})
      for (const double zeta : {0.0, 0.05, 0.7, 0.99}) {
        const ShockResponse exact = shock_spectrum(signal, {omega}, zeta).at(0);
        const ShockResponse small = stepped(signal, omega, zeta, 50 / omega);
        const double scale = exact.maximax();
        EXPECT_NEAR(exact.primary_largest, small.primary_largest, step_error * scale);
        EXPECT_NEAR(exact.primary_smallest, small.primary_smallest, step_error * scale);
        EXPECT_NEAR(exact.residual_largest, small.residual_largest, step_error * scale);
        EXPECT_NEAR(exact.residual_smallest, small.residual_smallest, step_error * scale);
        EXPECT_THAT(exact.relative_displacement, trivet::test::RelativelyNear(small.relative_displacement, step_error))
            << omega << " " << zeta;
      }
}

}  // namespace shock_spectrum_test

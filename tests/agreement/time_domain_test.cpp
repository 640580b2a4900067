// SPDX-License-Identifier: BSD-3-Clause
// Signs and phases of the frequency response against an integration in time.
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <numbers>

#include "support/random_system.h"
#include "trivet/assembly/assembled.h"
#include "trivet/assembly/loads.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace time_domain_test {

using namespace trivet;

TEST(TimeDomain, TheSteadyStateIsRealPartOfAmplitudeTimesExpIOmegaT) {
  // From a state on the predicted orbit, forty periods of Runge–Kutta with forces amplitude·cos(ωt + phase) must end on
  // the orbit.
  constexpr int periods = 40, steps_per_period = 4000;
  constexpr double truncation = 1e-6;  // fourth order; halving the step divides the error by 16
  const model::System system = test::checked(test::RandomSystem(3).description(1, test::RandomDamping::viscous));
  const assembly::Assembled assembled = assembly::assemble(system);
  const auto& m = assembled.matrices;
  const double omega = 14;
  const Eigen::VectorXcd load = assembly::harmonic_loading(system, assembled).force.at(0);
  const Eigen::VectorXcd q = numerics::sweep(m, load, {omega}).response.col(0);
  const Eigen::MatrixXd inverse_mass = m.A.inverse();

  // The force from the description: component by component, each with its own phase.
  const model::Action& force = system.description().excitations[0].action;
  const auto generalized = [&](double t) -> Eigen::VectorXd {
    Eigen::Vector3d f, moment;
    for (int j = 0; j < 3; ++j) {
      f(j) = std::real(force.amplitude(j) * std::polar(1.0, omega * t));
      moment(j) = std::real(force.amplitude(j + 3) * std::polar(1.0, omega * t));
    }
    moment += Eigen::Vector3d(force.at.y() * f.z() - force.at.z() * f.y(), force.at.z() * f.x() - force.at.x() * f.z(),
                              force.at.x() * f.y() - force.at.y() * f.x());
    Eigen::VectorXd h(6);
    h << f, moment;
    return h;
  };
  Eigen::VectorXd state(12);
  state << q.real(), (std::complex<double>(0, omega) * q).real();
  const auto rate = [&](double t, const Eigen::VectorXd& s) -> Eigen::VectorXd {
    Eigen::VectorXd r(12);
    r << s.tail(6), inverse_mass * (generalized(t) - m.B * s.tail(6) - m.K * s.head(6));
    return r;
  };
  const double step = 2 * std::numbers::pi / omega / steps_per_period;
  double t = 0;
  for (int i = 0; i < periods * steps_per_period; ++i, t += step) {
    const Eigen::VectorXd a = rate(t, state), b = rate(t + step / 2, state + step / 2 * a),
                          c = rate(t + step / 2, state + step / 2 * b), d = rate(t + step, state + step * c);
    state += step / 6 * (a + 2 * b + 2 * c + d);
  }
  EXPECT_LE((state.head(6) - q.real()).norm(), truncation * q.norm());
  EXPECT_LE((state.tail(6) - (std::complex<double>(0, omega) * q).real()).norm(), truncation * omega * q.norm());
}

}  // namespace time_domain_test

// SPDX-License-Identifier: BSD-3-Clause
// How long do the RMS values of a machine of ten bodies take? Sixty coordinates and all six components at twenty
// mounts, from the matrices to the numbers, including the eigenproblem. Compared with the usual method, a sum of
// squares over a grid of 20,000 frequencies, and, for white noise, with the Lyapunov equation. Answers are compared
// before the timing.
#include <benchmark/benchmark.h>

#include <Eigen/LU>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>

#include "support/lyapunov.h"
#include "trivet/foundation/index.h"
#include "trivet/response/random/random_response.h"
#include "trivet/response/steady/frequency_response.h"

namespace {

using namespace trivet;

constexpr std::size_t bodies = 10, mounts = 20;
/// A bound on the error of the trapezoidal sum at 20,000 frequencies.
constexpr double grid_accuracy = 1e-3;
constexpr double exact_accuracy = 1e-8;

/// Ten boxes in a row, each on a mount from the ground and on one from the previous box; 4 … 12 % of critical damping.
model::Description machine() {
  std::mt19937 generator(5);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  model::Description d;
  for (std::size_t i = 0; i < bodies; ++i) {
    model::Body body;
    body.name = "body " + std::to_string(i);
    body.pose.position = {0.6 * static_cast<double>(i), 0, 0.4};
    const double m = number(80, 300);
    body.mass = spatial::from_inertia_about_pole(
        m, Eigen::Vector3d::Zero(),
        m * Eigen::Vector3d(number(0.02, 0.03), number(0.02, 0.03), number(0.02, 0.03)).asDiagonal());
    d.bodies.push_back(body);
  }
  for (std::size_t e = 0; e < mounts; ++e) {
    const std::size_t on = e / 2;
    model::Element element;
    element.name = "mount " + std::to_string(e);
    element.type = "matrix";
    element.k.body = on;
    element.k.at = {number(-0.3, 0.3), number(-0.3, 0.3), -0.2};
    if (e % 2 == 1 && on > 0) {
      element.n.body = on - 1;
      element.n.at = element.k.at + d.bodies[on].pose.position - d.bodies[on - 1].pose.position;
    } else {
      element.n.at = element.k.at + d.bodies[on].pose.position;
    }
    const double k = number(2e5, 2e6);
    spatial::Vector6 constants, dampers;
    constants << k, k * number(0.5, 1), k * number(1, 3), 0.01 * k, 0.01 * k, 0.01 * k;
    for (int j = 0; j < 6; ++j) dampers(j) = constants(j) * number(4e-4, 2e-3);
    element.law.nominal_stiffness = elements::constants_at_point(constants, Eigen::Vector3d::Zero(), 0);
    element.law.damping = elements::DampingMatrix{elements::constants_at_point(dampers, Eigen::Vector3d::Zero(), 0)};
    d.elements.push_back(element);
  }
  return d;
}

struct Machine {
  model::System system = model::System::checked(machine()).value();
  assembly::Assembled assembled = assembly::assemble(system);
  std::vector<assembly::Channel> channels = answer_channels();
  excitation::Spectrum spectrum{{{6, 60, 0.4, 0.9, false}, {60, 2000, 0.9, 1e-3, false}}};

  std::vector<assembly::Channel> answer_channels() const {
    std::vector<std::string> of = {"coordinates"};
    for (std::size_t e = 0; e < mounts; ++e) of.push_back("mount " + std::to_string(e));
    return assembly::channels(system, assembled, of, assembly::MotionQuantity::displacement);
  }
  assembly::Loading force() const {
    model::Action action;
    action.body = 4;
    action.amplitude << 10, 5, 30, 1, 2, 0.5;
    return assembly::loading(assembled, action);
  }
  assembly::Loading floor() const {
    model::Action action;
    action.amplitude << 0, 0.3, 1, 0, 0, 0;
    action.derivative = 2;
    return assembly::loading(assembled, action);
  }
};

const Machine& machine_once() {
  static const Machine m;
  return m;
}

Eigen::VectorXd rms_of(const response::RandomResponse& random) {
  Eigen::VectorXd result(to_index(random.channels.size()));
  for (std::size_t i = 0; i < random.channels.size(); ++i) result(to_index(i)) = random.channels[i].rms.value();
  return result;
}

Eigen::VectorXd by_trapezoids(const assembly::Loading& load, int points) {
  const Machine& m = machine_once();
  std::vector<double> omega;
  for (int i = 0; i < points; ++i) omega.push_back(6 + (2000.0 - 6) * i / (points - 1));
  const response::FrequencyResponse swept = response::frequency_response(m.assembled, m.channels, load, omega);
  Eigen::VectorXd density(points);
  for (int i = 0; i < points; ++i)
    density(i) =
        excitation::density(m.spectrum, omega[i]) * (i == 0 || i == points - 1 ? 0.5 : 1) * (omega[1] - omega[0]);
  Eigen::VectorXd result(to_index(m.channels.size()));
  for (std::size_t c = 0; c < m.channels.size(); ++c)
    result(to_index(c)) = std::sqrt(swept.curves[c].value.cwiseAbs2().dot(density));
  return result;
}

/// RMS of the coordinates under a white force, 0 … ∞.
Eigen::VectorXd by_lyapunov(double density) {
  const Machine& machine = machine_once();
  const auto& m = machine.assembled.matrices;
  const Eigen::Index n = m.size();
  const Eigen::PartialPivLU<Eigen::MatrixXd> mass(m.A);
  Eigen::MatrixXd state = Eigen::MatrixXd::Zero(2 * n, 2 * n), intensity = state;
  state.topRightCorner(n, n).setIdentity();
  state.bottomLeftCorner(n, n) = -mass.solve(m.K);
  state.bottomRightCorner(n, n) = -mass.solve(m.B);
  const Eigen::VectorXd push = mass.solve(machine.force().force.at(0).real());
  intensity.bottomRightCorner(n, n) = std::numbers::pi * density * push * push.transpose();
  return test::lyapunov_covariance(state, intensity).diagonal().head(n).cwiseSqrt();
}

void compare(const char* what, const Eigen::VectorXd& mine, const Eigen::VectorXd& other, double allowed) {
  const double scale = 1e-9 * other.maxCoeff();
  const double worst = ((mine - other).array().abs() / (other.array() + scale)).maxCoeff();
  std::printf("%s: largest relative difference %.1e\n", what, worst);
  if (!(worst < allowed)) std::exit(1);
}

void compare_answers() {
  const Machine& m = machine_once();
  for (const auto& [what, load] :
       {std::pair{"force, against trapezoids", m.force()}, {"floor, against trapezoids", m.floor()}}) {
    const response::RandomResponse random =
        response::random_response(m.assembled, m.channels, {{{"input", load, m.spectrum}}, {}});
    std::printf("%zu answers by %s %s\n", random.channels.size(), name(random.method), random.remark.c_str());
    compare(what, rms_of(random), by_trapezoids(load, 20000), grid_accuracy);
  }
  const auto coordinates =
      assembly::channels(m.system, m.assembled, {"coordinates"}, assembly::MotionQuantity::displacement);
  compare("white noise, against the Lyapunov equation",
          rms_of(response::random_response(m.assembled, coordinates,
                                           {{{"noise", m.force(), excitation::flat_spectrum(1, 0, 1e8)}}, {}})),
          by_lyapunov(1), exact_accuracy);
}

void RandomForce(benchmark::State& state) {
  const Machine& m = machine_once();
  const response::RandomLoading loading{{{"force", m.force(), m.spectrum}}, {}};
  for (auto _ : state)
    benchmark::DoNotOptimize(response::random_response(m.assembled, m.channels, loading).channels.data());
}
BENCHMARK(RandomForce)->Unit(benchmark::kMillisecond);

void RandomFloorAcceleration(benchmark::State& state) {
  const Machine& m = machine_once();
  const response::RandomLoading loading{{{"floor", m.floor(), m.spectrum}}, {}};
  for (auto _ : state)
    benchmark::DoNotOptimize(response::random_response(m.assembled, m.channels, loading).channels.data());
}
BENCHMARK(RandomFloorAcceleration)->Unit(benchmark::kMillisecond);

void TrapezoidsOf20000Frequencies(benchmark::State& state) {
  const assembly::Loading load = machine_once().force();
  for (auto _ : state) benchmark::DoNotOptimize(by_trapezoids(load, 20000).data());
}
BENCHMARK(TrapezoidsOf20000Frequencies)->Unit(benchmark::kMillisecond);

void LyapunovForWhiteNoise(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(by_lyapunov(1).data());
}
BENCHMARK(LyapunovForWhiteNoise)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  compare_answers();
  benchmark::RunSpecifiedBenchmarks();
}

// SPDX-License-Identifier: BSD-3-Clause
// How long is a sweep of one six-coordinate machine? The paper's example; Trivet's checked sweep beside Eigen's fixed-size
// pivoted LU, the usual C++ way, unchecked. Answers are compared before anything is timed.
#include <benchmark/benchmark.h>

#include <Eigen/LU>
#include <cstdio>
#include <cstdlib>

#include "trivet/assembly/loads.h"
#include "trivet/numerics/frequency_sweep.h"
#include "trivet/response/peaks.h"
#include "trivet/study/project.h"

namespace {

using namespace trivet;
using Matrix6c = Eigen::Matrix<std::complex<double>, 6, 6>;
using Vector6c = Eigen::Matrix<std::complex<double>, 6, 1>;

struct Machine {
  study::Project project = study::read_project(TRIVET_PAPER).value();
  const model::System& system = project.base().system;
  assembly::Assembled assembled = assembly::assemble(system);
  Eigen::VectorXcd load = assembly::harmonic_loading(system, assembled).force.at(0);
};

const Machine& machine() {
  static const Machine m;
  return m;
}

std::vector<double> frequencies(std::int64_t count) {
  std::vector<double> omega(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < omega.size(); ++i) omega[i] = 200.0 * static_cast<double>(i) / static_cast<double>(count);
  return omega;
}

Vector6c by_eigen(double omega) {
  const numerics::DynamicMatrices& m = machine().assembled.matrices;
  const std::complex<double> i(0, 1);
  const Eigen::Matrix<double, 6, 6> A = m.A, B = m.B, K = m.K;
  const Matrix6c z = K.cast<std::complex<double>>() + i * omega * B.cast<std::complex<double>>() - omega * omega * A.cast<std::complex<double>>();
  return z.partialPivLu().solve(Vector6c(machine().load));
}

void compare_answers() {
  const std::vector<double> omega = frequencies(10000);
  const Eigen::MatrixXcd mine = numerics::sweep(machine().assembled.matrices, machine().load, omega).response;
  double worst = 0;
  for (std::size_t i = 0; i < omega.size(); ++i) {
    const Vector6c other = by_eigen(omega[i]);
    worst = std::max(worst, (mine.col(static_cast<Eigen::Index>(i)) - other).norm() / other.norm());
  }
  std::printf("largest relative difference over 10,000 frequencies: %.1e\n", worst);
  if (!(worst < 1e-11)) std::exit(1);
}

void Sweep(benchmark::State& state) {
  const std::vector<double> omega = frequencies(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(numerics::sweep(machine().assembled.matrices, machine().load, omega).response.data());
  state.counters["per frequency"] = benchmark::Counter(static_cast<double>(state.range(0)), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(Sweep)->Arg(1000)->Arg(10000)->Arg(1000000)->Unit(benchmark::kMillisecond);

void EigenFixedLu(benchmark::State& state) {
  const std::vector<double> omega = frequencies(state.range(0));
  Eigen::MatrixXcd q(6, state.range(0));
  for (auto _ : state) {
    for (std::size_t i = 0; i < omega.size(); ++i) q.col(static_cast<Eigen::Index>(i)) = by_eigen(omega[i]);
    benchmark::DoNotOptimize(q.data());
  }
  state.counters["per frequency"] = benchmark::Counter(static_cast<double>(state.range(0)), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(EigenFixedLu)->Arg(1000)->Arg(10000)->Arg(1000000)->Unit(benchmark::kMillisecond);

void ExactPeaksOfSixCoordinates(benchmark::State& state) {
  const modal::Modes modes = modal::modes(machine().system, machine().assembled);
  const modal::Roots roots = modal::roots(machine().system, machine().assembled, modes);
  const auto channels = assembly::channels(machine().system, machine().assembled, {"coordinates"}, assembly::Quantity::displacement);
  for (auto _ : state) benchmark::DoNotOptimize(response::peaks(machine().assembled, channels, machine().load, modes, roots).list.data());
}
BENCHMARK(ExactPeaksOfSixCoordinates)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  compare_answers();
  benchmark::RunSpecifiedBenchmarks();
}

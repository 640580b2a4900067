// SPDX-License-Identifier: BSD-3-Clause
// How much time does an exact coil spring cost? The published spring of 7.6 turns: stiffness, dynamic stiffness,
// natural frequencies, reduction; compared with 608 straight beam elements, the usual method. Answers are compared
// before the timing.
#include <benchmark/benchmark.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "trivet/elements/coil_preload.h"
#include "trivet/elements/coil_reduction.h"
#include "trivet/spatial/rigid_motion.h"

namespace {

using namespace trivet;
using namespace trivet::elements;
constexpr double pi = std::numbers::pi;
constexpr int pieces = 608;

CoilSpring spring() {
  CoilSpring s;
  s.wire = RoundWire{1e-3};
  s.mean_diameter = 10e-3;
  s.active_coils = 7.6;
  s.active_length = 2 * pi * 7.6 * 5e-3 * std::tan(8.5744 * pi / 180);
  s.youngs_modulus = 2.06e11;
  s.shear_modulus = 2.06e11 / 2.6;
  s.density = 7900;
  return s;
}

/// A straight shear-flexible beam between two points of the wire, global axes, mass lumped at its ends.
struct Piece {
  Matrix12 stiffness, mass;
};

Piece piece(const CoilSpring& s, double from, double to) {
  const Helix line = helix(s);
  const auto place = [&](double part) -> Eigen::Vector3d {
    return from_axis(line, line.turn * part) + Eigen::Vector3d(0, 0, line.height * part);
  };
  const WireSection w = wire_section(s);
  const Eigen::Vector3d chord = place(to) - place(from);
  const double L = chord.norm(), E = s.youngs_modulus, G = s.shear_modulus, I = w.second_moments(0), bend = 1 / (E * I);
  Matrix6 flexibility = Matrix6::Zero();  // at the far end, e3 along the chord
  flexibility.diagonal() << L / (w.shear_factor * G * w.area) + bend * L * L * L / 3,
      L / (w.shear_factor * G * w.area) + bend * L * L * L / 3, L / (E * w.area), L * bend, L * bend,
      L / (G * w.torsion_constant);
  flexibility(0, 4) = flexibility(4, 0) = bend * L * L / 2, flexibility(1, 3) = flexibility(3, 1) = -bend * L * L / 2;
  const Matrix6 turn = spatial::both_blocks(spatial::axes_along(chord));
  Piece p;
  p.stiffness = from_moved_end(turn * flexibility.llt().solve(Matrix6(turn.transpose())), chord);
  spatial::Vector12 half;
  const double mass = s.density * w.area * L / 2, turning = s.density * I * L / 2;
  half << mass, mass, mass, turning, turning, turning, mass, mass, mass, turning, turning, turning;
  p.mass = half.asDiagonal();
  return p;
}

std::vector<Piece> all_pieces(const CoilSpring& s) {
  std::vector<Piece> result;
  for (int i = 0; i < pieces; ++i) result.push_back(piece(s, double(i) / pieces, (i + 1.0) / pieces));
  return result;
}

/// Dynamic stiffness of the chain at the seats, condensed node by node.
Matrix12 chain(const CoilSpring& s, const std::vector<Piece>& beams, double omega) {
  Matrix12 sum = beams[0].stiffness - omega * omega * beams[0].mass;
  for (std::size_t i = 1; i < beams.size(); ++i) {
    const Matrix12 next = beams[i].stiffness - omega * omega * beams[i].mass;
    const Eigen::PartialPivLU<Matrix6> middle(sum.bottomRightCorner<6, 6>() + next.topLeftCorner<6, 6>());
    Eigen::Matrix<double, 6, 12> to_middle;
    to_middle << sum.bottomLeftCorner<6, 6>(), next.topRightCorner<6, 6>();
    Matrix12 joined = Matrix12::Zero();
    joined.topLeftCorner<6, 6>() = sum.topLeftCorner<6, 6>();
    joined.bottomRightCorner<6, 6>() = next.bottomRightCorner<6, 6>();
    sum = joined - to_middle.transpose() * middle.solve(to_middle);
  }
  const Helix line = helix(s);
  Matrix12 seats = Matrix12::Zero();
  seats.topLeftCorner<6, 6>() = spatial::rigid_motion(from_axis(line, 0));
  seats.bottomRightCorner<6, 6>() = spatial::rigid_motion(from_axis(line, line.turn));
  return seats.transpose() * sum * seats;
}

double difference(const Matrix12& a, const Matrix12& b) {
  double worst = 0;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
      worst = std::max(worst, std::abs(a(i, j) - b(i, j)) / std::sqrt(std::abs(b(i, i) * b(j, j))));
  return worst;
}

void compare_answers() {
  const CoilSpring s = spring();
  const std::vector<Piece> beams = all_pieces(s);
  const double at_rest = difference(chain(s, beams, 0), stiffness(s));
  const double moving = difference(chain(s, beams, 2 * pi * 100), dynamic_stiffness(s, 2 * pi * 100));
  const double first = natural_frequencies(s, SeatsHeld::both, 1)[0] / (2 * pi);
  std::printf(
      "%d straight elements differ by %.1e at rest, %.1e at 100 Hz; first frequency %.6f Hz, published 393.400\n",
      pieces, at_rest, moving, first);
  if (!(at_rest < 2e-3 && moving < 5e-3 && std::abs(first - 393.4) < 1e-3)) std::exit(1);
}

void Stiffness(benchmark::State& state) {
  CoilSpring s = spring();
  for (auto _ : state) {
    s.start_angle += 1e-3;
    benchmark::DoNotOptimize(stiffness(s).data());
  }
}
BENCHMARK(Stiffness)->Unit(benchmark::kMicrosecond);

void StraightElementsAtRest(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(chain(spring(), all_pieces(spring()), 0).data());
}
BENCHMARK(StraightElementsAtRest)->Unit(benchmark::kMicrosecond);

void DynamicStiffness(benchmark::State& state) {
  const SeatedCoil coil = seated_coil(spring());
  double hertz = double(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(dynamic_stiffness(coil, 2 * pi * (hertz += 1e-3)).data());
}
BENCHMARK(DynamicStiffness)->Arg(1)->Arg(300)->Arg(10000)->Unit(benchmark::kMicrosecond);

void DynamicStiffnessWithLoss(benchmark::State& state) {
  CoilSpring s = spring();
  s.loss_factor = 0.02;
  const SeatedCoil coil = seated_coil(s);
  double hertz = double(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(dynamic_stiffness(coil, std::complex<double>(2 * pi * (hertz += 1e-3))).data());
}
BENCHMARK(DynamicStiffnessWithLoss)->Arg(1)->Arg(300)->Arg(10000)->Unit(benchmark::kMicrosecond);

void StraightElementsMoving(benchmark::State& state) {
  const CoilSpring s = spring();
  const std::vector<Piece> beams = all_pieces(s);
  for (auto _ : state) benchmark::DoNotOptimize(chain(s, beams, 2 * pi * 300).data());
}
BENCHMARK(StraightElementsMoving)->Unit(benchmark::kMicrosecond);

void TenNaturalFrequencies(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(natural_frequencies(spring(), SeatsHeld::both, 10).data());
}
BENCHMARK(TenNaturalFrequencies)->Unit(benchmark::kMillisecond);

void ReductionToTenModes(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(reduced(spring(), 10).mass.data());
}
BENCHMARK(ReductionToTenModes)->Unit(benchmark::kMillisecond);

void Compressed(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(compressed_by(spring(), 0.01).stiffness.data());
}
BENCHMARK(Compressed)->Unit(benchmark::kMicrosecond);

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  compare_answers();
  benchmark::RunSpecifiedBenchmarks();
}

// SPDX-License-Identifier: BSD-3-Clause
// How long does a rubber mount take from its dimensions to its checked 12×12 with an error estimate? The bonded
// cylinder of 50 mm × 25 mm, a thin disc, a sandwich, a block of 100,000 unknowns in tetrahedra, and a preload. Answers
// are compared before the timing.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "../tests/support/tetrahedra.h"
#include "trivet/fem/preload.h"
#include "trivet/fem/shapes.h"

namespace {

using namespace trivet;

const fem::Disc cylinder{.diameter = 0.05, .layers = {{.thickness = 0.025}}};
const fem::Disc thin{.diameter = 0.1, .layers = {{.thickness = 0.0025}}};
const fem::Disc sandwich{.diameter = 0.1, .layers = fem::sandwich_layers(4, 0.008, 0.002)};
const fem::Block block{.width = 0.06, .depth = 0.05, .layers = {{.thickness = 0.03}}};
const std::vector<fem::Material> materials{fem::linear_elastic(3e6, 0.4995), fem::linear_elastic(2.1e11, 0.3)};

void compare_answers() {
  const auto solid = fem::condense(cylinder, materials);
  const auto& c = solid.stiffness;
  const double torsion = fem::shear_modulus(materials[0]) * std::numbers::pi * std::pow(0.025, 4) / 2 / 0.025;
  const double errors[] = {c(8, 8) / 363.45e3 - 1, c(6, 6) / 68.55e3 - 1, c(11, 11) / torsion - 1};
  std::printf("bonded cylinder: axial %+.3f %%, shear %+.3f %%, torsion %+.5f %%; estimated %.3f, %.3f, %.5f %%\n",
              100 * errors[0], 100 * errors[1], 100 * errors[2], 100 * solid.relative_error(8, 8),
              100 * solid.relative_error(6, 6), 100 * solid.relative_error(11, 11));
  for (const double error : errors)
    if (!(std::abs(error) < 0.0015)) std::exit(1);
}

void condense(benchmark::State& state, const fem::Shape& shape) {
  for (auto _ : state) benchmark::DoNotOptimize(fem::condense(shape, materials, static_cast<int>(state.range(0))));
}
BENCHMARK_CAPTURE(condense, bonded_cylinder, cylinder)->DenseRange(2, 4)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(condense, thin_disc_of_shape_factor_10, thin)
    ->DenseRange(2, 3)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(condense, sandwich_of_four, sandwich)->DenseRange(2, 3)->Unit(benchmark::kMillisecond)->UseRealTime();

void compressed_cylinder(benchmark::State& state) {
  const fem::Mesh mesh = fem::mesh(cylinder, static_cast<int>(state.range(0)));
  fem::Preload load;
  load.value(2) = -0.15 * 0.025;
  for (auto _ : state) benchmark::DoNotOptimize(fem::preloaded_stiffness(mesh, materials, fem::frame(cylinder), load));
}
BENCHMARK(compressed_cylinder)->DenseRange(2, 3)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Both kinds of tetrahedra, for value and bracket; level 5 has 26,000 unknowns, level 8 has 100,000.
void block_of_tetrahedra(benchmark::State& state) {
  const fem::Mesh mesh = test::in_tetrahedra(fem::mesh(block, static_cast<int>(state.range(0))));
  fem::SolidStiffness solid;
  for (auto _ : state) solid = fem::condense(mesh, materials, fem::frame(block));
  state.counters["unknowns"] = solid.unknowns;
}
BENCHMARK(block_of_tetrahedra)->Arg(5)->Arg(8)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  compare_answers();
  benchmark::RunSpecifiedBenchmarks();
}

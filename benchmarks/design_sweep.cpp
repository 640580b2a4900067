// SPDX-License-Identifier: BSD-3-Clause
// How long do the highest amplitudes of 10,000 designs on 500 frequencies each take, on one core and on two? Compared
// with the paper's loop and the best vectorised forms.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>

#include "quad.h"
#include "random_designs.h"
#include "rival.h"
#include "rivals/fixed_lu.h"
#include "rivals/lapack.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/numerics/batch/sweep_maxima.h"

namespace {

using namespace trivet;
using namespace trivet::benchmarks;

constexpr Eigen::Index count = 10000;
constexpr std::size_t few = 20, some = 200, points = 500;

/// Method timed by the wall clock, because two threads work.
Method by_the_clock(std::string name, const std::function<void()>& work) {
  return {std::move(name), [work] {
            const auto from = std::chrono::steady_clock::now();
            work();
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count() / double(count);
          }};
}

}  // namespace

int main() {
  openblas_set_num_threads(1);
  const numerics::Designs designs = random_designs(count);
  const std::vector<double> omega = even_frequencies(points);
  const std::vector<double> A = full_matrices(designs.A, some), B = full_matrices(designs.B, some),
                            K = full_matrices(designs.K, some);
  const Vector6 load = designs.load.row(0).transpose();
  const foundation::TemporaryFolder folder;
  const auto file = [&](const char* name, const double* x, std::size_t size) {
    write_numbers(folder.path() / name, x, size);
  };
  numerics::SweepOptions one, two;
  one.threads = 1;
  two.threads = 2;
  const numerics::SweepOptions directly = one;
  one.every_backward_error = two.every_backward_error = false;
  const std::string question = "designs by frequencies";

  std::vector<double> by_eigen(6 * some);
  const auto eigen = [&] {
    std::vector<std::complex<double>> q(6 * points);
    for (std::size_t d = 0; d < some; ++d) {
      eigen_fixed_lu({A.data() + 36 * d, B.data() + 36 * d, K.data() + 36 * d, load.data()}, omega.data(), points,
                     q.data());
      for (std::size_t j = 0; j < 6; ++j) {
        double highest = 0;
        for (std::size_t i = 0; i < points; ++i) highest = std::max(highest, std::norm(q[6 * i + j]));
        by_eigen[6 * d + j] = std::sqrt(highest);
      }
    }
  };
  // Truth: quadruple precision at every frequency.
  const auto truth = [&](std::size_t d) {
    const PaperMachine m = machine_of(designs, Eigen::Index(d));
    std::array<double, 6> highest{};
    for (const double w : omega) {
      const auto q = quad_solution(m.A, m.B, m.K, m.load, w);
      for (std::size_t j = 0; j < 6; ++j)
        highest[j] = std::max(highest[j], std::hypot(double(q[j].re), double(q[j].im)));
    }
    return highest;
  };
  std::vector<std::array<double, 6>> exact;
  for (std::size_t d = 0; d < few; ++d) exact.push_back(truth(d));
  const auto check = [&](const char* method, const auto& value) {
    double worst = 0;
    for (std::size_t d = 0; d < few; ++d)
      for (std::size_t j = 0; j < 6; ++j) {
        const double error = std::abs(value(d, j) / exact[d][j] - 1);
        worst = error <= worst ? worst : error;
      }
    std::printf("  error of %-40s %.1e in %zu designs\n", method, worst, few);
    compared(method, worst, 1e-9);
    return worst;
  };
  const auto maxima = numerics::sweep_maxima(designs, omega, one);
  const double error =
      check("Trivet", [&](std::size_t d, std::size_t j) { return maxima.amplitude(Eigen::Index(d), Eigen::Index(j)); });
  if ((numerics::sweep_maxima(designs, omega, two).amplitude != maxima.amplitude).any())
    compared("one thread and two", 1, 0);
  eigen();
  check("Eigen", [&](std::size_t d, std::size_t j) { return by_eigen[6 * d + j]; });

  const auto rivals_of = [&](const char* script, std::size_t of) {
    file("A", A.data(), 36 * of), file("B", B.data(), 36 * of), file("K", K.data(), 36 * of);
    file("H", load.data(), 6), file("p", omega.data(), points);
    return std::make_unique<Rival>(script, folder.path());
  };
  std::vector<double> seconds;
  {
    const OneCore one_core;
    const auto octave = rivals_of("designs.m", few), python = rivals_of("designs.py", some);
    const auto check_rival = [&](Rival& rival, const char* name) {
      const auto all = rival.answers(name);
      check(name, [&](std::size_t d, std::size_t j) { return all[6 * d + j].real(); });
    };
    for (const char* name : {"loop", "ldlt", "modal"}) check_rival(*octave, name);
    for (const char* name : {"batched", "modal"}) check_rival(*python, name);
    seconds = measure(
        {question, "10,000 designs × 500 frequencies, Octave 20 of them, others 200", "design", error},
        {in_process("Trivet, one core", count, [&] { (void)numerics::sweep_maxima(designs, omega, one); }),
         in_process("Trivet, directly, every backward error computed", count,
                    [&] { (void)numerics::sweep_maxima(designs, omega, directly); }),
         octave->method("loop", "Octave, the paper's loop", few),
         octave->method("ldlt", "Octave, LDLᵀ vectorised by hand", few),
         octave->method("modal", "Octave, poles vectorised", few),
         python->method("batched", "NumPy, batched solve", some), python->method("modal", "NumPy, batched poles", some),
         in_process("Eigen, fixed 6×6 pivoted LU", some, eigen)},
        7);
  }
  const double before = idle_part();
  const Method both = by_the_clock("two", [&] { (void)numerics::sweep_maxima(designs, omega, two); });
  std::vector<double> wall;
  for (int i = 0; i < 9; ++i) wall.push_back(both.seconds());
  std::sort(wall.begin(), wall.end());
  if (before < 0.9 || idle_part() < 0.9) {
    record(question, "two cores: contended", 1e6 * wall[4], "µs per design, wall", "", false);
    return 0;
  }
  record(question, "two cores, wall, µs per design", 1e6 * wall[4], "", "", true);
  record(question, "two cores, times as fast as one", seconds[0] / wall[4], "", "", true);
  const auto against = [&](const std::string& rival, double of_one, double wanted) {
    const double goal = wanted * goal_factor(), found = of_one / wall[4];
    record(question, "two cores against " + rival, found, "", "≥ " + std::to_string(static_cast<int>(goal)),
           found >= goal);
  };
  against("Octave's loop", seconds[2], 1500);
  against("NumPy's batched solve", seconds[5], 110);
}

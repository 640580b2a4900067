// SPDX-License-Identifier: BSD-3-Clause
// What does one frequency of a direct six-coordinate sweep cost? The checked sweep into reused memory beside Eigen's fixed-size pivoted LU and the
// peak of multiply-adds, all in one run and in time of one thread; answers are compared first.
#include <time.h>

#include <Eigen/LU>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "trivet/numerics/frequency_sweep.h"
#include "trivet/numerics/instruction_set.h"
#include "trivet/numerics/sweep_maxima.h"

namespace {

using namespace trivet::numerics;
using Matrix6c = Eigen::Matrix<Complex, 6, 6>;
using Vector6c = Eigen::Matrix<Complex, 6, 1>;

/// Of one solution for a real load: entries of Z 84, elimination 280 + 90 + 36, substitution 116, way back 20 + 12, growth 81.
constexpr double flops = 719;
constexpr int runs = 31;

double thread_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// The second of two runs: memory is warm, and so are the vector units.
template <typename Work>
double seconds(const Work& work) {
  work();
  const double start = thread_time();
  work();
  return thread_time() - start;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

#if defined(__x86_64__)
/// Multiply-adds of eight lanes in twelve independent chains: flops per second.
__attribute__((target("avx512f"))) double peak() {
  constexpr long rounds = 20000;
  typedef double Lanes __attribute__((vector_size(64)));
  Lanes a[12], factor, term;
  for (int lane = 0; lane < 8; ++lane) factor[lane] = 0.999, term[lane] = 1e-5;
  for (Lanes& each : a) each = term;
  Lanes a0 = a[0], a1 = a[1], a2 = a[2], a3 = a[3], a4 = a[4], a5 = a[5], a6 = a[6], a7 = a[7], a8 = a[8], a9 = a[9], a10 = a[10], a11 = a[11];
  const double start = thread_time();
  for (long i = 0; i < rounds; ++i)
    asm volatile(
        "vfmadd213pd %13,%12,%0\n vfmadd213pd %13,%12,%1\n vfmadd213pd %13,%12,%2\n vfmadd213pd %13,%12,%3\n vfmadd213pd %13,%12,%4\n vfmadd213pd %13,%12,%5\n"
        "vfmadd213pd %13,%12,%6\n vfmadd213pd %13,%12,%7\n vfmadd213pd %13,%12,%8\n vfmadd213pd %13,%12,%9\n vfmadd213pd %13,%12,%10\n vfmadd213pd %13,%12,%11"
        : "+v"(a0), "+v"(a1), "+v"(a2), "+v"(a3), "+v"(a4), "+v"(a5), "+v"(a6), "+v"(a7), "+v"(a8), "+v"(a9), "+v"(a10), "+v"(a11)
        : "v"(factor), "v"(term));
  const double time = thread_time() - start;
  return rounds * 12.0 * 16 / time;
}
#endif

DynamicMatrices machine() {
  std::srand(1);
  const Eigen::MatrixXd r = Eigen::MatrixXd::Random(6, 6), s = Eigen::MatrixXd::Random(6, 6), q = Eigen::MatrixXd::Random(6, 3);
  return {Eigen::MatrixXd::Identity(6, 6) + 0.2 * r * r.transpose(), 3 * q * q.transpose(), 1000 * s * s.transpose() + 100 * Eigen::MatrixXd::Identity(6, 6), {}, true};
}

}  // namespace

int main() {
  const DynamicMatrices m = machine();
  const Eigen::VectorXcd load = Eigen::VectorXd::Random(6).cast<Complex>();
  std::vector<double> omega(10000);
  for (std::size_t i = 0; i < omega.size(); ++i) omega[i] = 0.01 * static_cast<double>(i);
  const Eigen::Matrix<double, 6, 6> A = m.A, B = m.B, K = m.K;
  const Vector6c h = load;
  Eigen::MatrixXcd by_eigen(6, 10000);
  const auto eigen = [&] {
    for (std::size_t i = 0; i < omega.size(); ++i) {
      const Matrix6c z = K.cast<Complex>() + Complex(0, omega[i]) * B.cast<Complex>() - omega[i] * omega[i] * A.cast<Complex>();
      by_eigen.col(static_cast<Eigen::Index>(i)) = z.partialPivLu().solve(h);
    }
  };
  SweepPlanes checked, every;
  const SweepOptions by_growth{.every_backward_error = false, .threads = 1, .progress = {}}, by_residual{.every_backward_error = true, .threads = 1, .progress = {}};
  SweepMaxima maxima;
  eigen();
  sweep(m, load, omega, checked, by_growth);
  double worst = 0;
  for (Eigen::Index i = 0; i < 10000; ++i) {
    Vector6c q;
    for (int j = 0; j < 6; ++j) q(j) = {checked.re(i, j), checked.im(i, j)};
    worst = std::max(worst, (q - by_eigen.col(i)).norm() / by_eigen.col(i).norm());
  }
  std::printf("%s; largest relative difference %.1e, %d frequencies redone\n", instruction_set().c_str(), worst, checked.fallbacks);
  if (!(worst < 1e-11)) return 1;
  std::vector<double> growth, residual, reduced, rival, ratio, rate;
  for (int run = 0; run < runs; ++run) {
    growth.push_back(1e5 * seconds([&] { sweep(m, load, omega, checked, by_growth); }));
    rival.push_back(1e5 * seconds(eigen));
    residual.push_back(1e5 * seconds([&] { sweep(m, load, omega, every, by_residual); }));
    reduced.push_back(1e5 * seconds([&] { maxima = sweep_maxima(m, load, omega, by_growth); }));
    ratio.push_back(rival.back() / growth.back());
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) rate.push_back(flops / growth.back() * 1e9 / peak());
#endif
  }
  std::printf("ns per frequency: sweep %.2f, with every backward error %.2f, maxima only %.2f, Eigen fixed LU %.1f: %.1f times\n", median(growth), median(residual),
              median(reduced), median(rival), median(ratio));
  if (!rate.empty()) std::printf("%.0f %% of the peak of multiply-adds of eight lanes, %.1f GFLOP/s\n", 100 * median(rate), flops / median(growth) / median(rate));
}

// SPDX-License-Identifier: BSD-3-Clause
// How long does a sweep of one six-coordinate machine by poles and residues take? With and without their set-up, 10,000
// and 1,000,000 frequencies, compared with the best vectorised forms in Octave and NumPy and Eigen's fixed-size LU.
#include <algorithm>
#include <string>

#include "rivals/lapack.h"
#include "sweep_problem.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/sweep/pole_sweep.h"

namespace {

using namespace trivet;
using namespace trivet::benchmarks;

void sweep(std::size_t count, const char* size, int turns) {
  SweepProblem problem(count);
  const numerics::DynamicMatrices matrices{problem.machine.A, problem.machine.B, problem.machine.K, {}, true};
  const Eigen::VectorXcd h = problem.machine.load.cast<std::complex<double>>();
  const double items = static_cast<double>(count);
  const Eigen::Map<const Eigen::ArrayXd> omega(problem.omega.data(), to_index(count));
  Eigen::ArrayXXd re(count, 6), im(count, 6);
  Eigen::MatrixXcd q(6, count), other(6, count);
  const auto ready = numerics::PoleSweep::try_build(matrices, h);
  compared("Trivet, poles proven", ready ? 0 : 1, 0);
  const auto known = [&] { compared("Trivet, sampled residuals", ready->response(omega, re, im) ? 0 : 1, 0); };
  const auto complete = [&] {
    compared("Trivet, sampled residuals", numerics::PoleSweep::try_build(matrices, h)->response(omega, re, im) ? 0 : 1,
             0);
  };
  const auto eigen = [&] { eigen_fixed_lu(problem.system(), problem.omega.data(), count, other.data()); };
  complete();
  q.real() = re.transpose();
  q.imag() = im.transpose();
  const double error = problem.check("Trivet", q);
  eigen();
  problem.check("Eigen", other);
  Rival octave("sweep.m", problem.folder()), python("sweep.py", problem.folder());
  for (const char* name : {"modal", "modal_in_pieces"}) problem.check(octave, name);
  for (const char* name : {"modal", "modal_pairs"}) problem.check(python, name);

  constexpr double flops = 360;  // six pairs: 6 for the denominator, 6 for its inverse, 8 for each of six coordinates
  const std::string question = "sweep by poles of six coordinates";
  const auto medians = measure(
      {question, size, "frequency", error},
      {in_process("Trivet, with set-up", items, complete), in_process("Trivet, poles known", items, known, flops),
       octave.method("modal", "Octave, poles vectorised", items),
       octave.method("modal_in_pieces", "Octave, poles vectorised, in pieces", items, 45),
       python.method("modal", "NumPy, poles vectorised", items, 25),
       python.method("modal_pairs", "NumPy, pairs of poles, real arithmetic", items, 25),
       in_process("Eigen, fixed 6×6 pivoted LU", items, eigen, 0, 100)},
      turns);
  if (count == 10000) {
    record(question, "10,000 frequencies with set-up / without", medians[0] / medians[1], "", "≤ 1.3",
           medians[0] <= 1.3 * medians[1]);
  } else {
    std::vector<double> stores;
    for (int i = 0; i < 7; ++i) stores.push_back(streaming_store_bandwidth());
    std::sort(stores.begin(), stores.end());
    record(question, "stores past the caches, one core", 1e-9 * stores[3], "GB/s", "", true);
    record(question, "part of that by 1,000,000 frequencies, 96 byte each", 100 * 96 / medians[1] / stores[3], "%", "",
           true);
  }
}

}  // namespace

int main() {
  const OneCore one_core;
  openblas_set_num_threads(1);
  sweep(10000, "10,000 frequencies", 21);
  sweep(1000000, "1,000,000 frequencies", 7);
}

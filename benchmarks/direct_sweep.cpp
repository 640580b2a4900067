// SPDX-License-Identifier: BSD-3-Clause
// How long is a sweep of one six-coordinate machine with general damping, every frequency solved? Beside the paper's loop and the best
// vectorised form in Octave, NumPy, SciPy, Eigen's fixed-size LU and LAPACK.
#include "rivals/fixed_lu.h"
#include "sweep_problem.h"
#include "trivet/numerics/frequency_sweep.h"

int main() {
  using namespace trivet;
  using namespace trivet::benchmarks;
  const OneCore one_core;
  openblas_set_num_threads(1);
  constexpr std::size_t count = 10000;
  constexpr double solve_flops = 745;  // Z 63, LDLᵀ 406, right side 276: additions and multiplications, a division as one
  SweepProblem problem(count);
  const numerics::DynamicMatrices matrices{problem.machine.A, problem.machine.B, problem.machine.K, {}, true};
  const Vector6 h = problem.machine.load;
  const auto ours = [&] { return numerics::sweep(matrices, h, problem.omega); };

  Eigen::MatrixXcd q(6, count);
  const auto by = [&](auto solver) { return [&problem, &q, solver] { solver(problem.machine, problem.omega, q); }; };
  Rival octave("sweep.m", problem.folder()), python("sweep.py", problem.folder());
  const double error = problem.check("Trivet", ours().response);
  for (const auto& [name, solver] : {std::pair{"Eigen", &eigen_fixed_lu}, std::pair{"zgesv", &lapack_zgesv}, std::pair{"zsysv", &lapack_zsysv}}) {
    by(solver)();
    problem.check(name, q);
  }
  for (const char* name : {"loop", "ldlt"}) problem.check(octave, name);
  for (const char* name : {"batched", "ldlt", "scipy", "scipy_zgesv"}) problem.check(python, name);

  std::vector<Way> ways{
      here("Trivet, every solution checked", count, [&] { (void)ours(); }, solve_flops),
      octave.way("loop", "Octave, the paper's loop with `\\`", count, 800),
      octave.way("ldlt", "Octave, LDLᵀ vectorised by hand", count),
      python.way("batched", "NumPy, batched solve", count, 95),
      python.way("ldlt", "NumPy, LDLᵀ vectorised by hand", count),
      python.way("scipy", "SciPy, loop of linalg.solve", count),
      python.way("scipy_zgesv", "SciPy, loop of zgesv", count),
      here("Eigen, fixed 6×6 pivoted LU", count, by(&eigen_fixed_lu), 0, 42),
      here("LAPACK zgesv", count, by(&lapack_zgesv)),
      here("LAPACK zsysv", count, by(&lapack_zsysv)),
  };
  if (python.has("pyyeti")) {
    problem.check(python, "pyyeti");
    ways.push_back(python.way("pyyeti", "pyYeti, SolveUnc.fsolve", count));
  } else {
    std::puts("pyYeti is absent");
  }
  measure({"direct sweep of six coordinates", "10,000 frequencies", "frequency", error}, ways);
}

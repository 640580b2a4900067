// SPDX-License-Identifier: BSD-3-Clause
// How long does a sweep of one six-coordinate machine with general damping take, every frequency solved? Compared with
// the paper's loop and the best vectorised form in Octave, NumPy, SciPy, Eigen's fixed-size LU and LAPACK.
#include "rivals/fixed_lu.h"
#include "rivals/lapack.h"
#include "sweep_problem.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

int main() {
  using namespace trivet;
  using namespace trivet::benchmarks;
  const OneCore one_core;
  openblas_set_num_threads(1);
  constexpr std::size_t count = 10000;
  constexpr double solve_flops = 719;  // Z 84, LDLᵀ 406, right side 148, growth of the factors 81: additions and
                                       // multiplications, a division as one
  SweepProblem problem(count);
  const numerics::DynamicMatrices matrices{problem.machine.A, problem.machine.B, problem.machine.K, {}, true};
  const Vector6 h = problem.machine.load;
  numerics::SweepOptions options, with_errors;
  options.threads = with_errors.threads = 1;
  options.every_backward_error = false;
  Eigen::MatrixXcd q(6, count);
  const auto by = [&](SixCoordinateSolver solver) {
    return [&, solver] { solver(problem.system(), problem.omega.data(), count, q.data()); };
  };
  Rival octave("sweep.m", problem.folder()), python("sweep.py", problem.folder());
  const numerics::SweepResult found = numerics::sweep(matrices, h, problem.omega, options);
  const double error = problem.check("Trivet", found.response);
  problem.check("Trivet, backward errors reported", numerics::sweep(matrices, h, problem.omega, with_errors).response);
  std::printf("  recomputed with pivoting: %d\n", found.fallbacks);
  for (const auto& [name, solver] :
       {std::pair{"Eigen", &eigen_fixed_lu}, std::pair{"zgesv", &lapack_zgesv}, std::pair{"zsysv", &lapack_zsysv}}) {
    by(solver)();
    problem.check(name, q);
  }
  for (const char* name : {"loop", "ldlt"}) problem.check(octave, name);
  for (const char* name : {"batched", "ldlt", "scipy", "scipy_zgesv"}) problem.check(python, name);

  std::vector<Method> methods{
      in_process(
          "Trivet, every solution checked", count, [&] { (void)numerics::sweep(matrices, h, problem.omega, options); },
          solve_flops),
      in_process("Trivet, with every backward error reported", count,
                 [&] { (void)numerics::sweep(matrices, h, problem.omega, with_errors); }),
      octave.method("loop", "Octave, the paper's loop with `\\`", count, 800),
      octave.method("ldlt", "Octave, LDLᵀ vectorised by hand", count),
      python.method("batched", "NumPy, batched solve", count, 95),
      python.method("ldlt", "NumPy, LDLᵀ vectorised by hand", count),
      python.method("scipy", "SciPy, loop of linalg.solve", count),
      python.method("scipy_zgesv", "SciPy, loop of zgesv", count),
      in_process("Eigen, fixed 6×6 pivoted LU", count, by(&eigen_fixed_lu), 0, 42),
      in_process("LAPACK zgesv", count, by(&lapack_zgesv)),
      in_process("LAPACK zsysv", count, by(&lapack_zsysv)),
  };
  if (python.has("pyyeti")) {
    problem.check(python, "pyyeti");
    methods.push_back(python.method("pyyeti", "pyYeti, SolveUnc.fsolve", count));
  } else {
    std::puts("pyYeti is absent");
  }
  measure({"direct sweep of six coordinates", "10,000 frequencies", "frequency", error}, methods);
}

// SPDX-License-Identifier: BSD-3-Clause
// How long do natural frequencies and mode shapes of many designs take? Compared with Octave, SciPy, NumPy batched,
// Eigen's fixed-size solver and LAPACK.
#include "trivet/numerics/roots/design_modes.h"

#include <array>

#include "quad_modes.h"
#include "random_designs.h"
#include "rival.h"
#include "rivals/fixed_lu.h"
#include "rivals/lapack.h"
#include "trivet/foundation/temporary_folder.h"

namespace {

using namespace trivet;
using namespace trivet::benchmarks;

/// Largest relative error of λ (6 per design) over the designs with a known true solution.
template <typename Lambda>
double check(const char* method, const Lambda& lambda, const std::vector<std::array<Quad, 6>>& truth, double limit) {
  double worst = 0;
  for (std::size_t d = 0; d < truth.size(); ++d)
    for (std::size_t k = 0; k < 6; ++k) {
      const double error = std::abs(double((Quad(lambda(d, k)) - truth[d][k]) / truth[d][k]));
      worst = error <= worst ? worst : error;
    }
  std::printf("  error of %-40s %.1e of λ in %zu designs\n", method, worst, truth.size());
  compared(method, worst, limit);
  return worst;
}

}  // namespace

int main() {
  const OneCore one_core;
  openblas_set_num_threads(1);
  constexpr Eigen::Index few = 1000, many = 100000;
  const numerics::Designs designs = random_designs(few), more = random_designs(many);
  std::vector<std::array<Quad, 6>> truth;
  for (Eigen::Index d = 0; d < 300; ++d)
    truth.push_back(quad_modes(numerics::unpacked(designs.K, d), numerics::unpacked(designs.A, d)));

  const std::vector<double> A = full_matrices(designs.A, few), K = full_matrices(designs.K, few);
  const foundation::TemporaryFolder folder;
  write_numbers(folder.path() / "A", A.data(), A.size());
  write_numbers(folder.path() / "K", K.data(), K.size());
  Rival octave("modes.m", folder.path()), python("modes.py", folder.path());
  std::vector<double> lambda(6 * few), shapes(36 * few);
  const auto by = [&](SixCoordinateModes solver) {
    return [&, solver] {
      for (std::size_t d = 0; d < few; ++d)
        solver(K.data() + 36 * d, A.data() + 36 * d, lambda.data() + 6 * d, shapes.data() + 36 * d);
    };
  };

  numerics::DesignModesOptions options;
  options.threads = 1;
  numerics::DesignModes modes, more_modes;
  const auto ours = [&] { numerics::design_modes(designs, modes, options); };
  ours();
  const double error = check(
      "Trivet", [&](std::size_t d, std::size_t k) { return modes.lambda(Eigen::Index(d), Eigen::Index(k)); }, truth,
      1e-11);
  const auto here_lambda = [&](std::size_t d, std::size_t k) { return lambda[6 * d + k]; };
  by (&eigen_fixed_modes)();
  check("Eigen", here_lambda, truth, 1e-8);
  by (&lapack_dsygv)();
  check("dsygv", here_lambda, truth, 1e-8);
  const auto check_rival = [&](Rival& rival, const char* name) {
    const std::vector<std::complex<double>> all = rival.answers(name);
    check(name, [&](std::size_t d, std::size_t k) { return all[6 * d + k].real(); }, truth, 1e-8);
  };
  check_rival(octave, "loop");
  check_rival(python, "loop");
  check_rival(python, "batched");

  measure({"modes over designs", "1,000 designs", "design", error},
          {in_process("Trivet", few, ours),
           in_process("Trivet, 100,000 designs", many, [&] { numerics::design_modes(more, more_modes, options); }),
           octave.method("loop", "Octave, loop of eig", few), python.method("loop", "SciPy, loop of eigh", few),
           python.method("batched", "NumPy, batched Cholesky and eigh", few, 25),
           in_process("Eigen, fixed GeneralizedSelfAdjointEigenSolver", few, by(&eigen_fixed_modes), 0, 10),
           in_process("LAPACK dsygv", few, by(&lapack_dsygv))});
}

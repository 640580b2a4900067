// SPDX-License-Identifier: BSD-3-Clause
// How accurate is each method on matrices on which solvers fail? Errors of Trivet and of all rivals, against quadruple
// precision. Ends with status 1 if a backward error of Trivet exceeds its limit: then no time is valid. Forward errors
// are goals.
#include <cmath>
#include <limits>
#include <memory>

#include "hard_cases.h"
#include "rival.h"
#include "rivals/fixed_lu.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/temporary_folder.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace {

using namespace trivet;
using namespace trivet::benchmarks;
using Complex = std::complex<double>;

struct Errors {
  double forward = 0, backward = 0;
};

Errors errors(const HardCase& c, const Complex* answers) {
  Errors worst;
  const auto keep = [](double& largest, double error) { largest = error <= largest ? largest : error; };
  const Vector6 scale = c.system.A.diagonal().cwiseAbs().cwiseSqrt();
  for (std::size_t i = 0; i < c.omega.size(); ++i) {
    keep(worst.forward, forward_error(answers + 6 * i, c.truth[i], scale));
    keep(worst.backward,
         backward_error(c.system.A, c.system.B, c.system.K, c.system.load, c.omega[i], answers + 6 * i, scale));
  }
  return worst;
}

class Report {
 public:
  void add(const HardCase& c, const std::string& method, const Complex* answers, double forward_limit = 0,
           double backward_limit = 0) {
    const Errors e = errors(c, answers);
    const bool near = forward_limit == 0 || e.forward <= forward_limit,
               stable = backward_limit == 0 || e.backward <= backward_limit;
    std::string goal;
    char text[80];
    if (forward_limit > 0) std::snprintf(text, sizeof text, "forward ≤ %.1e ", forward_limit), goal += text;
    if (backward_limit > 0) std::snprintf(text, sizeof text, "backward ≤ %.0e", backward_limit), goal += text;
    std::printf("  %-28s forward %.1e  backward %.1e  %s\n", method.c_str(), e.forward, e.backward,
                near && stable ? "" : ("NOT MET: " + goal).c_str());
    record_errors(c.name, method, e.forward, e.backward, goal, near && stable);
    stable_ = stable_ && stable;
  }
  [[nodiscard]] bool stable() const { return stable_; }

 private:
  bool stable_ = true;
};

}  // namespace

int main() {
  constexpr double epsilon = std::numeric_limits<double>::epsilon(), backward_limit = 1e-14;
  Report report;
  const foundation::TemporaryFolder folder;
  std::unique_ptr<Rival> octave, python;
  for (const HardCase& c : hard_cases(TRIVET_HARD_CASES)) {
    std::printf("%s, least damping ratio %.1e, %zu frequencies\n", c.name.c_str(), c.least_damping_ratio,
                c.omega.size());
    const double direct_limit = c.lightly_damped ? 100 * epsilon / c.least_damping_ratio : 0;
    const numerics::DynamicMatrices matrices{c.system.A, c.system.B, c.system.K, {}, true};
    numerics::SweepOptions options;
    const numerics::SweepResult with_errors = numerics::sweep(matrices, c.system.load, c.omega, options);
    compared("Trivet, direct, with backward errors reported", errors(c, with_errors.response.data()).backward,
             backward_limit);
    options.every_backward_error = false;
    const numerics::SweepResult direct = numerics::sweep(matrices, c.system.load, c.omega, options);
    report.add(c, "Trivet, direct", direct.response.data(), direct_limit, backward_limit);
    std::printf("    recomputed with pivoting: %d\n", direct.fallbacks);

    Eigen::MatrixXcd q(6, to_index(c.omega.size()));
    const SixCoordinates system{c.system.A.data(), c.system.B.data(), c.system.K.data(), c.system.load.data()};
    for (const auto& [name, solver] :
         {std::pair{"Eigen fixed LU", &eigen_fixed_lu}, std::pair{"LAPACK zgesv", &lapack_zgesv},
          std::pair{"LAPACK zsysv", &lapack_zsysv}}) {
      solver(system, c.omega.data(), c.omega.size(), q.data());
      report.add(c, name, q.data());
    }
    const auto file = [&](const char* name, const auto& x) {
      write_numbers(folder.path() / name, x.data(), to_size(x.size()));
    };
    file("A", c.system.A), file("B", c.system.B), file("K", c.system.K), file("H", c.system.load), file("p", c.omega);
    if (octave) octave->read(), python->read();
    else
      octave = std::make_unique<Rival>("sweep.m", folder.path()),
      python = std::make_unique<Rival>("sweep.py", folder.path());
    report.add(c, "Octave loop", octave->answers("loop").data());
    report.add(c, "Octave LDLᵀ", octave->answers("ldlt").data());
    report.add(c, "Octave poles", octave->answers("modal").data());
    report.add(c, "NumPy batched", python->answers("batched").data());
    report.add(c, "NumPy poles", python->answers("modal").data());
    report.add(c, "SciPy solve", python->answers("scipy").data());
  }
  std::puts(report.stable() ? "Every backward error of Trivet is within its limit."
                            : "WRONG: a backward error of Trivet exceeds its limit; no time is valid.");
  return report.stable() ? 0 : 1;
}

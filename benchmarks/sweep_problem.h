// SPDX-License-Identifier: BSD-3-Clause
// One sweep of the paper's machine, the same for all methods, with the true solution at some hundred of its
// frequencies.
#pragma once

#include <Eigen/Eigenvalues>

#include <vector>

#include "paper_machine.h"
#include "quad.h"
#include "rival.h"
#include "rivals/fixed_lu.h"
#include "trivet/foundation/index.h"
#include "trivet/foundation/temporary_folder.h"

namespace trivet::benchmarks {

class SweepProblem {
 public:
  explicit SweepProblem(std::size_t count, double to = 200) : omega(even_frequencies(count, to)) {
    const auto file = [&](const char* name, const auto& x) {
      write_numbers(folder_.path() / name, x.data(), to_size(x.size()));
    };
    file("A", machine.A), file("B", machine.B), file("K", machine.K), file("H", machine.load), file("p", omega);
    for (std::size_t i = 0; i < count; i += std::max<std::size_t>(1, count / 400)) checked_.push_back(i);
    const auto squares = Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6>(machine.K, machine.A).eigenvalues().eval();
    for (int k = 0; k < 6; ++k) {
      const double place = std::sqrt(squares[k]) / to * static_cast<double>(count);
      for (double i = place - 5; i < place + 5; ++i)
        if (i >= 0 && i < static_cast<double>(count)) checked_.push_back(static_cast<std::size_t>(i));
    }
    for (const std::size_t i : checked_)
      truth_.push_back(quad_solution(machine.A, machine.B, machine.K, machine.load, omega[i]));
  }

  /// Largest forward error of answers (6 per frequency) at the checked frequencies; ends the program if it exceeds the
  /// limit.
  double check(const std::string& method, const std::complex<double>* answers) {
    double worst = 0;
    const Vector6 scale = machine.A.diagonal().cwiseSqrt();
    for (std::size_t c = 0; c < checked_.size(); ++c) {
      const double error = forward_error(answers + 6 * checked_[c], truth_[c], scale);
      worst = error <= worst ? worst : error;
    }
    std::printf("  error of %-40s %.1e at %zu frequencies\n", method.c_str(), worst, checked_.size());
    compared(method, worst, 1e-9);
    return worst;
  }
  double check(const std::string& method, const Eigen::MatrixXcd& answers) { return check(method, answers.data()); }
  double check(Rival& rival, const std::string& name) { return check(name, rival.answers(name).data()); }

  [[nodiscard]] SixCoordinates system() const {
    return {machine.A.data(), machine.B.data(), machine.K.data(), machine.load.data()};
  }

  PaperMachine machine = paper_machine();
  std::vector<double> omega;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  foundation::TemporaryFolder folder_;
  std::vector<std::size_t> checked_;
  std::vector<std::vector<QuadComplex>> truth_;
};

}  // namespace trivet::benchmarks

// SPDX-License-Identifier: BSD-3-Clause
// How fast is each instruction set? One binary uses one after the other; the answers are compared first.
#include "trivet/numerics/lanes/instruction_set.h"

#include "chain.h"
#include "measure.h"
#include "random_designs.h"
#include "trivet/numerics/roots/design_modes.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace {

using namespace trivet;
using namespace trivet::benchmarks;

/// Times `answers` under each instruction set, the best first; they may differ by `limit`.
template <typename CaseResults>
void under_each(const Question& question, double items, double limit, double flops, const CaseResults& answers) {
  std::vector<Method> methods;
  const std::vector<std::string> sets = numerics::instruction_sets();
  const auto best = answers().eval();
  double worst = 0;
  for (const std::string& set : sets) {
    numerics::use_instruction_set(set);
    const double difference = (answers() - best).cwiseAbs().maxCoeff() / best.cwiseAbs().maxCoeff();
    worst = difference <= worst ? worst : difference;
    Method method = in_process(set, items, [&] { (void)answers(); });
    method.seconds = [set, run = method.seconds] {
      numerics::use_instruction_set(set);
      return run();
    };
    methods.push_back(method);
  }
  compared(question.name, worst, limit);
  Question worst_case = question;
  worst_case.largest_error = worst;
  const std::vector<double> seconds = measure(worst_case, methods, 11);
  for (std::size_t s = 0; s < sets.size() && flops > 0; ++s) {
    numerics::use_instruction_set(sets[s]);
    double peak = 0;
    for (int i = 0; i < 5; ++i) peak = std::max(peak, peak_flops());
    record(question.name, sets[s] + ": part of its own peak of multiply-adds", 100 * flops / seconds[s] / peak, "%", "",
           true);
  }
  numerics::use_instruction_set("");
}

}  // namespace

int main() {
  const OneCore one_core;
  const PaperMachine m = paper_machine();
  const numerics::DynamicMatrices matrices{m.A, m.B, m.K, {}, true};
  const std::vector<double> omega = even_frequencies(10000);
  numerics::SweepOptions one_thread;
  one_thread.threads = 1;
  one_thread.every_backward_error = false;
  under_each({"instruction sets, direct sweep", "10,000 frequencies", "frequency"}, 10000, 1e-11, 719,
             [&]() -> Eigen::MatrixXcd { return numerics::sweep(matrices, m.load, omega, one_thread).response; });
  const numerics::Designs designs = random_designs(2048);
  numerics::DesignModesOptions options;
  options.threads = 1;
  under_each({"instruction sets, modes over designs", "2,048 designs", "design"}, 2048, 1e-11, 0,
             [&]() -> Eigen::ArrayXXd { return numerics::design_modes(designs, options).lambda; });
  const numerics::DynamicMatrices chain = chain_of(50);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(chain.size());
  load.tail(6) = m.load;
  const std::vector<double> some = even_frequencies(2000, 60);
  under_each({"instruction sets, chain of bodies", "50 bodies", "frequency"}, 2000, 1e-9, 0,
             [&]() -> Eigen::ArrayXXcd { return numerics::sweep(chain, load, some, one_thread).response.array(); });
}

// SPDX-License-Identifier: BSD-3-Clause
// Does the cost grow in proportion to frequencies, designs and bodies? Slopes of log time over log size.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "chain.h"
#include "measure.h"
#include "random_designs.h"
#include "trivet/foundation/index.h"
#include "trivet/numerics/roots/design_modes.h"
#include "trivet/numerics/sweep/frequency_sweep.h"

namespace {

using namespace trivet;
using namespace trivet::benchmarks;

double median_seconds(const Method& method, int turns) {
  std::vector<double> seconds;
  for (int i = 0; i < turns; ++i) seconds.push_back(method.seconds());
  std::ranges::sort(seconds);
  return seconds[seconds.size() / 2];
}

/// Least-squares slope of log total time over log size; goal 1 ± 0.05.
void slope(const std::string& what, const std::vector<std::pair<double, double>>& size_and_seconds) {
  double x = 0, y = 0, xx = 0, xy = 0;
  std::printf("%s:", what.c_str());
  for (const auto& [size, seconds] : size_and_seconds) {
    std::printf("  %g: %.3g s", size, seconds);
    x += std::log(size), y += std::log(seconds), xx += std::log(size) * std::log(size),
        xy += std::log(size) * std::log(seconds);
  }
  std::puts("");
  const double n = double(size_and_seconds.size()), found = (n * xy - x * y) / (n * xx - x * x);
  record("growth", what + ", slope", found, "", "1 ± 0.05", std::abs(found - 1) <= 0.05);
}

/// All sizes are timed in turns, so that a loaded machine slows them equally.
void grows(const std::string& what, const std::vector<double>& sizes,
           const std::function<std::function<void()>(double)>& work) {
  std::vector<Method> methods;
  for (const double size : sizes) methods.push_back(in_process(what, 1, work(size)));
  std::vector<std::vector<double>> seconds(sizes.size());
  for (int turn = 0; turn < 7; ++turn)
    for (std::size_t s = 0; s < sizes.size(); ++s)
      seconds[s].push_back(median_seconds(methods[s], sizes[s] >= 1e6 ? 1 : 3));
  std::vector<std::pair<double, double>> points;
  for (std::size_t s = 0; s < sizes.size(); ++s) {
    std::ranges::sort(seconds[s]);
    points.emplace_back(sizes[s], seconds[s][3]);
  }
  slope(what, points);
}

}  // namespace

int main() {
  const OneCore one_core;
  const PaperMachine m = paper_machine();
  const numerics::DynamicMatrices matrices{m.A, m.B, m.K, {}, true};
  numerics::SweepOptions one_thread;
  one_thread.threads = 1;
  one_thread.every_backward_error = false;
  grows("frequencies of a direct sweep, 1e3 … 1e6", {1e3, 1e4, 1e5, 1e6}, [&](double size) -> std::function<void()> {
    return [&, omega = even_frequencies(static_cast<std::size_t>(size))] {
      (void)numerics::sweep(matrices, m.load, omega, one_thread);
    };
  });
  grows("designs of modes, 1e2 … 1e6", {1e2, 1e3, 1e4, 1e5, 1e6}, [&](double size) -> std::function<void()> {
    return [designs = random_designs(static_cast<Eigen::Index>(size))] {
      numerics::DesignModesOptions options;
      options.threads = 1;
      options.shapes = false;
      (void)numerics::design_modes(designs, options);
    };
  });
  grows("bodies of a chain at 2000 frequencies, 2 … 50", {2, 5, 10, 20, 50}, [&](double size) -> std::function<void()> {
    const numerics::DynamicMatrices chain = chain_of(static_cast<int>(size));
    Eigen::VectorXd load = Eigen::VectorXd::Zero(chain.size());
    load.tail(6) = m.load;
    return [&one_thread, chain, load, omega = even_frequencies(2000, 60)] {
      (void)numerics::sweep(chain, load, omega, one_thread);
    };
  });
}

// SPDX-License-Identifier: BSD-3-Clause
// How long do the highest amplitudes (or also the peaks) of a million designs take, and are they right? Usage:
// million_designs [designs] [highest|peaks]
#include "trivet/foundation/index.h"
#include "trivet/numerics/batch/design_peaks.h"

#include <fmt/format.h>
#include <time.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "support/random_designs.h"
#include "trivet/numerics/lanes/instruction_set.h"

using namespace trivet;

namespace {

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Largest relative excess of |q| over `peaks`, from direct solutions at ω = 1e-3, 0.3 … 600 and next to the reported
/// maxima, independent of Trivet's poles.
double worst_miss(const numerics::Designs& designs, const numerics::DesignPeaks& peaks, Eigen::Index every,
                  long& misses) {
  double worst = 0;
  for (Eigen::Index d = 0; d < designs.count(); d += every) {
    const numerics::DynamicMatrices m = numerics::matrices_of(designs, d);
    const Eigen::VectorXcd load = designs.load.row(d).matrix().transpose().cast<std::complex<double>>();
    const auto update = [&](double omega) {
      const Eigen::VectorXcd q = m.at(omega).partialPivLu().solve(load);
      for (Eigen::Index j = 0; j < q.size(); ++j) {
        const double miss = std::abs(q(j)) / peaks.highest(d, j) - 1;
        worst = std::max(worst, miss);
        misses += miss > 1e-3 ? 1 : 0;
      }
    };
    update(1e-3);
    for (double omega = 0.3; omega < 600; omega *= 1.1) update(omega);
    for (Eigen::Index j = 0; j < designs.coordinates(); ++j)
      for (const double shift : {-1e-6, 1e-6})
        update(std::isfinite(peaks.highest_at(d, j)) ? peaks.highest_at(d, j) * (1 + shift) : 1.0);
  }
  return worst;
}

}  // namespace

int main(int count, char** arguments) {
  const int designs_wanted = count > 1 ? std::atoi(arguments[1]) : 1'000'000;
  numerics::DesignPeakOptions options;
  options.threads = 1;
  options.count_peaks = count > 2 && std::string(arguments[2]) == "peaks";
  constexpr int batch = 20'000;
  std::array<long, 4> status{};
  long misses = 0;
  double seconds = 0, worst = 0;
  for (int first = 0; first < designs_wanted; first += batch) {
    const numerics::Designs designs = test::random_designs(std::min(batch, designs_wanted - first), 6, 1e-6,
                                                           1000U + static_cast<unsigned>(first / batch));
    const double start = thread_seconds();
    const numerics::DesignPeaks peaks = numerics::design_peaks(designs, options);
    seconds += thread_seconds() - start;
    for (const numerics::DesignStatus s : peaks.status) ++status[static_cast<std::size_t>(s)];
    worst = std::max(worst, worst_miss(designs, peaks, 1, misses));
  }
  fmt::print(
      "{} designs, {}, {}: {:.0f} ns a design on one core; proven {}, recomputed {}, undecided {}, impossible {}; "
      "misses above 0.1 %: {}, worst {:.2g}\n",
      designs_wanted, options.count_peaks ? "peaks" : "highest", numerics::instruction_set(),
      1e9 * seconds / designs_wanted, status[0], status[1], status[2], status[3], misses, worst);
  return misses == 0 ? 0 : 1;
}

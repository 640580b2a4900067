// SPDX-License-Identifier: BSD-3-Clause
// How long does a design of a family over twenty numbers take? One body on eight mounts; compared with the model read
// and assembled again.
#include <random>

#include "measure.h"
#include "support/many_numbers.h"
#include "trivet/foundation/index.h"
#include "trivet/judging/read_project.h"
#include "trivet/study/optimize/design_objective.h"

using namespace trivet;
using namespace trivet::benchmarks;

int main() {
  const OneCore one_core;
  auto project =
      judging::project_from_text(test::machine_with_twenty_numbers("damping = {loss_factor = 0.08}\n"), "machine.toml");
  if (!project) return 1;
  const study::DesignObjective objective(*project, {});
  const study::DesignBatch& found = objective.families().front();
  if (!found.reason().empty()) {
    std::fprintf(stderr, "%s\n", found.reason().c_str());
    return 1;
  }
  constexpr Eigen::Index count = 1024;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  Eigen::MatrixXd points(count, to_index(objective.space().size()));
  for (Eigen::Index i = 0; i < count; ++i) {
    Eigen::VectorXd shares(points.cols());
    for (double& one : shares) one = share(random);
    points.row(i) = objective.space().values(shares).transpose();
  }
  const Eigen::MatrixXd many = found.family().designs(points);
  double worst = 0;
  for (Eigen::Index i = 0; i < 300; ++i) {
    const Eigen::VectorXd values = points.row(i).transpose(), one = found.family().at(values);
    const auto exact = found.packed().pack(objective.space().system(*objective.cases().front(), values));
    if (!exact.design) return 1;
    for (Eigen::Index e = 0; e < one.size(); ++e)
      if (const double scale = exact.design->scales(e); scale > 0)
        worst = std::max({worst, std::abs(one(e) - exact.design->entries(e)) / scale,
                          std::abs(many(i, e) - exact.design->entries(e)) / scale});
  }
  compared("designs of the family", worst, 1e-12);
  std::printf("  %zu terms of %td entries, from %zu assembled designs\n", found.family().terms(),
              found.family().entries(), found.family().assembled());
  Eigen::Index next = 0;
  double sum = 0;
  const auto values = [&]() -> Eigen::VectorXd { return points.row(next++ % count).transpose(); };
  const std::vector<double> seconds = measure(
      {"families of designs", "20 numbers, 8 elements", "design", worst},
      {in_process("Trivet, many at a time", double(count), [&] { sum += found.family().designs(points)(0, 0); }),
       in_process("Trivet, one at a time", 1, [&] { sum += found.family().at(values())(0); }),
       in_process("Trivet, with all slopes", 1, [&] { sum += found.family().slopes(values())(0, 0); }),
       in_process("the model read, assembled and packed again", 1, [&] {
         sum += found.packed().pack(objective.space().system(*objective.cases().front(), values())).design->entries(0);
       })});
  record("families of designs", "µs per design, many at a time", 1e6 * seconds[0], "µs", "≤ 2", seconds[0] <= 2e-6);
  record("families of designs", "µs per design, one at a time", 1e6 * seconds[1], "µs", "≤ 2", seconds[1] <= 2e-6);
  return std::isfinite(sum) ? 0 : 1;
}

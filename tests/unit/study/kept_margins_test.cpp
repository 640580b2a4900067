// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/optimize/kept_margins.h"

#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "support/projects.h"

namespace trivet {
namespace kept_margins_test {

constexpr double wanted = 0.9;

/// A mass whose sag and natural frequency scatter, and one with a damping ratio of 0.75 that scatters around 1/√2.
const std::string machine = test::sagging_mass() + R"(
[bodies.m2]
mass = 1
free = ["z"]
position = [1, 0, 0]
[elements.k2]
type = "three_springs"
on = "m2"
at = [0, 0, 0]
translation = [0, 0, 63165]
damping = {translation = [0, 0, 377]}
[excitations.force]
type = "harmonic"
on = "m2"
at = [0, 0, 0]
force = [0, 0, 1]
[parameters.stiffness]
path = "elements.k1.scale"
from = 0.4
to = 2
[tolerances.casting]
path = "bodies.m1.mass"
half_width = "10 %"
[tolerances.damper]
path = "elements.k2.damping.translation.z"
half_width = "30 %"
[analyses.optimize]
)";
const std::string requirements = R"([requirements]
static = {"m1.z" = "2.5 mm"}
natural_frequencies = {avoid = [["10.5 Hz", "25 Hz"]]}
)";

study::Aim adapted() {
  return {.searched = wanted, .wanted = wanted, .minimizes = true, .share = wanted, .is_adapted = true};
}

// The curve of m2 has no peak, so its margin is ∞; that of machines with a damping ratio below 1/√2 has one.
TEST(KeptMargins, ChangeNoShareForAMarginThatJumps) {
  const project::Project alone = test::project(machine + requirements);
  const project::Project with_peaks =
      test::project(machine + requirements + "no_peak = \"m2.z\"\npeak_tolerance = 0\n");
  const study::SampleRun run(alone), run_with_peaks(with_peaks);
  study::Aim aim = adapted(), aim_with_peaks = aim;
  const study::Kept kept = study::kept_by_share(run, aim, {});
  const study::Kept kept_with_peaks = study::kept_by_share(run_with_peaks, aim_with_peaks, {});
  EXPECT_EQ(aim_with_peaks.share, aim.share);
  EXPECT_NE(aim.share, wanted) << "the aim is adapted at all";
  ASSERT_EQ(kept_with_peaks.nominal[0].size(), 3);
  for (std::size_t r = 0, other = 0; r < 3; ++r) {
    if (std::isinf(kept_with_peaks.nominal[0][r])) continue;
    EXPECT_EQ(kept_with_peaks.kept[0][r], kept.kept[0][other++]);
  }
  EXPECT_GT(kept.least, kept_with_peaks.least) << "more than a tenth of the machines has a peak";
}

// What a search knows to be too little is not judged to the end; otherwise the number is the same.
TEST(KeptMargins, AreTheSameFromTheFamilyOfAllDesigns) {
  const project::Project project = test::project(machine + requirements);
  const study::SampleRun run(project);
  const study::DesignSpace space(project, {});
  const study::MachineFamily family(run, space);
  for (const double scale : {0.8, 1.0, 1.3}) {
    const project::Project there =
        test::project(machine + requirements, {"elements.k1.scale=" + std::to_string(scale)});
    const double exact = study::kept_least(study::SampleRun(there), wanted, 0, {});
    const Eigen::VectorXd shares = Eigen::VectorXd::Constant(1, space.axes()[0].share(scale));
    constexpr double reproduced = 1e-9;
    EXPECT_NEAR(family.kept_least(shares, wanted, 0, {}).value(), exact, reproduced * exact);
    EXPECT_NEAR(family.kept_least(shares, wanted, exact * 0.999, {}).value(), exact, reproduced * exact);
    EXPECT_EQ(family.kept_least(shares, wanted, exact * 1.001, {}), 0);
    EXPECT_EQ(study::kept_least(study::SampleRun(there), wanted, exact, {}), 0);
  }
}

// Numbers without bounds: the family judges no machine in their tails. The lightest ones have no model.
TEST(KeptMargins, AreTheSameFromTheFamilyWithMachinesInTails) {
  std::string text = machine + requirements;
  const std::string bounded = "half_width = \"10 %\"";
  text.replace(text.find(bounded), bounded.size(), "standard_deviation = \"27 %\"");
  text +=
      "[tolerances.spring]\npath = \"elements.k1.scale\"\nstandard_deviation = \"5 %\"\ndistribution = \"lognormal\"\n";
  const project::Project project = test::project(text);
  const study::SampleRun run(project);
  const study::SampledCase& one = run.cases().front();
  const Eigen::ArrayXXd draws = run.drawn().draw(0, study::searched_machines).array();
  const Eigen::ArrayXd above = (draws.rowwise() - one.from().transpose()).rowwise().minCoeff();
  const Eigen::ArrayXd below = ((-draws).rowwise() + one.to().transpose()).rowwise().minCoeff();
  const Eigen::Index inside = (above.min(below) >= 0).count();
  ASSERT_LT(inside, draws.rows());
  const study::DesignSpace space(project, {});
  const study::MachineFamily family(run, space);
  const project::Project there = test::project(text, {"elements.k1.scale=1.2"});
  for (const double share : {0.5, 0.9}) {
    const double exact = study::kept_least(study::SampleRun(there), share, 0, {});
    const Eigen::VectorXd shares = Eigen::VectorXd::Constant(1, space.axes()[0].share(1.2));
    constexpr double reproduced = 1e-9;
    const std::optional<double> kept = family.kept_least(shares, share, 0, {});
    ASSERT_TRUE(kept);
    EXPECT_NEAR(*kept, exact, reproduced * exact);
  }
}

}  // namespace kept_margins_test
}  // namespace trivet

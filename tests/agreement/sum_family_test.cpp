// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/many_numbers.h"
#include "support/projects.h"
#include "trivet/foundation/index.h"
#include "trivet/study/family/packed_margins.h"
#include "trivet/study/optimize/design_objective.h"

/// Designs of a family over twenty numbers, against models that are read and solved again.
namespace sum_family_test {

using namespace trivet;

/// As promised in sum_family.h; margins: heights have nine digits, and at the light damping here lose two.
constexpr double matrices = 1e-12, margins = 1e-7;

Eigen::VectorXd random_shares(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> share(0, 1);
  Eigen::VectorXd shares(to_index(count));
  for (double& one : shares) one = share(random);
  return shares;
}

void expect_agreement(const std::string& damping, const std::string& gravity = "-9.80665",
                      const std::string& more = "") {
  std::string text = test::machine_with_twenty_numbers(damping) + more;
  text.replace(text.find("-9.80665"), 8, gravity);
  const project::Project project = test::project(text);
  const study::DesignObjective objective(project, {});
  const study::DesignBatch& found = objective.families().front();
  ASSERT_EQ(found.reason(), "");
  ASSERT_EQ(objective.space().size(), 20u);
  EXPECT_LE(found.family().worst_difference(), matrices);
  std::mt19937 random(3);
  int compared = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const Eigen::VectorXd values = objective.space().values(random_shares(random, 20));
    const model::System system = objective.space().system(*objective.cases().front(), values);
    const design::PackedOrReason exact = found.packed().pack(system);
    ASSERT_TRUE(exact.design) << exact.reason;
    const Eigen::VectorXd entries = found.family().at(values);
    for (Eigen::Index e = 0; e < entries.size(); ++e)
      EXPECT_NEAR(entries(e), exact.design->entries(e), matrices * exact.design->scales(e)) << "entry " << e;
    const Eigen::ArrayXXd judged = study::packed_margins(found.packed(), entries.transpose());
    const std::vector<study::RequirementResult> alone = objective.results(0, system);
    for (std::size_t r = 0; r < alone.size(); ++r) {
      EXPECT_TRUE(found.packed().covers(r)) << alone[r].words.text();
      if (std::isnan(judged(0, to_index(r)))) continue;  // not proven in lanes
      EXPECT_NEAR(judged(0, to_index(r)) / alone[r].margin, 1, margins)
          << alone[r].words.text() << " of trial " << trial;
      ++compared;
    }
  }
  EXPECT_GE(compared, 40 * 8);
}

TEST(SumFamilyOfAMachine, IsThatOfModelsReadAgainUnderLossFactors) {
  expect_agreement("damping = {loss_factor = 0.08}\n");
}

TEST(SumFamilyOfAMachine, IsThatOfModelsReadAgainUnderViscousDamping) {
  expect_agreement("damping = {translation = [200, 300, 900], rotation = [1, 1, 1]}\n");
}

/// The weight takes up to a fifth of the tilting stiffness, by forces at rest that follow from all numbers together.
TEST(SumFamilyOfAMachine, IsThatOfModelsReadAgainUnderALargeWeight) {
  expect_agreement("damping = {loss_factor = 0.08}\n", "-98");
}

/// A constant force meets the stiffness that the weight leaves.
TEST(SumFamilyOfAMachine, IsThatOfModelsReadAgainUnderAThrust) {
  expect_agreement("damping = {loss_factor = 0.08}\n", "-98",
                   "[excitations.thrust]\ntype = \"constant\"\non = \"machine\"\nat = [0.3, 0.1, 0.9]\nforce = "
                   "[4000, 2500, -900]\nmoment = [0, 300, 0]\n");
}

/// Forces at rest are shared by the static stiffness, the machine vibrates on another one.
TEST(SumFamilyOfAMachine, IsThatOfModelsReadAgainOnRubber) {
  expect_agreement("stiffening = 1.4\ndamping = {loss_factor = 0.08}\n", "-98",
                   "[excitations.thrust]\ntype = \"constant\"\non = \"machine\"\nat = [0.3, 0.1, 0.9]\nforce = "
                   "[4000, 2500, -900]\n");
}

TEST(SumFamilyOfAMachine, IsRejectedForCoordinatesWithoutMass) {
  const project::Project project =
      test::project(test::machine_with_twenty_numbers("damping = {maxwell = {ratios = [0.4], times = [0.005]}}\n"));
  const study::DesignObjective objective(project, {});
  EXPECT_EQ(objective.families().front().reason(), "coordinates without mass");  // those inside the law
  EXPECT_FALSE(objective.families().front().judges());
}

}  // namespace sum_family_test

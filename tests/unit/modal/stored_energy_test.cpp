// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/modal/modes.h"

#include <gmock/gmock.h>

namespace stored_energy_test {

using namespace trivet;

constexpr double round_off = 1e-15;

modal::Mode mode_with(const Eigen::VectorXd& energies) {
  modal::Mode mode;
  mode.eigenvalue_squared = energies.sum();
  mode.strain_energy_share = Eigen::VectorXd(energies / energies.sum());
  return mode;
}

TEST(MostStrained, IsTheShareOfTheWholeWhereAllStoreEnergy) {
  const auto found = modal::most_strained(mode_with(Eigen::Vector4d(1, 4, 4, 1)));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->element, 1);
  EXPECT_EQ(found->alike, 1);
  EXPECT_NEAR(found->share, 0.4, round_off);
  EXPECT_EQ(modal::given_back_words(found->given_back), "");
}

TEST(MostStrained, IsAtMostTheWholeWhereOthersGiveBack) {
  const auto mode = mode_with(Eigen::Vector3d(800, 200, -773));
  EXPECT_GT((*mode.strain_energy_share)(0), 3.5) << "of the sum, 227";
  const auto found = modal::most_strained(mode);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->element, 0);
  EXPECT_NEAR(found->share, 0.8, round_off);
  EXPECT_NEAR(found->given_back, 0.773, round_off);
  EXPECT_EQ(modal::given_back_words(found->given_back), ", 77.3 % of it given back");
}

TEST(MostStrained, StoresEnergyInAMotionThatGrowsToo) {
  const auto found = modal::most_strained(mode_with(Eigen::Vector3d(-1000, 300, 100)));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->element, 1);
  EXPECT_NEAR(found->share, 0.75, round_off);
  EXPECT_NEAR(found->given_back, 2.5, round_off);
  EXPECT_FALSE(modal::most_strained(mode_with(Eigen::Vector2d(-5, -1)))) << "nothing is stored";
  EXPECT_FALSE(modal::most_strained(modal::Mode())) << "a rigid-body mode";
}

}  // namespace stored_energy_test

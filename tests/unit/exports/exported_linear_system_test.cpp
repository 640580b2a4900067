// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exports/linear_system.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "trivet/foundation/invalid_input.h"
#include "two_masses.h"

namespace exported_linear_system_test {

using trivet::exports::check;
using trivet::exports::LinearSystem;
using trivet::foundation::InvalidInput;
using trivet::test::two_masses;

struct WrongSystem {
  std::string message;
  std::function<void(LinearSystem&)> change;
};

TEST(LinearSystem, IsRejectedWithTheReason) {
  const std::vector<WrongSystem> wrong = {
      {"A is 4 × 3, but must be 4 × 4", [](LinearSystem& s) { s.A.conservativeResize(4, 3); }},
      {"D is 2 × 1, but must be 2 × 3", [](LinearSystem& s) { s.D.conservativeResize(2, 1); }},
      {"B has an entry that is not finite", [](LinearSystem& s) { s.B(0, 0) = std::nan(""); }},
      {"the initial state is 3 × 1", [](LinearSystem& s) { s.initial.conservativeResize(3); }},
      {"\"force\" is used twice", [](LinearSystem& s) { s.outputs[0].name = "force"; }},
      {"has no name", [](LinearSystem& s) { s.states[1].name = ""; }},
      {"the name \"a\nb\" has", [](LinearSystem& s) { s.states[1].name = "a\nb"; }},
      {"the nominal of \"x1\" is 0", [](LinearSystem& s) { s.states[0].nominal = 0; }}};
  for (const WrongSystem& one : wrong) {
    LinearSystem system = two_masses();
    EXPECT_NO_THROW(trivet::exports::check(system));
    one.change(system);
    try {
      trivet::exports::check(system);
      ADD_FAILURE() << "accepted: " << one.message;
    } catch (const InvalidInput& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(one.message));
    }
  }
}

TEST(LinearSystem, StartsAtZeroIfItNamesNoInitialState) {
  LinearSystem system = two_masses();
  system.initial.resize(0);
  EXPECT_NO_THROW(trivet::exports::check(system));
  EXPECT_EQ(trivet::exports::initial_states(system), Eigen::VectorXd::Zero(4));
}

}  // namespace exported_linear_system_test

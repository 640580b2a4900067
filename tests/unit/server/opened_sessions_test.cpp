// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/opened_sessions.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "trivet/engine/request.h"

namespace opened_sessions_test {

using namespace trivet;
using server::OpenedSessions;

const std::string text =
    "trivet = 1\n[bodies.cube]\nmass = 6\nfree = [\"z\"]\n"
    "[elements.k]\ntype = \"bushing\"\non = \"cube\"\nat = [0, 0, 0]\ntranslation = [60, 60, 60]\n"
    "rotation = [40, 40, 90]\n";

std::vector<std::string> mass(int kilograms) { return {"bodies.cube.mass = " + std::to_string(kilograms)}; }

OpenedSessions::Shared opened(OpenedSessions& sessions, const std::string& client,
                              const std::vector<std::string>& settings) {
  auto session = sessions.of(client, text, settings);
  EXPECT_TRUE(session.has_value());
  return session ? *session : nullptr;
}

// A session that is the same object has what was computed for it; another one computes it again.
TEST(OpenedSessions, OfTwoPagesWithTheSameTextDoNotReplaceEachOther) {
  OpenedSessions sessions("machine.toml");
  const auto first = opened(sessions, "first", mass(7)), second = opened(sessions, "second", mass(8));
  EXPECT_NE(first, second);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(opened(sessions, "first", mass(7)), first);
    EXPECT_EQ(opened(sessions, "second", mass(8)), second);
  }
}

TEST(OpenedSessions, OfASliderEndWithItsNextStep) {
  OpenedSessions sessions("machine.toml");
  const auto other = opened(sessions, "other", mass(100));
  std::weak_ptr<const engine::Session> before;
  for (int step = 1; step < 30; ++step) {
    const std::weak_ptr<const engine::Session> now = opened(sessions, "slider", mass(step));
    EXPECT_TRUE(before.expired() && !now.expired());
    before = now;
  }
  EXPECT_EQ(opened(sessions, "other", mass(100)), other);
}

TEST(OpenedSessions, AreSharedByPagesWithEqualSettingsUntilBothHaveOthers) {
  OpenedSessions sessions("machine.toml");
  const std::weak_ptr<const engine::Session> both = opened(sessions, "first", mass(7));
  EXPECT_EQ(opened(sessions, "second", mass(7)), both.lock());
  static_cast<void>(opened(sessions, "first", mass(8)));
  EXPECT_FALSE(both.expired());
  static_cast<void>(opened(sessions, "second", mass(9)));
  EXPECT_TRUE(both.expired());
}

TEST(OpenedSessions, AreBounded) {
  OpenedSessions sessions("machine.toml");
  std::vector<std::weak_ptr<const engine::Session>> all;
  for (int page = 1; page <= 50; ++page) all.push_back(opened(sessions, std::to_string(page), mass(page)));
  const auto kept = std::ranges::count_if(all, [](const auto& one) { return !one.expired(); });
  EXPECT_EQ(kept, OpenedSessions::most_kept - 1);  // and the one without settings
}

TEST(OpenedSessions, StopOpeningIfTheProgressIsInterrupted) {
  OpenedSessions sessions("machine.toml");
  const foundation::Progress interrupts = [](std::string_view, double) { throw foundation::Interrupted(); };
  EXPECT_THROW(static_cast<void>(sessions.of("page", text, mass(7), interrupts)), foundation::Interrupted);
  EXPECT_NE(opened(sessions, "page", mass(7)), nullptr);  // nothing of the earlier one is left
}

}  // namespace opened_sessions_test

// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/project_service.h"

#include <gmock/gmock.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "support/projects.h"
#include "trivet/foundation/temporary_folder.h"

namespace project_service_test {
namespace {

using nlohmann::json;
using trivet::server::ProjectService;

constexpr const char* question = R"({"revision": 1, "wants": [{"command": "modes", "keys": {"lowest": 1}}]})";

/// A mass of 1 kg between two springs, in a file of its own.
struct File {
  trivet::foundation::TemporaryFolder folder;
  std::string path = (folder.path() / "machine.toml").string();

  /// In one step, as the program saves: a reader never finds half a text.
  void write(double stiffness) const {
    std::ofstream(path + ".new") << trivet::test::chain({1}, {stiffness, stiffness}, {0, 0});
    std::filesystem::rename(path + ".new", path);
  }
};

std::string version_on_disk(ProjectService& service) {
  return json::parse(service.project({}).body)["version"].get<std::string>();
}

struct Answered {
  std::string version, modes;
};

Answered answered(ProjectService& service, const trivet::foundation::Progress& progress = {}) {
  const json found = json::parse(service.ask("page", question, progress).body);
  EXPECT_TRUE(found["ok"].get<bool>()) << found["problems"];
  return {found["version"].get<std::string>(), found["results"][0]["json"].dump()};
}

TEST(ProjectService, AnswersWithTheVersionOfTheTextThatItAnswersAbout) {
  const File file;
  file.write(1e4);
  ProjectService service(file.path, true, "");
  const std::string first = version_on_disk(service);
  const Answered before = answered(service);
  const Answered meanwhile = answered(service, [&](std::string_view task, double) {
    if (task != "opening the project") return;
    file.write(2e4);
    EXPECT_NE(version_on_disk(service), first);  // another page opens the new file
  });
  EXPECT_EQ(meanwhile.version, first);
  EXPECT_EQ(meanwhile.modes, before.modes);
  EXPECT_NE(answered(service).modes, before.modes);
}

TEST(ProjectService, KeepsVersionAndResultTogetherWhileAnotherThreadOpensTheFile) {
  constexpr int answers = 60;
  const File file;
  file.write(1e4);
  ProjectService service(file.path, true, "");
  const Answered one = answered(service);
  file.write(2e4);
  ASSERT_NE(version_on_disk(service), one.version);
  const Answered two = answered(service);
  std::atomic<bool> ends = false;
  std::thread other([&] {
    for (int i = 0; !ends; ++i) {
      file.write(i % 2 == 0 ? 1e4 : 2e4);
      version_on_disk(service);
    }
  });
  for (int i = 0; i < answers; ++i) {
    const Answered found = answered(service);
    const Answered& expected = found.version == one.version ? one : two;
    EXPECT_EQ(found.version, expected.version);
    EXPECT_EQ(found.modes, expected.modes);
  }
  ends = true;
  other.join();
}

}  // namespace
}  // namespace project_service_test

// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/session.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>
#include <thread>

namespace session_test {

using namespace trivet;
using engine::Request;
using engine::Session;

std::string example(const std::string& name) { return std::string(TRIVET_SOURCE_DIR) + "/examples/" + name; }

Session opened(const std::string& name, const std::vector<std::string>& settings = {}) {
  auto session = Session::open({example(name)}, settings);
  if (!session) throw std::runtime_error(foundation::message(session.error().list().front()));
  return std::move(*session);
}

std::string json(const Session& session, const std::string& command) {
  const engine::Result result = session.ask({command});
  EXPECT_FALSE(result.errors.has_errors()) << command;
  EXPECT_EQ(result.failure, "") << command;
  return engine::whole(result.json);
}

TEST(Session, ChangedIsTheChangedFileReadAgain) {
  const std::vector<std::string> setting = {"bodies.genset.mass = 4100"};
  const auto changed = opened("genset/genset.toml").changed(setting);
  ASSERT_TRUE(changed);
  const Session again = opened("genset/genset.toml", setting);
  for (const char* command : {"modes", "response", "peaks", "static", "check"})
    EXPECT_EQ(json(*changed, command), json(again, command)) << command;
  EXPECT_NE(json(again, "modes"), json(opened("genset/genset.toml"), "modes"));
}

TEST(Session, ExactCurvesEndWhereverTheyAreInterrupted) {
  const Session session = opened("genset/genset.toml");
  const std::vector<std::string> setting = {"bodies.genset.mass = 4100"};  // nothing of it is solved before
  std::vector<std::string> tasks;
  const engine::Result whole =
      session.changed(setting)->ask({"curves"}, [&](std::string_view task, double) { tasks.emplace_back(task); });
  ASSERT_TRUE(whole.json);
  const auto count = [&](const char* task) { return std::ranges::count(tasks, task); };
  EXPECT_GE(count("roots"), 6);  // one for each oscillating root
  EXPECT_GE(count("peaks"), 6);
  EXPECT_GE(count("modes of peaks"), 6);
  for (std::size_t last = 0; last < tasks.size(); ++last) {
    std::size_t calls = 0;
    const auto interrupts = [&](std::string_view, double) {
      if (calls++ == last) throw foundation::Interrupted();
    };
    EXPECT_THROW(static_cast<void>(session.changed(setting)->ask({"curves"}, interrupts)), foundation::Interrupted);
    EXPECT_EQ(calls, last + 1);
  }
}

TEST(Session, ResultsSeveralRequestsAtOnce) {
  const Session session = opened("genset/genset.toml");
  const std::vector<std::string> commands = {"modes", "response", "peaks", "static", "suspension", "roots"};
  std::vector<std::string> alone, together(commands.size());
  for (const std::string& command : commands) alone.push_back(json(opened("genset/genset.toml"), command));
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < commands.size(); ++i)
    threads.emplace_back([&, i] { together[i] = json(session, commands[i]); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(together, alone);
}

/// Every form of a result as one text, in the units of the file and in others.
std::string every_form(const engine::Result& result) {
  project::DisplayUnits inches;
  for (const auto& [key, unit] : {std::pair("length", "in"), {"frequency", "rpm"}, {"level", "rms"}})
    EXPECT_TRUE(project::set_shown_unit(inches, key, unit).list().empty());
  std::string all;
  if (result.json) all += engine::whole(result.json);
  if (result.text) all += engine::whole(result.text);
  if (result.text_in) all += result.text_in(inches);
  if (result.html) all += result.html(result.display) + result.html(inches);
  for (const auto& [file, table] : result.tables) {
    all += engine::whole(table);
    if (result.columns)
      for (const documents::TypedColumn& column : result.columns(file, inches))
        for (const documents::Json& value : column.values) all += value.dump();
  }
  for (const auto& figure : result.figures) all += engine::whole(figure.second);
  if (result.document) all += documents::as_text(engine::Result(result).document(inches), inches);
  if (result.arrays) {
    const documents::LabelledArrays arrays = result.arrays();
    for (const documents::LabelledArray& array : arrays.list())
      if (const auto* numbers = std::get_if<const double*>(&array.values); numbers && *numbers)
        all += std::to_string(**numbers);
  }
  return all;
}

TEST(Session, EveryFormOfAResultOutlivesItsSession) {
  for (const engine::Command& command : engine::commands()) {
    if (std::ranges::any_of(command.keys, &engine::Key::required) || command.name == "run") continue;
    const auto asked = [&] { return opened("genset/genset.toml").ask({command.name}); };
    const engine::Result first = asked(), second = asked();
    if (!first.failure.empty() || first.errors.has_errors()) continue;
    EXPECT_EQ(every_form(first), every_form(second)) << command.name;
    EXPECT_GT(every_form(first).size(), 10) << command.name;
  }
}

std::vector<std::string> subjects(const foundation::Problems& problems) {
  std::vector<std::string> all;
  for (const foundation::Problem& one : problems.list()) all.push_back(one.subject);
  return all;
}

TEST(Session, NamesEveryWrongKeyAtOnce) {
  const Session session = opened("genset/genset.toml");
  Request request{.command = "select", .keys = {{"most", 0.0}, {"by", "beauty"}, {"mots", 3.0}}, .before_keys = "--"};
  const engine::Result result = session.ask(request);
  EXPECT_THAT(subjects(result.errors), testing::UnorderedElementsAre("--most", "--by", "--mots"));
  for (const foundation::Problem& one : result.errors.list()) EXPECT_FALSE(one.remedy.empty()) << one.subject;
  EXPECT_EQ(engine::outcome(result, false), engine::Outcome::wrong_input);
}

TEST(Session, RejectsUnknownCommandsCasesAndElements) {
  const Session session = opened("genset/genset.toml");
  for (const Request& request :
       {Request{.command = "weather"}, Request{.command = "modes", .case_name = "winter"},
        Request{.command = "element", .keys = {{"name", "front lef"}}},
        Request{.command = "response", .keys = {{"band", "5 Hz"}}},
        Request{.command = "response", .keys = {{"at", "2 Hz"}, {"band", "1 Hz,5 Hz"}}},
        Request{.command = "suspension", .keys = {{"torque", "0,0,0"}}}, Request{.command = "element"}})
    EXPECT_TRUE(session.ask(request).errors.has_errors()) << request.command;
  const engine::Result whole = opened("genset/load_cases.toml").ask({.command = "optimize", .case_name = "2 g"});
  EXPECT_THAT(subjects(whole.errors), testing::ElementsAre("case \"2 g\""));  // a search is about all cases
}

TEST(Session, TakesNumbersInPlaceOfTexts) {
  const Session session = opened("genset/genset.toml");
  const auto response = [&](engine::Value at) {
    return engine::whole(session.ask({.command = "response", .keys = {{"at", std::move(at)}}}).json);
  };
  EXPECT_EQ(response("50 rad/s,62.5 rad/s"), response(std::vector<engine::Value>{50.0, 62.5}));
  EXPECT_EQ(response("8 Hz"), response(std::vector<engine::Value>{"8 Hz"}));
}

TEST(Commands, HaveExamplesAndDescribeTheirKeysInTheFile) {
  for (const engine::Command& command : engine::commands()) {
    EXPECT_EQ(engine::find_command(command.name), &command);
    EXPECT_NE(command.run, nullptr) << command.name;
    if (command.for_programs) continue;
    EXPECT_GE(command.examples.size(), 2u) << command.name;
    for (const std::string& line : command.examples)
      EXPECT_THAT(line, testing::StartsWith("trivet " + command.name + " "));
  }
  EXPECT_THAT(engine::file_keys(*engine::find_command("response")), testing::HasSubstr("  band "));
  EXPECT_THAT(engine::file_keys(*engine::find_command("random")), testing::HasSubstr("[analyses.random]"));
}

}  // namespace session_test

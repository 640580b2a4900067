// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/engine/result_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

#include "trivet/engine/key_reader.h"
#include "trivet/foundation/invalid_input.h"
#include "trivet/report/page/result_page.h"
#include "trivet/results/files/whole_file.h"

namespace trivet::engine {
namespace {

/// Without a document a result has no page: maps and checks.
std::vector<std::string> endings_of(const Command& command) {
  std::vector<std::string> endings = {".json"};
  if (command.csv) endings.emplace_back(".csv");
  if (command.name != "map" && command.name != "check") endings.emplace_back(".html");
  endings.emplace_back(".txt");
  return endings;
}

std::string checked_ending(const std::string& name, const Command& command) {
  const std::string ending = std::filesystem::path(name).extension().string();
  const std::vector<std::string> endings = endings_of(command);
  if (std::ranges::find(endings, ending) == endings.end())
    throw foundation::InvalidInput(fmt::format("--output {}: the ending chooses the form of the result; {} has {}",
                                               name, command.name, fmt::join(endings, ", ")));
  return ending;
}

}  // namespace

ResultFile::ResultFile(const std::string& name, const Command& command, const std::string& project)
    : name_(name), ending_(checked_ending(name, command)) {
  try {
    file_ = std::make_unique<results::WholeFile>(name, [&project](const std::filesystem::path& earlier) {
      std::error_code none;
      return std::filesystem::equivalent(earlier, project, none) ? std::string("it is the project file") : "";
    });
  } catch (const foundation::InvalidInput& refused) {
    throw foundation::InvalidInput(std::string("--output ") + refused.what());
  }
}

ResultFile::~ResultFile() = default;

void ResultFile::publish(const Result& result) const {
  if (ending_ == ".json") return file_->publish(whole(result.json));
  if (ending_ == ".csv") return file_->publish(whole(result.tables.front().second));
  if (ending_ == ".txt") return file_->publish(preface(result) + whole(result.text));
  const std::string title = (result.title.empty() ? result.command : result.title + ": " + result.command) +
      (result.case_name.empty() ? "" : ", case " + result.case_name);
  file_->publish(report::result_page(title, preface(result), result.html(result.display)));
}

std::string taken_result_file(const Command& command, Request& request) {
  const auto key = std::ranges::find(request.keys, "output", [](const auto& one) { return one.first; });
  if (!command.json || key == request.keys.end()) return "";
  std::string name = text_of(key->second);
  const std::string ending = std::filesystem::path(name).extension().string();
  const std::vector<std::string> endings = endings_of(command);
  if (std::ranges::find(endings, ending) == endings.end()) return "";
  request.keys.erase(key);
  return name;
}

}  // namespace trivet::engine

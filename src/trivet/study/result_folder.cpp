// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/result_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "trivet/study/file_writing.h"

namespace trivet::study {
namespace {

namespace fs = std::filesystem;

/// Does the folder hold nothing but what an earlier run wrote? One foreign file, and it is somebody's work.
bool is_earlier_result(const fs::path& folder) {
  std::ifstream stream(folder / "results.json", std::ios::binary);
  const std::string_view start = "{\"format\":\"trivet-results\"";
  std::string found(start.size(), ' ');
  if (!stream.read(found.data(), static_cast<std::streamsize>(found.size())) || found != start) return false;
  return std::all_of(fs::directory_iterator(folder), fs::directory_iterator(), [](const fs::directory_entry& entry) {
    const std::string name = entry.path().filename().string();
    const bool of_a_case = entry.is_directory() && name.size() > 3 && name.find_first_not_of("0123456789") == name.find('-');
    return of_a_case || name == "results.json" || name == "report.html";
  });
}

bool may_be_replaced(const fs::path& target) {
  if (!fs::exists(target)) return true;
  if (!fs::is_directory(target) || fs::equivalent(target, fs::current_path())) return false;
  return fs::is_empty(target) || is_earlier_result(target);
}

}  // namespace

ResultFolder::ResultFolder(fs::path target) : target_(fs::absolute(target).lexically_normal()) {
  if (target_.filename().empty()) target_ = target_.parent_path();
  if (!may_be_replaced(target_))
    throw std::runtime_error(fmt::format("{} exists and holds something else than an earlier result of trivet; choose another folder with -o", target_.string()));
  working_ = name_beside(target_, "partial");
  std::error_code error;
  fs::create_directories(working_, error);
  if (error) throw std::runtime_error(fmt::format("cannot write beside {}: {}; choose another folder with -o", target_.string(), error.message()));
}

ResultFolder::~ResultFolder() {
  if (published_) return;
  std::error_code ignored;
  fs::remove_all(working_, ignored);
}

void ResultFolder::write(const std::string& name, const std::string& content) {
  const fs::path path = working_ / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  write_file(path, content, target_ / name);
}

void ResultFolder::publish() {
  const fs::path old = name_beside(target_, "old");
  const bool replaces = fs::exists(target_);
  if (replaces) fs::rename(target_, old);
  std::error_code error;
  fs::rename(working_, target_, error);
  if (error) {
    if (replaces) fs::rename(old, target_);
    throw std::runtime_error(fmt::format("cannot put {} in place: {}", target_.string(), error.message()));
  }
  published_ = true;
  if (replaces) fs::remove_all(old, error);
}

}  // namespace trivet::study

// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/study/result_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace trivet::study {
namespace {

namespace fs = std::filesystem;

constexpr const char* marker = "results.json";

bool may_be_replaced(const fs::path& target) {
  if (!fs::exists(target)) return true;
  if (!fs::is_directory(target)) return false;
  return fs::is_empty(target) || fs::exists(target / marker);
}

}  // namespace

ResultFolder::ResultFolder(fs::path target) : target_(fs::absolute(target).lexically_normal()) {
  if (target_.filename().empty()) target_ = target_.parent_path();
  if (!may_be_replaced(target_))
    throw std::runtime_error(fmt::format("{} exists and is no earlier result of trivet; choose another folder with -o", target_.string()));
  working_ = target_.parent_path() / fmt::format(".{}.partial-{}", target_.filename().string(), static_cast<long>(::getpid()));
  std::error_code error;
  fs::create_directories(working_, error);
  if (error) throw std::runtime_error(fmt::format("cannot write beside {}: {}", target_.string(), error.message()));
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
  errno = 0;
  std::ofstream stream(path, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) throw std::runtime_error(fmt::format("cannot write {}: {}", (target_ / name).string(), errno ? std::strerror(errno) : "unknown reason"));
}

void ResultFolder::publish() {
  const fs::path old = target_.parent_path() / fmt::format(".{}.old-{}", target_.filename().string(), static_cast<long>(::getpid()));
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

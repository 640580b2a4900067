// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/files/folder_lock.h"

#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace trivet::results {
namespace {

constexpr std::chrono::seconds longest_wait(
    60);  // publishing takes milliseconds, or some seconds with gigabytes in the folder
constexpr std::chrono::milliseconds pause(10);

}  // namespace

FolderLock::FolderLock(const foundation::FolderHandle& folder, const std::filesystem::path& shown)
    : own_(folder.folder(".")) {
  const auto end = std::chrono::steady_clock::now() + longest_wait;
  while (flock(own_.descriptor(), LOCK_EX | LOCK_NB) != 0) {
    error_ = errno;
    if (error_ == EINTR) continue;
    if (error_ != EWOULDBLOCK) return;
    if (std::chrono::steady_clock::now() > end)
      throw std::runtime_error(
          fmt::format("{}: another program has held its lock for {} s; end it, or choose another folder with -o",
                      shown.string(), longest_wait.count()));
    std::this_thread::sleep_for(pause);
  }
  error_ = 0;
}

FolderLock::~FolderLock() {
  if (is_held()) flock(own_.descriptor(), LOCK_UN);
}

std::string FolderLock::reason() const { return std::strerror(error_); }

}  // namespace trivet::results

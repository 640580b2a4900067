// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace trivet::study {

/// A result folder in the making: files go to a hidden folder beside the target, which takes the target's place only when
/// `publish` is called. Without it, everything written is removed again.
class ResultFolder {
 public:
  /// @throws std::runtime_error if the target exists and is not an earlier result of Trivet, or nothing can be written there
  explicit ResultFolder(std::filesystem::path target);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  /// Writes one file, `name` may hold folders. @throws std::runtime_error with the reason (a full disk, for instance)
  void write(const std::string& name, const std::string& content);
  /// Moves the folder into place; an earlier result is replaced.
  void publish();

 private:
  std::filesystem::path target_;
  std::filesystem::path working_;
  bool published_ = false;
};

}  // namespace trivet::study

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trivet::foundation {

/// An open folder. Names are looked up in it one by one and no symbolic link is followed, so that a link planted later
/// leads nowhere else.
class FolderHandle {
 public:
  enum class Kind { none, file, folder, link, other };

  FolderHandle() = default;
  /// Links on the way to it are followed: they are the user's way. Not open if it cannot be read; errno is the reason.
  explicit FolderHandle(const std::filesystem::path& path);
  ~FolderHandle();
  FolderHandle(FolderHandle&& other) noexcept : descriptor_(other.descriptor_) { other.descriptor_ = -1; }
  FolderHandle& operator=(FolderHandle&& other) noexcept;

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  [[nodiscard]] int descriptor() const { return descriptor_; }

  /// A folder in it. Not open if there is none of this name, or a link.
  [[nodiscard]] FolderHandle folder(const std::string& name) const;
  /// The same, made if there is nothing of this name.
  [[nodiscard]] FolderHandle made_folder(const std::string& name) const;
  [[nodiscard]] Kind kind(const std::string& name) const;
  /// What it holds, in alphabetical order. @throws std::system_error if that cannot be read
  [[nodiscard]] std::vector<std::string> names() const;
  /// Bytes of a regular file of at most this size; nothing for anything else.
  [[nodiscard]] std::optional<std::string> content(const std::string& name, std::size_t largest) const;
  /// Are the two names one and the same file (hard links)?
  [[nodiscard]] bool is_same_file(const std::string& name, const FolderHandle& other,
                                  const std::string& other_name) const;

 private:
  int descriptor_ = -1;
};

/// "a folder", "a symbolic link", …: for messages.
[[nodiscard]] const char* words(FolderHandle::Kind kind);

}  // namespace trivet::foundation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trivet::foundation {

/// An open folder. Names are looked up in it one at a time and symbolic links are not followed, so that a link planted
/// later cannot redirect access.
class FolderHandle {
 public:
  enum class Kind { none, file, folder, link, other };

  FolderHandle() = default;
  /// Links in the path are followed, because the user chose the path. Not open if it cannot be read; errno is the
  /// reason.
  explicit FolderHandle(const std::filesystem::path& path);
  ~FolderHandle();
  FolderHandle(FolderHandle&& other) noexcept : descriptor_(other.descriptor_) { other.descriptor_ = -1; }
  FolderHandle& operator=(FolderHandle&& other) noexcept;

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  [[nodiscard]] int descriptor() const { return descriptor_; }

  /// Subfolder. Not open if it does not exist or is a link.
  [[nodiscard]] FolderHandle folder(const std::string& name) const;
  /// The same, created if the name does not exist. @param mode  of a new one, before the umask
  [[nodiscard]] FolderHandle made_folder(const std::string& name, mode_t mode = 0777) const;
  [[nodiscard]] Kind kind(const std::string& name) const;
  /// Names of its entries, in alphabetical order. @throws std::system_error if they cannot be read
  [[nodiscard]] std::vector<std::string> names() const;
  /// Bytes of a regular file of at most this size; otherwise nullopt.
  [[nodiscard]] std::optional<std::string> content(const std::string& name, std::size_t largest) const;
  /// Are the two names the same file (hard links)?
  [[nodiscard]] bool is_same_file(const std::string& name, const FolderHandle& other,
                                  const std::string& other_name) const;

 private:
  int descriptor_ = -1;
};

/// Kind in words for messages: "a folder", "a symbolic link", …
[[nodiscard]] const char* kind_name(FolderHandle::Kind kind);

/// Writes a new file; an existing entry of this name, even a link, is an error.
/// @param shown  path in the message  @param mode  of the file, before the umask
/// @throws std::runtime_error with the reason (a full disk, for instance)
void write_new_file(const FolderHandle& folder, const std::string& name, const std::string& content,
                    const std::filesystem::path& shown, mode_t mode = 0666);

}  // namespace trivet::foundation

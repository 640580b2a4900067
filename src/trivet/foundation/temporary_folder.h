// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <list>
#include <mutex>
#include <optional>
#include <string_view>

namespace trivet::foundation {

/// A folder that must not outlive the process: registered as long as the object exists.
class RegisteredFolder {
 public:
  enum class Removal { with_contents, if_empty };
  RegisteredFolder(const std::filesystem::path& path, Removal removal);
  ~RegisteredFolder();
  RegisteredFolder(const RegisteredFolder&) = delete;
  RegisteredFolder& operator=(const RegisteredFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return place_->path; }

  struct Folder {
    std::filesystem::path path;
    Removal removal;
  };

 private:
  std::list<Folder>::iterator place_;
};

/// A program that must not outlive the process. Its guard (child_process.h) kills it and all that it started when the
/// lifeline is closed.
class RegisteredProgram {
 public:
  /// @param guard     process number of the guard, our child
  /// @param lifeline  file descriptor; the object takes ownership
  RegisteredProgram(int guard, int lifeline);
  /// Closes the lifeline and waits for the guard.
  ~RegisteredProgram();
  RegisteredProgram(const RegisteredProgram&) = delete;
  RegisteredProgram& operator=(const RegisteredProgram&) = delete;

  struct Program {
    int guard, lifeline;
  };

 private:
  std::list<Program>::iterator place_;
};

/// While it exists, `remove_leftovers` waits: for steps that must not be interrupted. May be nested. Keep the steps
/// short.
class Undisturbed {
 public:
  Undisturbed();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
};

/// Kills all registered programs and removes all registered folders, so that the process can end immediately. A thread
/// that registers or releases one afterwards waits for ever; the caller must end the process.
void remove_leftovers() noexcept;

/// Name of the file that marks our folders (TemporaryFolder): the owner holds a lock on it.
inline constexpr const char* owner_mark = ".owned-by-trivet";

/// Removes a folder, the owner's mark last, so that a later run can complete an interrupted removal. Links are removed,
/// not followed. @returns whether the folder is gone
bool remove_marked_folder(const std::filesystem::path& folder) noexcept;

/// Prefix of the names of all temporary folders.
inline constexpr std::string_view temporary_name_start = ".trivet-";

/// Removes temporary folders that killed processes of this user left in $TMPDIR or /tmp, or in `parent`.
void remove_abandoned_folders();
void remove_abandoned_folders(const std::filesystem::path& parent);

/// A new folder for this user only, with a name that cannot be guessed, removed with its contents when the object is
/// destroyed. It contains one file, the owner's mark, on which this process holds a lock; creating the next temporary
/// folder in the same place removes those of killed owners. On a file system without locks those remain.
class TemporaryFolder {
 public:
  /// In $TMPDIR, or in /tmp if that is not set. @throws std::runtime_error with reason and remedy if no folder can be
  /// created there
  TemporaryFolder();
  /// In an existing folder. @throws std::system_error if no folder can be created there
  explicit TemporaryFolder(const std::filesystem::path& parent);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int mark_ = -1;  ///< file descriptor of the owner's mark
  std::optional<RegisteredFolder> registered_;
};

}  // namespace trivet::foundation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <list>
#include <mutex>

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

/// A program that must not outlive the process. Its guard (guarded_program.h) kills it and all that it started when the
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

}  // namespace trivet::foundation

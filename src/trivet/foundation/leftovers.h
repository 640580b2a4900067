// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <list>
#include <mutex>

namespace trivet::foundation {

/// A folder that must not outlive the process: registered as long as the object lives.
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

/// A program that must not outlive the process. Its guard (guarded_program.h) ends it and all that it started when the
/// lifeline is closed.
class RegisteredProgram {
 public:
  /// @param guard     process number of the guard, our child
  /// @param lifeline  file descriptor, owned from now on
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

/// While it lives, `remove_leftovers` waits: around steps that must not be cut in two. Nested ones are allowed. Keep it
/// short.
class Undisturbed {
 public:
  Undisturbed();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
};

/// Ends every registered program and removes every registered folder, so that the process can end at once, in the
/// middle of its work. A thread that would register or release something afterwards waits for ever; the caller ends the
/// process.
void remove_leftovers() noexcept;

/// Name of the file that marks a folder of ours (TemporaryFolder): its owner holds a lock on it.
inline constexpr const char* owner_mark = ".owned-by-trivet";

/// Removes a folder; the owner's mark goes last, so that a removal that was cut short can be completed by a later run.
/// Links are removed, not followed. @returns whether nothing is left
bool remove_marked_folder(const std::filesystem::path& folder) noexcept;

}  // namespace trivet::foundation

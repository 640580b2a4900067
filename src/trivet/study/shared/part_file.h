// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "trivet/foundation/files.h"
#include "trivet/study/shared/chunk_set.h"

namespace trivet::study {

/// One of several processes that share a study: the chunks number − 1, number − 1 + of, … are its own.
struct StudyPart {
  std::uint64_t number = 1, of = 1;

  [[nodiscard]] bool has(std::uint64_t chunk) const { return chunk % of == number - 1; }
  /// "part-3-of-64"
  [[nodiscard]] std::string file_name() const;
  [[nodiscard]] static std::optional<StudyPart> of_file(std::string_view name);
  bool operator==(const StudyPart&) const = default;
};

inline constexpr std::uint64_t most_parts = 1'000'000;

/// What the file of a part contains.
struct PartRecord {
  std::string study;               ///< hash of the manifest
  std::uint64_t written_at = 0;    ///< [s] since 1970
  std::uint64_t milliseconds = 0;  ///< since the process began
  std::uint64_t computed = 0;      ///< designs or items since then
  bool has_ended = false;          ///< it computes nothing more
  ChunkSet chunks;                 ///< finished ones, also those of earlier processes; of shared items none
  std::string results;             ///< in the words of the command

  /// Notes the time now. @param start  of the process
  void stamp(std::chrono::steady_clock::time_point start);
  [[nodiscard]] std::string text() const;
  /// Empty if the text is damaged.
  [[nodiscard]] static std::optional<PartRecord> read(const std::string& text);
};

/// Largest file of a study that is read [bytes].
inline constexpr std::size_t largest_part_file = std::size_t{1} << 30;

/// The file of the own part. While it exists, no other process has it: the file is locked.
class OwnPart {
 public:
  /// Creates the file if there is none. @param shown  the folder, in messages
  /// @throws foundation::InvalidInput if another process works on this part, or the file cannot be opened
  OwnPart(const foundation::FolderHandle& folder, const StudyPart& part, const std::filesystem::path& shown);
  ~OwnPart();
  OwnPart(const OwnPart&) = delete;
  OwnPart& operator=(const OwnPart&) = delete;

  /// False on a file system without locks.
  [[nodiscard]] bool is_locked() const { return locked_; }
  /// Replaces the file as a whole: at any moment its name has the text before or after.
  /// @throws foundation::NotComputable with the reason, such as a full disk; the text before stays
  void replace(const std::string& text);

 private:
  const foundation::FolderHandle& folder_;
  std::string name_;
  std::filesystem::path shown_;
  int file_ = -1;
  bool locked_ = true;
};

/// Whether some process works on a part now. False on a file system without locks.
[[nodiscard]] bool is_worked_on(const foundation::FolderHandle& folder, const StudyPart& part);

/// Replaces a file of a study folder as a whole, from a file with the same name and ".new".
/// @returns the new file, open and locked if the file system has locks  @throws foundation::NotComputable
[[nodiscard]] int replaced_file(const foundation::FolderHandle& folder, const std::string& name,
                                const std::string& text, const std::filesystem::path& shown);

}  // namespace trivet::study

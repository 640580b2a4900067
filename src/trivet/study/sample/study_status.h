// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "trivet/study/shared/part_file.h"

namespace trivet::study {

/// How far the processes of a study folder are, from their files.
struct StudyStatus {
  enum class State {
    running,  ///< its process has the lock of the file
    ended,    ///< its process has ended as it wanted: it was done, or a signal asked for it
    stopped   ///< its process was killed, or it is on a file system without locks
  };
  struct Part {
    StudyPart part;
    State state = State::stopped;
    std::uint64_t done = 0;         ///< chunks
    std::uint64_t missing = 0;      ///< chunks of the part that the folder does not have
    std::optional<double> rate;     ///< [designs/s] of its last process; none before its first file
    std::uint64_t written_ago = 0;  ///< [s]
  };

  std::filesystem::path folder;
  std::uint64_t designs = 0, chunks = 0, done = 0;
  std::vector<Part> parts;  ///< with a file, in the order of their numbers
  std::vector<std::string> damaged, overlapping;
  double rate = 0;                ///< [designs/s] of the running parts together
  std::optional<double> seconds;  ///< left until the last running part is done; none if nothing runs
};

/// @throws foundation::InvalidInput if there is no study in the folder
[[nodiscard]] StudyStatus study_status(const std::filesystem::path& folder);

/// "running", "ended", "stopped"
[[nodiscard]] const char* state_name(StudyStatus::State state);

}  // namespace trivet::study

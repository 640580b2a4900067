// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "trivet/study/shared/part_file.h"

namespace trivet::engine {

/// The part of a study that this process has, and what says so.
struct RankedPart {
  study::StudyPart part;
  std::string reason;  ///< "SLURM_PROCID and SLURM_NTASKS"

  /// "part 3 of 64 (SLURM_PROCID and SLURM_NTASKS)"
  [[nodiscard]] std::string words() const;
};

/// Value of an environment variable; nullptr: it is not set.
using Environment = std::function<const char*(const char* name)>;

/// "3/64" → part 3 of 64. @throws foundation::InvalidInput, naming the key  @param key  "--part"
[[nodiscard]] study::StudyPart part_of_words(const std::string& words, const std::string& key);

/// Rank and size of this process among those that mpirun (Open MPI, MPICH), srun or an array of Slurm has started;
/// none if it is alone. Processes within tasks of an array share the whole array.
/// @throws foundation::InvalidInput if the variables contradict each other
[[nodiscard]] std::optional<RankedPart> part_of_rank(const Environment& environment);

}  // namespace trivet::engine

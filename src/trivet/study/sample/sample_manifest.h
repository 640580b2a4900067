// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "trivet/project/project.h"
#include "trivet/study/sample/sample_tally.h"
#include "trivet/study/shared/chunk_set.h"
#include "trivet/study/shared/study_manifest.h"

namespace trivet::study {

/// The command in the identity of a study of designs within tolerances.
inline constexpr const char* sample_command_name = "sample";

/// What a study of designs within tolerances is of.
[[nodiscard]] StudyIdentity sample_identity(const project::Project& project);

/// What its first process fixes: all processes take chunks and magnitudes of the sums from it.
struct FixedBySample {
  StudyChunks chunks;
  SampleMagnitudes magnitudes;

  [[nodiscard]] std::string text() const;
  /// Empty if the text is of something else.
  [[nodiscard]] static std::optional<FixedBySample> read(const std::string& text);
};

}  // namespace trivet::study

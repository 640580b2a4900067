// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>

#include "trivet/foundation/interruption.h"
#include "trivet/project/project.h"
#include "trivet/study/sample/sample.h"
#include "trivet/study/shared/part_file.h"

namespace trivet::study {

struct StudyRequest {
  std::filesystem::path folder;
  StudyPart part;
  bool shares = false;  ///< of the variance, once the study is complete
  /// Once it is true, the process ends with what is there. Called on any thread; empty: never.
  std::function<bool()> ends = {};
};

/// As `sample`, in a folder that any number of processes share: computes those chunks of its part that the folder does
/// not have. The result is that of all chunks in the folder; once all are there, it is the same as that of `sample`,
/// for any processes, parts, threads and interruptions. Method: docs/sample.md, "Study folder".
/// @throws foundation::InvalidInput as `sample`, for a folder of another study, and if another process has the part;
/// NotComputable if a file cannot be written, and if there is no design yet; Interrupted by `progress`, after writing
[[nodiscard]] Sample sample_in_folder(const project::Project& project, const StudyRequest& request,
                                      const foundation::Progress& progress = {});

}  // namespace trivet::study

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "trivet/foundation/problems.h"

namespace trivet::exchange {

/// Size limit of a file [bytes].
inline constexpr std::size_t largest_matrix_file = std::size_t{1} << 30;

/// Texts of messages about files of one kind.
struct FileRules {
  const char* subject;
  const char* rule;
  const char* if_missing;    ///< remedy
  const char* if_too_large;  ///< remedy
};
inline constexpr FileRules matrix_file_rules{"matrix file", "it must be a readable file with a matrix in it",
                                             "check the path; it is relative to the folder of the project file",
                                             "condense the model to its interface nodes first"};
inline constexpr FileRules universal_file_rules{"universal file", "it must be a readable universal file (.unv, .uff)",
                                                "check the path", "export fewer functions, or in binary form (58b)"};

/// Content of a file; errors for directories and for unreadable, empty or too large files.
[[nodiscard]] foundation::Expected<std::string> file_bytes(const std::filesystem::path& path,
                                                           const FileRules& rules = matrix_file_rules);

}  // namespace trivet::exchange

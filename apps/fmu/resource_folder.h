// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace trivet::fmu {

/// Path of a folder that is given as a URI, "file:///tmp/my%20unit/resources", in UTF-8. Text without "file:" is a path
/// already.
/// @throws std::runtime_error if an escape is wrong, or the folder is on another host (except as a Windows share)
[[nodiscard]] std::string path_of_uri(std::string_view uri);

/// Text of a file in a folder.
/// @param folder  in UTF-8, with or without a slash at the end  @throws std::runtime_error with path and reason
[[nodiscard]] std::string text_in_folder(const std::string& folder, const std::string& name);

}  // namespace trivet::fmu

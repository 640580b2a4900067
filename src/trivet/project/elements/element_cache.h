// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace trivet::project {

/// Results of long computations, stored on disk under a hash of all that they depend on. The folder is $TRIVET_CACHE,
/// else trivet/ in $XDG_CACHE_HOME or ~/.cache; TRIVET_CACHE="" switches it off. A damaged entry, a link or a folder in
/// its place counts as absent; without a writable folder, no entry is stored.
[[nodiscard]] std::optional<std::vector<double>> cached_numbers(const std::string& key);
void keep_numbers(const std::string& key, const std::vector<double>& numbers);

/// Key from a description of the computation and from the contents of files.
[[nodiscard]] std::string content_key(const std::string& description, const std::vector<std::string>& files = {});

}  // namespace trivet::project

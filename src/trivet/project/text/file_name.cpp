// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/project/text/file_name.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace trivet::project {

bool is_file_key(const std::string& key) {
  static constexpr std::array<const char*, 5> keys = {"file", "catalogue", "step", "load_cases", "loops"};
  return std::ranges::find(keys, key) != keys.end();
}

std::filesystem::path named_file(const Node& name) {
  namespace fs = std::filesystem;
  const fs::path folder = name.folder.empty() ? fs::path(name.origin.source).parent_path() : fs::path(name.folder);
  return fs::path(name.text).is_absolute() ? fs::path(name.text) : folder / name.text;
}

std::optional<std::filesystem::path> read_file_name(TableReader& reader, const std::string& key) {
  assert(is_file_key(key));
  namespace fs = std::filesystem;
  if (!reader.has(key)) reader.missing(key, "name the file, relative to the project file: " + key + " = \"…\"");
  const auto name = reader.text(key);
  if (!name) return std::nullopt;
  fs::path path = named_file(*reader.node(key));
  std::error_code unreadable;
  if (!fs::is_regular_file(path, unreadable)) {
    reader.error(key, "\"" + name->substr(0, 200) + "\"", "no file of this name can be read",
                 "names are relative to the folder of the project file");
    return std::nullopt;
  }
  return path;
}

}  // namespace trivet::project

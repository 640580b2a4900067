// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/server/page_files.h"

#include <algorithm>
#include <array>
#include <utility>

namespace trivet::server {

const EmbeddedFile* find_page_file(std::string_view path) {
  if (!path.starts_with('/')) return nullptr;
  const std::string_view name = path == "/" ? "index.html" : path.substr(1);
  const auto found = std::ranges::find(page_files(), name, &EmbeddedFile::name);
  return found == page_files().end() ? nullptr : &*found;
}

std::string media_type(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, const char*>, 9> types = {{{".html", "text/html"},
                                                                                     {".js", "text/javascript"},
                                                                                     {".css", "text/css"},
                                                                                     {".txt", "text/plain"},
                                                                                     {".json", "application/json"},
                                                                                     {".svg", "image/svg+xml"},
                                                                                     {".png", "image/png"},
                                                                                     {".woff2", "font/woff2"},
                                                                                     {".wasm", "application/wasm"}}};
  const auto found = std::ranges::find_if(types, [&](const auto& type) { return name.ends_with(type.first); });
  return found == types.end() ? "application/octet-stream" : found->second;
}

}  // namespace trivet::server

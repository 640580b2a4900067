// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace trivet::server {

/// A file of the source tree that is a part of the program.
struct EmbeddedFile {
  std::string_view name;  ///< "page.js"
  std::string_view content;
};

/// The bundle of the page (web/dist).
[[nodiscard]] std::span<const EmbeddedFile> page_files();
/// Project files that a page without a project offers.
[[nodiscard]] std::span<const EmbeddedFile> example_files();

/// @param path  of a request: "/page.js"; "/" is index.html  @returns nullptr if the page has no such file
[[nodiscard]] const EmbeddedFile* find_page_file(std::string_view path);

/// "text/javascript", by the ending of the name.
[[nodiscard]] std::string media_type(std::string_view name);

}  // namespace trivet::server

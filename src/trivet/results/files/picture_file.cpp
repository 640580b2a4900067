// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/results/files/picture_file.h"

#include <fmt/format.h>

#include <fstream>
#include <string>
#include <system_error>

#include "trivet/foundation/index.h"
#include "trivet/foundation/invalid_input.h"

namespace trivet::results {
namespace {

namespace fs = std::filesystem;

/// Is the file empty or an SVG file? Declaration, comments and document type may precede the element.
bool is_earlier_picture(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string head(4096, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(to_size(stream.gcount()));
  if (head.empty()) return stream.eof();
  const std::size_t start = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (start == std::string::npos) return false;
  const auto begins = [&](const char* words) { return head.compare(start, std::string(words).size(), words) == 0; };
  return begins("<svg") || ((begins("<?xml") || begins("<!DOCTYPE svg")) && head.find("<svg") != std::string::npos);
}

const fs::path& not_the_project(const fs::path& target, const fs::path& project) {
  std::error_code error;
  if (fs::equivalent(target, project, error))
    throw foundation::InvalidInput(
        fmt::format("{}: this is the project file; choose another name for the picture", target.string()));
  return target;
}

}  // namespace

PictureFile::PictureFile(const fs::path& target, const fs::path& project)
    : WholeFile(not_the_project(target, project), [](const fs::path& earlier) {
        return is_earlier_picture(earlier) ? std::string() : "it exists and is not an SVG picture; choose another name";
      }) {}

}  // namespace trivet::results

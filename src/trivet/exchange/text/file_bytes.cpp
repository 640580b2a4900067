// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/exchange/text/file_bytes.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "trivet/foundation/index.h"

namespace trivet::exchange {
namespace {

tl::unexpected<foundation::Problems> refused(const std::filesystem::path& path, const FileRules& rules,
                                             std::string finding, std::string remedy) {
  return foundation::failure({.origin = {path.string()},
                              .subject = rules.subject,
                              .finding = std::move(finding),
                              .rule = rules.rule,
                              .remedy = std::move(remedy)});
}

}  // namespace

foundation::Expected<std::string> file_bytes(const std::filesystem::path& path, const FileRules& rules) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return refused(path, rules, "no such file", rules.if_missing);
  if (std::filesystem::is_directory(status))
    return refused(path, rules, "this is a directory", "name the file inside it");
  if (!std::filesystem::is_regular_file(status))
    return refused(path, rules, "this is a pipe or a device", "write it to a file first and name that");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return refused(path, rules, std::strerror(errno), "check its permissions");
  std::string bytes, chunk(1u << 16, '\0');
  while (stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || stream.gcount() > 0) {
    bytes.append(chunk, 0, to_size(stream.gcount()));
    if (bytes.size() > largest_matrix_file)
      return refused(path, rules, fmt::format("larger than {} MiB", largest_matrix_file >> 20), rules.if_too_large);
  }
  if (stream.bad()) return refused(path, rules, "reading failed", "check the disk");
  if (bytes.empty()) return refused(path, rules, "the file is empty", "did the program that wrote it finish?");
  return bytes;
}

}  // namespace trivet::exchange
